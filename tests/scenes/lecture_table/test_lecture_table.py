"""The lecture's table as a scene: the cue by posted events, the levels of its hard cases, digests."""

import math
from pathlib import Path

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage
from game.billiards.lecture.settings import DEFAULTS, lecture_settings
from game.billiards.table.rack import BALL_RADIUS as R
from game.levels import LevelError, level_files, load_level
from game.scenes.lecture_table.scene import LectureTable
from game.scenes.lecture_table.view import velocity_words
from game.stage import Action, Pointer, SetEffect, SetParameter, Stage
from game.ui.canvas.canvas import Canvas

MASS = 0.170097


def open_level(name: str, **parameters) -> Stage:
    path = next(path for path in level_files("lecture-table") if path.stem == name)
    level = load_level(path, "lecture-table", LectureTable.content_type)
    return Stage(LectureTable, level=level, parameters=parameters)


def seconds(stage: Stage, s: float) -> Stage:
    stage.run(round(s / stage.dt))
    assert stage.fault is None
    return stage


def free_table(**parameters) -> Stage:
    return open_level("free-play", **parameters)


def pull_and_release(stage: Stage, back: float) -> None:
    """Aim straight up the table, pull ``back`` metres, let go."""
    x, y = stage.scene.model.table.positions[0]
    stage.post(Pointer("move", x, y + 1.0))
    stage.post(Pointer("down", x, y + 1.0, button=1))
    stage.post(Pointer("move", x, y + 1.0 - back, button=1))
    stage.post(Pointer("up", x, y + 1.0 - back, button=1))


# -- the cue ------------------------------------------------------------------------------------------


def test_aim_follows_the_pointer_and_shift_makes_it_fine():
    stage = free_table()
    x, y = stage.scene.model.table.positions[0]
    stage.post(Pointer("move", x + 1.0, y))
    assert stage.scene.cue.aim == pytest.approx(0.0, abs=1e-12)
    stage.post(Pointer("move", x + 1.0, y + 1.0, shift=True))
    assert stage.scene.cue.aim == pytest.approx(0.1 * math.pi / 4, abs=1e-12)


def test_a_longer_pull_strikes_harder_and_the_ball_gets_that_speed():
    speeds = []
    for back in (0.1, 0.2, 0.4):
        stage = free_table(friction=1.0, minimum_speed=0.0)
        pull_and_release(stage, back)
        wanted = stage.scene.cue.speed
        for _ in range(200):
            stage.run(1)
            if stage.scene.model.strokes:
                break
        speed = np.linalg.norm(stage.scene.model.table.velocities[0])
        assert speed == pytest.approx(wanted, rel=1e-12)
        speeds.append(speed)
    assert speeds == sorted(speeds) and speeds[0] > 1.0


def test_escape_takes_the_stroke_back():
    stage = free_table()
    x, y = stage.scene.model.table.positions[0]
    stage.post(Pointer("down", x, y + 1.0, button=1))
    stage.post(Pointer("move", x, y + 0.7, button=1))
    assert stage.scene.cue.speed > 0.0
    stage.post(Pointer("cancel", x, y))
    stage.post(Pointer("up", x, y, button=1))
    seconds(stage, 1.0)
    assert stage.scene.model.strokes == 0 and not stage.scene.model.table.moving


def test_two_cues_take_turns_and_a_potted_cue_ball_comes_back():
    stage = free_table()
    pull_and_release(stage, 0.02)
    seconds(stage, 8.0)
    assert stage.scene.model.strokes == 1 and stage.scene.turns.player == 1
    table = stage.scene.model.table
    pocket = table.table.pockets[0, :2]
    table.place(0, (R + 0.1, R + 0.1))
    path = pocket - table.positions[0]
    table.strike(0, 1.5 * path / np.linalg.norm(path))
    stage.scene.turns.rest_s = 0.0
    for _ in range(2000):
        stage.run(1)
        if not table.state.in_play[0]:
            break
    assert not table.state.in_play[0]
    seconds(stage, 3.0)
    assert table.state.in_play[0] and stage.scene.turns.player == 0
    assert any("cue ball" in line for line in stage.scene.messages())


