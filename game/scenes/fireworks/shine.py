"""Kernels of the picture: places, colours and sizes of all that shines, and of smoke in the light of bursts.

A star stands at a depth behind the shore. A pinhole over the near bank sees it at a share of its distance
from the middle of the view. So layers slide past one another as the camera goes along the show.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.generations import step
from game.physics.kernels import elementary

EYE = 6.0  # m above the lake
CAMERA_AWAY = 420.0  # m before the shore
BLINK_SHARE = 0.16  # of a strobe's period in which it shines
FLASH_FADES = 0.45  # s
FLASH_REACH = 42.0  # m, at which a burst lights smoke half as much
SMOKE_LIT = 0.22  # of a burst's light that smoke near it gives back at first
SMOKE_START, SMOKE_GROWTH = 3.5, 3.5  # m, m/√s


class Seen(NamedTuple):
    """Where the camera is (m along the show), the moment that is shown (s), and how long before now it is."""

    middle: float
    time: float
    back: float


class Glow(NamedTuple):
    """How a kind shines, as numbers: see `LookOf`."""

    size: int
    dots: int
    tail_s: float
    bloom: float
    blink: float
    twinkle: float


@inner_kernel
def nearness(depth):
    """How much larger than at the shore a thing at a depth (m) is seen."""
    return CAMERA_AWAY / max(CAMERA_AWAY + depth, 20.0)


@inner_kernel
def part_of(value):
    """What is behind the point of a number."""
    return value - math.floor(value)


@inner_kernel
def pack(red, green, blue):
    """0xRRGGBB of channels 0 to 255."""
    return (int(min(red, 255.0)) << 16) | (int(min(green, 255.0)) << 8) | int(min(blue, 255.0))


@lean_kernel
def shine(rows, shades, glow, seen, places, colors, sizes, shares, line):
    """Write the lights of a kind's stars ``rows`` (FIELDS, n) from ``line`` on; the next line.

    places (m, 2) m, as they are seen; colors (m,), sizes (m,), shares (m,) as `Canvas.glow` takes them.
    """
    last = shades.shape[0] - 1
    room = places.shape[0]
    for i in range(rows.shape[1]):
        age = seen.time - rows[step.BORN, i]
        if age < 0.0 or line + glow.dots >= room:
            continue
        strength = 1.0
        if glow.blink > 0.0:
            phase = part_of(
                seen.time * glow.blink * (0.7 + 0.6 * part_of(rows[step.DIES, i] * 31.7))
                + rows[step.DIES, i] * 97.3
            )
            if phase > BLINK_SHARE:
                strength = 0.05
        if glow.twinkle > 0.0:
            strength = 1.0 - glow.twinkle * part_of(rows[step.DIES, i] * 5717.3 + seen.time * 11.3)
        at = min(int(age / max(rows[step.DIES, i] - rows[step.BORN, i], 1e-9) * last), last)
        red, green, blue = shades[at, 0] * strength, shades[at, 1] * strength, shades[at, 2] * strength
        near = nearness(rows[step.DEPTH, i])
        vx, vy = rows[step.VX, i], rows[step.VY, i]
        x = rows[step.X, i] - seen.back * vx
        y = rows[step.Y, i] - seen.back * vy
        reach = min(glow.tail_s, age)
        for dot in range(glow.dots + 1):
            behind = reach * dot / max(glow.dots, 1)
            fade = 1.0 if dot == 0 else 0.62 * (1.0 - dot / (glow.dots + 1.0))
            places[line, 0] = seen.middle + near * (x - behind * vx - seen.middle)
            places[line, 1] = EYE + near * (y - behind * vy - EYE)
            colors[line] = pack(red * fade, green * fade, blue * fade)
            sizes[line] = glow.size if dot == 0 else max(glow.size - 1, 0)
            shares[line] = glow.bloom if dot == 0 else 0.0
            line += 1
    return line


@lean_kernel
def light_smoke(rows, flashes, seen, ambient, places, radii, colors, shares):
    """Write smoke ``rows`` (FIELDS, n) as it is lit by ``flashes`` (m, 7): s, x, y, depth, r, g, b; how many.

    ambient (4,): red, green, blue of the sky's light, and how much of it smoke gives back.
    """
    line = 0
    for i in range(rows.shape[1]):
        age = seen.time - rows[step.BORN, i]
        life = rows[step.DIES, i] - rows[step.BORN, i]
        if age < 0.0 or line >= places.shape[0]:
            continue
        x = rows[step.X, i] - seen.back * rows[step.VX, i]
        y = rows[step.Y, i] - seen.back * rows[step.VY, i]
        red, green, blue = ambient[0] * ambient[3], ambient[1] * ambient[3], ambient[2] * ambient[3]
        for j in range(flashes.shape[0]):
            since = seen.time - flashes[j, 0]
            if since < 0.0 or since > 6.0 * FLASH_FADES:
                continue
            dx, dy, back = x - flashes[j, 1], y - flashes[j, 2], rows[step.DEPTH, i] - flashes[j, 3]
            light = SMOKE_LIT * elementary.exp(-since / FLASH_FADES)
            light = light / (1.0 + (dx * dx + dy * dy + back * back) / (FLASH_REACH * FLASH_REACH))
            red += light * flashes[j, 4]
            green += light * flashes[j, 5]
            blue += light * flashes[j, 6]
        most = max(red, green, blue, 1e-6)
        part = age / max(life, 1e-9)
        near = nearness(rows[step.DEPTH, i])
        radius = SMOKE_START + SMOKE_GROWTH * math.sqrt(age)
        thin = SMOKE_START * SMOKE_START * 4.0 / (radius * radius)  # as much smoke on a larger disc
        places[line, 0] = seen.middle + near * (x - seen.middle)
        places[line, 1] = EYE + near * (y - EYE)
        radii[line] = near * radius
        colors[line] = pack(255.0 * red / most, 255.0 * green / most, 255.0 * blue / most)
        shares[line] = most * min(age / 0.3, 1.0) * max(1.0 - part, 0.0) * min(thin, 1.0)
        line += 1
    return line
