"""The column beside the table as the hand has it: which rows of the log are seen, and what a click does."""

from __future__ import annotations

from typing import NamedTuple

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame
from game.billiards.game.log import Log, Logged
from game.billiards.game.rules import Call
from game.billiards.shot.cue import strike
from game.scenes.billiards.beside import BESIDE, COACH, LOG, MAP, NONE
from game.scenes.billiards.model import as_practice
from game.scenes.billiards.play import AIMING, SET_UP, Play
from game.scenes.billiards.practice.advisor import PLAY, SHOW, PoolAdvisor
from game.scenes.billiards.practice.columns import COLUMN, ROWS
from game.scenes.billiards.practice.hands import hand_of
from game.scenes.billiards.stroke.motion import PRACTISED
from game.stage import Decision, Part, Pointer

DECISIONS = (SHOW, PLAY)


class LogRow(NamedTuple):
    """A row of the log: a stroke, or the head of a rack (number), or the way back to the frame that was
    left.
    """

    stroke: Logged | None = None
    rack: int = 0


def log_rows(log: Log) -> list[LogRow]:
    """All rows of a log, the oldest first."""
    rows: list[LogRow] = []
    rack = 0
    for entry in log.entries:
        if entry.rack != rack:
            rack = entry.rack
            rows.append(LogRow(rack=rack))
        rows.append(LogRow(entry))
    if log.left is not None:
        rows.append(LogRow())
    return rows


class Side(Part):
    """scrolled: rows that lie below those that are seen."""

    def __init__(self, play: Play, advisor: PoolAdvisor) -> None:
        self.play = play
        self.advisor = advisor
        self.scrolled = 0

    @property
    def beside(self) -> str:
        """What is shown beside the table: one of BESIDE."""
        return str(self.play.parameters.beside)

    def turn(self, beside: str) -> None:
        """Show something else, or nothing if it is shown already."""
        assert beside in BESIDE
        self.play.parameters.beside = NONE if self.beside == beside else beside
        self.scrolled = 0

    def holds(self, x: float, y: float) -> bool:
        """True on the column."""
        return self.beside != NONE and COLUMN.box.holds(x, y)

    def rows_seen(self) -> list[LogRow]:
        """The rows of the log that there is space for."""
        rows = log_rows(self.play.log)
        end = len(rows) - min(self.scrolled, max(len(rows) - ROWS, 0))
        return rows[max(end - ROWS, 0) : end]

    def wheel(self, event: Pointer) -> None:
        """The wheel moves the log."""
        if self.beside == LOG:
            most = max(len(log_rows(self.play.log)) - ROWS, 0)
            self.scrolled = min(max(self.scrolled + round(event.wheel), 0), most)

    def click(self, event: Pointer) -> None:
        """A row is taken where it was pressed and let go."""
        row = COLUMN.row_at(event.x, event.y)
        if row < 0 or self.play.grip:
            return
        if self.beside == MAP:
            self.advisor.click(row)
        elif self.beside == COACH and row == ROWS - 1:
            self.play.ask_coach()
        elif self.beside == LOG and self.play.phase == AIMING:
            rows = self.rows_seen()
            if row < len(rows):
                self._take(rows[row])

    def _take(self, row: LogRow) -> None:
        if row.stroke is not None:
            self.go_back(row.stroke.number)
        elif not row.rack:
            self.go_on()

    def go_back(self, number: int) -> None:
        """To the frame before a stroke of the log, aimed as it was; what counts for good is practised there.
        ValueError for an unknown number.
        """
        play = self.play
        play.log = play.log.gone_back(number, play.model.frame)
        entry = play.log.find(number)
        assert entry is not None
        before = entry.struck.frame
        if before.game.final:
            before = as_practice(before)
            play.messages.say("What was counted is practised here. The last row of the log goes back.")
        self._look_at(before, entry.struck.stroke)

    def go_on(self) -> None:
        """To the frame that was left by going back in the log."""
        play = self.play
        if play.log.left is not None:
            frame, play.log = play.log.left[0], play.log.returned()
            self._look_at(frame, frame.last.stroke if frame.last is not None else None)

    def _look_at(self, frame: Frame, stroke: Stroke | None) -> None:
        """Another frame is in play: aimed as a stroke, if there is one."""
        play = self.play
        play.model.show(frame)
        play.pending, play.aiming.call = None, Call()
        play.let_go()
        if stroke is not None:
            play.aiming.aim_as(stroke)
        play.start_phase(AIMING)

    def decide(self, event: Decision) -> None:
        """A pot of the map: aimed, or played. Where strokes count it is the hand that plays it, whose chance
        the map tells. ValueError for what cannot be.
        """
        play = self.play
        if len(event.values) != 7:
            raise ValueError(f"{event.name}: expected seven numbers")
        stroke, (ball, pocket) = Stroke(*event.values[:5]), event.values[5:]
        strike(*stroke)  # refuses what no stroke can be
        if play.phase == SET_UP and event.name == PLAY:
            play.model.end_set_up()
            play.start_phase(AIMING)
        if play.phase != AIMING or not play.model.frame.playable:
            raise ValueError(f"{event.name}: none may be played now")
        call = Call(int(ball), int(pocket))
        if event.name == PLAY:
            counts = len(play.model.frame.game.players) == 2 or play.model.frame.game.final
            if counts:
                stroke = play.by_own_hand(stroke, hand_of(play).noise)
            play.begin_stroke(stroke, call, PRACTISED)
        else:
            play.aiming.aim_as(stroke)
            play.aiming.call_this(call if play.model.frame.game.needs_call() else Call())
