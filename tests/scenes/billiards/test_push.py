"""A stroke that is pushed through the ball: as fast as the pointer, as straight as the hand."""

import math

import numpy as np
import pygame
import pytest

from game.app.stagehand.headless import prepare
from game.app.stagehand.view import StageView
from game.billiards.map.hand import FEWEST
from game.billiards.shot.miscue import slip_limit
from game.billiards.table.rack import BALL_RADIUS
from game.scenes.billiards.scene import Billiards
from game.scenes.billiards.stroke.motion import power_of
from game.scenes.billiards.view import instruments
from game.scenes.shared.tables.cue import MAX_SPEED, REST_GAP
from game.scenes.shared.tables.through.breath import HELD_S, STEADIED, TIRED_S
from game.scenes.shared.tables.through.measured import pushed as rolling_stroke
from game.scenes.shared.tables.through.push import BRIDGE, GRIP
from game.scenes.shared.tables.through.recoil import FARTHEST, LASTS_S, recoil
from game.stage import Action, Pointer, SetParameter, Stage, replay_scene
from game.ui.look.look import Look
from game.ui.look.theme import theme_named
from tests.scenes.billiards.billiards_stages import AT_THE_CORNER, aim, seconds, straight_pot, until_aiming
from tests.scenes.pushing import BACK, push


def ready(**parameters) -> Stage:
    """A straight pot that is aimed, strokes are pushed and the aim does not sway."""
    stage = straight_pot()
    for name, value in {"stroke_by": "push", "sway": 0.0, **parameters}.items():
        stage.post(SetParameter(name, value))
    aim(stage, AT_THE_CORNER)
    return stage


def pushed(stage: Stage, speed: float, **more):
    """The stroke that came of a push."""
    push(stage, stage.scene.model.frame.cue_ball, AT_THE_CORNER, speed, **more)
    return stage.scene.play.done


@pytest.mark.parametrize(("speed", "every"), [(0.4, 2), (1.5, 2), (1.5, 1), (3.0, 3), (5.0, 2)])
def test_the_cue_is_as_fast_as_the_pointer_that_crosses_the_ball(speed: float, every: int):
    stage = ready()
    made = pushed(stage, speed, every=every)
    assert made.cue_speed == pytest.approx(speed, rel=1e-9)
    assert made.azimuth == pytest.approx(AT_THE_CORNER, abs=1e-12)
    assert stage.scene.play.meant.cue_speed != made.cue_speed, "the power that is set is what was meant"


def test_the_cue_goes_farther_than_the_pointer_if_it_is_to_and_never_too_fast():
    assert pushed(ready(reach=2.5), 1.0).cue_speed == pytest.approx(2.5, rel=1e-9)
    stage = ready(reach=4.0)
    ratio = stage.scene.play.push.ball_per_cue
    assert pushed(stage, 3.0).cue_speed == pytest.approx(MAX_SPEED / ratio)


def test_the_last_part_of_the_push_counts_and_not_the_whole_of_it():
    stage = ready()
    x, y = stage.scene.model.frame.cue_ball
    along = (math.cos(AT_THE_CORNER), math.sin(AT_THE_CORNER))

    def move(reach: float, kind: str = "move") -> None:
        stage.post(Pointer(kind, x + reach * along[0], y + reach * along[1], button=1))
        stage.run(2)

    move(0.3, "down")
    for k in range(1, 21):  # slowly back, slowly forward for a quarter of the way, then fast
        move(0.3 - 0.01 * k)
    for k in range(1, 6):
        move(0.1 + 0.01 * k)
    for k in range(1, 11):
        if stage.scene.play.push.held:
            move(0.15 + 0.03 * k)
    assert stage.scene.play.done.cue_speed == pytest.approx(0.03 / (2 * stage.dt), rel=1e-9)


def test_a_hand_that_trembles_has_the_speed_of_its_last_60_ms():
    stage = ready()
    x, y = stage.scene.model.frame.cue_ball
    along = (math.cos(AT_THE_CORNER), math.sin(AT_THE_CORNER))
    gaps, places = [0.02, 0.05], []
    reach = 0.3
    for k in range(40):
        kind = "down" if not k else "move"
        reach += 0.0 if not k else -0.01 if k < 21 else gaps[k % 2]
        stage.post(Pointer(kind, x + reach * along[0], y + reach * along[1], button=1))
        stage.run(2)
        places.append((stage.time_s, reach))
        if k and not stage.scene.play.push.held:
            break
    last = np.array([place for place in places if place[0] >= places[-1][0] - 0.06 - 1e-9])
    slope = np.polyfit(last[:, 0] - last[0, 0], last[:, 1], 1)[0]
    assert len(last) > 3 and stage.scene.play.done.cue_speed == pytest.approx(slope, rel=1e-9)


