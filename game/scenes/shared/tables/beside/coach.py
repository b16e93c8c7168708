"""The coach: what the last stroke was worth, why it missed and what it left; and the next one, if asked.

It is worked out in a thread of its own. Nothing of it belongs to the state but that it was asked before a
stroke (`coached` of the course), which the score then says.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from game.billiards.game.arrangement import Stroke
from game.billiards.map.causes import Cause
from game.scenes.shared.newest import Newest

POCKETS = ("upper left", "lower left", "upper middle", "lower middle", "upper right", "lower right")
SHOWN = ("aiming", "replay")  # phases, as of `course` and of pool's `play`
SURE = 0.02  # by which a chance is not worse than another one


class Way(NamedTuple):
    """A stroke that there is or was: its chance, what it does in words, how it is struck in words."""

    chance: float
    words: str
    stroke: str = ""


class Told(NamedTuple):
    """What there is to say of a stroke.

    tried: what it was to do, None if that was nothing that counts; aimed: the ball that it was aimed at in
    vain. foul: it did what it was to, and was a foul. strayed: as it was meant it does. best: the surest that
    there was. left: the surest of the position it left. shooter: who played; next_shooter: who is at turn.
    """

    shooter: str
    next_shooter: str
    over: bool
    tried: Way | None = None
    aimed: str = ""
    made: bool = False
    foul: bool = False
    strayed: bool = False
    causes: tuple[Cause, ...] = ()
    best: Way | None = None
    left: Way | None = None

    @property
    def surest(self) -> bool:
        """True if what was tried was the surest, or as good."""
        best, tried = self.best, self.tried
        if best is None or tried is None:
            return False
        return best.words == tried.words or tried.chance >= best.chance - SURE


class Speech(NamedTuple):
    """Words in which one table's coach differs from another's."""

    made: str = "it went down"
    right: str = "put right alone, it falls"
    nothing_right: str = "nothing put right alone pots it"
    untried: tuple[str, str] = ("no pot was tried", "a safety, or by a cushion first")
    in_vain: str = "on this line it goes into no pocket"
    none: tuple[str, str] = ("no pot in sight", "a safety, or a kick")
    best: str = "the chance of the best pot"
    key: str = "Q"


class Coach:
    """What is known of the last stroke, and of the next. Subclasses know a table's maps.

    course: with phase, model, parameters, may_aim and advised.
    """

    speech = Speech()

    def __init__(self, course: Any, radius: float) -> None:
        self.course = course
        self.radius = radius
        self.after: Newest[Told] = Newest("coach")
        self.ahead: Newest[Way | None] = Newest("coach ahead")

    # -- for subclasses -----------------------------------------------------------------------------

    @property
    def shown(self) -> bool:
        """True while the card is seen."""
        return bool(self.course.parameters.coach)

    @property
    def hand_words(self) -> str:
        """Whose chances are told."""
        raise NotImplementedError

    @property
    def key(self) -> object:
        """Equal for equal positions, rules, cloths and hands."""
        raise NotImplementedError

    def reviewing(self, meant: Stroke, struck: Any) -> Callable[[], Told]:
        """What reviews the last stroke; it may run in a thread."""
        raise NotImplementedError

    def best(self) -> Callable[[], Way | None]:
        """What finds the surest stroke of the position on the table; it may run in a thread."""
        raise NotImplementedError

    # -- after the stroke ---------------------------------------------------------------------------

    @property
    def active(self) -> bool:
        """True while the last stroke is to be told of."""
        course = self.course
        return self.shown and course.phase in SHOWN and course.model.frame.last is not None

    @property
    def _struck_key(self) -> object:
        last = self.course.model.frame.last
        return getattr(last.frame, "places", None) or last.frame.layout.places, last.stroke, self.key

    def _work(self) -> Callable[[], Told]:
        last, pair = self.course.model.frame.last, self.course.aimed_and_done
        meant = pair[0] if pair is not None and pair[1] == last.stroke else last.stroke
        return self.reviewing(meant, last)

    def told(self) -> Told | None:
        """What there is to tell of the last stroke; asks for it."""
        if not self.active:
            return None
        key = self._struck_key
        self.after.ask(key, self._work())
        latest = self.after.latest
        return latest.value if latest is not None and latest.key == key else None

    def now(self) -> Told | None:
        """The same, worked out here and now."""
        return self.after.answer(self._struck_key, self._work()) if self.active else None

    # -- before the stroke, if asked ----------------------------------------------------------------

    @property
    def asked(self) -> bool:
        """True if the coach was asked about the stroke that is aimed."""
        course = self.course
        return self.shown and course.may_aim and course.advised == course.model.frame.strokes

    def advice(self) -> tuple[bool, Way | None]:
        """Whether it is known what the surest stroke is, and that stroke, None if there is none."""
        key = self.key
        self.ahead.ask(key, self.best())
        latest = self.ahead.latest
        known = latest is not None and latest.key == key
        return known, latest.value if known and latest is not None else None
