"""How each kind shines: colour and strength over its life, size, tail, share in the bloom."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels import elementary, linear

SHADES = 64  # of a kind over its life
Rgb = tuple[float, float, float]  # 0 to 1
_WAVES_UM = (0.610, 0.549, 0.468)  # of red, green and blue, µm
_SECOND_RADIATION = 14_388.0  # µm K, of Planck's law
WHITE_HOT = 3_400.0  # K, shown as warm white


class LookOf(NamedTuple):
    """stops: (share of life, colour, strength). size: which of the canvas's GLOW_RADII. tail_s: how far back
    its dots reach, s. bloom: share of the light. blink: flashes a second (0: none). twinkle: 0 to 1.
    """

    stops: tuple[tuple[float, Rgb, float], ...]
    size: int = 1
    dots: int = 0
    tail_s: float = 0.0
    bloom: float = 0.05
    blink: float = 0.0
    twinkle: float = 0.0


def glowing(kelvin: float) -> Rgb:
    """Colour of a glowing body (Planck 1900 at three wavelengths), its brightest channel 1."""
    raw = [
        elementary.expm1(_SECOND_RADIATION / (wave * WHITE_HOT))
        / elementary.expm1(_SECOND_RADIATION / (wave * kelvin))
        for wave in _WAVES_UM
    ]
    tints = [channel * tint for channel, tint in zip(raw, (1.0, 0.86, 0.62), strict=True)]
    most = max(tints)
    return tints[0] / most, tints[1] / most, tints[2] / most


def cooling(hot: float, cold: float, strength: float, **more: object) -> LookOf:
    """A spark that cools, from a temperature (K) to another."""
    shares = (0.0, 0.15, 0.4, 0.7, 1.0)
    stops = tuple(
        (share, glowing(hot + (cold - hot) * share), strength * elementary.pow(1.0 - share, 1.4))
        for share in shares
    )
    return LookOf(stops, **more)  # type: ignore[arg-type]


def burning(color: Rgb, strength: float = 1.0, **more: object) -> LookOf:
    """A star of a colour: white at first, then its metal's colour, an ember in the end."""
    pale: Rgb = (0.5 + 0.5 * color[0], 0.5 + 0.5 * color[1], 0.5 + 0.5 * color[2])
    stops = (
        (0.0, (1.0, 1.0, 0.95), 1.0 * strength),
        (0.08, pale, 1.0 * strength),
        (0.25, color, 1.0 * strength),
        (0.8, color, 0.9 * strength),
        (0.94, glowing(1500.0), 0.35 * strength),
        (1.0, glowing(1200.0), 0.0),
    )
    settings: dict[str, object] = {"size": 2, "dots": 11, "tail_s": 0.26, "bloom": 0.22, **more}
    return LookOf(stops, **settings)  # type: ignore[arg-type]


RED, GREEN, BLUE = (1.0, 0.22, 0.14), (0.30, 1.0, 0.36), (0.26, 0.46, 1.0)  # strontium, barium, copper
LEMON, VIOLET, WHITE = (1.0, 0.82, 0.28), (0.74, 0.36, 1.0), (0.95, 0.97, 1.0)
CYAN, ROSE, GOLD = (0.26, 0.92, 0.95), (1.0, 0.30, 0.52), (1.0, 0.70, 0.30)
LOOKS: dict[str, LookOf] = {
    "ember": cooling(2400.0, 1300.0, 0.85, size=0, bloom=0.05, twinkle=0.5),
    "cinder": cooling(2600.0, 1350.0, 0.8, size=0, bloom=0.035, twinkle=0.6),
    "glitter": cooling(2900.0, 1500.0, 0.7, size=0, bloom=0.025, twinkle=0.8),
    "silver": LookOf(
        ((0.0, WHITE, 0.75), (0.5, WHITE, 0.35), (1.0, WHITE, 0.0)), 0, bloom=0.025, twinkle=0.7
    ),
    "crack": LookOf(((0.0, WHITE, 1.0), (0.4, LEMON, 0.9), (1.0, GOLD, 0.0)), 1, bloom=0.16),
    "lift": cooling(2900.0, 1400.0, 0.9, size=0, dots=2, tail_s=0.04, bloom=0.05),
    "red": burning(RED),
    "green": burning(GREEN),
    "blue": burning(BLUE, bloom=0.3),
    "lemon": burning(LEMON),
    "violet": burning(VIOLET, bloom=0.26),
    "white": burning(WHITE),
    "gilt": burning(GOLD, 0.95, size=1, dots=4, tail_s=0.06),
    "weeping": cooling(2500.0, 1500.0, 0.9, size=1, bloom=0.06),
    "cyan": burning(CYAN, bloom=0.3),
    "frond": burning(GOLD, 1.0, size=3, dots=4, tail_s=0.06, bloom=0.4),
    "split": burning(LEMON, size=3, dots=6, tail_s=0.1, bloom=0.3),
    "cross": burning(WHITE, size=1, dots=5, tail_s=0.1),
    "magnesium": LookOf(((0.0, WHITE, 1.0), (0.85, WHITE, 1.0), (1.0, WHITE, 0.0)), 2, bloom=0.35, blink=3.0),
    "whirl": burning(GREEN, dots=5, tail_s=0.1),
    "lace": burning(GOLD, 0.95, size=1, dots=3, tail_s=0.05, bloom=0.1),
    "rose": burning(ROSE, dots=6, tail_s=0.12, bloom=0.3),
    "popping": burning(RED, 0.8, size=1),
}
SHELL_LOOK = LookOf(((0.0, GOLD, 0.7), (1.0, GOLD, 0.5)), 1, 4, 0.05, 0.10)
COMET_LOOK = LookOf(((0.0, (1.0, 0.93, 0.8), 1.0), (0.9, GOLD, 1.0), (1.0, GOLD, 0.3)), 3, 6, 0.06, 0.5)

FLASH_COLORS: dict[str, Rgb] = {  # of the light of a burst on smoke and sky
    "peony": RED, "peony-blue": BLUE, "peony-green": GREEN, "dahlia": VIOLET, "ring": CYAN, "heart": ROSE,
    "spiral": GREEN, "strobe": WHITE, "rocket": WHITE, "crackle": RED,
}  # fmt: skip


def look_of(kind: str) -> LookOf:
    """The look of a kind; shells glow a little, comets strongly."""
    if kind == "comet":
        return COMET_LOOK
    return LOOKS.get(kind, SHELL_LOOK)


def shades_of(look: LookOf) -> NDArray[np.float64]:
    """(SHADES, 3) red, green and blue, 0 to 255, over the life."""
    at = np.linspace(0.0, 1.0, SHADES)
    shares = [stop[0] for stop in look.stops]
    strength = linear.interpolated(at, shares, [stop[2] for stop in look.stops])
    channels = [
        linear.interpolated(at, shares, [stop[1][c] for stop in look.stops]) * strength for c in range(3)
    ]
    return 255.0 * np.stack(channels, axis=1)
