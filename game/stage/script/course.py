"""How far a story has come: a list of what has happened at which step, and all that follows from it.

Nothing else is remembered, so a step back only drops what has happened since.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.stage.script.entries import Begun, Dropped, Ended, Entry, Found, Held, Reached, Turned
from game.stage.script.lines import Do, Follow, HandOver, Look, Moment, Say, Slow, Story, Title

READING = 17.0  # characters that one reads in a second
LEAST_S = 1.8  # s that the shortest caption stays
SLACK_S = 1e-9


LATE_S = 0.3  # s simulated: what is told later than that after it came is over, and the story is late
SLOWEST = 1.0 / 16.0  # pace of a clock that waits for words
MARGIN_S = 0.05  # s of `LATE_S` that are left for what lies between two looks


class Caption(NamedTuple):
    """Words in the picture from one moment of the film to another (s; infinity as long as that is open).

    line: the line that says them.
    """

    text: str
    begins: float
    ends: float
    line: int


def reading_s(text: str) -> float:
    """How long one reads, s."""
    return max(len(text) / READING, LEAST_S)


class Course:
    """The entries of a story, in order, and what follows from them."""

    def __init__(self, story: Story) -> None:
        self.story = story
        self.entries: list[Entry] = []
        self._derive()

    def add(self, entry: Entry) -> None:
        """Something has happened."""
        self.entries.append(entry)
        self._take(entry)

    def forget_after(self, step: int) -> None:
        """Drop what has happened after a step."""
        if self.entries and self.entries[-1].step > step:
            self.entries = [entry for entry in self.entries if entry.step <= step]
            self._derive()

    def _derive(self) -> None:
        self.begun: dict[int, Begun] = {}
        self.reached: dict[str, Reached] = {}
        self.found: dict[int, Found] = {}
        self.under_way: dict[int, Begun] = {}  # deeds
        self._ended: dict[int, float] = {}  # deeds that took time, s of film
        self.speed = 1.0
        self._anchor = (0.0, 0.0)  # s simulated, s of film
        self._paces = [(0.0, 0.0, 1.0)]
        self.dropped: list[int] = []  # lines
        self.since: dict[int, float] = {}  # moments to come whose condition has become true, s simulated
        self.true: set[int] = set()  # moments whose condition is true now
        self._told_pace = 1.0
        self._held: Held | None = None
        self._words: list[int] = []  # lines that show words, as they began
        self._last = -1  # line that has begun in its turn
        for entry in self.entries:
            self._take(entry)

    def _take(self, entry: Entry) -> None:
        if isinstance(entry, Found):
            self.found[entry.expectation] = entry
        elif isinstance(entry, Turned):
            self._turn(entry)
        elif isinstance(entry, Ended):
            del self.under_way[entry.line]
            self._ended[entry.line] = entry.film_s
        elif isinstance(entry, Dropped):
            self.dropped.append(entry.line)
            if self._held is not None and self._held.line == entry.line:
                self._held = None
                time_s = self._anchor[0] + (entry.film_s - self._anchor[1]) * self.speed
                self._set_pace(time_s, entry.film_s, self._told_pace)
        elif isinstance(entry, Held):
            self._held = entry
            self._set_pace(entry.time_s, entry.film_s, entry.pace)
        elif isinstance(entry, Reached):
            self._reach(entry)
        else:
            self._take_begun(entry)

    def _take_begun(self, entry: Begun) -> None:
        line = self.story.lines[entry.line]
        self.begun[entry.line] = entry
        if not line.at:
            self._last = entry.line
        if isinstance(line, (Say, Title, HandOver)):
            self._words.append(entry.line)
        if isinstance(line, Slow):
            self._told_pace = line.slow
            if self._held is None or line.slow < self.speed:
                self._set_pace(entry.time_s, entry.film_s, line.slow)
        elif isinstance(line, Do) and line.do.over:
            self.under_way[entry.line] = entry
        if self._held is not None and self._held.line == entry.line:
            self._held = None
            self._set_pace(entry.time_s, entry.film_s, self._told_pace)

    def _set_pace(self, time_s: float, film_s: float, pace: float) -> None:
        self._anchor, self.speed = (time_s, film_s), pace
        self._paces.append((time_s, film_s, pace))

    def _turn(self, entry: Turned) -> None:
        """A condition came or went. One that went before its moment could be awaited is of no account."""
        if entry.true:
            self.true.add(entry.line)
            self.since.setdefault(entry.line, entry.time_s)
        else:
            self.true.discard(entry.line)
            if not self.follows_reached(entry.line):
                self.since.pop(entry.line, None)

    def _reach(self, entry: Reached) -> None:
        line = self.story.lines[entry.line]
        assert isinstance(line, Moment)
        self.reached[line.moment] = entry
        for number in [number for number in self.since if number not in self.true]:
            if self.story.moment_before(number) == line.moment:
                del self.since[number]

    def follows_reached(self, number: int) -> bool:
        """Whether the moment before a moment has come: from then on the story waits for this one."""
        before = self.story.moment_before(number)
        return not before or before in self.reached

    # -- time ---------------------------------------------------------------------------------------

    def film_s(self, time_s: float) -> float:
        """The moment of the film at a simulated time from the last change of pace on."""
        return self._anchor[1] + (time_s - self._anchor[0]) / self.speed

    def paces(self) -> tuple[tuple[float, float, float], ...]:
        """Changes of pace so far: s simulated, s of film, the pace from there on."""
        return tuple(self._paces)

    # -- lines --------------------------------------------------------------------------------------

    def waiting(self) -> list[tuple[int, float]]:
        """Lines that may begin, each with the moment of the film from which on it may.

        They stand in the order of their turn: the one that has waited longest for words to go comes first.
        """
        lines = self.story.lines
        found = [
            (self.reached[line.at].film_s + line.after, i)
            for i, line in enumerate(lines)
            if line.at and i not in self.begun and line.at in self.reached
        ]
        coming = self.coming
        if coming is not None:
            free = self._free_after(self._last)
            if free < math.inf:
                found.append((free + lines[coming].after, coming))
        return [(i, self._with_words(i, from_s)) for from_s, i in sorted(found)]

    @property
    def coming(self) -> int | None:
        """The line whose turn is next; None after the last one."""
        lines = self.story.lines
        return next((i for i in range(self._last + 1, len(lines)) if not lines[i].at), None)

    def overtaken(self, number: int) -> list[int] | None:
        """Lines before a moment whose turn has not come, if it may come before them; else None.

        It may not come before what is still to be done to the scene, or before an earlier moment.
        """
        lines = self.story.lines
        if lines[number].at or number <= self._last:
            return None
        between = [i for i in range(self._last + 1, number) if not lines[i].at]
        if any(isinstance(lines[i], (Do, Moment)) for i in between):
            return None
        last = lines[self._last] if self._last >= 0 else None
        if isinstance(last, Moment) and last.moment not in self.reached:
            return None
        return between

    def hold_for(self, number: int, time_s: float, film_s: float, since_s: float) -> Held | None:
        """The pace at which a line's words come in time, where those before cannot be read till then."""
        rest_s = self._least_end(self._words[-1]) - film_s if self._words else 0.0
        left_s = max(LATE_S - MARGIN_S - (time_s - since_s), 0.0)
        if rest_s * self.speed <= left_s:
            return None
        pace = max(left_s / rest_s, SLOWEST)
        return Held(0, time_s, film_s, number, pace) if pace < self.speed else None

    def _with_words(self, number: int, film_s: float) -> float:
        """Words wait until those before could be read."""
        if not self._words or not isinstance(self.story.lines[number], (Say, Title, HandOver)):
            return film_s
        return max(film_s, self._least_end(self._words[-1]))

    def _free_after(self, number: int) -> float:
        """When a line no longer holds up what comes after it, s of film; infinity if that is not known."""
        if number < 0:
            return 0.0
        line, begun = self.story.lines[number], self.begun[number]
        if line.meanwhile or isinstance(line, Slow):
            return begun.film_s
        if isinstance(line, (Look, Follow)):
            return begun.film_s + (0.0 if line.cut else line.ease)
        if isinstance(line, Moment):
            return self.reached[line.moment].film_s if line.moment in self.reached else math.inf
        if isinstance(line, Do):
            return math.inf if number in self.under_way else self._ended.get(number, begun.film_s)
        if isinstance(line, Say) and line.until:
            return begun.film_s
        return self._least_end(number)

    def _least_end(self, number: int) -> float:
        """Until when words stand at least, s of film."""
        line, begun = self.story.lines[number], self.begun[number]
        if isinstance(line, (Title, HandOver)):
            return begun.film_s + line.seconds
        return begun.film_s + reading_s(begun.text)

    @property
    def awaited(self) -> list[int]:
        """Moments that are waited for now."""
        lines = self.story.lines
        return [
            i for i in self.begun if isinstance(line := lines[i], Moment) and line.moment not in self.reached
        ]

    @property
    def handed_over(self) -> bool:
        """Whether the last line has begun."""
        return len(self.story.lines) - 1 in self.begun

    @property
    def end_s(self) -> float:
        """Where the film ends, s of film; infinity while that is not known."""
        last = len(self.story.lines) - 1
        return self._least_end(last) if last in self.begun else math.inf

    # -- words --------------------------------------------------------------------------------------

    def captions(self) -> list[Caption]:
        """All captions so far."""
        found = []
        for place, number in enumerate(self._words):
            line, begun = self.story.lines[number], self.begun[number]
            if not isinstance(line, Say):
                continue
            ends = self._least_end(number)
            if line.until:
                reached = self.reached.get(line.until)
                ends = max(ends, reached.film_s) if reached is not None else math.inf
                if place + 1 < len(self._words):
                    ends = min(ends, self.begun[self._words[place + 1]].film_s)
            found.append(Caption(begun.text, begun.film_s, ends, number))
        return found

    def news(self) -> list[float]:
        """When something new begins, s of film: words, a moment, another picture; and when the film ends."""
        kinds = (Say, Title, HandOver, Look, Follow)
        begun = (one.film_s for i, one in self.begun.items() if isinstance(self.story.lines[i], kinds))
        return sorted([0.0, *begun, *(one.film_s for one in self.reached.values()), self.end_s])

    def cards(self) -> list[tuple[int, float, float]]:
        """Title cards and the end card so far: line, from, to, s of film."""
        return [
            (number, self.begun[number].film_s, self._least_end(number))
            for number in self._words
            if isinstance(self.story.lines[number], (Title, HandOver))
        ]
