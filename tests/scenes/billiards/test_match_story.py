"""What the story of a match measures and names: the first contact, its throw beside the law, turns taken."""

from __future__ import annotations

import math

import numpy as np
import pygame
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.games.combination import CombinationMatch
from game.billiards.game.rules import CUE_BALL
from game.billiards.laws.state import BALL_BALL
from game.scenes.billiards.story.throw import BEFORE_S, THINNEST, first_contact, throw_by_law, throw_chart
from game.stage import Action, Frame, Pointer, SetParameter
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from tests.scenes.billiards.billiards_stages import level_of, until_aiming


def cut_shot(side: float, up: float = 0.0, power: float = 2.0, by: float = 0.03):
    """A stroke along y at a ball that stands ``by`` m beside the line; its scene, at rest afterwards."""
    stage = level_of(
        'game = "practice"\nballs = [{ number = 0, position = [0.6, 0.6] },'
        f" {{ number = 5, position = [{0.6 + by}, 1.1] }}]"
    )
    for name, value in (("power", power), ("tip_left", side), ("tip_up", up)):
        stage.post(SetParameter(name, value))
    stage.post(Pointer("move", 0.6, 1.0))
    stage.post(Action("strike"))
    until_aiming(stage)
    return stage.scene


def contact_of(scene):
    """Of its last stroke."""
    last, played = scene.model.frame.last, scene.model.frame.last.frame.play(scene.model.frame.last.stroke)
    return first_contact(played, last.frame.layout.numbers), played


def test_a_cut_is_the_angle_of_the_path_and_the_line_of_centres():
    """Without squirt: the cue ball comes along y, and is two radii from the other one as they meet."""
    contact, played = contact_of(cut_shot(0.0))
    place = contact.other - contact.place
    assert contact.ball == 5
    assert math.hypot(*place) == pytest.approx(2 * 0.028575, abs=contact.speed * BEFORE_S)
    assert contact.cut == pytest.approx(math.asin(place[0] / math.hypot(*place)), abs=1e-3)
    rows = played.trajectory.rows
    assert contact.time == rows[rows[:, 1] == BALL_BALL][0, 0]


@pytest.mark.parametrize("by", [0.03, -0.03])
@pytest.mark.parametrize("side", [-0.4, 0.0, 0.4])
@pytest.mark.parametrize("up", [-0.3, 0.3])
def test_throw_is_that_of_the_law_for_any_spin_and_to_either_side(by: float, side: float, up: float):
    """A.14 leaves out restitution in the speed at which friction acts, and no more: within 0.25 degrees."""
    contact, _ = contact_of(cut_shot(side, up, by=by))
    law = throw_by_law(contact.cut, contact.speed, contact.roll, contact.side)
    assert math.degrees(contact.throw) == pytest.approx(math.degrees(law), abs=0.25)
    assert abs(math.degrees(contact.throw)) > 0.05


def test_side_that_turns_with_the_cut_takes_throw_away_and_turns_it_round():
    throws = [math.degrees(contact_of(cut_shot(side))[0].throw) for side in (-0.5, 0.0, 0.5)]
    assert max(throws) - min(throws) > 2.0
    assert min(throws) == min(throws[0], throws[2]) < 0.0 < throws[1]


def test_the_law_at_its_ends():
    """Full: no throw without side. A stun shot that slips no more: a seventh of the tangent of the cut."""
    assert throw_by_law(0.0, 2.0, 0.0, 0.0) == 0.0
    slow = throw_by_law(math.radians(10.0), 0.1, 0.0, 0.0)
    assert math.tan(slow) == pytest.approx(math.tan(math.radians(10.0)) / 7.0)
    fast = throw_by_law(math.radians(60.0), 2.0, 0.0, 0.0)
    slip = 2.0 * math.sin(math.radians(60.0))
    assert math.tan(fast) == pytest.approx(0.009951 + 0.108 * math.exp(-1.088 * slip))


def test_the_chart_has_the_stroke_on_its_own_law():
    contact, _ = contact_of(cut_shot(0.0))
    shown = throw_chart(contact)
    assert shown.measured.tolist() == [[math.degrees(contact.cut), math.degrees(contact.throw)]]
    assert shown.expected[-1, 0] == pytest.approx(math.degrees(THINNEST))
    at = np.interp(shown.measured[0, 0], shown.expected[:, 0], shown.expected[:, 1])
    assert shown.measured[0, 1] == pytest.approx(at, abs=0.25)
    assert len(throw_chart(None).measured) == 0


