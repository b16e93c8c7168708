"""What a level of detection on a budget may say."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-10.0, le=10.0)]
Speed = Annotated[float, msgspec.Meta(ge=-50.0, le=50.0)]
Angle = Annotated[float, msgspec.Meta(ge=-1000.0, le=1000.0)]
Size = Annotated[float, msgspec.Meta(ge=0.01, le=3.0)]


class BodyEntry(LevelEntry, frozen=True, kw_only=True):
    """A body: its outline, size (m to its farthest corner), place (m), angle (rad), velocity (m/s), rate of
    turning (rad/s). Last what it is accelerated by (m/s²), as far as the bound allows.
    """

    kind: Literal["star", "comb", "letter", "coast"]
    variant: Annotated[int, msgspec.Meta(ge=0, le=99)] = 0
    size: Size
    place: tuple[Metre, Metre]
    angle: Angle = 0.0
    velocity: tuple[Speed, Speed] = (0.0, 0.0)
    spin: Angle = 0.0
    push: tuple[Speed, Speed] = (0.0, 0.0)


class SpaceTimeContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level: bodies, or none for as many as the parameter says, by chance; speed: of those
    (m/s) and twice their rate of turning (rad/s), at most; scale: of their sizes."""

    bodies: Annotated[tuple[BodyEntry, ...], msgspec.Meta(max_length=48)] = ()
    speed: Annotated[float, msgspec.Meta(ge=0.0, le=20.0)] = 1.2
    scale: Annotated[float, msgspec.Meta(ge=0.1, le=2.0)] = 1.0
    expected: Expectations = ()


DEFAULT = SpaceTimeContent()
