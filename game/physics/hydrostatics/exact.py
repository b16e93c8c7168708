"""Floating bodies that are exactly known: logs, beams, discs, planks; how they heave, sink and enter.

Plane problems: masses are for each metre of length. s is the density beside the liquid's.
"""

from __future__ import annotations

import math

from game.physics.kernels import elementary

G = 9.81
FLAT = (3.0 - math.sqrt(3.0)) / 6.0  # s up to which a square log floats flat
CORNER_UP = 9.0 / 32.0  # s from which it floats corner up
GAMMA_QUARTER = 3.625609908221908  # Euler's gamma function at 1/4


def checked_ratio(s: float) -> float:
    """ValueError unless above 0 and below 1."""
    if not 0.0 < s < 1.0:
        raise ValueError(f"s = {s!r}: expected a density ratio above 0 and below 1")
    return s


def square_log_tilt(s: float) -> float:
    """rad, of a side from the horizontal, 0 to pi/4 (Huygens 1650; Erdos, Schibler and Herndon 1992)."""
    s = min(checked_ratio(s), 1.0 - s)
    if s <= FLAT:
        return 0.0
    if s <= 0.25:
        return float(elementary.atan(math.sqrt(max(0.0, 12.0 * s * (1.0 - s) - 2.0))))
    if s <= CORNER_UP:
        root = math.sqrt(9.0 - 32.0 * s)
        return float(elementary.atan((3.0 - root) / (3.0 + root)))
    return 0.25 * math.pi


def beam_metacentre(width: float, height: float, s: float) -> float:
    """GM m of a beam that floats flat: b²/(12 s h) - h (1 - s)/2 (Bouguer 1746)."""
    return width * width / (12.0 * checked_ratio(s) * height) - 0.5 * height * (1.0 - s)


def least_beam(s: float) -> float:
    """Width over height from which a beam floats flat: sqrt(6 s (1 - s))."""
    return math.sqrt(6.0 * checked_ratio(s) * (1.0 - s))


def disc_draft(radius: float, s: float) -> tuple[float, float]:
    """Depth of a disc's lowest point, and width of its waterline, m: t - sin t cos t = pi s."""
    low, high, goal = 0.0, math.pi, math.pi * checked_ratio(s)
    for _ in range(80):
        middle = 0.5 * (low + high)
        if middle - elementary.sin(middle) * elementary.cos(middle) < goal:
            low = middle
        else:
            high = middle
    return radius * (1.0 - elementary.cos(low)), 2.0 * radius * elementary.sin(low)


def hinged_plank_angle(length: float, s: float, depth: float) -> float:
    """rad from the vertical, of a thin plank on a hinge so deep (m) below the surface: cos = D/(L sqrt s).

    Upright, 0, where the water is too deep for it to lean.
    """
    share = depth / (length * math.sqrt(checked_ratio(s)))
    return float(elementary.acos(share)) if share < 1.0 else 0.0


def heave_period(draft: float, gravity: float = G) -> float:
    """s, of a body with upright sides, without added mass: 2 pi sqrt(d/g)."""
    return math.tau * math.sqrt(draft / gravity)


def roll_period(width: float, height: float, s: float, gravity: float = G) -> float:
    """s, of a beam that floats flat, without added mass: 2 pi sqrt((b² + h²)/(12 g GM))."""
    metacentre = beam_metacentre(width, height, s)
    return math.tau * math.sqrt((width * width + height * height) / (12.0 * gravity * metacentre))


def tank_heave_period(
    width: float, tank: float, mass: float, density: float = 1000.0, gravity: float = G
) -> float:
    """s, in a tank so wide (m) that the level answers: the stiffness is rho g b W/(W - b)."""
    return math.tau * math.sqrt(mass * (tank - width) / (density * gravity * width * tank))


def puddle(width: float, height: float, s: float, pool: float) -> float:
    """m² of water that float a beam in a pool hardly wider: (W - b) s h."""
    return (pool - width) * checked_ratio(s) * height


def released(s: float, added: float = 1.0) -> float:
    """First acceleration upwards over g of a body let go in liquid; added: mass over the displaced one."""
    return (1.0 - s) / (s + added)


def ring_added_mass(radius: float, ring: float) -> float:
    """Added mass over the displaced one, of a disc in a fixed ring (Stokes 1843)."""
    return (ring * ring + radius * radius) / (ring * ring - radius * radius)


def square_added_mass() -> float:
    """Over rho a², of a square that moves along a side: 2 pi R² - 1, R its conformal radius (Lewis 1929)."""
    radius = GAMMA_QUARTER * GAMMA_QUARTER / (4.0 * math.pi * math.sqrt(math.pi))
    return 2.0 * math.pi * radius * radius - 1.0


def wedge_speed(mass: float, speed: float, wetted: float, density: float = 1000.0) -> float:
    """m/s, of a wedge that entered at a speed, by its wetted half width m (von Karman 1929)."""
    return speed * mass / (mass + 0.5 * math.pi * density * wetted * wetted)


def terminal_speed(diameter: float, s: float, drag: float, gravity: float = G) -> float:
    """m/s, of a disc that sinks: v² = pi g d (s - 1)/(2 C)."""
    return math.sqrt(0.5 * math.pi * gravity * diameter * (s - 1.0) / drag)


def terminal_way(diameter: float, s: float, drag: float, share: float = 0.9) -> float:
    """m, until a disc with added mass 1 has a share of its terminal speed, from rest."""
    return -(s + 1.0) * math.pi * diameter / (4.0 * drag) * float(elementary.log1p(-share * share))


def sphere_terminal_speed(diameter: float, s: float, drag: float, gravity: float = G) -> float:
    """m/s, of a ball that sinks: v² = 4 g d (s - 1)/(3 C) (Newton 1687)."""
    return math.sqrt(4.0 / 3.0 * gravity * diameter * (s - 1.0) / drag)
