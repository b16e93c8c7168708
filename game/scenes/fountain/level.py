"""What a level file of the particle fountain may say: nozzles, stones, single particles, the view."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.scenes.shared.insets import Zoom
from game.scenes.shared.repeats import Period
from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-1000.0, le=1000.0)]
Speed = Annotated[float, msgspec.Meta(ge=-10_000.0, le=10_000.0)]  # m/s
Point = tuple[Metre, Metre]

MOST_STONES = 32
MOST_NOZZLES = 8


class Nozzle(LevelEntry, frozen=True, kw_only=True):
    """Where particles come from. position: m; tilt: ° from straight up, clockwise; share: of the rate."""

    position: Point = (0.0, 0.0)
    tilt: Annotated[float, msgspec.Meta(ge=-180.0, le=180.0)] = 0.0
    share: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)] = 1.0


class Stone(LevelEntry, frozen=True, kw_only=True):
    """A round obstacle: centre and radius, m. restitution: its own; without, the one of the panel."""

    centre: Point
    radius: Annotated[float, msgspec.Meta(ge=1e-3, le=500.0)]
    restitution: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)] | None = None


class Particle(LevelEntry, frozen=True, kw_only=True):
    """A single particle that is there from the beginning: m, m/s."""

    position: Point
    velocity: tuple[Speed, Speed] = (0.0, 0.0)


class View(LevelEntry, frozen=True, kw_only=True):
    """The part of the world in view, m."""

    left: Metre = -4.7
    bottom: Metre = -0.45
    right: Metre = 5.1
    top: Metre = 4.75


class FountainContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a fountain level. floor: m; whirl: centre of the vortex, m; expected: of readouts.

    repeat: s after which it begins again; zoom: what an inset shows; paths: where the listed particles have
    been is drawn.
    """

    nozzles: Annotated[tuple[Nozzle, ...], msgspec.Meta(max_length=MOST_NOZZLES)] = (Nozzle(),)
    stones: Annotated[tuple[Stone, ...], msgspec.Meta(max_length=MOST_STONES)] = (
        Stone(centre=(0.2, 2.42), radius=0.45),
    )
    particles: Annotated[tuple[Particle, ...], msgspec.Meta(max_length=1000)] = ()
    floor: Metre = 0.0
    whirl: Point = (2.2, 2.6)
    expected: Expectations = ()
    repeat: Period = 0.0
    zoom: Zoom | None = None
    paths: bool = False
    view: View = View()
