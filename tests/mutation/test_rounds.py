"""How faults are judged: forks leave nothing behind, quick tests that call the function come first."""

import os
import time
from functools import cache

import pytest

from tests.mutation import drawing
from tests.mutation.costs import Costs, Ran
from tests.mutation.drawing import choose, find
from tests.mutation.forks import OutOfTime, at_most, in_fork
from tests.mutation.log import Log
from tests.paths import ROOT

TESTS = ["tests/a.py::one", "tests/a.py::two", "tests/a.py::three", "tests/b.py::four"]


def test_a_fork_returns_what_it_found_and_leaves_nothing_behind():
    kept = []
    assert in_fork(lambda: kept.append(1) or [len(kept), os.getpid()], 30.0)[0] == 1
    assert not kept


def test_a_fork_that_breaks_or_comes_to_no_end_returns_none():
    assert in_fork(lambda: 1 / 0, 30.0) is None
    assert in_fork(lambda: time.sleep(60.0), 0.2) is None


def test_processor_time_is_bounded():
    def count():
        with at_most(0.1):
            while True:
                pass

    with pytest.raises(OutOfTime):
        count()


@pytest.fixture
def costs(tmp_path):
    for name in ("tests/a.py", "tests/b.py"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(name)
    return Costs(tmp_path / "costs.json", tmp_path, TESTS)


def learn(costs: Costs) -> None:
    costs.learn(
        [
            Ran(TESTS[0], True, 2.0, ["game/a.py:f"]),
            Ran(TESTS[1], True, 0.01, ["game/a.py:g"]),
            Ran(TESTS[3], False, 0.01, ["game/a.py:f"]),
        ]
    )


def test_what_calls_the_function_comes_first_and_what_fails_anyway_is_left_out(costs):
    learn(costs)
    assert costs.select("game/a.py:f", ["tests/a.py", "tests/b.py"]) == [TESTS[2], TESTS[0]]
    assert costs.select("game/a.py:h", ["tests/a.py"]) == [TESTS[2]]
    assert costs.calling("game/a.py:f") == [TESTS[0]]
    assert costs.known(TESTS[0]) == Ran(TESTS[0], True, 2.0, ["game/a.py:f"])
    assert costs.known(TESTS[2]) is None and costs.known(TESTS[3]) is None


def test_a_file_is_new_until_one_of_its_tests_has_run(costs):
    files = ["tests/a.py", "tests/b.py", "tests/gone.py"]
    assert costs.new_of(files) == files[:2]
    costs.learn([Ran(TESTS[3], True, 0.1, [])])
    assert costs.new_of(files) == ["tests/a.py"]
    learn(costs)
    assert costs.new_of(files) == []


def test_costs_are_kept_as_long_as_the_file_of_tests_is_the_same(costs, tmp_path):
    learn(costs)
    costs.save()
    again = Costs(tmp_path / "costs.json", tmp_path, TESTS)
    assert again.calling("game/a.py:g") == [TESTS[1]]
    (tmp_path / "tests/a.py").write_text("changed")
    assert not Costs(tmp_path / "costs.json", tmp_path, TESTS).calling("game/a.py:g")


@pytest.fixture(scope="module", autouse=True)
def each_source_once():
    """Every file of the game is gone through for a draw, which takes seconds; the next one finds it done."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(drawing, "find_faults", cache(drawing.find_faults))
        yield


@pytest.fixture(scope="module")
def drawn(each_source_once):
    return choose(1, 40, ROOT)


def test_the_last_line_of_a_fault_counts(tmp_path, capsys, drawn):
    first, second = drawn[:2]
    log = Log(tmp_path / "log.jsonl")
    log.add(first, False, "2 tests", "uncompiled", 1.0)
    log.add(second, True, "a test", "uncompiled", 1.0)
    assert log.report(ROOT).splitlines()[0] == "2 judged, 0 equivalent, 1 of 2 noticed (50.0 %)"
    assert first.key in log.report(ROOT)
    assert not log.is_open(first.key, again=False) and log.is_open(first.key, again=True)
    log.add(first, True, "another test", "compiled", 1.0)
    again = Log(tmp_path / "log.jsonl")
    assert again.report(ROOT) == "2 judged, 0 equivalent, 2 of 2 noticed (100.0 %)"
    assert not again.is_open(first.key, again=True)
    assert again.is_open("another", again=False)


def test_a_fault_is_found_by_its_name_as_long_as_its_line_stands(tmp_path, drawn):
    first = drawn[0]
    copied = tmp_path / first.path
    copied.parent.mkdir(parents=True)
    source = (ROOT / first.path).read_text()
    copied.write_text('"""More."""\n' + source)
    assert find(first.key, first.fault.line, tmp_path).fault.line == first.fault.line + 1
    copied.write_text('"""No line of it is left."""\n')
    assert find(first.key, first.fault.line, tmp_path) is None
    copied.unlink()
    assert find(first.key, first.fault.line, tmp_path) is None


def test_draws_repeat_and_reach_every_floor(drawn):
    assert [one.key for one in drawn] == [one.key for one in choose(1, 40, ROOT)]
    assert {one.module.split(".")[1] for one in drawn} >= {"physics", "billiards", "stage", "scenes", "app"}