@pytest.mark.parametrize("drift", [0.05, -0.1])
def test_a_hand_that_drifts_aside_turns_the_cue_about_the_bridge(drift: float):
    stage = ready(miscues="off")
    made = pushed(stage, 2.0, drift=drift)
    gone = math.ceil((BACK + REST_GAP) / (2.0 * 2 * stage.dt)) * 2.0 * 2 * stage.dt
    turn = math.atan2(drift * gone, GRIP)
    assert made.azimuth - AT_THE_CORNER == pytest.approx(turn, rel=1e-6)
    assert made.tip_left == pytest.approx((BRIDGE + BALL_RADIUS) * math.sin(turn) / BALL_RADIUS, rel=1e-6)


def test_a_push_replays_to_the_bit_with_its_sway_and_its_breath():
    stage = ready(sway=0.4)
    stage.post(Action("breath"))
    for speed in (1.0, 2.1, 1.7):
        pushed(stage, speed, drift=0.03)
        until_aiming(stage)
        aim(stage, 0.3)
    assert stage.scene.play.by_hand == 3
    again = replay_scene(stage.recording, Billiards)
    assert again.digest() == stage.digest() and again.scene.play.done == stage.scene.play.done


def test_a_step_back_into_a_push_goes_on_with_it():
    stage = ready(sway=0.2)
    pushed(stage, 2.0)
    done, steps, events = stage.scene.play.done, stage.step_number, list(stage.recording.events)
    while stage.step_number > steps - 6:
        stage.step_back()
    assert stage.scene.play.push.held and stage.scene.play.phase == "aiming"
    for one in [one for one in events if one.step > stage.step_number]:
        stage.run(one.step - stage.step_number)
        stage.post(one.event)
    assert stage.scene.play.done == done


@pytest.mark.parametrize("way", ["let go", "cancel", "forward"])
def test_a_cue_that_is_not_pushed_through_strikes_nothing(way: str):
    stage = ready()
    x, y = stage.scene.model.frame.cue_ball
    for kind, away in (("down", 0.2), ("move", 0.3 if way == "forward" else 0.1)):
        stage.post(Pointer(kind, x - away * 0.7, y - away * 0.7, button=1))
        stage.run(3)
    assert stage.scene.play.push.held
    assert stage.scene.play.push.gap == pytest.approx(
        REST_GAP if way == "forward" else REST_GAP + 0.099, abs=1e-3
    )
    stage.post(Pointer("cancel" if way == "cancel" else "up", x - 0.1, y - 0.1, button=1))
    seconds(stage, 0.5)
    assert not stage.scene.play.push.held and stage.scene.model.frame.strokes == 0
    assert stage.scene.play.phase == "aiming" and not stage.scene.play.grip


def test_a_click_locks_the_aim_also_where_strokes_are_pushed():
    stage = ready()
    x, y = stage.scene.model.frame.cue_ball
    for kind in ("down", "up"):
        stage.post(Pointer(kind, x - 0.2, y - 0.2, button=1))
    assert stage.scene.aiming.locked and stage.scene.model.frame.strokes == 0


def test_the_sway_has_its_declared_deviation_and_a_breath_steadies_it_for_a_while():
    stage = ready(sway=0.3)
    breath = stage.scene.play.push.breath
    swayed = []
    for _ in range(6000):
        stage.run(2)
        swayed.append(stage.scene.play.push.sway)
    assert np.std(swayed) == pytest.approx(math.radians(0.3), rel=0.03)
    assert abs(np.mean(swayed)) < 0.05 * np.std(swayed)
    stage.post(Action("breath"))
    seconds(stage, 0.5 * HELD_S)
    assert breath.holding and breath.size == pytest.approx(STEADIED * math.radians(0.3), rel=0.05)
    seconds(stage, 0.5 * HELD_S + 0.1)
    stage.post(Action("breath"))
    assert not breath.holding, "it must come back first"
    seconds(stage, TIRED_S)
    stage.post(Action("breath"))
    assert breath.holding


def test_the_sway_is_in_the_stroke():
    stage = ready(sway=1.0)
    made = pushed(stage, 2.0)
    assert made.azimuth - AT_THE_CORNER == pytest.approx(stage.scene.play.push.sway, rel=1e-9)
    assert made.tip_left == pytest.approx(0.0, abs=1e-12), "the whole cue sways about the ball"


@pytest.mark.parametrize(("miscues", "slipped"), [("auto", True), ("on", True), ("off", False)])
def test_a_tip_beyond_its_friction_slips(miscues: str, slipped: bool):
    stage = ready(miscues=miscues, chalk=0.5, tip_up=0.55)
    made = pushed(stage, 2.0)
    assert (made.tip_up < 0.55) is slipped
    assert slipped == any("miscue" in words for words in stage.scene.messages())
    if slipped:
        assert made.tip_up == pytest.approx(slip_limit(0.5)) and made.elevation > 0.0
    until_aiming(stage)
    assert stage.scene.model.frame.strokes == 1