def test_the_table_plays_by_itself_until_somebody_takes_the_cue():
    stage = open_level("default")
    seconds(stage, 12.0)
    assert stage.scene.model.strokes >= 1
    stage.post(Pointer("down", 0.6, 0.6, button=1))
    stage.post(Pointer("cancel", 0.6, 0.6))
    strokes = stage.scene.model.strokes
    seconds(stage, 20.0)
    assert stage.scene.model.strokes == strokes
    stage.post(Action("rack"))
    assert stage.scene.model.strokes == 0 and stage.scene.model.balls_down == 0


def test_no_ball_is_lost_and_a_cleared_table_is_racked_again():
    stage = open_level("default")
    racks = 0
    for _ in range(120):
        before = stage.scene.model.balls_down
        seconds(stage, 5.0)
        state = stage.scene.model.table.state
        assert np.all(state.in_play | (state.pocketed_by >= 0))
        assert np.isfinite(state.offsets).all()
        racks += stage.scene.model.balls_down < before
    assert racks >= 1


# -- what every scene promises ------------------------------------------------------------------------


def test_two_runs_and_a_run_saved_half_way_give_one_digest():
    def played(stage: Stage) -> Stage:
        stage.run(100)
        pull_and_release(stage, 0.3)
        stage.run(200)
        stage.post(SetParameter("restitution", 0.8))
        stage.run(200)
        return stage

    first, second = played(free_table()), played(free_table())
    assert first.digest() == second.digest()
    for _ in range(50):
        first.step_back()
    assert first.digest() != second.digest()
    first.run(50)
    assert first.digest() == second.digest()


def test_defaults_are_those_of_the_table_and_a_change_reaches_it():
    stage = free_table()
    assert stage.scene.model.table.settings == DEFAULTS
    stage.post(SetParameter("restitution", 0.5))
    stage.post(SetParameter("rule", "scaled"))  # impulses are not for this rule, so pair by pair
    expected = lecture_settings(restitution=0.5, rule="scaled", order="pairwise")
    assert stage.scene.model.table.settings == expected
    stage.post(SetParameter("rule", "conserving"))
    assert stage.scene.model.table.settings == DEFAULTS._replace(restitution=0.5)


def test_effects_can_be_switched_and_what_is_off_does_nothing():
    stage = open_level("hard-04-corner")
    for name in stage.scene.effects.names:
        stage.post(SetEffect(name, False))
    before = stage.scene.model.table.velocities.copy()
    seconds(stage, 0.5)
    assert np.array_equal(before, stage.scene.model.table.velocities)
    assert stage.scene.model.table.positions[0, 0] > stage.scene.model.table.table.width  # no wall held it


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("table = 'snooker'", "table"),
        ("balls = [{ number = 99, position = [0.1, 0.1] }]", "number"),
        ("balls = [{ number = 1, position = [9.0, 0.1] }]", "outside"),
        ("balls = [{ number = 1, position = [0.1, 0.1], radius = -1.0 }]", "radius"),
        ("balls = [{ number = 1, position = [0.1, nan] }]", "position"),
        ("rack = false", "at least one ball"),
        ("colour = 'red'", "colour"),
    ],
)
def test_a_broken_level_is_one_line_that_names_the_field(tmp_path: Path, content: str, words: str):
    path = tmp_path / "broken.toml"
    path.write_text(f'scene = "lecture-table"\n[content]\n{content}\n')
    with pytest.raises(LevelError) as caught:
        Stage(LectureTable, level=load_level(path, "lecture-table", LectureTable.content_type))
    line = str(caught.value)
    assert "broken.toml" in line and words in line and "\n" not in line


def test_the_table_is_saved_and_loaded_as_it_lies(tmp_path: Path):
    stage = seconds(free_table(), 0.1)
    pull_and_release(stage, 0.4)
    seconds(stage, 1.5)
    content = stage.scene.save_content()
    again = LectureTable(None)
    assert again.model.numbers.tolist() == list(range(16))
    kept = {row.number: row for row in content.balls}
    for i, place in enumerate(stage.scene.model.table.positions.tolist()):
        if stage.scene.model.table.state.in_play[i]:
            assert kept[i].position == tuple(place)


# -- the hard cases, as levels -------------------------------------------------------