def test_readouts_and_places_follow_a_stroke():
    scene = cut_shot(0.0)
    values = {one.name: one.value for one in scene.readouts()}
    assert values["cut"] == pytest.approx(math.degrees(contact_of(scene)[0].cut))
    assert values["throw error"] == pytest.approx(abs(values["throw"] - values["throw by law"]))
    places = scene.story_targets()
    assert places["cue ball"] == scene.model.frame.layout.place_of(CUE_BALL)
    assert places["object ball"] == scene.model.frame.layout.place_of(5)
    assert any("thrown" in words for _, words in scene.story_names())


def test_before_its_time_nothing_is_told_of_a_contact():
    stage = level_of(
        'game = "practice"\nballs = [{ number = 0, position = [0.6, 0.6] },'
        " { number = 5, position = [0.62, 1.6] }]"
    )
    stage.post(Pointer("move", 0.6, 1.0))
    stage.post(SetParameter("power", 1.0))
    stage.post(Action("strike"))
    while stage.scene.play.phase != "rolling":
        stage.run(1)
    assert math.isnan({one.name: one.value for one in stage.scene.readouts()}["cut"])
    assert len(stage.scene.story_charts()["throw"].measured) == 0


def test_players_take_turns_also_after_a_stroke_that_counts():
    for alternating, following in ((True, 1), (False, 0)):
        stage = level_of(
            f'game = "combination"\nalternating = {str(alternating).lower()}\n'
            "balls = [{ number = 0, position = [0.6, 0.6] }, { number = 3, position = [0.4, 0.4] },"
            " { number = 5, position = [0.2, 0.2] }, { number = 9, position = [1.0, 2.2] }]"
        )
        played = stage.scene.model.frame.play(Stroke(2.2, math.atan2(-1.0, -1.0)))
        assert played.verdict.scored and played.frame.game.turn == following
        assert played.frame.game.points == (1, 0)
    assert CombinationMatch(alternating=True, winner=0, won=(1, 0)).next_rack().game.alternating


def test_a_saved_match_goes_on_taking_turns():
    stage = level_of('game = "combination"\nalternating = true')
    assert stage.scene.save_content().alternating


@pytest.mark.parametrize(("nearer", "around"), [(1.0, True), (1.04, False), (1.6, False)])
def test_what_stands_round_the_table_is_seen_whole_or_not_at_all(monkeypatch, nearer: float, around: bool):
    scene = level_of('game = "combination"').scene
    drawn = []
    monkeypatch.setattr(scene.view, "_draw_around", lambda *arguments: drawn.append(1))
    canvas, surface = Canvas(Look(DARK)), pygame.Surface((1280, 720), 0, 32)
    camera = Camera(y_up=scene.y_up, quarter_turns=scene.quarter_turns)
    camera.fit(scene.frame(), surface.get_rect(), 0.0)
    camera.show(smaller(camera.visible(), nearer))
    canvas.begin(surface, surface.get_rect(), camera)
    try:
        scene.view.draw(canvas, 1.0, None)
    finally:
        canvas.end()
    assert bool(drawn) == around


def smaller(frame: Frame, times: float) -> Frame:
    x, y = 0.5 * (frame.left + frame.right), 0.5 * (frame.bottom + frame.top)
    wide, tall = 0.5 * (frame.right - frame.left) / times, 0.5 * (frame.top - frame.bottom) / times
    return Frame(x - wide, y - tall, x + wide, y + tall)


def test_the_ball_that_goes_down_is_followed_with_more_table_than_floor_in_the_picture():
    """A picture that is 1.9 m wide has its pocket within its middle 60 %, and shows more bed than else."""
    stage = level_of(
        'game = "practice"\nballs = [{ number = 0, position = [0.5, 0.5] },'
        " { number = 3, position = [0.22, 0.22] }, { number = 5, position = [0.9, 2.2] }]"
    )
    stage.post(Pointer("move", 0.22, 0.22))
    stage.post(SetParameter("power", 2.0))
    stage.post(Action("strike"))
    while not stage.scene.seen.fallen:
        stage.run(1)
    places, wide = stage.scene.story_targets(), 1.9
    (x, y), (at_x, at_y) = places["ball"], places["pocket"]
    assert abs(at_y - y) <= 0.3 * wide and abs(at_x - x) <= 0.3 * wide * 9.0 / 16.0
    assert (x + 0.5 * wide * 9.0 / 16.0) * (y + 0.5 * wide) > 0.5 * wide * wide * 9.0 / 16.0
