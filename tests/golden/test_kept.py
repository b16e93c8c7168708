"""Accounts are compared by what they say: rounding is no difference, anything else is."""

from __future__ import annotations

import math
import time

import numpy as np
import pygame
import pytest

from game.app.stagehand.headless import prepare
from game.scenes import CATALOGUE
from game.scenes.shared.newest import Newest
from game.scenes.shared.thinker import Question, Thinker, Thought
from game.stage import Stage
from tests.golden import kept
from tests.golden.accounts import TICK, nothing_by_chance
from tests.golden.drawn import MOST, SIZE, Tally, drawing_of, in_one, lines, painted


def tally(*values: object) -> Tally:
    told = Tally()
    for value in values:
        told.add(value)
    return told


@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
def test_no_account_keeps_a_fault(name: str) -> None:
    """What fails when it is drawn, pointed at or set is mended, not written down."""
    assert "fault: " not in kept.file_of(name).read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("energy: 12.3456 J", "energy: 12.3457 J"),
        ("error: 1e-12", "error: -3e-13"),
        ("3 12 4.00000001/92.1 1f2e3d4c", "3 12 4.00000002/92.1 1f2e3d4c"),
    ],
)
def test_rounding_is_no_difference(one: str, other: str) -> None:
    assert kept.same(one, other)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("energy: 12.3456 J", "energy: -12.3456 J"),
        ("energy: 12.3456 J", "energy: 12.35 J"),
        ("energy: 12.3456 J", "energy: 12.3456 N"),
        ("energy: 12.3456 J", "energy: 12.3456"),
        ("balls: 15", "balls: 16"),
        ("boxes: 100000", "boxes: 100001"),
        ("4/92.1", "4"),
        ("heat: nan", "heat: 1.5"),
        ("3 12 4.00000001/92.1 1f2e3d4c", "4 12 4.00000001/92.1 1f2e3d4c"),
        ("3 12 4.00000001/92.1 1f2e3d4c", "3 13 4.00000001/92.1 1f2e3d4c"),
        ("3 12 4.00000001/92.1 1f2e3d4c", "3 12 4.001/92.1 1f2e3d4c"),
        ("3 12 4.00000001/92.1 1f2e3d4c", "3 12 4.00000001/93.1 1f2e3d4c"),
        ("3 12 4.00000001/92.1 1f2e3d4c", "3 12 4.00000001/92.1 1f2e3d4d"),
        ("1 1 0/0 00000012", "1 1 0/0 00000013"),
        ("1 1 0/0 1234e567", "1 1 0/0 1234e568"),
    ],
)
def test_anything_else_is_one(one: str, other: str) -> None:
    assert not kept.same(one, other)


def test_differences_are_named_by_their_place() -> None:
    one = {"a": {"painted": "10.0 12.0", "list": ["x: 1.5 m", "y: 2 m"]}, "gone": "1"}
    other = {"a": {"painted": "10.2 12.4", "list": ["x: 1.5 m"]}, "new": "1"}
    assert list(kept.differences(one, one)) == []
    assert [line.split(":")[0] for line in kept.differences(one, other)] == [
        "a / painted", "a / list 1", "gone", "new",
    ]  # fmt: skip


def test_a_tally_depends_on_every_number_and_word_and_on_their_order() -> None:
    values = ("line", 1.5, (2.0, -3.0), np.array([[4.0, 5.0]]), pygame.Color("#102030"), None, True)
    told = {tally(*values).text()}
    for number, other in enumerate(
        ("lime", 1.6, (2.0, 3.0), np.array([[4.0, 5.1]]), pygame.Color("#102031"))
    ):
        changed = list(values)
        changed[number] = other  # type: ignore[call-overload]
        told.add(tally(*changed).text())
    told |= {tally(*values[:-1], False).text(), tally(1.5, *values).text(), tally(2.0, 1.0).text()}
    told |= {tally(1.0, 2.0).text(), tally("1.0", 2.0).text(), tally(math.inf, 2.0).text()}
    assert len(told) == 12
    assert tally(*values).text() == tally(*values).text()


def test_a_tally_in_a_line() -> None:
    """Weights are 0.5 and the fractions of the golden ratio's multiples: 0.5 1 - 1.118034 2."""
    assert tally(1.0, -2.0).text() == "0 2 -1.73606798/2.736 00000000"


def test_a_long_array_is_looked_at_here_and_there() -> None:
    long = np.linspace(0.0, 1.0, 10 * MOST)
    assert tally(long).count == 1 + len(long[::11]) <= MOST + 1
    assert tally(long).text() != tally(long[::-1]).text() != tally(long[:-1]).text()


def test_colours_do_not_outweigh_places() -> None:
    assert tally(np.full(10, 0xFFFFFF, np.uint32)).absolute < 20.0


def test_in_one_tally_no_verb_outweighs_another() -> None:
    def drawn(radius: float) -> Tally:
        return in_one({"circle": tally(0.1, radius), "field": tally(np.full(1000, 1e6))})

    assert not kept.same(drawn(0.2).text(), drawn(0.2001).text())
    assert not kept.same(drawn(0.2).text(), drawn(-0.2).text())
    assert kept.same(drawn(0.2).text(), drawn(0.2 + 1e-15).text())


def test_a_drawing_lists_the_verbs_and_paints_none_of_them() -> None:
    prepare()
    stage = Stage(CATALOGUE["pendulum"].load())
    before, surface = drawing_of(stage)
    assert {"line", "circle"} & set(before) and painted(surface) == ""
    stage.run(5)
    after = drawing_of(stage)[0]
    assert all(tally.calls > 0 for tally in after.values())
    assert lines(before) != lines(after) and lines(after) == lines(drawing_of(stage)[0])


def test_what_is_painted_past_the_verbs_is_seen_by_its_place() -> None:
    surface = pygame.Surface(SIZE, 0, 32)
    surface.fill((90, 90, 90), (0, 0, SIZE[0] // 4, SIZE[1] // 2))
    assert painted(surface).split() == ["90.0", *["0.0"] * 7]
    assert painted(surface, (2, 1)).split() == ["22.5", "0.0"]


def test_no_thread_answers() -> None:
    asked: Newest[int] = Newest("asked")
    thinker = Thinker(lambda _: Thought(()), lambda: None)
    with nothing_by_chance():
        asked.ask("question", lambda: 1)
        thinker.prepare()
        assert thinker.ask(Question("question", None, "", 0)) is None
    asked.wait()
    assert asked.latest is None and not thinker.thinking and not thinker.warm


def test_a_clock_is_counted() -> None:
    with nothing_by_chance():
        assert time.perf_counter() == 0.0 and time.perf_counter() == TICK
    assert time.perf_counter() != 2.0 * TICK
