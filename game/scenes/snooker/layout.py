"""Where everything round the snooker table lies, in the world's metres, so that the hand finds it at every
size.

The picture is turned: x runs down and y to the right. Measures are design px of a table drawn with PIXELS
to a metre; the frame has the sides of a window of 16 : 9.
"""

from __future__ import annotations

import math

from game.billiards.table.snooker import BALL_RADIUS, COLOURS
from game.billiards.table.table import CUSHION_DEPTH, SNOOKER_LENGTH, SNOOKER_WIDTH
from game.physics.kernels import elementary
from game.scenes.shared.tables.boxes import Box
from game.stage import Frame

PIXELS = 288.0  # design px to a metre: the frame is 1280 by 720 of them
LEAST_PIXELS = 90.0  # px to a metre; a smaller picture shows the table alone
RIM = CUSHION_DEPTH + 0.074  # m; cushion and wood
REACH = 1.5  # radii within which a ball is grasped


def metres(pixels: float) -> float:
    """Design px in metres."""
    return pixels / PIXELS


TABLE = Box(-RIM, -RIM, SNOOKER_WIDTH + RIM, SNOOKER_LENGTH + RIM)
SIDE = 0.5 * (metres(1280.0) - (TABLE.right - TABLE.left))  # of the gutters left and right
ROW = 0.5 * (metres(720.0) - (TABLE.bottom - TABLE.top))  # of the frame above and below the table
FRAME = Frame(TABLE.top - ROW, TABLE.left - SIDE, TABLE.bottom + ROW, TABLE.right + SIDE)
BOARD = Box(TABLE.top - ROW + metres(6.0), TABLE.left, TABLE.top - metres(5.0), TABLE.right)
FOOT = Box(TABLE.bottom + metres(2.0), TABLE.left, TABLE.bottom + metres(29.0), TABLE.right)

CARD, CARD_FROM = (
    296.0,
    146.0,
)  # design px: width of a card, and of what lies beside both: title, window's bar
ASKED = 300.0  # design px: width of the words before the options
LEFT_MIDDLE, RIGHT_MIDDLE = TABLE.left - 0.5 * SIDE, TABLE.right + 0.5 * SIDE
POWER = Box(TABLE.top, TABLE.left - SIDE, TABLE.bottom, TABLE.left - metres(4.0))
POWER_TOP, POWER_FOOT = metres(52.0), metres(68.0)  # of its box that are not the bar: see gauges.draw_power
SPIN, SPIN_RADIUS = (TABLE.top + metres(50.0), RIGHT_MIDDLE), metres(30.0)
ELEVATION = (TABLE.top + metres(206.0), RIGHT_MIDDLE - metres(20.0))  # pivot
ELEVATION_RADIUS = metres(40.0)
NUMBERS_TOP, NUMBERS_PITCH = TABLE.top + metres(252.0), metres(48.0)  # of the numbers below each other
BUTTON_HEIGHT, BUTTON_GAP = metres(26.0), metres(2.5)  # eight of them leave space for numbers
CHIP, CHIP_PITCH = metres(11.0), metres(32.0)  # radius of a colour to be nominated, and from one to the next
CHIPS_RIGHT = FOOT.right - metres(18.0)


def button_box(row: int) -> Box:
    """The button of that number at the right of the table, counted from below."""
    bottom = TABLE.bottom - row * (BUTTON_HEIGHT + BUTTON_GAP)
    half = metres(43.0)
    return Box(bottom - BUTTON_HEIGHT, RIGHT_MIDDLE - half, bottom, RIGHT_MIDDLE + half)


def option_box(row: int, count: int) -> Box:
    """The box of one of several options, side by side below the table."""
    gap, left = metres(8.0), FOOT.left + metres(ASKED)
    width = min((FOOT.right - left + gap) / count - gap, metres(330.0))
    left += row * (width + gap)
    return Box(FOOT.top, left, FOOT.bottom, left + width)


def card_box(player: int) -> Box:
    """The card of a player on the score board."""
    width = metres(CARD)
    left = BOARD.left + metres(CARD_FROM) if player == 0 else BOARD.right - metres(CARD_FROM) - width
    return Box(BOARD.top, left, BOARD.bottom, left + width)


def chip_place(colour: int) -> tuple[float, float]:
    """Where a colour can be nominated below the table (x, y), m."""
    return FOOT.middle[0], CHIPS_RIGHT - (COLOURS[-1] - colour) * CHIP_PITCH


def chip_at(x: float, y: float) -> int | None:
    """The colour to be nominated at a point."""
    return next((c for c in COLOURS if elementary.dist(chip_place(c), (x, y)) <= 1.4 * CHIP), None)


def power_at(x: float, top_speed: float) -> float:
    """Speed m/s that the power bar says at a height x of the picture."""
    zero, full = POWER.bottom - POWER_FOOT, POWER.top + POWER_TOP
    return top_speed * min(max((zero - x) / (zero - full), 0.0), 1.0)


def spin_at(x: float, y: float, most: float) -> tuple[float, float]:
    """Offset of the tip (left, up) in radii at a point of the spin picture, at most ``most`` off."""
    up, left = (SPIN[0] - x) / SPIN_RADIUS, (SPIN[1] - y) / SPIN_RADIUS
    length = elementary.hypot(up, left)
    shrink = min(1.0, most / length) if length > 0.0 else 1.0
    return left * shrink, up * shrink


def on_spin(x: float, y: float) -> bool:
    """True on the picture of the cue ball."""
    return elementary.dist(SPIN, (x, y)) <= 1.2 * SPIN_RADIUS


def on_elevation(x: float, y: float) -> bool:
    """True on the picture of the elevation."""
    up, right = ELEVATION[0] - x, y - ELEVATION[1]
    reach = ELEVATION_RADIUS + metres(12.0)
    return -metres(10.0) <= up <= reach and -metres(10.0) <= right <= reach


def elevation_at(x: float, y: float) -> float:
    """Elevation, degrees, that its picture says at a point."""
    return math.degrees(min(max(elementary.atan2(ELEVATION[0] - x, y - ELEVATION[1]), 0.0), 0.5 * math.pi))


def near(place: tuple[float, float], x: float, y: float) -> bool:
    """True on a ball, or close by it."""
    return elementary.dist(place, (x, y)) <= REACH * BALL_RADIUS
