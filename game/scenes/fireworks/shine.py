"""Kernels of the picture: places, colours and sizes of all that shines, and of smoke in its light."""

from __future__ import annotations

import math
from typing import NamedTuple

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.generations import step
from game.physics.kernels import elementary
from game.scenes.fireworks.eye import EYE, nearness, turned

BLINK_SHARE = 0.16  # of a strobe's period in which it shines
FLASH_FADES = 0.45  # s
FLASH_REACH = 42.0  # m, at which a burst lights smoke half as much
SMOKE_LIT = 0.15  # of a burst's light that smoke near it gives back at first
STAR_REACH = 30.0  # m, at which the stars of a cell light smoke half as much
STAR_LIT = 0.0011  # of a star's light that smoke near it gives back
CELL = 40.0  # m, side of the cells in which the light of stars is summed
CELLS = (16, 7, 8)  # along the fleet, up, and away from the audience
CORNER = (-320.0, 0.0, -160.0)  # m, of the first cell
SMOKE_START, SMOKE_GROWTH = 3.5, 2.6  # m, m/√s
FORMS_S = 0.6  # s in which a puff comes up
WHITEST = (
    0.13  # share of a light that smoke gives back at most: what lies before takes it from what is behind
)


class Glow(NamedTuple):
    """How a kind shines, as numbers: see `LookOf`."""

    size: int
    dots: int
    tail_s: float
    bloom: float
    blink: float
    twinkle: float


@inner_kernel
def part_of(value):
    """What is behind the point of a number."""
    return value - math.floor(value)


@inner_kernel
def pack(red, green, blue):
    """0xRRGGBB of channels 0 to 255."""
    return (
        (int(min(red, 255.0) + 0.5) << 16) | (int(min(green, 255.0) + 0.5) << 8) | int(min(blue, 255.0) + 0.5)
    )


@inner_kernel
def strength_of(rows, i, glow, time):
    """How strongly a star shines at a time (s): strobes blink, sparks twinkle."""
    if glow.twinkle > 0.0:
        return 1.0 - glow.twinkle * part_of(rows[step.DIES, i] * 5717.3 + time * 11.3)
    if glow.blink > 0.0:
        phase = part_of(
            time * glow.blink * (0.7 + 0.6 * part_of(rows[step.DIES, i] * 31.7)) + rows[step.DIES, i] * 97.3
        )
        if phase > BLINK_SHARE:
            return 0.05
    return 1.0


@inner_kernel
def shade_at(rows, i, age, last):
    """Which of a kind's shades a star has at an age (s)."""
    return min(int(age / max(rows[step.DIES, i] - rows[step.BORN, i], 1e-9) * last), last)


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
        strength = strength_of(rows, i, glow, seen.time)
        at = shade_at(rows, i, age, last)
        red, green, blue = shades[at, 0] * strength, shades[at, 1] * strength, shades[at, 2] * strength
        x, along = turned(seen, rows[step.X, i], rows[step.Z, i])
        vx, away = turned(seen, rows[step.VX, i], rows[step.VZ, i])
        near = nearness(along - seen.back * away)
        vy = rows[step.VY, i]
        x -= seen.back * vx
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
def shed_light(rows, shades, glow, time, every, cells):
    """Add the light of a kind's stars ``rows`` (FIELDS, n) to the cells it falls from.

    cells (k, 7): sums of x, y, z by light, of red, green and blue, and of light. every: one in so many is
    taken, for all of those.
    """
    last = shades.shape[0] - 1
    weight = every * (1.0 if glow.size > 1 else 0.25 if glow.size == 1 else 0.06) / 255.0
    for i in range(0, rows.shape[1], every):
        age = time - rows[step.BORN, i]
        if age < 0.0:
            continue
        x, y, z = rows[step.X, i], rows[step.Y, i], rows[step.Z, i]
        across = min(max(int((x - CORNER[0]) / CELL), 0), CELLS[0] - 1)
        up = min(max(int((y - CORNER[1]) / CELL), 0), CELLS[1] - 1)
        back = min(max(int((z - CORNER[2]) / CELL), 0), CELLS[2] - 1)
        cell = (across * CELLS[1] + up) * CELLS[2] + back
        at = shade_at(rows, i, age, last)
        strength = weight * strength_of(rows, i, glow, time)
        light = strength * (shades[at, 0] + shades[at, 1] + shades[at, 2])
        cells[cell, 0] += light * x
        cells[cell, 1] += light * y
        cells[cell, 2] += light * z
        for channel in range(3):
            cells[cell, 3 + channel] += strength * shades[at, channel]
        cells[cell, 6] += light


@lean_kernel
def light_smoke(rows, flashes, lamps, seen, ambient, places, radii, colors, shares):
    """Write smoke ``rows`` (FIELDS, n) as it is lit by ``flashes`` (m, 7): s, x, y, z, r, g, b; how many.

    lamps (k, 6): x, y, z m of stars' light, and its red, green and blue. ambient (4,): red, green, blue of
    the sky's light, and how much of it smoke gives back.
    """
    line = 0
    for i in range(rows.shape[1]):
        age = seen.time - rows[step.BORN, i]
        life = rows[step.DIES, i] - rows[step.BORN, i]
        if age < 0.0 or line >= places.shape[0]:
            continue
        x = rows[step.X, i] - seen.back * rows[step.VX, i]
        y = rows[step.Y, i] - seen.back * rows[step.VY, i]
        z = rows[step.Z, i] - seen.back * rows[step.VZ, i]
        red, green, blue = ambient[0] * ambient[3], ambient[1] * ambient[3], ambient[2] * ambient[3]
        for j in range(flashes.shape[0]):
            since = seen.time - flashes[j, 0]
            if since < 0.0 or since > 6.0 * FLASH_FADES:
                continue
            dx, dy, dz = x - flashes[j, 1], y - flashes[j, 2], z - flashes[j, 3]
            light = SMOKE_LIT * elementary.exp(-since / FLASH_FADES)
            light = light / (1.0 + (dx * dx + dy * dy + dz * dz) / (FLASH_REACH * FLASH_REACH))
            red += light * flashes[j, 4]
            green += light * flashes[j, 5]
            blue += light * flashes[j, 6]
        for j in range(lamps.shape[0]):
            dx, dy, dz = x - lamps[j, 0], y - lamps[j, 1], z - lamps[j, 2]
            light = STAR_LIT / (1.0 + (dx * dx + dy * dy + dz * dz) / (STAR_REACH * STAR_REACH))
            red += light * lamps[j, 3]
            green += light * lamps[j, 4]
            blue += light * lamps[j, 5]
        most = max(red, green, blue, 1e-6)
        strength = most / (1.0 + most / WHITEST)
        across, along = turned(seen, x, z)
        near = nearness(along)
        radius = SMOKE_START + SMOKE_GROWTH * math.sqrt(age)
        thin = SMOKE_START * SMOKE_START * 4.0 / (radius * radius)  # as much smoke on a larger disc
        places[line, 0] = seen.middle + near * (across - seen.middle)
        places[line, 1] = EYE + near * (y - EYE)
        radii[line] = near * radius
        colors[line] = pack(255.0 * red / most, 255.0 * green / most, 255.0 * blue / most)
        left = max(1.0 - age / max(life, 1e-9), 0.0)
        shares[line] = strength * min(age / FORMS_S, 1.0) * min(2.0 * left, 1.0) * min(thin, 1.0)
        line += 1
    return line
