"""What a level may hold for teaching: a task, what is locked or hidden, and questions that are checked.

    [teaching]
    task = "Find out how much of its energy the ball keeps at a bounce."
    locked = ["gravity"]                   # parameters that cannot be changed
    locked_effects = ["gravity"]
    hidden = ["effects", "charts"]         # parts of the window, see PARTS
    hidden_parameters = ["restitution"]    # not in the panel, and locked
    hidden_readouts = ["energy"]           # nowhere in the window

    [[teaching.questions]]
    kind = "number"                        # typed; right within the tolerance of a value or of a readout now
    ask = "How high does it rise?"
    readout = "height"                     # or: value = 0.64
    unit = "m"
    percent = 5.0                          # or: tolerance = 0.02, in the same unit

    [[teaching.questions]]
    kind = "choice"                        # one of the options, counted from 1; or the one whose readout is
    ask = "What does gravity change?"      # the largest (most = true) or the smallest (most = false)
    options = ["the height", "the time"]
    right = 2

    [[teaching.questions]]
    kind = "goal"                          # nothing is typed: the readout must lie between the two
    ask = "Make the ball rise above 2 m."
    readout = "height"
    least = 2.0

Whatever a question says of the answer stands in the file in plain words: this is for practice, not for marks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Annotated, Literal

import msgspec

PARTS = ("levels", "parameters", "effects", "measured", "table", "legend", "charts")
MOST_QUESTIONS = 24

Words = Annotated[str, msgspec.Meta(min_length=1, max_length=400)]
Name = Annotated[str, msgspec.Meta(min_length=1, max_length=100)]
Names = Annotated[list[Name], msgspec.Meta(max_length=200)]
Part = Literal["levels", "parameters", "effects", "measured", "table", "legend", "charts"]
Positive = Annotated[float, msgspec.Meta(gt=0.0)]


class TeachingError(ValueError):
    """What is wrong in the section ``teaching``: ``field`` within it, and ``reason``."""

    def __init__(self, field: str, reason: str):
        self.field, self.reason = field, reason
        super().__init__(f"{field}: {reason}")


class NumberQuestion(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="kind", tag="number"):
    """A number that is typed. Right if it is near ``value``, or near what ``readout`` reads when asked."""

    ask: Words
    readout: Name | None = None
    value: float | None = None
    unit: Annotated[str, msgspec.Meta(max_length=20)] = ""
    tolerance: Positive | None = None  # in the unit of the answer
    percent: Annotated[float, msgspec.Meta(gt=0.0, le=100.0)] | None = None  # of the right answer

    def expected(self, readouts: Mapping[str, float]) -> float:
        """The right answer now; NaN if its readout is not measured."""
        return readouts.get(self.readout, math.nan) if self.readout is not None else float(self.value or 0.0)

    def is_right(self, answer: str, readouts: Mapping[str, float]) -> bool:
        """Whether what was typed is near enough."""
        expected = self.expected(readouts)
        reach = (
            self.tolerance if self.tolerance is not None else abs(expected) * (self.percent or 0.0) / 100.0
        )
        return abs(read_number(answer) - expected) <= reach * (1.0 + 1e-9)


class ChoiceQuestion(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="kind", tag="choice"):
    """One of a few answers: number ``right`` of them, or that whose readout is the largest or smallest."""

    ask: Words
    options: Annotated[list[Words], msgspec.Meta(min_length=2, max_length=6)]
    right: Annotated[int, msgspec.Meta(ge=1, le=6)] | None = None
    readouts: Annotated[list[Name], msgspec.Meta(min_length=2, max_length=6)] | None = None  # of the options
    most: bool = True

    def expected(self, readouts: Mapping[str, float]) -> int:
        """Number of the right option now, from 1; 0 if that cannot be told."""
        if self.readouts is None:
            return self.right or 0
        values = [readouts.get(name, math.nan) for name in self.readouts]
        if not all(map(math.isfinite, values)):
            return 0
        return 1 + values.index(max(values) if self.most else min(values))

    def is_right(self, answer: str, readouts: Mapping[str, float]) -> bool:
        """Whether the option of that number is the right one."""
        right = self.expected(readouts)
        return right > 0 and answer == str(right)


class GoalQuestion(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="kind", tag="goal"):
    """Something to be reached in the scene: a readout between two numbers when it is checked."""

    ask: Words
    readout: Name
    least: float | None = None
    most: float | None = None

    def is_right(self, answer: str, readouts: Mapping[str, float]) -> bool:
        """Whether it is reached now; nothing is typed."""
        value = readouts.get(self.readout, math.nan)
        low = -math.inf if self.least is None else self.least
        return low <= value <= (math.inf if self.most is None else self.most)


Question = NumberQuestion | ChoiceQuestion | GoalQuestion


class Teaching(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The section ``[teaching]`` of a level."""

    task: Annotated[str, msgspec.Meta(min_length=1, max_length=4000)]
    locked: Names = []
    locked_effects: Names = []
    hidden: Annotated[list[Part], msgspec.Meta(max_length=len(PARTS))] = []
    hidden_parameters: Names = []
    hidden_readouts: Names = []
    questions: Annotated[list[Question], msgspec.Meta(max_length=MOST_QUESTIONS)] = []

    @property
    def fixed(self) -> frozenset[str]:
        """Parameters that cannot be changed: those locked, and those hidden."""
        return frozenset((*self.locked, *self.hidden_parameters))

    def check(self) -> None:
        """TeachingError for what the types allow and no question can mean."""
        for i, question in enumerate(self.questions):
            _check_question(question, f"questions[{i}]")

    def check_names(self, parameters: Mapping[str, object], effects: list[str]) -> None:
        """TeachingError for a parameter or an effect that there is not."""
        for field, known, kind in (
            ("locked", list(parameters), "parameter"),
            ("hidden_parameters", list(parameters), "parameter"),
            ("locked_effects", effects, "effect"),
        ):
            for i, name in enumerate(getattr(self, field)):
                if name not in known:
                    raise TeachingError(f"{field}[{i}]", _no_such(kind, name, known))

    def check_readouts(self, known: list[str]) -> None:
        """TeachingError for a readout that the scene does not measure."""
        named = [(f"hidden_readouts[{i}]", name) for i, name in enumerate(self.hidden_readouts)]
        for field, name in (*named, *self._asked()):
            if name not in known:
                raise TeachingError(field, _no_such("readout", name, known))

    def _asked(self) -> Iterator[tuple[str, str]]:
        """Field and name of each readout in a question."""
        for i, question in enumerate(self.questions):
            if isinstance(question, ChoiceQuestion):
                for j, name in enumerate(question.readouts or ()):
                    yield f"questions[{i}].readouts[{j}]", name
            elif question.readout is not None:
                yield f"questions[{i}].readout", question.readout


