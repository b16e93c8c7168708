"""What a level file of the rigid body scene may say: spheres one by one or as a rock, spin, the window."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec
import numpy as np

from game.arrays import Floats
from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-10_000_000.0, le=10_000_000.0)]
Length = Annotated[float, msgspec.Meta(ge=1e-6, le=10_000.0)]
FARTHEST = 1e15  # m, m/s, rad/s: what a level keeps of a body that a method has let run away
Far = Annotated[float, msgspec.Meta(ge=-FARTHEST, le=FARTHEST)]
Vector = tuple[Metre, Metre, Metre]
Fars = tuple[Far, Far, Far]
ColorName = Literal["ivory", "chalk", "green", "pink", "violet", "yellow", "vermilion", "stone"]

COLORS: tuple[str, ...] = ("ivory", "chalk", "green", "pink", "violet", "yellow", "vermilion", "stone")
MOST_SPHERES = 2_000
# columns of a design (n, 6): place m in the body's own frame, radius m, density over the panel's, colour
RADIUS, SHARE, COLOR = 3, 4, 5


class SphereEntry(LevelEntry, frozen=True, kw_only=True):
    """A sphere: position m (in the world, at first), radius m, density as a multiple of the panel's."""

    position: Annotated[tuple[Metre, ...], msgspec.Meta(min_length=2, max_length=3)]
    radius: Length
    density: Annotated[float, msgspec.Meta(ge=1e-6, le=1e6)] = 1.0
    color: ColorName = "ivory"


class RockEntry(LevelEntry, frozen=True, kw_only=True):
    """Spheres at random in an ellipsoid with these half axes (m), as ``seed`` has it."""

    half_axes: tuple[Length, Length, Length]
    spheres: Annotated[int, msgspec.Meta(ge=1, le=MOST_SPHERES)]
    radius: Length
    centre: Vector = (0.0, 0.0, 0.0)
    seed: Annotated[int, msgspec.Meta(ge=0, le=2**31)] = 0
    color: ColorName = "stone"


class RigidContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level of one rigid body.

    place: where its centre of mass is at first, m; else where the spheres as listed have it. velocity m/s
    and spin rad/s about the world's axes at first; orientation: a quaternion, scalar first, by which the
    spheres as listed are turned at first. window: half the sides of the box, m.
    expected: of readouts.
    """

    spheres: Annotated[tuple[SphereEntry, ...], msgspec.Meta(max_length=MOST_SPHERES)] = ()
    rocks: Annotated[tuple[RockEntry, ...], msgspec.Meta(max_length=20)] = ()
    place: Fars | None = None
    velocity: Fars = (0.0, 0.0, 0.0)
    spin: Fars = (0.0, 0.0, 0.0)
    orientation: tuple[float, float, float, float] = (1.0, 0.0, 0.0, 0.0)
    window: tuple[Length, Length, Length] = (4.0, 1.9, 1.5)
    expected: Expectations = ()


def design_of(content: RigidContent) -> Floats:
    """The spheres of a content, (n, 6). ValueError if there is none, or too many."""
    rows: list[tuple[float, ...]] = []
    for entry in content.spheres:
        x, y, z = (*entry.position, 0.0)[:3]
        rows.append((x, y, z, entry.radius, entry.density, COLORS.index(entry.color)))
    for rock in content.rocks:
        rows.extend(_rock(rock))
    if not 1 <= len(rows) <= MOST_SPHERES:
        raise ValueError(f"spheres: expected 1 to {MOST_SPHERES}, got {len(rows)}")
    return np.array(rows, dtype=np.float64)


def entries_of(design: Floats) -> tuple[SphereEntry, ...]:
    """A design as entries of a level file."""
    return tuple(
        SphereEntry(position=(x, y, z), radius=radius, density=share, color=COLORS[int(color)])  # type: ignore[arg-type]
        for x, y, z, radius, share, color in design.tolist()
    )


def _rock(rock: RockEntry) -> list[tuple[float, ...]]:
    """Spheres evenly in an ellipsoid: points of a cube are thrown away until one lies in the ball."""
    generator = np.random.default_rng(rock.seed)
    color = float(COLORS.index(rock.color))
    rows: list[tuple[float, ...]] = []
    while len(rows) < rock.spheres:
        x, y, z, size = (2.0 * generator.random(4) - 1.0).tolist()
        if x * x + y * y + z * z <= 1.0:
            a, b, c = rock.half_axes
            place = (rock.centre[0] + a * x, rock.centre[1] + b * y, rock.centre[2] + c * z)
            rows.append((*place, rock.radius * (1.0 + 0.35 * size), 1.0, color))
    return rows
