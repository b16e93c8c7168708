"""The bench on which a skeleton is edited: its figure, what the hand holds, and what can be taken back.

A bench is frozen, and each event gives another one. So a scene keeps it as a plain attribute and the stage
remembers it with the step. The pose itself is not on the bench: it moves, and belongs to the scene's state.
"""

from __future__ import annotations

from typing import NamedTuple

import msgspec
import numpy as np

from game.arrays import Floats
from game.physics.animation.skeleton_editing import NOWHERE
from game.scenes.skeletons.level import FigureContent, Point
from game.scenes.skeletons.rig import Rig

HISTORY = 64  # edits that can be taken back
REACH = 0.03  # of the height in view: how near to a thing the pointer takes it


class Memo(msgspec.Struct, frozen=True):
    """A figure and its pose (n + 2,), to go back to."""

    figure: FigureContent
    pose: tuple[float, ...]


class Bench(msgspec.Struct, frozen=True):
    """The figure and the hand on it. drawn: points of the skin being drawn, m. pointer: where the hand is.

    held: "" or what is dragged ("bone", "root"); grip: how it was taken. picked: first bone of a chain being
    picked, or NOWHERE. socket: where on the chosen bone a new one begins, m from its base; None: its end.
    message: what the last event has to say, or "".
    """

    figure: FigureContent
    chosen: int = NOWHERE
    picked: int = NOWHERE
    socket: float | None = None
    drawn: tuple[Point, ...] = ()
    pointer: Point = (0.0, 0.0)
    held: str = ""
    grip: tuple[float, float] = (0.0, 0.0)
    past: tuple[Memo, ...] = ()
    future: tuple[Memo, ...] = ()
    message: str = ""


class Turn(NamedTuple):
    """What came of an event: the bench, and the pose (n + 2,) that the figure is to take, or None."""

    bench: Bench
    pose: Floats | None = None


def reach_of(figure: FigureContent) -> float:
    """How near to a thing the pointer takes it, m."""
    return REACH * (figure.view.top - figure.view.bottom)


def with_message(bench: Bench, words: str) -> Bench:
    """The bench with something to say."""
    return msgspec.structs.replace(bench, message=words)


def remembered(bench: Bench, pose: Floats) -> Bench:
    """The bench with its present figure and pose to go back to."""
    memo = Memo(bench.figure, tuple(pose.tolist()))
    return msgspec.structs.replace(bench, past=(*bench.past, memo)[-HISTORY:], future=())


def undo(bench: Bench, rig: Rig) -> Turn:
    """Take the last edit back, or the last point drawn."""
    if bench.drawn:
        return Turn(msgspec.structs.replace(bench, drawn=bench.drawn[:-1]))
    if not bench.past:
        return Turn(with_message(bench, "There is nothing to undo."))
    future = (*bench.future, Memo(bench.figure, tuple(rig.now.tolist())))[-HISTORY:]
    return _as_it_was(bench, bench.past[-1], bench.past[:-1], future)


def redo(bench: Bench, rig: Rig) -> Turn:
    """Do again what was taken back last."""
    if not bench.future:
        return Turn(with_message(bench, "There is nothing to redo."))
    past = (*bench.past, Memo(bench.figure, tuple(rig.now.tolist())))[-HISTORY:]
    return _as_it_was(bench, bench.future[-1], past, bench.future[:-1])


def _as_it_was(bench: Bench, memo: Memo, past: tuple[Memo, ...], future: tuple[Memo, ...]) -> Turn:
    chosen = bench.chosen if bench.chosen < len(memo.figure.bones) else NOWHERE
    bench = Bench(memo.figure, chosen, pointer=bench.pointer, past=past, future=future)
    return Turn(bench, np.array(memo.pose))
