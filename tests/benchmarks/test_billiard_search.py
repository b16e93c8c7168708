"""How fast shots are found, how long a match takes, and how good the computer players are.

python -m pytest tests/benchmarks/test_billiard_search.py --benchmark-enable -s
The last two take an hour; what they measured is in their `extra_info`, and printed.
"""

from __future__ import annotations

import json

import numpy as np
import pytest

from game.billiards import find_shots
from game.billiards.game.frame import Frame
from game.billiards.game.games import EightBall
from game.billiards.players.match import check_match_data, match_data, play_match
from game.billiards.players.opponents import CLUB, EXPERT, GRADES, MASTER, NOVICE, decide
from game.billiards.search.finding import processors, thread_pool
from game.billiards.search.strokes import Board
from game.lab.players import measure_clearing, measure_series, with_hand
from tests.billiards.search.search_tables import POOL, random_strokes, scattered

STROKES = 4096
MATCHES = 20
TABLES = 200
RACKS = 100
LONGEST_ROUND = 2.0  # s; the goal for finding a round


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("count", [4, 16])
def test_random_strokes(benchmark, count, threads):
    """Strokes of all sorts, struck, played and summed up; goal: some ten thousand a second and core."""
    benchmark.group = f"{STROKES} strokes at {count} balls"
    board = Board(scattered(1, count), POOL)
    strokes = random_strokes(1, STROKES if benchmark.enabled else 64)
    outcomes = benchmark(board.play, strokes, thread_pool(threads))
    assert len(outcomes.facts) == len(strokes)


@pytest.mark.parametrize("seed", [1, 2])
def test_find_shots(benchmark, seed):
    benchmark.group = "find_shots, 16 balls"
    layout = scattered(seed)
    assert benchmark(find_shots, layout)


@pytest.mark.parametrize("grade", GRADES)
def test_a_decision(benchmark, grade):
    benchmark.group = "a decision of a player, 16 balls"
    game = EightBall(opening=False, in_hand="", groups=("solids", "stripes"))
    frame = Frame(game, scattered(3), POOL)
    assert benchmark(decide, frame, GRADES[grade]).stroke is not None


def test_matches(benchmark):
    """Rounds of matches, found in at most 2 s each on two cores; every one holds by its own record."""
    seeds = range(1, 1 + (MATCHES if benchmark.enabled else 1))
    play_match(0)  # kernels are compiled, or read from the disk
    matches = benchmark.pedantic(lambda: [play_match(seed) for seed in seeds], rounds=1, iterations=1)
    for match in matches:
        check_match_data(json.loads(json.dumps(match_data(match))))
    seconds = np.array([one.seconds for match in matches for one in match.rounds])
    figures = {
        "rounds": len(seconds), "median": float(np.median(seconds)), "worst": float(seconds.max()),
        "shortest match, s of play": min(match.playing_time for match in matches),
    }  # fmt: skip
    benchmark.extra_info.update(figures)
    print(figures)
    if benchmark.enabled and processors() >= 2:
        assert seconds.max() <= LONGEST_ROUND


def test_grades(benchmark):
    """Tables cleared in one visit by each grade: with its own hand, the usual one, and a steady one."""
    if not benchmark.enabled:
        pytest.skip("measured only with --benchmark-enable")

    def measure():
        table = {}
        for name, grade in GRADES.items():
            for hand in sorted({grade.unsteady, 1.0, 0.0}, reverse=True):
                count = TABLES if (grade, hand) == (MASTER, 1.0) else TABLES // 4
                table[name, hand] = measure_clearing(with_hand(grade, hand), range(count))
                print(name, "hand", hand, table[name, hand])
        return table

    table = benchmark.pedantic(measure, rounds=1, iterations=1)
    assert table["master", 1.0].cleared >= TABLES // 2
    assert table["master", 0.0].success > table["master", 1.0].success


@pytest.mark.parametrize(
    ("better", "worse"), [(MASTER, EXPERT), (EXPERT, CLUB), (CLUB, NOVICE)], ids=lambda grade: grade.name
)
def test_the_better_grade_wins(benchmark, better, worse):
    """At least three of four racks."""
    if not benchmark.enabled:
        pytest.skip("measured only with --benchmark-enable")
    series = benchmark.pedantic(measure_series, (better, worse, range(RACKS)), rounds=1, iterations=1)
    print(better.name, worse.name, series)
    assert series.first >= 3 * RACKS // 4
