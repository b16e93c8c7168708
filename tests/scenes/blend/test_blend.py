"""Splashes between splashes: the square of nine beside true runs, links, what is shown, its page."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage
from game.levels import LevelError, level_files, load_level
from game.scenes.blend import paper
from game.scenes.blend.level import BlendContent, RunEntry, WaterEntry
from game.scenes.blend.recording import between, recorded
from game.scenes.blend.scene import SplashBlend
from game.stage import Pointer, Stage
from tests.scenes.by_hand import measured

LEVELS = {path.stem: path for path in level_files("splash-blend")}


def opened(name: str = "default", **parameters) -> Stage:
    return Stage(
        SplashBlend, level=load_level(LEVELS[name], "splash-blend", BlendContent), parameters=parameters
    )


@pytest.fixture(scope="module")
def dams() -> Stage:
    return opened("dams")


def test_nine_dams_from_four_lie_near_true_runs(dams):
    """Corners are the recorded runs to the last bit; the five between within a tenth of the true area."""
    squares = dams.scene.model.squares
    assert len(squares) == 9
    for one in squares:
        if 1.0 in one.weights:
            assert np.array_equal(one.blended, one.true) and one.area == one.misplaced == 0.0
        else:
            assert 0.0 < one.area < 0.08 and 0.0 < one.misplaced < 0.12
    assert measured(dams, "area off, 0.5 0.5") == squares[4].area


def test_alignment_is_nearer_to_true_runs_than_plain_mixing(dams):
    """By the liquid that lies elsewhere in the middle of the square, at each third of the run."""
    model: Any = dams.scene.model
    one = model.squares[4]
    inside = model.dry(one.entry)
    for frame in (10, 15, 20):
        plain, true = model.blend.at(frame, one.weights, False), one.true[frame]
        apart = [
            model.area(np.minimum(found, true), inside) - model.area(np.maximum(found, true), inside)
            for found in (one.blended[frame], plain)
        ]
        assert apart[0] < apart[1]


def test_drops_that_never_meet_vanish_only_plainly():
    stage = opened("hard-01-never-meet")
    assert "not equally long" in "".join(_said(stage, 3))
    assert measured(stage, "error, plain") == -1.0
    assert abs(measured(stage, "error, aligned")) < 0.1


def test_an_empty_run_is_stated():
    assert "no surface" in "".join(_said(opened("hard-02-empty"), 3))


def _said(stage: Stage, steps: int) -> list[str]:
    said: list[str] = []
    for _ in range(steps):
        stage.run(1)
        said += stage.scene.messages()
    return said


def test_a_link_is_drawn_from_the_first_tank_and_forgotten():
    stage = opened("hard-01-never-meet")
    model: Any = stage.scene.model
    (ax, ay), (bx, by) = model.corners()
    before = model.blend.shifts.copy()
    for start, end, count in (
        ((ax + 0.3, ay + 0.6), (bx + 1.3, by + 0.6), 1),
        ((bx + 0.3, by + 0.6), (ax + 1.3, ay + 0.6), 1),
    ):
        stage.scene.pointer(Pointer("down", *start, 1))
        stage.scene.pointer(Pointer("up", *end, 1))
        assert len(model.links) == count == measured(stage, "links")
    assert not np.array_equal(before, model.blend.shifts)
    assert model.links[0, 5:] == pytest.approx([0.6, 1.3])
    kept = stage.scene.state()
    stage.scene.pointer(Pointer("down", *start, 3))
    stage.scene.pointer(Pointer("up", *start, 3))
    assert len(model.links) == 0 and np.array_equal(before, model.blend.shifts)
    stage.scene.restore(kept)
    assert len(model.links) == 1 and not np.array_equal(before, model.blend.shifts)


def test_a_drop_that_is_linked_to_a_drop_is_one_drop_between():
    """Two links of the default level: halfway lies one disc, at the mean place, with the mean radius."""
    model: Any = opened().scene.model
    inside = model.blend.at(0, (0.5, 0.5)) < 0.0
    rows, columns = np.nonzero(inside)
    falling = rows * model.cell > 0.3
    x, y = columns[falling] * model.cell, rows[falling] * model.cell
    assert (x.mean(), y.mean()) == pytest.approx((0.5 * (0.45 + 1.1), 0.5 * (0.55 + 0.62)), abs=model.cell)
    area = np.count_nonzero(falling) * model.cell**2
    assert area == pytest.approx(np.pi * 0.12**2, rel=0.15)
    still = model.blend.at(0, (0.5, 0.5), False)
    assert not np.any(still[round(0.3 / model.cell) :] < 0.0)


def test_a_link_names_a_run_that_is_there(tmp_path):
    file = tmp_path / "third.toml"
    file.write_text(
        LEVELS["default"].read_text().replace("[[content.links]]", "[[content.links]]\nrun = 3", 1)
    )
    with pytest.raises((LevelError, ValueError), match="number of runs"):
        Stage(SplashBlend, level=load_level(file, "splash-blend", BlendContent))


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_water_is_seen_in_each_tank_and_nowhere_else(theme):
    stage = opened()
    stage.run(10)
    picture = picture_of_stage(stage, (640, 360), theme)
    pixels = np.array([[picture.get_at((x, y))[:3] for x in range(640)] for y in range(360)], int)
    watery = (pixels[..., 2] > pixels[..., 0] + 35) & (pixels[..., 2] > 60)
    for rows in (slice(0, 180), slice(180, 360)):
        for columns in (slice(0, 320), slice(320, 640)):
            assert 0.05 < watery[rows, columns].mean() < 0.3
    assert not watery[:, :60].any() and not watery[:, -60:].any() and not watery[:20].any()


def test_numbers_between_runs_are_their_means_and_a_wall_stays_dry():
    low = RunEntry(water=(WaterEntry(high=(0.2, 0.4)),), at=0.8, width=0.2, height=0.2, seconds=0.2)
    high = RunEntry(water=(WaterEntry(high=(0.4, 0.4)),), at=0.8, width=0.4, height=0.4, seconds=0.4)
    mean = between((low, high), (0.25, 0.75))
    assert (mean.width, mean.seconds, *mean.water[0].high) == pytest.approx((0.35, 0.35, 0.35, 0.4))
    run = recorded(low, (1.6, 0.9), 32)
    assert run.distance.shape == (7, 10, 17) and run is recorded(low, (1.6, 0.9), 32)
    with pytest.raises(ValueError, match="as many"):
        between((low, RunEntry()), (0.5, 0.5))


def test_three_runs_are_refused(tmp_path):
    file = tmp_path / "three.toml"
    file.write_text(LEVELS["default"].read_text() + "\n[[content.runs]]\n")
    with pytest.raises((LevelError, ValueError), match="two or four"):
        Stage(SplashBlend, level=load_level(file, "splash-blend", BlendContent))


def test_the_page_measures_what_it_claims():
    assert paper.lost_at_ends(paper.pair(2.5)) == 0.0
    assert paper.kept(paper.pair(1.5), False) == pytest.approx(paper.lens(1.5), abs=0.01)
