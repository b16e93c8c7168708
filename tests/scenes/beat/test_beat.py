"""On the beat: taps, the search as a player of its own, the shot that is played, and levels that hold one."""

import pytest

from game.levels import LevelError, level_files, load_level, parse_level
from game.scenes.beat.model import SHOWN_S
from game.scenes.beat.scene import Beat
from game.scenes.beat.state import PLAYING, SEARCHING, SILENT, TAPPING
from game.stage import Action, Decision, Pointer, Stage

LEVELS = level_files("p22")


def level_of(text: str):
    return parse_level('scene = "p22"\ntitle = "T"\n[content]\n' + text, "p22", Beat.content_type)


def silent() -> Stage:
    return Stage(Beat, level=level_of("beats = []"))


def tap_at(stage: Stage, *times: float) -> None:
    """Taps at times from now on, s."""
    begin = stage.time_s
    for time in times:
        stage.run(round((begin + time - stage.time_s) / stage.dt))
        stage.post(Action("tap"))


def readout(stage: Stage, name: str) -> float:
    return next(row.value for row in stage.readouts() if row.name == name)


@pytest.mark.parametrize("path", LEVELS, ids=lambda path: path.stem)
def test_the_shot_of_a_level_meets_its_beat(path):
    stage = Stage(Beat, level=load_level(path, "p22", Beat.content_type))
    assert stage.scene.model.phase == PLAYING
    expected = stage.scene.model.content.expected
    assert readout(stage, "largest error") <= max((one.within for one in expected), default=1e-9)
    assert readout(stage, "off the beat") == 0.0
    assert bool(expected) == path.stem.startswith("hard")


@pytest.mark.parametrize("path", LEVELS, ids=lambda path: path.stem)
def test_every_click_that_is_heard_is_counted(path):
    """While the shot is shown, from its stroke on: those for beats, those off them, those after the last."""
    stage = Stage(Beat, level=load_level(path, "p22", Beat.content_type))
    shown = stage.scene.model.shown
    until = shown.rhythm.beats[-1] + SHOWN_S
    heard = [click for click in shown.clicks if click <= until]
    assert readout(stage, "impacts") + readout(stage, "after the last beat") == len(heard)
    assert all(row[0] <= shown.trajectory.end_time for row in shown.sounds)


def test_what_is_tapped_is_searched_for_and_played():
    stage = silent()
    assert stage.scene.model.phase == SILENT
    tap_at(stage, 0.0, 0.4, 0.8)
    assert stage.scene.model.phase == TAPPING
    assert stage.scene.model.beats == pytest.approx((0.0, 0.4, 0.8), abs=1e-9)
    stage.run(round(1.3 / stage.dt))
    assert stage.scene.model.phase == SEARCHING
    stage.run(3, players=True)
    assert stage.scene.model.phase == PLAYING
    assert readout(stage, "largest error") < 1e-6 and readout(stage, "impacts") == 3.0
    sounds = [sound.time for sound in stage.scene.hearing().sounds]
    for beat in stage.scene.model.beats:
        assert min(abs(time - beat) for time in sounds) < 1e-9


def test_a_press_on_the_bar_taps_and_one_on_the_table_does_not():
    stage = silent()
    stage.post(Pointer("down", 0.5, 1.0, 1))
    assert stage.scene.model.phase == SILENT
    stage.post(Pointer("down", 1.7, 1.0, 1))
    stage.run(1)
    assert stage.scene.model.phase == TAPPING


def test_one_tap_is_no_beat_and_double_taps_are_one():
    stage = silent()
    tap_at(stage, 0.0)
    stage.run(round(1.3 / stage.dt))
    assert stage.scene.model.phase == SILENT and "two or more" in stage.scene.messages()[-1]
    tap_at(stage, 0.0, 0.02, 0.3)
    assert len(stage.scene.model.beats) == 2


def test_a_tap_while_it_plays_begins_a_new_beat_and_n_searches_again():
    stage = Stage(Beat)
    stage.run(2, players=True)
    assert stage.scene.model.phase == PLAYING
    stage.post(Action("again"))
    stage.run(1)
    assert stage.scene.model.phase == SEARCHING and len(stage.scene.model.beats) == 6
    stage.post(Action("tap"))
    stage.run(1)
    assert stage.scene.model.phase == TAPPING and stage.scene.model.beats == (0.0,)


def test_a_search_that_finds_nothing_says_so():
    stage = Stage(Beat)
    stage.post(Decision("nothing", ()))
    stage.run(1)
    assert stage.scene.model.phase == SILENT and "No shot" in stage.scene.messages()[-1]


def test_sixteen_taps_are_the_most():
    stage = silent()
    tap_at(stage, *(0.1 * i for i in range(17)))
    assert len(stage.scene.model.beats) == 16 and stage.scene.model.phase == SEARCHING


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("beats = [0.0]", "beats"),
        ("beats = [0.0, 0.5]\nlayout = [1.0]", "layout"),
        ("beats = [0.0, 0.5]\nlayout = [1.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.5, 0.5]", "ball"),
        ("beats = [0.0, nan]", "beats"),
        ("beat = [0.0]", "beat"),
    ],
)
def test_levels_that_make_no_sense_are_refused_in_a_line(text, said):
    with pytest.raises(LevelError, match=said) as error:
        Stage(Beat, level=level_of(text))
    assert "\n" not in str(error.value)
