"""The accuracy report: pages, prices of effects, and going on after an interruption."""

from __future__ import annotations

import json
import math
import signal
import threading
from pathlib import Path

import example_scene
import numpy as np
import pytest

from game.app.commands import accuracy, run_command_line
from game.app.report import prices
from game.app.report.page import SceneReport, write_page
from game.app.report.prices import Price, Prices, measure_prices
from game.billiards.shot_effects import EXACT_EFFECTS
from game.lab import Knob, Method, Outcome, Row, Setting, Study, StudyTable
from game.scenes import CATALOGUE

PARAMETERS = [0.4, 0.2, 0.1, 0.05]


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
        "settings": lambda: [Setting(method, parameter) for method in "ab" for parameter in PARAMETERS],
        "trial": Trial, "reference": "a closed form.",
    }  # fmt: skip
    return Study(**{**values, **more})


@pytest.fixture
def study(monkeypatch: pytest.MonkeyPatch) -> Study:
    made = made_study()
    monkeypatch.setattr(example_scene.BouncingBall, "study", made)
    monkeypatch.setattr(Trial, "runs", 0)
    monkeypatch.setattr(accuracy, "ENOUGH_S", 0.0)  # so that the number of runs does not depend on the clock
    from game.scenes import CATALOGUE

    monkeypatch.setattr("game.scenes.CATALOGUE", type(CATALOGUE)((CATALOGUE["example"],)))
    return made


def test_all_scenes_make_a_page_with_pictures_orders_and_prices(
    study: Study, tmp_path: Path, capsys, monkeypatch: pytest.MonkeyPatch
):
    assert run_command_line(["accuracy", "--all", "--out", str(tmp_path)]) == 0
    page = (tmp_path / "index.html").read_text(encoding="utf-8")
    assert "Made &lt;up&gt;" in page and "<td>a first</td><td>1.00</td><td>1</td>" in page
    assert "src='example/made-up.png'" in page and (tmp_path / "example" / "made-up.png").exists()
    assert "What every effect costs" in page
    for effect in example_scene.BouncingBall.effects:
        assert f"<td>{effect.label}</td>" in page
    first = Trial.runs
    with monkeypatch.context() as patch:
        patch.setattr(prices, "measure_prices", None)
        assert run_command_line(["accuracy", "--all", "--out", str(tmp_path)]) == 0
    assert Trial.runs == first  # all is there, the prices too
    assert run_command_line(["accuracy", "--all", "--anew", "--out", str(tmp_path)]) == 0
    assert Trial.runs == 2 * first
    assert str(tmp_path / "index.html") in capsys.readouterr().out


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupted_run_goes_on_where_it_stopped(study: Study, tmp_path: Path, monkeypatch, number):
    whole = measured_points(study)

    class Stopping(Trial):
        def run(self) -> None:
            super().run()
            if self.setting.key == whole[3]:
                signal.raise_signal(number)

    stopping = made_study(trial=Stopping)
    monkeypatch.setattr(example_scene.BouncingBall, "study", stopping)
    assert run_command_line(["accuracy", "example", "--out", str(tmp_path)]) == 128 + number
    kept = json.loads((tmp_path / "made-up.json").read_text(encoding="utf-8"))
    assert not kept["complete"] and 0 < len(kept["rows"]) < len(whole)
    monkeypatch.setattr(example_scene.BouncingBall, "study", study)
    Trial.runs = 0
    assert run_command_line(["accuracy", "example", "--out", str(tmp_path)]) == 0
    table = StudyTable.from_dict(study, json.loads((tmp_path / "made-up.json").read_text(encoding="utf-8")))
    assert table.complete and [row.key for row in table] == whole
    assert Trial.runs == (len(whole) - len(kept["rows"])) * 8


def test_what_was_measured_is_kept_before_the_end(study: Study, tmp_path: Path, monkeypatch):
    """Where a point cannot be interrupted the process ends under it."""
    whole = measured_points(study)

    class Ending(Trial):
        def run(self) -> None:
            if self.setting.key == whole[3]:
                raise SystemExit
            super().run()

    monkeypatch.setattr(accuracy, "KEPT_EVERY_S", 0.0)
    monkeypatch.setattr(example_scene.BouncingBall, "study", made_study(trial=Ending))
    with pytest.raises(SystemExit):
        run_command_line(["accuracy", "example", "--out", str(tmp_path)])
    table = StudyTable.from_dict(study, json.loads((tmp_path / "made-up.json").read_text(encoding="utf-8")))
    assert [row.key for row in table] == whole[:3] and not table.complete


def measured_points(study: Study) -> list:
    return [setting.key for setting in study.settings()]