def test_one_substep_tunnels_and_automatic_substeps_do_not():
    through = seconds(open_level("hard-01-tunnelling"), 0.15)
    assert through.scene.model.marks.unseen == 1  # and the picture says so
    assert not through.scene.model.table.velocities[1].any()
    assert through.scene.model.table.positions[0, 1] > through.scene.model.table.positions[1, 1]
    held = seconds(open_level("hard-01-tunnelling", substeps=0), 0.15)
    assert held.scene.model.marks.unseen == 0
    assert held.scene.model.table.velocities[1, 1] > 7.0


def test_a_thin_hit_is_missed_with_one_substep_only():
    missed = seconds(open_level("hard-02-grazing"), 0.35)
    assert missed.scene.model.marks.unseen == 1
    assert not missed.scene.model.table.velocities[1].any()
    hit = seconds(open_level("hard-02-grazing", substeps=64), 0.35)
    assert hit.scene.model.marks.unseen == 0
    assert hit.scene.model.table.velocities[1].any()


def test_absurd_speed_stays_on_the_table_with_its_energy():
    stage = open_level("hard-03-overshoot")
    energy = stage.scene.model.table.energy
    for _ in range(100):
        stage.run(1)
        x, y = stage.scene.model.table.positions[0]
        assert R - 1e-9 <= x <= 1.27 - R + 1e-9 and R - 1e-9 <= y <= 2.54 - R + 1e-9
    assert stage.scene.model.table.energy == pytest.approx(energy, rel=1e-12)


def test_both_cushions_turn_it_round():
    stage = seconds(open_level("hard-04-corner"), 0.5)
    assert (stage.scene.model.table.velocities[0] < 0.0).all()
    vx, vy = stage.scene.model.table.velocities[0]
    assert vx == pytest.approx(vy, rel=1e-12)


def test_the_pressed_ball_stays_out_of_the_wood():
    stage = open_level("hard-05-pressed")
    for _ in range(120):
        stage.run(1)
        assert stage.scene.model.table.positions[1, 1] <= 2.54 - R + 1e-9


def test_a_compressed_rack_opens_without_gaining_energy():
    stage = open_level("hard-06-compressed-rack")
    assert stage.scene.model.table.deepest_overlap > 0.004
    stage.run(1)
    assert stage.scene.model.table.deepest_overlap < 2.6e-5 * 2 * R
    assert stage.scene.model.table.energy == 0.0


def test_momentum_and_energy_of_the_break_are_those_of_the_cue_ball():
    stage = open_level("hard-07-break")
    while not stage.scene.model.strokes:
        stage.run(1)
    for _ in range(400):
        stage.run(1)
        speeds = np.abs(stage.scene.model.table.velocities).max(axis=1)
        if (speeds > 0.0).sum() > 3:
            break
    assert stage.scene.model.table.momentum[0] == pytest.approx(0.0, abs=1e-14)
    assert stage.scene.model.table.momentum[1] == pytest.approx(8.0 * MASS, rel=1e-14)
    assert stage.scene.model.table.energy == pytest.approx(0.5 * MASS * 64.0, rel=1e-12)


def test_a_symmetric_break_stays_symmetric_when_solved_jointly_only():
    def asymmetry(stage: Stage) -> float:
        while not stage.scene.model.strokes:
            stage.run(1)
        seconds(stage, 0.6)
        offsets = stage.scene.model.table.state.offsets
        mirrored = offsets * (-1.0, 1.0)
        gaps = np.abs(offsets[:, None, :] - mirrored[None, :, :]).max(axis=2)
        return float(gaps.min(axis=1).max())

    # the stroke's direction is off by the rounding of cos(pi / 2), 6e-17; only chaos may add to that
    assert asymmetry(open_level("hard-08-symmetric-break")) < 1e-12
    assert asymmetry(open_level("hard-08-symmetric-break", order="pairwise")) > 0.01


def test_one_ball_comes_one_ball_leaves():
    stage = seconds(open_level("hard-09-cradle"), 0.35)
    speeds = stage.scene.model.table.velocities[:, 1]
    assert speeds[-1] == pytest.approx(2.0, abs=1e-12)
    assert np.abs(speeds[:-1]).max() <= 1e-12


