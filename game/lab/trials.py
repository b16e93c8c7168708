"""Trials that are made of functions, and points at which every method is measured alike."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Generic, TypeVar

from game.lab.study import Outcome, Setting

Start = TypeVar("Start")
Found = TypeVar("Found")


class Computation(Generic[Start, Found]):
    """A trial: what ``begin`` gives is made anew before each run, ``work`` is timed, ``judge`` looks at it.

    simulated_s: seconds for which one run stands.
    """

    def __init__(
        self,
        simulated_s: float,
        begin: Callable[[], Start],
        work: Callable[[Start], Found],
        judge: Callable[[Found], Outcome],
    ) -> None:
        self.simulated_s = simulated_s
        self._begin, self._work, self._judge = begin, work, judge

    def reset(self) -> None:
        """Begin anew."""
        self._start = self._begin()

    def run(self) -> None:
        """The work."""
        self._found = self._work(self._start)

    def outcome(self) -> Outcome:
        """What is found of the last run."""
        return self._judge(self._found)


def computation(
    simulated_s: float, work: Callable[[], Found], judge: Callable[[Found], Outcome]
) -> Computation[None, Found]:
    """A trial in which nothing is kept between runs."""
    return Computation(simulated_s, lambda: None, lambda _: work(), judge)


def every_setting(
    methods: Sequence[str],
    values: Sequence[float],
    scene: Callable[[str, Any], Mapping[str, Any]],
    weight: Callable[[float], float] = float,
) -> list[Setting]:
    """Every method at every value of the knob, method by method.

    scene(method, value): the scene's parameters there; weight(value): the expected cost.
    """
    return [
        Setting(method, float(value), {}, scene(method, value), weight(value))
        for method in methods
        for value in values
    ]


def chosen_setting(
    method: str, knob: str, among: Sequence[str] | None = None
) -> Callable[[Mapping[str, Any]], Setting | None]:
    """Where a scene stands whose parameters of these names say method and knob; None if not among these."""

    def present(parameters: Mapping[str, Any]) -> Setting | None:
        name = str(parameters[method])
        return Setting(name, float(parameters[knob])) if among is None or name in among else None

    return present
