"""Keeps what is practised in the scene that is played: each set as it stands, from its first try on."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from typing import TYPE_CHECKING

from game.stage.records.history import PracticeSet, Practised, keep_set, read_history

if TYPE_CHECKING:
    from game.stage import Stage


class PracticeKeeper:
    """A new set begins with another key, and where nothing of a set has been tried yet.

    A set under way in a game that is gone on with after the program was closed is gone on with, too.
    """

    def __init__(self, now: Callable[[], datetime] = datetime.now) -> None:
        self._now = now
        self._last: Practised | None = None
        self._begun = ""

    def update(self, stage: Stage) -> str:
        """Keep the set as it stands, if it has changed. What there is to complain of, in a line."""
        seen, last = stage.scene.practised, self._last
        if seen is None or seen == last:
            return ""
        self._last = seen
        if not seen.tried:
            return ""
        if last is None or last.key != seen.key:
            self._begun = _under_way(seen) or self._moment()
        elif not last.tried:
            self._begun = self._moment()
        title = seen.title[:200]
        return keep_set(PracticeSet(seen.key, title, self._begun, seen.made, seen.tried, seen.of))

    def _moment(self) -> str:
        return self._now().isoformat(timespec="microseconds")


def _under_way(seen: Practised) -> str:
    """When the set was begun that has come so far, if it is the newest of its key; else empty."""
    try:
        alike = [one for one in read_history() if one.key == seen.key]
    except ValueError:
        return ""
    if seen.tried < 2 or not alike:  # at the first try it has only just begun
        return ""
    newest = alike[-1]
    goes_on = newest.tried <= seen.tried and newest.made <= seen.made and newest.of == seen.of
    return newest.when if goes_on else ""
