"""Where the view from the cue lies over the table, and how the hand makes it larger and moves the eye."""

from __future__ import annotations

from typing import Any

from game.billiards.game.rules import CUE_BALL
from game.billiards.table.table import Table
from game.scenes.shared.tables.boxes import Box
from game.scenes.shared.tables.eye.choices import HIGHEST, LEAST_SIZE, LOWEST, MOST_SIZE
from game.stage import Part

SHAPE = 9.0 / 16.0  # height of the view for its breadth
EDGE = 0.015  # m from the cushions
USUAL = 0.36  # of the bed's length: by a view of that size the corner is chosen
HANDLE = 0.05  # m about the inner corner that are grasped
NOTCH = 0.04  # m that a notch of the wheel raises the eye

Places = list[tuple[float, float]]


class Inset(Part):
    """The view's box over a corner of the bed: the one that hides fewest balls, and not the cue ball.

    parameters: of a table, with those of `eye.choices`. model: with frame.
    """

    def __init__(self, parameters: Any, model: Any) -> None:
        self.parameters = parameters
        self.model = model

    @property
    def table(self) -> Table:
        """The table that is played on."""
        table: Table = self.model.frame.table
        return table

    def lying(self) -> tuple[tuple[float, float] | None, Places]:
        """Where the cue ball lies, and the others, m."""
        frame = self.model.frame
        return frame.cue_ball, [(x, y) for number, x, y in frame.layout.places if number != CUE_BALL]

    @property
    def box(self) -> Box | None:
        """Where it lies, in the world's metres; None if it is not shown."""
        if not self.parameters.eye:
            return None
        far, low = corner_for(self.table, *self.lying())
        return box_at(self.table, far, low, float(self.parameters.eye_size))

    def holds(self, x: float, y: float) -> bool:
        """True on the view."""
        box = self.box
        return box is not None and box.holds(x, y)

    def grasps(self, x: float, y: float) -> bool:
        """True on the corner that makes the view larger."""
        box = self.box
        if box is None:
            return False
        cx, cy = inner_corner(box, self.table)
        return abs(x - cx) <= HANDLE and abs(y - cy) <= HANDLE

    def drag(self, x: float, y: float) -> None:
        """The inner corner follows the pointer, as far as the view may grow."""
        box, table = self.box, self.table
        if box is None:
            return
        far, low = _side(box, table)
        wide = (box.right - y) if far else (y - box.left)
        high = (box.bottom - x) if low else (x - box.top)
        share = max(wide, high / SHAPE) / table.length
        self.parameters.eye_size = round(min(max(share, LEAST_SIZE), MOST_SIZE), 3)

    def wheel(self, notches: float) -> None:
        """Raise or lower the eye."""
        height = float(self.parameters.eye_height) + NOTCH * notches
        self.parameters.eye_height = round(min(max(height, LOWEST), HIGHEST), 3)


def corner_for(table: Table, cue_ball: tuple[float, float] | None, others: Places) -> tuple[bool, bool]:
    """Which corner: at the far end (right in the picture), at the lower side."""
    best, least = (True, False), float("inf")
    for far in (True, False):
        for low in (False, True):
            box = box_at(table, far, low, USUAL)
            hidden = sum(_near(box, place) for place in others)
            mark = hidden + (100.0 if cue_ball is not None and _near(box, cue_ball) else 0.0)
            if mark < least:
                best, least = (far, low), mark
    return best


def box_at(table: Table, far: bool, low: bool, share: float) -> Box:
    """A box over a corner of the bed, as broad as a share of its length."""
    wide = share * table.length
    high = min(SHAPE * wide, table.width - 2.0 * EDGE)
    left = table.length - wide - EDGE if far else EDGE
    top = table.width - high - EDGE if low else EDGE
    return Box(top, left, top + high, left + wide)


def inner_corner(box: Box, table: Table) -> tuple[float, float]:
    """The corner (x, y) m of a box that lies towards the middle of the bed."""
    far, low = _side(box, table)
    return (box.top if low else box.bottom), (box.left if far else box.right)


def _side(box: Box, table: Table) -> tuple[bool, bool]:
    """Whether a box lies at the far end, and at the lower side."""
    return box.left > table.length - box.right, box.top > table.width - box.bottom


def _near(box: Box, place: tuple[float, float]) -> bool:
    return Box(box.top - 0.04, box.left - 0.04, box.bottom + 0.04, box.right + 0.04).holds(*place)
