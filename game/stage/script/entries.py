"""What a story has come to, entry by entry: all that `course.Course` remembers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

NO_TEXTS: Mapping[int, str] = MappingProxyType({})


class Begun(NamedTuple):
    """A line has begun. text: a caption with its numbers. start, place, to: of a deed that takes time."""

    step: int
    time_s: float
    film_s: float
    line: int
    text: str = ""
    start: float = 0.0
    place: tuple[float, float] = (0.0, 0.0)
    to: tuple[float, float] = (0.0, 0.0)


class Turned(NamedTuple):
    """The condition of a moment has become true, or is so no more."""

    step: int
    time_s: float
    film_s: float
    line: int
    true: bool


class Reached(NamedTuple):
    """A moment was reached, or its deadline was (``missed``).

    since_s: when its condition became true, s simulated. texts: its first words by their lines, with the
    numbers of this step. typed: readouts among them that only repeat what the moment waited for.
    """

    step: int
    time_s: float
    film_s: float
    line: int
    missed: bool = False
    since_s: float = math.nan
    texts: Mapping[int, str] = NO_TEXTS
    typed: tuple[str, ...] = ()


class Dropped(NamedTuple):
    """Words were still waiting when what they were to tell was over."""

    step: int
    film_s: float
    line: int


class Held(NamedTuple):
    """The clock goes slowly, until a line (``line``) can say what is to be seen."""

    step: int
    time_s: float
    film_s: float
    line: int
    pace: float


class Ended(NamedTuple):
    """A deed that takes time has ended."""

    step: int
    film_s: float
    line: int


class Found(NamedTuple):
    """What an expectation came to."""

    step: int
    time_s: float
    expectation: int
    value: float
    holds: bool


Entry = Begun | Turned | Reached | Dropped | Held | Ended | Found