def test_balls_in_contact_rest_and_coincident_ones_separate():
    stage = seconds(open_level("hard-10-touching"), 1.0)
    places = stage.scene.model.table.positions
    assert places[0].tolist() == [0.4, 1.0] and places[1, 0] == pytest.approx(0.45715, abs=1e-15)
    assert stage.scene.model.table.deepest_overlap < 1e-9
    assert stage.scene.model.table.energy == 0.0


def test_the_factor_per_frame_shortens_the_path_and_the_factor_per_second_does_not():
    def distance(**parameters) -> float:
        stage = seconds(open_level("hard-11-friction-factor", **parameters), 12.0)
        assert not stage.scene.model.table.moving
        return float(stage.scene.model.table.positions[0, 1]) - 1.0

    assert distance() == pytest.approx(0.83, abs=0.01)  # 240 frames a second
    assert distance(friction_law="consistent") == pytest.approx(3.3042, abs=5e-4)
    assert distance(friction_law="consistent", step_length=1 / 60) == pytest.approx(3.3168, abs=5e-4)


def test_a_stopped_ball_wakes_when_it_is_pushed():
    stage = open_level("hard-12-minimum-speed")
    stopped = 0
    moving_before = True
    for _ in range(round(2.0 / stage.dt)):
        stage.run(1)
        moving = bool(stage.scene.model.table.velocities[1].any())
        stopped += moving_before and not moving
        if stage.scene.model.table.velocities[1, 1] > 0.3:
            break
        moving_before = moving
    assert stopped == 1
    assert stage.scene.model.table.velocities[1, 1] > 0.3


def test_a_dead_cushion_takes_the_normal_speed_only():
    stage = seconds(open_level("hard-13-dead-cushion"), 1.0)
    vx, vy = stage.scene.model.table.velocities[0]
    assert vx == 0.0 and vy == 0.5
    assert stage.scene.model.table.positions[0, 0] == pytest.approx(1.27 - R, abs=1e-12)


def test_wedged_balls_do_not_tremble():
    stage = seconds(open_level("hard-14-wedged"), 1.0)
    before = stage.scene.model.table.positions.copy()
    seconds(stage, 1.0)
    assert np.abs(stage.scene.model.table.positions - before).max() <= 1e-12


def test_as_printed_loses_momentum_and_the_default_does_not():
    """The printed rule on the break, before any cushion."""

    def momentum(**parameters) -> float:
        stage = open_level("hard-07-break", **parameters)
        while not stage.scene.model.strokes:
            stage.run(1)
        seconds(stage, 0.18)
        return stage.scene.model.table.momentum[1]

    assert momentum() == pytest.approx(8.0 * MASS, rel=1e-12)
    assert abs(momentum(rule="as-printed", restitution=0.9) - 8.0 * MASS) > 0.05


# -- what is said ---------------------------------------------------------------------------------------


def words_of(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The words in the picture."""
    said: list[str] = []
    monkeypatch.setattr(Canvas, "label", lambda canvas, position, text, *more, **other: said.append(text))
    picture_of_stage(stage, (640, 400))
    return said


def test_a_table_that_plays_itself_says_so_until_a_person_takes_the_cue(monkeypatch: pytest.MonkeyPatch):
    stage = Stage(LectureTable)
    assert any("plays itself" in words for words in words_of(stage, monkeypatch))
    stage.post(Pointer("down", 0.6, 1.2, button=1))
    stage.post(Pointer("up", 0.6, 1.2, button=1))
    assert not any("plays itself" in words for words in words_of(stage, monkeypatch))


def test_the_rings_of_contacts_are_explained(monkeypatch: pytest.MonkeyPatch):
    assert any("contact" in words for words in words_of(free_table(), monkeypatch))


def test_speed_direction_and_components_of_the_cue_ball_are_written_while_it_moves():
    stage = open_level("free-play")
    model = stage.scene.model
    assert velocity_words(model) == ("", "")
    model.strike(math.radians(150.0), 4.0, stage.dt)  # from the x axis, which is across the table
    assert velocity_words(model) == ("4.00 m/s at 60°", "along 2.00, across −3.46")
    readouts = {row.name: row.value for row in stage.readouts()}
    assert readouts["its velocity along"] == pytest.approx(2.0)
    assert readouts["its velocity across"] == pytest.approx(-2.0 * math.sqrt(3.0))
