"""Where a story looks on the billiard table, and what it calls single things there."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.billiards.game.frame import Played
from game.billiards.game.rules import CUE_BALL, Pocketing
from game.billiards.laws.state import BALL_POCKET
from game.scenes.billiards.play import PHASE_S, ROLLING, Play
from game.scenes.billiards.story.throw import Contact, first_contact

Point = tuple[float, float]
AHEAD_S, BACK_S = 0.4, 0.3  # s of the shot to each side of the present moment that the play is taken from
TURN_S, THERE_S = 1.3, 0.5  # s before a ball falls that one begins to look at the pocket, and does
ROOM = (0.25, 0.45)  # m across and along the table that the middle of the play keeps from the cushions


class StrokeSeen:
    """What a story sees of the last stroke; found once for each, and no part of the state."""

    def __init__(self, play: Play) -> None:
        self.play = play
        self._of: object = None
        self._contact: Contact | None = None
        self._falls: tuple[tuple[float, Pocketing], ...] = ()

    @property
    def shot_s(self) -> float:
        """s since the hit; infinite once the balls lie still."""
        return float(self.play.clock[PHASE_S]) if self.play.phase == ROLLING else math.inf

    @property
    def numbers(self) -> tuple[int, ...]:
        """The balls of the last stroke, in the order of its paths."""
        last = self.play.model.frame.last
        return () if last is None else last.frame.layout.numbers

    def _look(self) -> Played | None:
        played = self.play.model.played
        if played is not None and played is not self._of:
            self._of = played
            self._contact = first_contact(played, self.numbers)
            self._falls = _falls(played, self.numbers)
        return played

    @property
    def contact(self) -> Contact | None:
        """The first contact of the stroke, once it has come."""
        if self._look() is None or self._contact is None:
            return None
        return self._contact if self._contact.time <= self.shot_s else None

    @property
    def fallen(self) -> tuple[Pocketing, ...]:
        """Balls that have gone down in the stroke so far."""
        return () if self._look() is None else tuple(one for at, one in self._falls if at <= self.shot_s)

    @property
    def falling(self) -> Pocketing | None:
        """The ball of the stroke that goes down first, before and after it does; None if none does."""
        return self._falls[0][1] if self._look() is not None and self._falls else None

    def place_of(self, number: int) -> Point | None:
        """Where a ball is now, m; None if it is not on the table."""
        play = self.play
        if play.phase == ROLLING and self._look() is not None and number in self.numbers:
            x, y = play.model.places[number].tolist()
            return x, y
        return play.model.frame.layout.place_of(number)

    def play_now(self) -> Point:
        """The middle of the balls that a stroke is about while it rolls, and then the pocket; else the cue
        ball, m.
        """
        played, falling = self._look(), self.falling
        if self.play.phase != ROLLING or played is None or falling is None:
            return self._kept(np.array(self.place_of(CUE_BALL) or self.middle()))
        rows = [self.numbers.index(ball) for ball in {CUE_BALL, *falling.chain} if ball in self.numbers]
        at = self.shot_s
        points = np.concatenate(
            [played.trajectory.state_at(max(at + d, 0.0)).positions[rows] for d in (-BACK_S, 0.0, AHEAD_S)]
        )
        middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
        share = min(max((at - self._falls[0][0] + TURN_S) / (TURN_S - THERE_S), 0.0), 1.0)
        share *= share * (3.0 - 2.0 * share)
        pocket = self.play.model.frame.table.pockets[falling.pocket, :2]
        return self._kept(middle + share * (pocket - middle))

    def _kept(self, place: Floats) -> Point:
        """The nearest place about which a picture has little beside the table, m."""
        table = self.play.model.frame.table
        low, size = np.array(ROOM), np.array((table.width, table.length))
        return _point(np.clip(place, low, size - low))

    def middle(self) -> Point:
        """The middle of the table, m."""
        table = self.play.model.frame.table
        return 0.5 * table.width, 0.5 * table.length

    def targets(self) -> dict[str, Point]:
        """The play, the cue ball, the ball that goes down and its pocket, the object ball; m.

        The play and the ball that goes down keep from the cushions: at a pocket one would see more floor
        than table.
        """
        falling, contact = self.falling, self.contact
        table = self.play.model.frame.table
        pocket = self.middle() if falling is None else _point(table.pockets[falling.pocket, :2])
        ball = pocket if falling is None else self.place_of(falling.ball) or pocket
        struck = None if contact is None else self.place_of(contact.ball)
        cue_ball = self.place_of(CUE_BALL) or self.middle()
        return {
            "table": self.middle(),
            "play": self.play_now(),
            "cue ball": cue_ball,
            "ball": self._kept(np.array(ball)),
            "pocket": pocket,
            "object ball": struck or cue_ball,
        }

    def sizes(self) -> dict[str, float]:
        """Diameters of the balls and of the pocket, m."""
        falling, contact = self.falling, self.contact
        frame = self.play.model.frame
        radii = frame.layout.balls.radii.tolist()
        found = {"cue ball": 2.0 * radii[CUE_BALL]}
        if falling is not None:
            found["ball"] = 2.0 * radii[falling.ball]
            found["pocket"] = 2.0 * float(frame.table.pockets[falling.pocket, 2])
        if contact is not None:
            found["object ball"] = 2.0 * radii[contact.ball]
        return found

    def names(self) -> list[tuple[Point, str]]:
        """The cue ball by its speed, the object ball by cut and throw, the others of the play by number."""
        found = []
        contact, at = self.contact, self.place_of(CUE_BALL)
        if at is not None:
            found.append((at, "cue ball"))
        if contact is not None and (place := self.place_of(contact.ball)) is not None:
            cut, throw = math.degrees(contact.cut), math.degrees(contact.throw)
            found.append((place, f"{contact.ball}: cut {cut:.0f}°, thrown {throw:.1f}°"))
        falling = self.falling
        if falling is not None and (contact is None or falling.ball != contact.ball):
            place = self.place_of(falling.ball)
            if place is not None:
                found.append((place, str(falling.ball)))
        return found


def _falls(played: Played, numbers: tuple[int, ...]) -> tuple[tuple[float, Pocketing], ...]:
    """When balls go down, s since the hit, and how, in the order of time."""
    known = {one.ball: one for one in played.summary.pocketed}
    return tuple(
        (float(time), known[numbers[int(ball)]])
        for time, code, ball, _ in played.trajectory.rows.tolist()
        if int(code) == BALL_POCKET and numbers[int(ball)] in known
    )


def _point(place: Floats) -> Point:
    x, y = place.tolist()
    return x, y