def test_a_stroke_that_is_let_go_slips_only_if_that_is_asked_for():
    for miscues, slipped in (("auto", False), ("on", True)):
        stage = ready(stroke_by="release", miscues=miscues, chalk=0.5, tip_up=0.55)
        stage.post(Action("strike"))
        assert (stage.scene.play.pending.tip_up < 0.55) is slipped


def test_the_noise_of_pushed_strokes_is_measured_and_told():
    stage, told = ready(), []
    for k in range(FEWEST):
        aim(stage, AT_THE_CORNER)
        pushed(stage, 2.0 + 0.1 * k)
        told += stage.scene.messages()
        until_aiming(stage)
        stage.post(Action("undo"))
    play = stage.scene.play
    assert len(play.own) == FEWEST
    off = [made.cue_speed - meant.cue_speed for meant, made in play.own]
    deviation = math.sqrt(sum(value * value for value in off) / FEWEST)
    assert [words for words in told if words.startswith("Your hand")] == [
        f"Your hand: ±0.00°, ±{deviation:.2f} m/s from 5 strokes."
    ]


def test_the_picture_gives_way_more_for_a_harder_stroke_and_comes_back():
    assert recoil(6.0, 0.0) == FARTHEST > recoil(2.0, 0.0) > recoil(2.0, 0.05) * -1.0 > 0.0
    assert recoil(6.0, LASTS_S) == 0.0 == recoil(6.0, -0.01)


def test_chalk_wears_off_from_stroke_to_stroke_and_is_put_on_again():
    stage = ready(wear=True, chalk=0.65)
    tip = stage.scene.play.push
    frictions = []
    for _ in range(4):
        frictions.append(tip.friction)
        tip.after_the_tip(stage.scene.aiming.stroke)
    assert frictions[0] == 0.65 and frictions == sorted(set(frictions), reverse=True)
    tip.since_chalk = 10_000
    assert tip.friction == pytest.approx(0.25)
    stage.post(Action("chalk"))
    assert tip.friction == 0.65 and any("chalked" in words for words in stage.scene.messages())


def test_a_worn_tip_slips_where_a_chalked_one_holds():
    offset = slip_limit(0.5)
    for since, slipped in ((0, False), (8, True)):
        stage = ready(wear=True, chalk=0.65, tip_left=-offset)
        stage.scene.play.push.since_chalk = since
        pushed(stage, 1.5)
        said = " ".join(stage.scene.messages())
        assert ("too far right" in said) is slipped


def test_without_wear_the_friction_is_the_one_chosen():
    stage = ready(chalk=0.65)
    stage.scene.play.push.after_the_tip(stage.scene.aiming.stroke)
    assert stage.scene.play.push.friction == 0.65 and stage.scene.play.push.since_chalk == 0


@pytest.mark.parametrize(("tip_up", "kind"), [(0.55, "miscue"), (0.1, "tip")])
def test_a_miscue_is_heard_as_one(tip_up: float, kind: str):
    stage = ready(miscues="on", chalk=0.5, tip_up=tip_up)
    pushed(stage, 2.0)
    for _ in range(200):
        stage.run(1)
        heard = stage.scene.hearing()
        if heard is not None:
            break
    assert heard.sounds[0].kind == kind
    assert {sound.kind for sound in heard.sounds[1:]} & {"tip", "miscue"} == set()


def test_after_a_push_the_power_bar_shows_how_fast_the_cue_was(monkeypatch: pytest.MonkeyPatch):
    stage, shown = ready(), []
    pushed(stage, 3.0)
    while stage.scene.play.phase != "rolling":
        stage.run(1)
    set_power = stage.scene.parameters.power
    assert rolling_stroke(stage.scene.play).cue_speed == pytest.approx(3.0)
    monkeypatch.setattr(instruments, "draw_power", lambda surface, rect, speed, *more: shown.append(speed))
    frame_of_stage(stage)
    assert shown == [pytest.approx(power_of(3.0))] and shown[0] != pytest.approx(set_power)
    until_aiming(stage)
    frame_of_stage(stage)
    assert shown[1] == pytest.approx(set_power)


def frame_of_stage(stage: Stage) -> None:
    """Draw the stage once."""
    prepare()
    look, surface = Look(theme_named("dark"), 1.0), pygame.Surface((1280, 720), 0, 32)
    view = StageView(stage, look)
    view.place(surface.get_rect(), look)
    view.draw(surface)
