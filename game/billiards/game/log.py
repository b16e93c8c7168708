"""The log of a game: every stroke with the frame before it, so that any of them can be gone back to.

A stroke that is taken back stays in the log, and what is played instead is a branch of it: nothing is lost.
"""

from __future__ import annotations

from typing import NamedTuple

import msgspec

from game.billiards.game.frame import Frame, Played, Struck

START = 0  # number of no stroke: the beginning
MOST_LOGGED = 500  # strokes; of more the oldest are given up


class Logged(msgspec.Struct, frozen=True, eq=False):
    """One stroke. number: from 1 on, in the order in which they were played. after: number of the stroke that
    led to it, START at the beginning. rack: from 1 on. struck: with the frame before. down: numbered balls
    that went down. words: the verdict's. winner: name of who has won the rack by it, else empty.
    """

    number: int
    after: int
    rack: int
    struck: Struck
    down: tuple[int, ...] = ()
    words: tuple[str, ...] = ()
    foul: bool = False
    winner: str = ""

    @property
    def shooter(self) -> str:
        """Name of the player."""
        return self.struck.frame.game.shooter

    @property
    def scored(self) -> int:
        """Balls that it brought its player."""
        return 0 if self.foul else len(self.down)

    @property
    def branches(self) -> bool:
        """True if it does not follow from the stroke that was played before it."""
        return self.after != self.number - 1


class RackResult(NamedTuple):
    """How a rack went. rack: its number; winner: name, empty while it goes on; strokes: played in it."""

    rack: int
    winner: str
    strokes: int


class Log(msgspec.Struct, frozen=True, eq=False):
    """entries: the newest last. at: number of the stroke that led to the frame in play, START if none.

    left: the frame that was left by going back to a stroke, and its stroke's number, until one returns to it;
    None: none was.
    """

    entries: tuple[Logged, ...] = ()
    at: int = START
    left: tuple[Frame, int] | None = None

    def with_stroke(self, struck: Struck, played: Played) -> Log:
        """With a stroke that has been played to its end; a break begins the next rack."""
        last, before = self.entries[-1] if self.entries else None, self.find(self.at)
        game = played.frame.game
        rack = 1 if before is None else before.rack + struck.frame.game.opening
        entry = Logged(
            last.number + 1 if last else 1, self.at, rack, struck,
            played.summary.balls_down, tuple(played.verdict.words), bool(played.verdict.fouls),
            game.players[game.winner] if game.winner is not None else "",
        )  # fmt: skip
        return Log((*self.entries, entry)[-MOST_LOGGED:], entry.number, self.left)

    def find(self, number: int) -> Logged | None:
        """The stroke of a number; None if there is none, or it was given up."""
        return next((entry for entry in self.entries if entry.number == number), None)

    def taken_back(self, strokes: int) -> Log:
        """After so many strokes on the line in play have been taken back."""
        at = self.at
        for _ in range(strokes):
            entry = self.find(at)
            at = entry.after if entry is not None else START
        return Log(self.entries, at, self.left)

    def gone_back(self, number: int, frame: Frame) -> Log:
        """At the frame before a stroke; ``frame``: the one that is left. ValueError for an unknown number."""
        entry = self.find(number)
        if entry is None:
            raise ValueError(f"log: there is no stroke {number}")
        left = self.left if self.left is not None else (frame.replace(earlier=None), self.at)
        return Log(self.entries, entry.after, left)

    def returned(self) -> Log:
        """At the frame that was left."""
        return self if self.left is None else Log(self.entries, self.left[1])

    @property
    def racks(self) -> tuple[RackResult, ...]:
        """The racks in their order, as far as their strokes are in the log."""
        found: dict[int, RackResult] = {}
        for entry in self.entries:
            before = found.get(entry.rack, RackResult(entry.rack, "", 0))
            found[entry.rack] = RackResult(entry.rack, entry.winner or before.winner, before.strokes + 1)
        return tuple(found[rack] for rack in sorted(found))
