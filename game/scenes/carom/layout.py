"""Where table, score board, list of strokes and the picture of the tip lie, in the world's metres.

The picture is turned: x runs down and y to the right. Design px are those of a window of 1280 by 720.
"""

from __future__ import annotations

from game.billiards.table.carom import BALL_RADIUS
from game.billiards.table.table import CAROM_LENGTH, CAROM_WIDTH, CUSHION_DEPTH
from game.physics.kernels import elementary
from game.scenes.shared.tables.beside.column import Column
from game.scenes.shared.tables.boxes import Box
from game.stage import Frame

PIXELS = 300.0  # design px to a metre
LEAST_PIXELS = 100.0  # px to a metre; a smaller picture shows the table alone
RIM = CUSHION_DEPTH + 0.074  # m; cushion and wood
GAP = 0.05  # m

TABLE = Box(-RIM, -RIM, CAROM_WIDTH + RIM, CAROM_LENGTH + RIM)
FRAME = Frame(-0.36, -0.18, 2.04, 4.087)  # the window's hints cover its lowest tenth of a metre
BOARD = Box(-0.34, TABLE.left, TABLE.top - 0.02, TABLE.right)
COLUMN_LEFT, COLUMN_RIGHT = TABLE.right + GAP, FRAME.top - 0.03
LIST = Box(-0.20, COLUMN_LEFT, 1.23, COLUMN_RIGHT)  # below the window's buttons
HEAD, ROW = 0.155, 0.1405  # m; of the list
ROWS = 9
COLUMN = Column(LIST, 0.215, 0.119, 0.02)  # of the coach, in the place of the list
TIP = Box(1.26, COLUMN_LEFT, 1.93, COLUMN_RIGHT)
TIP_MIDDLE, TIP_RADIUS = (1.62, COLUMN_LEFT + 0.30), 0.25  # the ball; LARGEST_TIP is nearer
FOOT = Box(TABLE.bottom + 0.02, TABLE.left, 1.93, TABLE.right - 0.72)
BUTTONS = ("play", "strike", "undo", "next", "eye", "coach", "replay", "film-strokes")
IN_COLUMN = 4  # buttons below each other


def row_box(row: int) -> Box:
    """The box of a row of the list."""
    top = LIST.top + HEAD + row * ROW
    return Box(top, LIST.left, top + ROW - 0.012, LIST.right)


def row_at(x: float, y: float) -> int:
    """The row of the list at a point, -1 for none."""
    return next((row for row in range(ROWS) if row_box(row).holds(x, y)), -1)


def button_box(row: int) -> Box:
    """The button of that number, from above, right of the foot; the first column is the right one."""
    column, place = divmod(row, IN_COLUMN)
    top, right = FOOT.top + place * 0.094, TABLE.right - column * 0.34
    return Box(top, right - 0.32, top + 0.082, right)


def option_box(row: int, count: int) -> Box:
    """The box of one of several options, side by side in the foot."""
    width = (FOOT.right - FOOT.left) / max(count, 1)
    left = FOOT.left + row * width
    return Box(FOOT.top + 0.12, left, FOOT.top + 0.24, left + width - 0.03)


def tip_at(x: float, y: float, most: float) -> tuple[float, float]:
    """Offset of the tip (left, up) in radii at a point of its picture, at most `most` off."""
    up, left = (TIP_MIDDLE[0] - x) / TIP_RADIUS, (TIP_MIDDLE[1] - y) / TIP_RADIUS
    length = elementary.hypot(up, left)
    shrink = min(1.0, most / length) if length > 0.0 else 1.0
    return left * shrink, up * shrink


def on_tip(x: float, y: float) -> bool:
    """True on the picture of the ball that is struck."""
    return elementary.hypot(x - TIP_MIDDLE[0], y - TIP_MIDDLE[1]) <= 1.1 * TIP_RADIUS


def near(place: tuple[float, float], x: float, y: float) -> bool:
    """True on a ball, or close by it."""
    return elementary.hypot(x - place[0], y - place[1]) <= 1.3 * BALL_RADIUS
