"""The accuracy report: pages, prices of effects, and going on after an interruption."""

from __future__ import annotations

import json
import math
from pathlib import Path

import example_scene
import pytest

from game.app.commands import accuracy, run_command_line
from game.app.report.page import SceneReport, write_page
from game.app.report.prices import Price, Prices, measure_prices
from game.lab import Knob, Method, Outcome, Row, Setting, Study, StudyTable

KNOBS = [0.4, 0.2, 0.1, 0.05]


class Trial:
    """Counts how often it is run."""

    runs = 0
    simulated_s = 1.0

    def __init__(self, setting: Setting):
        self.setting = setting

    def reset(self) -> None:
        pass

    def run(self) -> None:
        type(self).runs += 1

    def outcome(self) -> Outcome:
        failed = self.setting.knob > 0.3 and self.setting.method == "b"
        return Outcome(
            self.setting.knob ** (1 + (self.setting.method == "b")), 1, "diverged" if failed else ""
        )


def made_study(**more) -> Study:
    values = {
        "name": "made-up", "title": "Made <up>", "error": "distance", "error_unit": "m", "counter": "steps",
        "knob": Knob("step", "step", "s"), "methods": (Method("a", "a first", 1.0), Method("b", "b", 2.0)),
        "settings": lambda: [Setting(method, knob) for method in "ab" for knob in KNOBS],
        "trial": Trial, "reference": "a closed form.",
    }  # fmt: skip
    return Study(**{**values, **more})


@pytest.fixture
def study(monkeypatch: pytest.MonkeyPatch) -> Study:
    made = made_study()
    monkeypatch.setattr(example_scene.BouncingBall, "study", made)
    monkeypatch.setattr(Trial, "runs", 0)
    from game.scenes import CATALOGUE

    monkeypatch.setattr("game.scenes.CATALOGUE", type(CATALOGUE)((CATALOGUE["example"],)))
    return made


def test_all_scenes_make_a_page_with_pictures_orders_and_prices(study: Study, tmp_path: Path, capsys):
    assert run_command_line(["accuracy", "--all", "--out", str(tmp_path)]) == 0
    page = (tmp_path / "index.html").read_text(encoding="utf-8")
    assert "Made &lt;up&gt;" in page and "<td>a first</td><td>1.00</td><td>1</td>" in page
    assert "src='example/made-up.png'" in page and (tmp_path / "example" / "made-up.png").exists()
    assert "What every effect costs" in page
    for effect in example_scene.BouncingBall.effects:
        assert f"<td>{effect.label}</td>" in page
    first = Trial.runs
    assert run_command_line(["accuracy", "--all", "--out", str(tmp_path)]) == 0
    assert Trial.runs == first  # all is there
    assert run_command_line(["accuracy", "--all", "--anew", "--out", str(tmp_path)]) == 0
    assert Trial.runs == 2 * first
    assert str(tmp_path / "index.html") in capsys.readouterr().out


def test_an_interrupted_run_goes_on_where_it_stopped(study: Study, tmp_path: Path, monkeypatch):
    whole = measured_points(study)

    class Stopping(Trial):
        def run(self) -> None:
            super().run()
            if self.setting.key == whole[3]:
                import os
                import signal

                os.kill(os.getpid(), signal.SIGINT)

    stopping = made_study(trial=Stopping)
    monkeypatch.setattr(example_scene.BouncingBall, "study", stopping)
    assert run_command_line(["accuracy", "example", "--out", str(tmp_path)]) == accuracy.INTERRUPTED
    kept = json.loads((tmp_path / "made-up.json").read_text(encoding="utf-8"))
    assert not kept["complete"] and 0 < len(kept["rows"]) < len(whole)
    monkeypatch.setattr(example_scene.BouncingBall, "study", study)
    Trial.runs = 0
    assert run_command_line(["accuracy", "example", "--out", str(tmp_path)]) == 0
    table = StudyTable.from_dict(study, json.loads((tmp_path / "made-up.json").read_text(encoding="utf-8")))
    assert table.complete and [row.key for row in table] == whole
    assert Trial.runs == (len(whole) - len(kept["rows"])) * 8


def measured_points(study: Study) -> list:
    return [setting.key for setting in study.settings()]


@pytest.mark.parametrize(
    "text", ["", "{", "[]", "null", '{"study": "other"}', '{"study": "made-up", "rows": [3]}']
)
def test_what_was_kept_and_cannot_be_read_is_measured_again(study: Study, tmp_path: Path, text: str):
    (tmp_path / "made-up.json").write_text(text, encoding="utf-8")
    assert run_command_line(["accuracy", "example", "--out", str(tmp_path)]) == 0
    assert Trial.runs == 2 * len(KNOBS) * 8


def test_prices_of_every_effect():
    prices = measure_prices(example_scene.BouncingBall)
    assert [price.label for price in prices.effects] == [e.label for e in example_scene.BouncingBall.effects]
    assert math.isfinite(prices.bare_s) and prices.step_s > 0.0


def test_a_page_without_numbers(tmp_path: Path):
    study = made_study()
    row = Row("b", 0.4, math.inf, 1.0, 1, "diverged", {}, {})
    table = StudyTable(study, [row])
    prices = Prices(1e-6, math.nan, (Price("Gravity", math.nan),))
    report = SceneReport(example_scene.BouncingBall, (table,), "example", prices)
    page = write_page([report], tmp_path / "index.html").read_text(encoding="utf-8")
    assert "nan" not in page and "inf" not in page.lower().replace("info", "")
    assert "Stopped before all points" in page and "<td class=bad>1</td>" in page
