"""Running a study: progress, stopping, going on, in a thread of its own."""

import math
import threading
from types import SimpleNamespace

import pytest

from game.lab import runner
from game.lab.runner import StoppedError, measure, measure_present, run_study
from game.lab.study import Knob, Method, Outcome, Row, Setting, Study, StudyTable


class Halving:
    """Halves 1 `knob` times."""

    simulated_s = 2.0

    def __init__(self, setting, calls):
        self.n = int(setting.knob)
        self.calls = calls
        self.value = 0.0

    def reset(self):
        self.calls.append("reset")
        self.value = 1.0

    def run(self):
        self.calls.append("run")
        for _ in range(self.n):
            self.value *= 0.5

    def outcome(self):
        return Outcome(math.inf if self.n > 1000 else self.value, self.n, "too few" if self.n == 1 else "")


def make_study(calls, knobs=(1, 2, 3, 4, 2000)):
    return Study(
        name="halving",
        title="Halving",
        error="what is left",
        error_unit="",
        counter="halvings",
        knob=Knob("n", "halvings"),
        methods=(Method("halve", "halving"),),
        settings=lambda: [Setting("halve", n, {"twice": 2 * n}, {"n": n}, n) for n in knobs],
        trial=lambda setting: Halving(setting, calls),
        reference="0",
        present=lambda parameters: Setting("present", parameters["n"]),
    )


def test_rows_hold_method_knob_error_cost_counter_and_scene():
    table = run_study(make_study([]))
    assert table.complete
    assert [row.knob for row in table] == [1, 2, 3, 4, 2000]
    assert [row.error for row in table][:4] == [0.5, 0.25, 0.125, 0.0625]
    assert table.rows[1][:3] == ("halve", 2.0, 0.25)
    assert all(row.cpu_s > 0.0 for row in table)
    assert table.rows[1].counter == 2
    assert table.rows[1].scene == {"n": 2}
    assert [row.failure for row in table] == ["too few", "", "", "", "not a finite number"]
    assert [row.knob for row in table.of("halve")] == [2, 3, 4]
    assert len(table.of("halve", failed=True)) == 2
    assert len(table.of("halve", failed=None)) == len(table) == 5


def test_each_point_is_warmed_up_and_repeated_seven_times():
    calls = []
    measure(make_study(calls), Setting("halve", 3))
    assert calls == ["reset", "run"] * 8
    with pytest.raises(ValueError, match="repeats"):
        measure(make_study(calls), Setting("halve", 3), repeats=0)


def test_progress_is_told_before_each_point_and_at_the_end():
    told = []
    run_study(make_study([]), lambda *news: told.append(news))
    assert [news[:3] for news in told[:-1]] == [(k, 5, "halving") for k in range(5)]
    assert told[-1] == (5, 5, "done", 0.0)
    assert math.isnan(told[0][3])
    assert all(news[3] >= 0.0 for news in told[1:])


def test_what_is_left_is_guessed_by_the_weights_of_the_points(monkeypatch):
    """Points that take as long as they weigh: what is told to be left is what comes."""
    clock = SimpleNamespace(now=0.0)
    monkeypatch.setattr(runner, "time", SimpleNamespace(perf_counter=lambda: clock.now))

    def measured(study, setting, *others):
        clock.now += 0.5 * setting.weight
        return Row(setting.method, setting.knob, 1.0, 1.0, 1, "", {}, {})

    monkeypatch.setattr(runner, "measure", measured)
    told = []
    run_study(make_study([], (1, 2, 3, 4)), lambda *news: told.append(news[3]))
    assert math.isnan(told[0]) and told[1:] == [4.5, 3.5, 2.0, 0.0]


def test_a_study_stopped_can_be_gone_on_with():
    calls = []
    study = make_study(calls)
    left = [20]

    def stop():
        left[0] -= 1
        return left[0] < 0

    told = []
    table = run_study(study, lambda *news: told.append(news), stop)
    assert not table.complete
    assert [row.knob for row in table] == [1, 2]
    assert told[-1][2] == "stopped"
    # by way of plain values, as from a file
    table = StudyTable.from_dict(study, table.to_dict())
    calls.clear()
    finished = run_study(study, table=table)
    assert finished.complete
    assert [row.knob for row in finished] == [1, 2, 3, 4, 2000]
    assert len(calls) == 3 * 16
    with pytest.raises(StoppedError):
        measure(study, Setting("halve", 1), lambda: True)


def test_a_table_of_another_study_is_refused():
    study = make_study([])
    with pytest.raises(ValueError, match="halving"):
        run_study(study, table=StudyTable(make_study([])))
    with pytest.raises(ValueError, match="belongs to 'other'"):
        StudyTable.from_dict(study, {"study": "other", "rows": []})
    with pytest.raises(ValueError, match=r"rows\[0\]"):
        StudyTable.from_dict(study, {"study": "halving", "rows": [{"knob": 1}]})


def test_a_study_runs_in_a_thread_of_its_own_while_its_table_grows():
    study = make_study([])
    table = StudyTable(study)
    seen = []
    worker = threading.Thread(
        target=run_study, args=(study, lambda *news: seen.append(len(table))), kwargs={"table": table}
    )
    worker.start()
    worker.join(600.0)
    assert seen == [0, 1, 2, 3, 4, 5]
    assert table.complete


def test_the_present_setting_of_a_scene_can_be_placed():
    row = measure_present(make_study([]), {"n": 5})
    assert (row.method, row.error) == ("present", 0.5**5)
    blind = Study("b", "B", "", "", "", Knob("n", "n"), (Method("m", "M"),), list, lambda s: None, "")
    assert measure_present(blind, {}) is None


def test_studies_check_what_they_are_made_of():
    with pytest.raises(ValueError, match="different names"):
        Study(
            "b",
            "B",
            "",
            "",
            "",
            Knob("n", "n"),
            (Method("m", "M"), Method("m", "N")),
            list,
            lambda s: None,
            "",
        )
    with pytest.raises(ValueError, match="order_over"):
        Study(
            "b",
            "B",
            "",
            "",
            "",
            Knob("n", "n"),
            (Method("m", "M"),),
            list,
            lambda s: None,
            "",
            order_over="time",
        )
    with pytest.raises(ValueError, match="no method 'x'"):
        make_study([]).method("x")
