"""How near a stroke came that is measured against a place, to be kept and compared with others'."""

from __future__ import annotations

from typing import NamedTuple


class Scored(NamedTuple):
    """The last stroke at a task of that kind. strokes: played to their end so far. par: a good one's, m.

    distance: m from the place; None if the stroke did not do what else was asked, or none was played.
    """

    strokes: int
    distance: float | None
    par: float