@pytest.mark.parametrize(
    "text", ["", "{", "[]", "null", '{"study": "other"}', '{"study": "made-up", "rows": [3]}']
)
def test_what_was_kept_and_cannot_be_read_is_measured_again(study: Study, tmp_path: Path, text: str):
    (tmp_path / "made-up.json").write_text(text, encoding="utf-8")
    assert run_command_line(["accuracy", "example", "--out", str(tmp_path)]) == 0
    assert Trial.runs == 2 * len(PARAMETERS) * 8


def test_a_scene_without_a_study_has_its_prices_on_the_page(study: Study, tmp_path: Path, monkeypatch):
    monkeypatch.setattr(example_scene.BouncingBall, "study", None)
    assert run_command_line(["accuracy", "--all", "--out", str(tmp_path)]) == 0
    assert "What every effect costs" in (tmp_path / "index.html").read_text(encoding="utf-8")
    assert run_command_line(["accuracy", "example", "--out", str(tmp_path)]) == 2


def test_a_study_of_two_scenes_is_measured_once(study: Study, tmp_path: Path):
    known: dict[str, StudyTable] = {}
    for name in ("one", "other"):
        accuracy._measure(
            example_scene.BouncingBall, tmp_path, name, "", threading.Event(), anew=True, known=known
        )
    assert Trial.runs == 2 * len(PARAMETERS) * 8
    assert (tmp_path / "other" / "made-up.png").exists()


def test_prices_of_every_effect():
    found = measure_prices(example_scene.BouncingBall)
    assert [price.label for price in found.effects] == [e.label for e in example_scene.BouncingBall.effects]
    for price in found.effects:
        assert min(price.with_s, price.without_s, price.undeclared_s) > 0.0
        assert price.cost_s == price.with_s - price.without_s
    assert min(found.bare_s, found.step_s) > 0.0
    assert Prices.from_dict(json.loads(json.dumps(found.to_dict()))) == found


def test_tables_played_by_events_are_priced_by_a_break():
    active = EXACT_EFFECTS.without("cloth")
    assert prices._break(active, active)() > 0.0
    assert all(EXACT_EFFECTS & CATALOGUE[name].load().effects == EXACT_EFFECTS for name in prices.BY_EVENTS)


def test_a_copy_without_an_effect_does_not_declare_it():
    """The same steps as with the effect switched off: what is not declared is not computed either."""
    stage = prices._begun(example_scene.BouncingBall)
    declared = stage.scene_type.effects
    made = prices.copy_declaring(stage, declared.without("test-gravity"), declared.without("test-gravity"))
    off = stage.build_scene(stage.scene.values, declared.without("test-gravity"))
    off.restore(stage.scene.state())
    assert "test-gravity" not in type(made).effects.names
    made.restore(off.state())
    for scene in (made, off):
        scene.advance(stage.dt)
    assert [np.asarray(part).tolist() for part in made.state()] == [
        np.asarray(part).tolist() for part in off.state()
    ]


def test_a_page_without_numbers(tmp_path: Path):
    study = made_study()
    row = Row("b", 0.4, math.inf, 1.0, 1, "diverged", {}, {})
    table = StudyTable(study, [row])
    none = Prices(1e-6, math.nan, (Price("Gravity", math.nan, math.nan, math.nan),))
    report = SceneReport(example_scene.BouncingBall, (table,), "example", none)
    page = write_page([report], tmp_path / "index.html").read_text(encoding="utf-8")
    assert "nan" not in page and "inf" not in page.lower().replace("info", "")
    assert "Stopped before all points" in page and "<td class=bad>1</td>" in page
    assert "Failed: b: diverged (1 point, step 0.4 s)." in page


def test_a_page_tells_which_orders_are_as_expected(tmp_path: Path):
    rows = [Row("a", h, h, 1.0 / h, round(1 / h), "", {}, {}) for h in PARAMETERS]
    rows += [Row("b", h, h, 1.0 / h, round(1 / h), "", {}, {}) for h in PARAMETERS]
    found = Prices(1e-6, 1e-7, (Price("Gravity", 1.2e-6, 1.1e-6, 1.11e-6), Price("Drag", 1e-6, 1e-6, 1e-6)))
    report = SceneReport(
        example_scene.BouncingBall, (StudyTable(made_study(), rows, True),), "example", found
    )
    page = write_page([report], tmp_path / "index.html").read_text(encoding="utf-8")
    assert "1 of 2 fitted orders" in page
    assert "<td class=bad>1.00</td><td>2</td>" in page
    assert page.count("none to be seen") == 1 and "<td>100 ns</td>" in page.replace("\u202f", " ")