def read_number(text: str) -> float:
    """The number that a text says, with a point or a comma; NaN if it says none."""
    cleaned = text.strip().replace("\u202f", "").replace("\u2212", "-").replace(",", ".").replace("_", " ")
    try:
        number = float(cleaned)
    except ValueError:
        return math.nan
    return number if math.isfinite(number) else math.nan


def _no_such(kind: str, name: str, known: list[str]) -> str:
    return f"no {kind} {name!r}; there are {', '.join(known) or 'none'}"


def _check_question(question: Question, field: str) -> None:
    """TeachingError if the question has no right answer, or two."""
    if isinstance(question, NumberQuestion):
        if (question.readout is None) == (question.value is None):
            raise TeachingError(field, "expected either readout or value")
        if (question.tolerance is None) == (question.percent is None):
            raise TeachingError(field, "expected either tolerance or percent")
        if question.value == 0.0 and question.percent is not None:
            raise TeachingError(f"{field}.percent", "of 0 is nothing: expected a tolerance")
        numbers = (("value", question.value), ("tolerance", question.tolerance))
    elif isinstance(question, ChoiceQuestion):
        _check_choice(question, field)
        return
    else:
        if question.least is None and question.most is None:
            raise TeachingError(field, "expected least or most, or both")
        numbers = (("least", question.least), ("most", question.most))
    for name, number in numbers:
        if number is not None and not math.isfinite(number):
            raise TeachingError(f"{field}.{name}", "expected a finite number")
    if isinstance(question, GoalQuestion) and None not in (question.least, question.most):
        assert question.least is not None and question.most is not None
        if question.least > question.most:
            raise TeachingError(f"{field}.least", f"{question.least:g} is above most, {question.most:g}")


def _check_choice(question: ChoiceQuestion, field: str) -> None:
    if (question.right is None) == (question.readouts is None):
        raise TeachingError(field, "expected either right or readouts")
    if question.right is not None and question.right > len(question.options):
        raise TeachingError(f"{field}.right", f"{question.right}: there are {len(question.options)} options")
    if question.readouts is not None and len(question.readouts) != len(question.options):
        raise TeachingError(f"{field}.readouts", f"expected one for each of {len(question.options)} options")
