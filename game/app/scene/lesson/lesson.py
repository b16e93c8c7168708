"""The task of a teaching level at work: answers are judged by what the scene measures now."""

from __future__ import annotations

import math
from collections.abc import Callable

from game.app.scene.in_play import InPlay
from game.app.scene.shell import Shell
from game.app.screens.host import Host
from game.app.stagehand.teaching_draft import Draft, save_draft
from game.levels import Level
from game.teaching import ChoiceQuestion, NumberQuestion, Question, read_number
from game.ui.look.numerals import format_si
from game.ui.widgets.lesson import Verdict


class Lesson:
    """Judges the answers on the shell's sheet; `follow` when the level has changed."""

    def __init__(self, host: Host, record: InPlay, shell: Shell, saved: Callable[[], object]) -> None:
        """``saved`` is called when a level has been saved."""
        self._host, self._record, self._shell, self._saved = host, record, shell, saved
        self._level: Level | None = None
        self._tries: dict[int, int] = {}
        self._told = False
        self.follow()

    def follow(self) -> None:
        """Show the present level's task, from its beginning if the level is another."""
        level = self._record.stage.level
        if level is self._level:
            return
        self._level, self._tries, self._told = level, {}, False
        teaching = level.teaching if level is not None else None
        locked = ""
        if teaching is not None:
            scene_type = self._record.stage.scene_type
            names = [scene_type.parameter(name).label for name in teaching.locked]
            names += [f"{scene_type.effect(name).label} (effect)" for name in teaching.locked_effects]
            locked = ", ".join(names)
        self._shell.teach(teaching, locked)

    def ask_and_save(self) -> None:
        """Make a teaching level of what is in play."""
        self._record.errands.act(
            lambda: self._host.cards.open_teaching(Draft(self._record.stage), self._save)
        )

    def _save(self, draft: Draft) -> str:
        """Save it and say where; why it cannot be, in a line."""
        try:
            path = save_draft(self._record.stage, draft)
        except ValueError as error:
            return str(error)
        self._saved()
        self._host.tell("Teaching level saved", str(path))
        return ""

    def check(self, i: int) -> None:
        """Judge the answer to a question, by its number."""
        sheet, stage = self._shell.lesson, self._record.stage
        if sheet.teaching is None or self._record.errands.inside:
            return
        question, answer = sheet.teaching.questions[i], sheet.answers.get(i, "")
        readouts = {one.name: float(one.value) for one in stage.readouts()}
        missing = _missing(question, answer)
        if missing:
            sheet.judge(i, Verdict(False, missing))
            return
        self._tries[i] = self._tries.get(i, 0) + 1
        right = question.is_right(answer, readouts)
        sheet.judge(i, Verdict(right, _words(question, right, self._tries[i], readouts)))
        if right and sheet.right == len(sheet.teaching.questions) and not self._told:
            self._told = True
            count = sheet.right
            self._host.tell("All is answered.", f"{count} of {count} right.")


def _missing(question: Question, answer: str) -> str:
    """What is to be done before there is anything to judge; empty if there is."""
    if isinstance(question, NumberQuestion):
        if not answer.strip():
            return "Type a number first."
        return "" if math.isfinite(read_number(answer)) else "This is no number."
    if isinstance(question, ChoiceQuestion):
        return "" if answer else "Choose one first."
    return ""


def _words(question: Question, right: bool, tries: int, readouts: dict[str, float]) -> str:
    """The verdict in words."""
    if not right:
        return "Not yet." if tries == 1 else f"Not yet ({tries} tries)."
    if isinstance(question, NumberQuestion):
        return f"Right: {format_si(question.expected(readouts), question.unit)}."
    return "Right." if isinstance(question, ChoiceQuestion) else "Reached."
