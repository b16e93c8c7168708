"""Reports: what stands in the files, and what happens without matplotlib."""

import csv
import dataclasses
import math
import sys

import pytest

from game.lab.report import PlotsMissingError, write_report
from game.lab.study import Axes, Knob, Method, Row, Study, StudyTable

STUDY = Study(
    name="made-up",
    title="Made up",
    error="distance",
    error_unit="m",
    counter="steps",
    knob=Knob("step_length", "step", "s"),
    methods=(Method("euler", "Euler", 1.0), Method("exact", "exact"), Method("idle", "never run")),
    settings=list,
    trial=lambda setting: None,
    reference="a closed form.",
    expectation="A straight line.",
)


def made_up():
    rows = [
        Row("euler", h, 3.0 * h, 1e-3 / h, int(1 / h), "", {"passes": 2}, {"order": "joint"})
        for h in (0.1, 0.05, 0.025, 0.0125)
    ]
    rows.append(Row("euler", 0.5, math.inf, 2e-3, 2, "diverged", {"passes": 2}, {}))
    rows.append(Row("euler", 0.9, 7.0, 1e-3, 1, "diverged", {"passes": 2}, {}))
    rows.append(Row("exact", 0.1, 0.0, 1e-4, 7, "", {}, {}))
    return StudyTable(STUDY, rows, complete=True)


def test_csv_holds_every_row(tmp_path):
    files = write_report(made_up(), tmp_path / "deep" / "report")
    assert [file.name for file in files] == ["made-up.csv", "made-up.png", "made-up.md"]
    with files[0].open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 7
    assert rows[0] == {
        "method": "euler",
        "step_length": "0.1",
        "error": repr(3.0 * 0.1),
        "cpu_s": "0.01",
        "counter": "10",
        "failure": "",
        "passes": "2",
        "scene.order": "joint",
    }
    assert rows[4]["failure"] == "diverged"


def test_markdown_tells_orders_costs_and_failures(tmp_path):
    text = write_report(made_up(), tmp_path)[2].read_text(encoding="utf-8")
    assert "# Made up" in text
    assert "| points | failed | out of order |" in text
    assert "![Made up](made-up.png)" in text
    assert "| Euler | 1 | 1 | " in text
    assert "- Euler: diverged (2 points, step 0.5 to 0.9 s)" in text
    assert "A straight line." in text
    assert "stopped" not in text
    unfinished = made_up()
    unfinished.complete = False
    assert "stopped" in write_report(unfinished, tmp_path)[2].read_text(encoding="utf-8")


def test_picture_is_a_png_and_the_same_each_time(tmp_path):
    first = write_report(made_up(), tmp_path / "a")[1].read_bytes()
    second = write_report(made_up(), tmp_path / "b")[1].read_bytes()
    assert first.startswith(b"\x89PNG")
    assert len(first) > 5000
    assert first == second


def test_a_table_without_a_usable_row_makes_a_report(tmp_path):
    assert len(write_report(StudyTable(STUDY), tmp_path)) == 3


def test_without_matplotlib_the_rest_is_written(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    with pytest.raises(PlotsMissingError, match="matplotlib"):
        write_report(made_up(), tmp_path)
    assert sorted(file.name for file in tmp_path.iterdir()) == ["made-up.csv", "made-up.md"]
    assert "png" not in (tmp_path / "made-up.md").read_text(encoding="utf-8")


def test_a_study_of_cost_tells_where_it_is_least(tmp_path):
    study = dataclasses.replace(STUDY, axes=Axes("knob", "cpu"))
    rows = [Row("euler", h, 1.0, (h - 0.3) ** 2 + 0.01, 1, "", {}, {}) for h in (0.1, 0.2, 0.3, 0.4)]
    files = write_report(StudyTable(study, rows, True), tmp_path)
    text = files[2].read_text(encoding="utf-8")
    assert "| least cost | at step |" in text and "cost of" not in text
    assert "out of order" not in text
    assert "| Euler |" in text and "| 0.01 | 0.3 |" in text
    assert files[1].stat().st_size > 1000
