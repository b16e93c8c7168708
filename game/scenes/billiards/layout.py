"""Where everything round the table lies, in the world's metres, so that the hand finds it at every size.

The picture is turned: x runs down and y to the right. Measures are design px of a table drawn with
PIXELS to a metre; what draws them scales its letters and lines likewise. The frame has the sides of a
window of 16 : 9: the board stands in the row of the window's bar, the foot above that of its hints.
"""

from __future__ import annotations

import math

from game.billiards.table.table import BED_LENGTH, BED_WIDTH, CUSHION_DEPTH
from game.physics.kernels import elementary
from game.scenes.shared.tables.beside.coach import POCKETS
from game.scenes.shared.tables.boxes import Box, rect_of
from game.stage import Frame

__all__ = ["Box", "rect_of"]
PIXELS = 403.0  # design px to a metre: the frame is 1280 by 720 of them
WOOD = 0.074  # m
RIM = CUSHION_DEPTH + WOOD

# names of the pockets as they are seen in the turned picture, in the order of the table's rows. The table's
# own (`table.POCKET_NAMES`) are of its frame; they are ids in files, and not for people

REACH = 1.4  # radii within which a round thing is grasped
LEAST_PIXELS = 120.0  # px to a metre; a smaller picture shows the table alone


def metres(pixels: float) -> float:
    """Design px in metres."""
    return pixels / PIXELS


ASKED = 270.0  # design px: width of the words before the options
CARD, CARD_FROM = 352.0, 144.0  # design px: width of a player's card, and where it begins
SIDE = metres(80.0)  # of the gutters left and right
ROW = metres(56.0)  # of the frame above and below the table

TABLE = Box(-RIM, -RIM, BED_WIDTH + RIM, BED_LENGTH + RIM)
BOARD = Box(TABLE.top - ROW + metres(5.0), TABLE.left, TABLE.top - metres(5.0), TABLE.right)
FOOT = Box(TABLE.bottom + metres(2.0), TABLE.left, TABLE.bottom + metres(28.0), TABLE.right)
FRAME = Frame(TABLE.top - ROW, TABLE.left - SIDE, TABLE.bottom + ROW, TABLE.right + SIDE)

LEFT_MIDDLE = TABLE.left - 0.5 * SIDE
RIGHT_MIDDLE = TABLE.right + 0.5 * SIDE
POWER = Box(TABLE.top, TABLE.left - SIDE, TABLE.bottom, TABLE.left - metres(4.0))
POWER_TOP, POWER_FOOT = metres(52.0), metres(68.0)  # of its box that are not the bar: see gauges.draw_power

SPIN = (TABLE.top + metres(50.0), RIGHT_MIDDLE)
SPIN_RADIUS = metres(30.0)
ELEVATION = (TABLE.top + metres(206.0), RIGHT_MIDDLE - metres(20.0))  # pivot
ELEVATION_RADIUS = metres(40.0)
NUMBERS_TOP, NUMBERS_PITCH = TABLE.top + metres(252.0), metres(48.0)  # of the numbers below each other

BUTTON_HEIGHT, BUTTON_GAP = metres(26.0), metres(2.5)  # eight of them leave space for numbers
PLAY = Box(FOOT.top + metres(1.0), FOOT.left, FOOT.bottom - metres(1.0), FOOT.left + metres(64.0))
SPEED = Box(PLAY.top, PLAY.right + metres(8.0), PLAY.bottom, PLAY.right + metres(72.0))
SCRUBBER = Box(PLAY.top, SPEED.right + metres(20.0), PLAY.bottom, FOOT.right - metres(84.0))


def pocket_words(row: int) -> str:
    """The name of a pocket for people, as it is seen in game and film, by its row of the table."""
    return f"{POCKETS[row]} pocket"


def button_box(row: int) -> Box:
    """The button of that number at the right of the table, counted from below."""
    bottom = TABLE.bottom - row * (BUTTON_HEIGHT + BUTTON_GAP)
    return Box(bottom - BUTTON_HEIGHT, RIGHT_MIDDLE - metres(37.0), bottom, RIGHT_MIDDLE + metres(37.0))


def option_box(row: int, count: int) -> Box:
    """The box of one of several options, side by side below the table, where they cover no ball."""
    gap, left = metres(8.0), FOOT.left + metres(ASKED)
    width = min((FOOT.right - left + gap) / count - gap, metres(300.0))
    left += row * (width + gap)
    return Box(FOOT.top, left, FOOT.bottom, left + width)


def card_box(player: int) -> Box:
    """The card of a player on the score board."""
    width = metres(CARD)
    left = BOARD.left + metres(CARD_FROM) if player == 0 else BOARD.right - metres(CARD_FROM) - width
    return Box(BOARD.top, left, BOARD.bottom, left + width)


def power_at(x: float, top_speed: float) -> float:
    """Speed m/s that the power bar says at a height x of the picture."""
    zero, full = POWER.bottom - POWER_FOOT, POWER.top + POWER_TOP
    return top_speed * min(max((zero - x) / (zero - full), 0.0), 1.0)


def spin_at(x: float, y: float, most: float) -> tuple[float, float]:
    """Offset of the tip (left, up) in radii at a point of the spin picture, at most ``most`` off."""
    up, left = (SPIN[0] - x) / SPIN_RADIUS, (SPIN[1] - y) / SPIN_RADIUS
    length = math.sqrt(up * up + left * left)
    shrink = min(1.0, most / length) if length > 0.0 else 1.0
    return left * shrink, up * shrink


def spin_offset(left: float, up: float) -> tuple[float, float]:
    """Where the tip is in the spin picture, from its middle (x, y), m."""
    return -up * SPIN_RADIUS, -left * SPIN_RADIUS


def on_spin(x: float, y: float) -> bool:
    """True on the picture of the cue ball."""
    dx, dy = x - SPIN[0], y - SPIN[1]
    return dx * dx + dy * dy <= elementary.square(1.2 * SPIN_RADIUS)


def on_elevation(x: float, y: float) -> bool:
    """True on the picture of the elevation."""
    up, right = ELEVATION[0] - x, y - ELEVATION[1]
    reach = ELEVATION_RADIUS + metres(12.0)
    return -metres(10.0) <= up <= reach and -metres(10.0) <= right <= reach


def elevation_at(x: float, y: float) -> float:
    """Elevation, rad, that its picture says at a point."""
    return min(max(elementary.atan2(ELEVATION[0] - x, y - ELEVATION[1]), 0.0), 0.5 * math.pi)


def share_of_scrubber(y: float) -> float:
    """How far along the scrubber a point lies, 0 to 1."""
    return min(max((y - SCRUBBER.left) / (SCRUBBER.right - SCRUBBER.left), 0.0), 1.0)


def near(place: tuple[float, float], x: float, y: float, radius: float) -> bool:
    """True within reach of a round thing."""
    dx, dy = x - place[0], y - place[1]
    return dx * dx + dy * dy <= elementary.square(REACH * radius)


def tray_place(number: int) -> tuple[float, float]:
    """Where a ball lies in the tray below the table while it is not on it (x, y), m."""
    return 0.5 * (FOOT.top + FOOT.bottom), FOOT.left + metres(26.0) + number * metres(37.0)
