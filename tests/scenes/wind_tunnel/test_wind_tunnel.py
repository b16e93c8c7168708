"""The wind tunnel as a person meets it: hard levels, a drawn shape, a sweep to its flights, step back."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage, prepare
from game.levels import level_files, load_level
from game.physics.tunnel.sweep import ANGLE, BOOK, DRAG
from game.scenes.wind_tunnel.hand import closed_path
from game.scenes.wind_tunnel.scene import WindTunnel
from game.scenes.wind_tunnel.view import apart_words
from game.stage import Action, Pointer, SetParameter, Stage
from game.worlds.expectations import captions_of
from tests.scenes.by_hand import measured

LEVELS = level_files("wind-tunnel")
HARD = [path for path in LEVELS if path.stem.startswith("hard-")]
QUICK = {
    "shape": "plate", "cells": 5, "height": 5.0, "reynolds": 40.0, "settle": 1.0, "window": 1.0, "angles": 8,
    "checks": 1, "pace": 6, "order": 4,
}  # fmt: skip


def opened(path) -> Stage:
    return Stage(WindTunnel, level=load_level(path, "wind-tunnel", WindTunnel.content_type))


def run_until(stage: Stage, done, most: int = 400) -> None:
    for _ in range(most):
        if done():
            return
        stage.run(1)
    raise AssertionError("it did not come to that")


def swept() -> Stage:
    stage = Stage(WindTunnel, parameters=QUICK)
    stage.post(Action("sweep"))
    run_until(stage, lambda: not stage.scene.model.sweep.running)
    return stage


@pytest.mark.parametrize("path", HARD, ids=lambda path: path.stem)
def test_a_hard_level_comes_to_what_it_expects(path):
    stage = opened(path)
    average = stage.scene.model.average
    run_until(stage, lambda: average.done)
    assert stage.scene.model.content.expected
    captions = captions_of(stage.scene.model.content.expected, stage.readouts())
    assert all(caption.met for caption in captions), captions


@pytest.mark.parametrize("path", [path for path in LEVELS if path not in HARD], ids=lambda path: path.stem)
def test_the_other_levels_open_and_run(path):
    stage = opened(path)
    stage.run(3)
    assert stage.scene.model.sweep.running == stage.scene.model.content.sweep
    assert math.isfinite(measured(stage, "drag now"))


def test_a_shape_is_drawn_by_hand_and_stands_as_it_was_drawn():
    stage = Stage(WindTunnel, parameters=QUICK)
    turn = np.linspace(0.0, 2.1 * math.pi, 40)  # a little more than once round
    x, y = 4.0 + 0.6 * np.cos(turn), 2.0 + 0.3 * np.sin(turn)
    stage.post(Pointer("down", float(x[0]), float(y[0]), button=3))
    for a, b in zip(x[1:].tolist(), y[1:].tolist(), strict=True):
        stage.post(Pointer("move", a, b, button=3))
    assert len(stage.scene.hand.path) > 30
    stage.post(Pointer("up", float(x[-1]), float(y[-1]), button=3))
    outline = stage.scene.model.tunnel.outline
    assert stage.scene.parameters.shape == "drawn" and stage.scene.parameters.attack == 0.0
    assert outline.chord == pytest.approx(1.2, abs=0.05)
    assert outline.area == pytest.approx(math.pi * 0.18, rel=0.05)
    assert not stage.scene.hand.path and measured(stage, "shapes refused") == 0
    kept = stage.scene.save_content()
    assert np.allclose(kept.outline, outline.corners)


def test_a_drawn_eight_is_refused_in_a_message_and_the_shape_stays():
    stage = Stage(WindTunnel, parameters={**QUICK, "tool": "draw"})
    area = stage.scene.model.tunnel.outline.area
    turn = np.linspace(0.0, 2.0 * math.pi, 60)
    x, y = 3.0 + 0.8 * np.sin(turn), 2.0 + 0.5 * np.sin(2.0 * turn)
    stage.post(Pointer("down", float(x[0]), float(y[0]), button=1))
    for a, b in zip(x[1:].tolist(), y[1:].tolist(), strict=True):
        stage.post(Pointer("move", a, b, button=1))
    stage.post(Pointer("up", float(x[-1]), float(y[-1]), button=1))
    assert measured(stage, "shapes refused") == 1 and stage.scene.model.tunnel.outline.area == area
    said = list(stage.scene.messages())
    assert len(said) == 1 and said[0].startswith("Refused: shape:")
    stage.post(Pointer("down", 1.0, 1.0, button=1))
    stage.post(Pointer("up", 1.0, 1.0, button=1))
    assert list(stage.scene.messages()) == ["Draw once around the shape that you want."]


def test_a_drawn_line_is_closed_where_it_comes_back_to_its_beginning():
    turn = np.linspace(0.0, 2.4 * math.pi, 121)
    path = closed_path(np.stack([np.cos(turn), np.sin(turn)], axis=1))
    assert len(path) == 101
    assert closed_path(np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]])).shape == (3, 2)


def test_a_drag_turns_the_shape_with_the_pointer():
    stage = Stage(WindTunnel, parameters={**QUICK, "attack": 10.0})
    x, y = stage.scene.model.tunnel.settings.place
    stage.post(Pointer("down", x + 1.0, y, button=1))
    stage.post(Pointer("move", x, y - 1.0, button=1))  # a quarter to the right
    assert stage.scene.parameters.attack == pytest.approx(100.0)
    assert measured(stage, "angle") == pytest.approx(100.0)
    stage.post(Pointer("move", x - 1.0, y, button=1))
    assert stage.scene.parameters.attack == pytest.approx(-170.0)
    stage.post(Pointer("up", x - 1.0, y, button=1))
    stage.post(Pointer("move", x, y + 1.0, button=1))
    assert stage.scene.parameters.attack == pytest.approx(-170.0)
    assert stage.scene.model.average.row[0] == 0.0


def test_a_sweep_measures_fits_checks_and_lets_three_fly():
    stage = swept()
    model = stage.scene.model
    assert measured(stage, "angles measured") == 3
    assert model.series is not None and model.series.order == 3
    assert model.attack == pytest.approx(stage.scene.parameters.attack)
    plate = model.plate_fit
    assert plate is not None and plate.drag > plate.drag_turn > 0.1 and plate.glide > 0.2
    assert measured(stage, "error at checks") > 0.0
    assert len(model.flights.kinds) == 3
    stage.run(30)
    falls = [measured(stage, name) for name in ("by its law", "by the fit", "as measured")]
    assert all(fall > 0.02 for fall in falls) and len({round(fall, 6) for fall in falls}) == 3
    # the curves are of what was chosen: the book's drag is another than the wall's
    drag = model.series.at(0.0)[0, 0]
    flat = model.sweep.table[0]
    assert flat[ANGLE] == 0.0 and flat[BOOK] != flat[DRAG]
    assert model.samples()[1][np.argmin(np.abs(model.samples()[0])), 0] == flat[BOOK]
    stage.post(SetParameter("measure", "wall"))
    assert model.samples()[1][np.argmin(np.abs(model.samples()[0])), 0] == flat[DRAG]
    assert model.series.at(0.0)[0, 0] != pytest.approx(drag, rel=1e-3)
    stage.post(SetParameter("order", 1))
    assert model.series.order == 1
    stage.post(Action("fly"))
    assert model.flights.clock[0] == 0.0
    stage.post(Action("next-shape"))
    assert stage.scene.parameters.shape == "aerofoil" and model.series is None
    assert len(model.flights.kinds) == 1


def test_each_angle_of_a_sweep_is_settled_and_averaged_anew(monkeypatch):
    stage = Stage(WindTunnel, parameters=QUICK)
    stage.post(Action("sweep"))
    model, spent = stage.scene.model, [0.0]
    take, keep = model.average.take, model.sweep.keep

    def timed(reading, dt):
        spent[-1] += dt
        take(reading, dt)

    def parted(mean):
        spent.append(0.0)
        return keep(mean)

    monkeypatch.setattr(model.average, "take", timed)
    monkeypatch.setattr(model.sweep, "keep", parted)
    run_until(stage, lambda: not model.sweep.running)
    whole, step = model.average.settle + model.average.window, model.tunnel.step_length
    assert len(spent) > 3 and spent[:-1] == pytest.approx([whole] * (len(spent) - 1), abs=1.5 * step)


def test_a_sweep_can_be_stopped_and_takes_no_hand():
    stage = Stage(WindTunnel, parameters=QUICK)
    stage.post(Action("sweep"))
    stage.run(2)
    assert stage.scene.why_idle("attack")
    stage.post(Pointer("down", 1.0, 1.0, button=1))
    assert "sweep" in next(iter(stage.scene.messages()))
    stage.post(Action("stop"))
    assert not stage.scene.model.sweep.running and not stage.scene.why_idle("attack")
    assert stage.scene.model.series is None


def test_a_step_back_in_a_sweep_and_in_flight_comes_to_the_same_bits():
    stage = Stage(WindTunnel, parameters=QUICK)
    stage.post(Action("sweep"))
    stage.run(8)
    for more in (6, 12):
        before, number = stage.digest(), stage.step_number
        stage.run(more)
        after = stage.digest()
        stage.return_to(number)
        assert stage.digest() == before
        stage.run(more)
        assert stage.digest() == after
    run_until(stage, lambda: not stage.scene.model.sweep.running)
    stage.run(5)
    number, before = stage.step_number, stage.digest()
    stage.run(7)
    after = stage.digest()
    stage.return_to(number)
    assert stage.digest() == before
    stage.run(7)
    assert stage.digest() == after


def test_smoke_is_let_go_at_the_same_moments_after_a_step_back():
    stage = Stage(WindTunnel, parameters={**QUICK, "courant": 0.17, "pace": 1})
    for more in (1, 2, 3):  # the nozzles open every third step
        stage.run(2)
        number = stage.step_number
        stage.run(more)
        after = stage.digest()
        stage.return_to(number)
        stage.run(more)
        assert stage.digest() == after


def test_wind_reynolds_number_and_times_act_at_once():
    stage = Stage(WindTunnel, parameters=QUICK)
    stage.run(3)
    tunnel = stage.scene.model.tunnel
    stage.post(SetParameter("reynolds", 80.0))
    assert tunnel.gas.settings.viscosity == pytest.approx(1.0 / 80.0)
    stage.post(SetParameter("wind", 2.0))
    assert tunnel.gas.settings.viscosity == pytest.approx(2.0 / 80.0)
    assert stage.scene.model.average.settle == pytest.approx(0.5)
    stage.post(SetParameter("window", 3.0))
    assert stage.scene.model.average.window == pytest.approx(1.5)
    stage.post(SetParameter("inertia", 3.0))
    assert stage.scene.model.flights.clock[0] == 0.0
    stage.post(SetParameter("attack", -40.0))
    assert math.degrees(tunnel.attack) == pytest.approx(-40.0)


def test_the_picture_has_the_air_in_each_view_and_all_that_can_be_shown():
    prepare()
    seen = set()
    stage = swept()
    for view in ("smoke", "vorticity", "pressure", "speed"):
        stage.post(SetParameter("view", view))
        stage.post(SetParameter("box", view == "smoke"))
        seen.add(np.asarray(picture_of_stage(stage, (480, 270), "light").get_buffer()).tobytes())
    assert len(seen) == 4


@pytest.mark.parametrize("moment", [-0.3, 0.2, 5.0])
def test_the_dot_of_the_moment_is_where_its_arc_ends(monkeypatch, moment: float):
    """About the middle of the shape, as far as the arc goes, and against its own sense of turning."""
    view = Stage(WindTunnel).scene.view
    mean = view.model.mean()
    force = np.array((1.1, 0.4, moment))
    monkeypatch.setattr(view.model, "mean", lambda: mean._replace(book=force, wall=force))
    drawn = {}

    class Paper:
        def arrow(self, at, vector, color, label):
            drawn[label] = (at, vector)

        def arc(self, center, radius, start, end, color, width):
            drawn["arc"] = (center, radius, start, end)

        def dot(self, place, radius, color):
            drawn["dot"] = place

    view._draw_forces(Paper(), (0.7, -0.2))
    center, radius, start, end = drawn["arc"]
    assert center == (0.7, -0.2) and (end - start) * moment < 0.0
    away = np.subtract(drawn["dot"], center)
    assert math.hypot(*away) == pytest.approx(radius)
    assert away == pytest.approx([radius * math.cos(end), radius * math.sin(end)])
    (_, along), (_, across) = drawn["D"], drawn["L"]
    assert along[1] == across[0] == 0.0
    assert along[0] / across[1] == pytest.approx(1.1 / 0.4)


def test_before_a_sweep_nothing_is_told_of_fit_and_flight():
    stage = Stage(WindTunnel, parameters={"cells": 8})
    stage.run(20)
    for name in ("by the fit", "as measured", "glide, measured", "fit residual", "drag, A", "lift, C_T"):
        assert math.isnan(measured(stage, name)), name
    assert measured(stage, "by its law") > 0.0


def test_a_drag_that_differs_at_the_wall_is_told_with_the_cells():
    stage = Stage(WindTunnel, parameters={"cells": 8})
    assert apart_words(stage.scene.model) == ""
    stage.run(150)
    more = 100.0 * (measured(stage, "drag, wall") / measured(stage, "drag") - 1.0)
    assert abs(more) > 5.0
    words = apart_words(stage.scene.model)
    assert words.startswith(f"drag at the wall {abs(more):.0f} % {'more' if more > 0.0 else 'less'}")
    assert words.endswith("8 cells a chord")
