"""A drill of one's own: balls placed freely, a ball and the pocket it is for, a zone where the cue ball is to
stop. Last, how many of how many tries must do it.
"""

from __future__ import annotations

from game.billiards.game.goals import Goal, Pot, Zone
from game.billiards.game.rules import CUE_BALL
from game.billiards.table.rack import BALL_RADIUS
from game.physics.kernels import elementary
from game.scenes.billiards import layout
from game.scenes.billiards.level import BilliardsContent, PlacedBall
from game.scenes.billiards.modes import SetUp
from game.scenes.billiards.play import AIMING, SET_UP, Play
from game.stage import Part

LEAST_ZONE, LARGEST_ZONE = BALL_RADIUS, 0.6  # m; its radius
MOST_TRIES = 100
Point = tuple[float, float]


class DrillMaker(Part):
    """making: a goal is set, too, while the balls are placed. ball, pocket: to be potted, None while not
    chosen; zone: x, y, radius m, None without one. needed of tries. moved: the ball that is held has been
    moved since it was grasped.
    """

    def __init__(self, play: Play, set_up: SetUp) -> None:
        self.play = play
        self.set_up = set_up
        self.making = False
        self.ball: int | None = None
        self.pocket: int | None = None
        self.zone: tuple[float, float, float] | None = None
        self.tries, self.needed = 10, 7
        self.moved = False

    @property
    def active(self) -> bool:
        """True while a drill is made."""
        return self.making and self.play.phase == SET_UP

    def toggle(self) -> None:
        """Set a goal as well, or only the balls."""
        self.making = not self.making

    def click(self, x: float, y: float) -> bool:
        """Choose the ball or the pocket at a point; once more takes it back. False if there is none."""
        frame = self.play.model.frame
        for row, (px, py, radius) in enumerate(frame.table.pockets.tolist()):
            if layout.near((px, py), x, y, radius):
                self.pocket = None if self.pocket == row else row
                return True
        for number, bx, by in frame.layout.places:
            if number != CUE_BALL and layout.near((bx, by), x, y, BALL_RADIUS):
                self.ball = None if self.ball == number else number
                return True
        return False

    def begin_zone(self, x: float, y: float) -> bool:
        """A zone about a point of the cloth; False beside it."""
        table = self.play.model.frame.table
        if not (0.0 <= x <= table.width and 0.0 <= y <= table.length):
            return False
        self.zone = (x, y, LEAST_ZONE)
        return True

    def draw_zone(self, x: float, y: float) -> None:
        """The zone as large as the pointer is far from its middle."""
        if self.zone is not None:
            radius = elementary.hypot(x - self.zone[0], y - self.zone[1])
            self.zone = (*self.zone[:2], min(max(radius, LEAST_ZONE), LARGEST_ZONE))

    def clear_zone(self) -> None:
        """No zone."""
        self.zone = None

    def change_needed(self, notches: int) -> None:
        """So many more of the tries must meet the goal."""
        self.needed = min(max(self.needed + notches, 1), self.tries)

    def change_tries(self, notches: int) -> None:
        """So many more tries."""
        self.tries = min(max(self.tries + notches, 1), MOST_TRIES)
        self.needed = min(self.needed, self.tries)

    @property
    def lacking(self) -> str:
        """What is still missing, in a sentence; empty if the drill can be played."""
        frame = self.play.model.frame
        if frame.cue_ball is None:
            return "The cue ball is not on the table."
        if self._pots() is None:
            return "A ball is chosen and no pocket, or a pocket and no ball."
        if not self._pots() and self.zone is None:
            return "Click a ball and a pocket, or drag a zone on the cloth."
        return ""

    def _pots(self) -> tuple[Pot, ...] | None:
        """What is to be potted; None if only half of it is chosen."""
        on_table = self.play.model.frame.layout.numbers
        ball = self.ball if self.ball in on_table else None
        if (ball is None) != (self.pocket is None):
            return None
        return () if ball is None else (Pot(ball, self.pocket),)

    @property
    def content(self) -> BilliardsContent:
        """The drill as a level's content. ValueError while something is lacking."""
        if self.lacking:
            raise ValueError(self.lacking)
        zones = () if self.zone is None else (Zone(CUE_BALL, *(round(value, 4) for value in self.zone)),)
        balls = [PlacedBall(number=n, position=(x, y)) for n, x, y in self.play.model.frame.layout.places]
        return BilliardsContent(
            game="drill", balls=balls, goal=Goal(pots=self._pots() or (), zones=zones), tries=self.tries,
            needed=self.needed,
        )  # fmt: skip

    def finish(self) -> None:
        """Play the drill; a message says what is lacking, if it cannot be."""
        if self.lacking:
            self.play.messages.say(f"The drill cannot be played yet. {self.lacking}")
            return
        self.play.model.begin(self.content)
        self.play.parameters.game = "level"  # and not another game in its place
        self.making = False
        self.play.let_go()
        self.play.start_phase(AIMING)
        self.play.messages.say("Your drill. Ctrl+S keeps it as a level.")
