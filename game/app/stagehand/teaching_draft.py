"""A teaching level that is being made of what is in play: what is locked and hidden, and what is asked."""

from __future__ import annotations

import math
from pathlib import Path
from typing import NamedTuple

from game.app.stagehand import files
from game.folders import user_folder
from game.levels import save_level
from game.stage import Readout, Stage
from game.teaching import (
    PARTS,
    ChoiceQuestion,
    GoalQuestion,
    NumberQuestion,
    Question,
    Teaching,
    TeachingError,
    read_number,
)

PERCENT = 5.0  # that an answer may be off, unless it is said
FREE, LOCKED, HIDDEN, SHOWN = "free", "locked", "hidden", "shown"


class Row(NamedTuple):
    """One thing that can be locked or hidden: its section, its name, its words, and its states in turn."""

    section: str
    name: str
    label: str
    states: tuple[str, ...]


class Draft:
    """What has been chosen so far; ``states``: by section and name, where it is not the first one."""

    def __init__(self, stage: Stage) -> None:
        self.title, self.task = "", ""
        self.questions: list[Question] = []
        self.states: dict[tuple[str, str], str] = {}
        self.readouts: list[Readout] = stage.readouts()
        self.rows = _rows_of(stage, self.readouts)
        level = stage.level
        if level is not None and level.teaching is not None:
            self._take_over(level.title, level.teaching)

    def _take_over(self, title: str, teaching: Teaching) -> None:
        """Go on with a level that has a task already."""
        self.title, self.task = title, teaching.task
        self.questions = list(teaching.questions)
        for section, names, state in (
            ("Parameters", teaching.locked, LOCKED), ("Parameters", teaching.hidden_parameters, HIDDEN),
            ("Effects", teaching.locked_effects, LOCKED), ("Window", teaching.hidden, HIDDEN),
            ("Readouts", teaching.hidden_readouts, HIDDEN),
        ):  # fmt: skip
            self.states |= {(section, name): state for name in names}

    def state(self, row: Row) -> str:
        """How a row stands."""
        return self.states.get((row.section, row.name), row.states[0])

    def turn(self, row: Row) -> None:
        """Its next state."""
        at = row.states.index(self.state(row))
        self.states[row.section, row.name] = row.states[(at + 1) % len(row.states)]

    def _named(self, section: str, state: str) -> list[str]:
        return [row.name for row in self.rows if row.section == section and self.state(row) == state]

    def add(self, kind: str, readout: Readout | None, words: str) -> None:
        """A question from a line of words; TeachingError says what is missing in it."""
        parts = [part.strip() for part in words.split("|")]
        if not parts[0]:
            raise TeachingError("question", "expected words")
        if kind == "choice":
            question: Question = _choice(parts)
        elif readout is None:
            raise TeachingError("question", "expected a readout")
        elif kind == "number":
            question = _number(readout, parts)
        else:
            question = _goal(readout, parts)
        found = Teaching(task="a", questions=[question])
        found.check()
        self.questions.append(question)

    def teaching(self) -> Teaching:
        """The section of the level's file; TeachingError if it has no task."""
        if not self.task.strip():
            raise TeachingError("task", "expected words")
        return Teaching(
            task=self.task.strip(),
            locked=self._named("Parameters", LOCKED),
            locked_effects=self._named("Effects", LOCKED),
            hidden=self._named("Window", HIDDEN),  # type: ignore[arg-type]
            hidden_parameters=self._named("Parameters", HIDDEN),
            hidden_readouts=self._named("Readouts", HIDDEN),
            questions=list(self.questions),
        )


def suggestion(kind: str, readout: Readout | None) -> str:
    """The line that one begins with for a question."""
    if kind == "choice" or readout is None:
        return ""
    if kind == "number":
        return f"What is the {readout.name}? | {PERCENT:g} %"
    value = float(readout.value)
    low, high = sorted((0.9 * value, 1.1 * value)) if math.isfinite(value) and value else (0.0, 1.0)
    return f"Bring the {readout.name} between the two | {low:.3g} | {high:.3g}"


def save_draft(stage: Stage, draft: Draft) -> Path:
    """Write the scene as it stands as a level with the task; its path. TeachingError, LevelError."""
    teaching = draft.teaching()
    title = draft.title.strip() or files.date_title()
    level = files.present_level(stage, title)
    folder = user_folder() / "levels" / stage.scene.name
    word = "".join(c if c.isalnum() and c.isascii() else "-" for c in title.lower()).strip("-")[:40] or "task"
    path, number = folder / f"teaching-{word}.toml", 2
    while path.exists():
        path, number = folder / f"teaching-{word}-{number}.toml", number + 1
    save_level(files.with_teaching(level, teaching), path)
    return path


def _rows_of(stage: Stage, readouts: list[Readout]) -> list[Row]:
    scene = stage.scene
    rows = [
        Row("Parameters", name, one.label, (FREE, LOCKED, HIDDEN))
        for name, one in scene.declared_parameters().items()
    ]
    rows += [Row("Effects", one.name, one.label, (FREE, LOCKED)) for one in scene.effects]
    rows += [Row("Window", name, name.capitalize(), (SHOWN, HIDDEN)) for name in PARTS]
    return rows + [
        Row("Readouts", one.name, one.name[:1].upper() + one.name[1:], (SHOWN, HIDDEN)) for one in readouts
    ]


def _number(readout: Readout, parts: list[str]) -> NumberQuestion:
    """``words | 5 %`` or ``words | 0.02``."""
    said = parts[1] if len(parts) > 1 and parts[1] else f"{PERCENT:g} %"
    reach = read_number(said.removesuffix("%"))
    if not reach > 0.0:
        raise TeachingError("tolerance", f"{said!r}: expected a number above 0, or so many %")
    if said.endswith("%"):
        return NumberQuestion(
            ask=parts[0], readout=readout.name, unit=readout.unit, percent=min(reach, 100.0)
        )
    return NumberQuestion(ask=parts[0], readout=readout.name, unit=readout.unit, tolerance=reach)


def _choice(parts: list[str]) -> ChoiceQuestion:
    """``words | the right answer | another | …``; shown in the order of the alphabet."""
    options = [part for part in parts[1:] if part]
    if len(options) < 2 or len(options) > 6 or len(set(options)) < len(options):
        raise TeachingError("options", "expected the question | the right answer | up to five others")
    shown = sorted(options)
    return ChoiceQuestion(ask=parts[0], options=shown, right=1 + shown.index(options[0]))


def _goal(readout: Readout, parts: list[str]) -> GoalQuestion:
    """``words | least | most``; one of the two may be left out."""
    ends: list[float | None] = []
    for name, said in zip(("least", "most"), (*parts[1:3], "", "")[:2], strict=True):
        number = read_number(said) if said else None
        if number is not None and not math.isfinite(number):
            raise TeachingError(name, f"{said!r}: expected a number")
        ends.append(number)
    return GoalQuestion(ask=parts[0], readout=readout.name, least=ends[0], most=ends[1])
