"""Views in perspective at the tables: from the cue, from a stroke's side, on the ball that decides."""

from __future__ import annotations

import math

import numpy as np
import pygame
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Struck, trajectory_of
from game.billiards.game.rules import CUE_BALL
from game.billiards.laws.state import BALL_POCKET
from game.billiards.table.table import Table
from game.scenes.shared.tables.eye import view
from game.scenes.shared.tables.eye.cameras import Room, behind, beside
from game.scenes.shared.tables.eye.inset import SHAPE, corner_for, inner_corner
from game.scenes.shared.tables.eye.lines import CIRCLE, Line, draw_lines_seen, lines_of
from game.scenes.shared.tables.moments import AFTER_S, SLOW, Moments, moments_of, pace_at
from game.scenes.shared.tables.prediction import FIRST_BALL, SET_OFF, foresee
from game.stage import Action, Pointer
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from game.ui.painters.perspective.eye import room_points
from tests.scenes.billiards import billiards_stages as pool
from tests.scenes.carom import carom_stages as carom
from tests.scenes.snooker import snooker_stages as snooker

ROOM = Room(0.0, 0.0, 640.0, 360.0)
OPEN = {
    "pool": pool.open_level,
    "snooker": snooker.open_level,
    "carom": lambda **chosen: carom.open_level(map=False, **chosen),
}


def drawn(stage, size=(960, 540)):
    """The scene's picture."""
    surface = pygame.Surface(size, 0, 32)
    canvas, camera = Canvas(Look(DARK, size[0] / 1280.0)), Camera(quarter_turns=1)
    camera.fit(stage.scene.frame(), surface.get_rect(), 0.0)
    canvas.begin(surface, surface.get_rect(), camera)
    stage.scene.draw(canvas, 1.0)
    canvas.end()
    return surface


def differ(first, second):
    """Share of the pixels that are not the same."""
    a, b = (pygame.surfarray.array2d(picture) for picture in (first, second))
    return float((a != b).mean())


def potted():
    """A stroke that pots the 3, over and aimed again."""
    stage = pool.straight_pot()
    stage.scene.play.aiming.point_along(pool.AT_THE_CORNER)
    stage.scene.parameters.power = 2.0
    stage.post(Action("strike"))
    pool.seconds(stage, 0.2)
    return pool.until_aiming(stage)


def test_behind_the_cue_ball_lies_low_in_the_middle_and_the_aim_goes_up():
    table = Table.pool()
    for azimuth in (0.3, 1.9, -2.2):
        eye = behind(table, (0.6, 1.1), azimuth, (0.32, 0.0), ROOM)
        ahead = (0.6 + 0.5 * math.cos(azimuth), 1.1 + 0.5 * math.sin(azimuth))
        ball, target = eye.seen(room_points(np.array(((0.6, 1.1), ahead)), 0.0, table.width, table.length))
        assert (ball[0], target[0]) == pytest.approx((320.0, 320.0), abs=1e-6)
        assert ball[1] > 0.7 * ROOM.height > target[1]
        assert target[2] == pytest.approx(ball[2] + 0.5 * math.cos(eye.tilt))


def test_beside_sees_a_path_at_right_angles_and_whole():
    path = room_points(np.array(((0.3, 0.4), (0.9, 1.6))), 0.03, 1.27, 2.54)
    eye = beside(path, np.empty((0, 3)), ROOM)
    along = path[1] - path[0]
    view = np.array((math.cos(eye.heading), math.sin(eye.heading)))
    assert abs(float(along[:2] @ view)) < 1e-6 * float(np.linalg.norm(along))
    seen = eye.seen(path)
    assert (seen[:, 0] > 0.0).all() and (seen[:, 0] < ROOM.width).all()


def test_beside_takes_the_side_from_which_nothing_hides_the_path():
    path = np.array(((-0.3, 0.0, 0.03), (0.3, 0.0, 0.03)))
    for side in (-1.0, 1.0):
        eye = beside(path, np.array(((0.0, 0.3 * side, 0.03),)), ROOM)
        assert eye.y * side < 0.0
    assert beside(path, np.empty((0, 3)), ROOM).y < 0.0  # alike: from the picture's foot


def test_moments_of_a_pot_are_contact_and_drop():
    played = potted().scene.model.played
    cue = [int(i) for i in played.trajectory.shot.ids].index(CUE_BALL)
    moments = moments_of(played.trajectory, cue)
    events = {event.type: event.time for event in reversed(played.trajectory.events)}
    assert moments.contact == events["ball-ball"]
    assert moments.drop == events["ball-pocket"] and moments.hangs is None
    assert played.trajectory.shot.ids[moments.ball] == "3"


def test_a_ball_that_stays_before_a_pocket_hangs():
    stage = pool.straight_pot()
    for power in np.arange(0.3, 2.0, 0.01):
        stage.scene.aiming.point_along(pool.AT_THE_CORNER)
        stroke = stage.scene.aiming.stroke._replace(cue_speed=float(power))
        trajectory = stage.scene.model.frame.play(stroke).trajectory
        moments = moments_of(trajectory, 0)
        if moments.hangs is not None:
            break
    place = trajectory.state_at(moments.hangs).positions[moments.ball]
    x, y, radius = trajectory.shot.table.pockets[0]
    assert math.dist(place, (x, y)) - radius < 1.25 * 0.0286
    assert moments.drop is None and moments.contact < moments.hangs <= trajectory.end_time


def test_the_pace_is_slow_about_moments_and_no_other_time():
    moments = Moments(1, 0.5, None, 3.0)
    assert pace_at(0.5, moments) == pace_at(3.0 + 0.5 * AFTER_S, moments) == SLOW
    assert pace_at(0.1, moments) == pace_at(2.0, moments) == pace_at(9.0, moments) == 1.0
    assert SLOW < pace_at(0.5 + AFTER_S + 0.05, moments) < 1.0


@pytest.mark.parametrize("table", OPEN)
def test_the_view_from_the_cue_is_shown_by_its_key_and_changes_nothing(table):
    stage = OPEN[table]()
    stage.run(2)
    without, digest = drawn(stage), stage.digest()
    stage.post(Action("eye"))
    stage.run(0)
    box = stage.scene.hand.inset.box
    seen = drawn(stage)
    assert differ(without, seen) > 0.05
    assert stage.digest() == digest
    assert box is not None
    stage.post(Action("eye"))
    stage.run(0)
    assert stage.scene.hand.inset.box is None
    assert differ(without, drawn(stage)) == 0.0


@pytest.mark.parametrize("table", OPEN)
def test_its_inner_corner_is_dragged_and_the_wheel_raises_the_eye(table):
    stage = OPEN[table]()
    stage.post(Action("eye"))
    stage.run(1)
    inset, parameters = stage.scene.hand.inset, stage.scene.parameters
    before, box = parameters.eye_size, inset.box
    x, y = inner_corner(box, inset.table)
    mx, my = box.middle
    aim = stage.scene.course.cue.aim
    stage.post(Pointer("down", x, y, 1))
    stage.post(Pointer("move", x + 0.5 * (x - mx), y + 0.5 * (y - my), 1))
    stage.post(Pointer("up", x + 0.5 * (x - mx), y + 0.5 * (y - my), 1))
    stage.run(1)
    assert parameters.eye_size == pytest.approx(1.25 * before, abs=2e-3)
    grown = inset.box
    assert (grown.bottom - grown.top) == pytest.approx(SHAPE * (grown.right - grown.left))
    assert stage.scene.course.cue.aim == aim  # nothing was aimed meanwhile
    height = parameters.eye_height
    stage.post(Pointer("wheel", *grown.middle, 0, 2.0))
    stage.run(1)
    assert parameters.eye_height == pytest.approx(height + 0.08)


def test_it_lies_where_it_hides_neither_cue_ball_nor_many_others():
    table = Table.pool()
    assert corner_for(table, (0.2, 0.3), []) == (True, False)
    assert corner_for(table, (0.2, 2.3), []) == (True, True)
    crowd = [(0.2, 2.3), (1.0, 2.3), (0.2, 0.3)]
    assert corner_for(table, (0.6, 1.2), crowd) == (False, True)


@pytest.mark.parametrize("table", OPEN)
def test_a_replay_from_the_side_is_left_by_its_way_out_and_changes_nothing(table):
    stage = OPEN[table]()
    stage.post(Action("centre"))
    stage.scene.parameters.power = 3.0
    stage.post(Action("strike"))
    stage.run(20)
    for _ in range(400):
        if stage.scene.course.phase == "aiming":
            break
        stage.run(10)
    stage.run(1)
    before, places = drawn(stage), stage.scene.model.places.copy()
    word, turns = stage.scene.model.word, stage.scene.model.turns.copy()
    stage.post(Action("side"))
    stage.run(20)
    assert stage.scene.course.phase == "replay"
    assert differ(before, drawn(stage)) > 0.3
    first = float(stage.scene.course.clock[-1])
    stage.run(4)
    assert first < float(stage.scene.course.clock[-1])
    stage.post(Action(stage.scene.way_out))
    stage.run(1)
    assert stage.scene.course.phase == "aiming" and stage.scene.way_out == ""
    assert stage.scene.model.word == word
    assert np.array_equal(stage.scene.model.places, places)
    assert np.array_equal(stage.scene.model.turns, turns)


def test_a_replay_from_the_side_takes_longer_about_the_contact():
    lengths = []
    for action in ("replay", "side"):
        stage = potted()
        moment = stage.scene.model.moments.contact
        stage.post(Action(action))
        stage.run(1)
        steps = 0
        while stage.scene.replay.time < moment + AFTER_S:
            stage.run(1)
            steps += 1
        lengths.append(steps)
    assert lengths[1] > 1.5 * lengths[0]


def test_the_side_is_changed_within_a_replay():
    stage = potted()
    stage.post(Action("side"))
    stage.run(2)
    side = drawn(stage)
    stage.post(Action("side"))
    stage.run(0)
    assert stage.scene.play.phase == "replay"
    assert differ(side, drawn(stage)) > 0.2


@pytest.mark.parametrize("table", OPEN)
def test_a_camera_follows_only_if_it_is_chosen_and_only_while_balls_roll(table):
    pictures = {}
    for follows in ("off", "perspective"):
        stage = OPEN[table](eye_follows=follows)
        stage.run(2)
        aiming = drawn(stage)
        stage.scene.parameters.power = 3.0
        stage.post(Action("strike"))
        stage.run(70)
        assert stage.scene.course.phase == "rolling"
        pictures[follows] = aiming, drawn(stage), stage.digest()
    assert differ(pictures["off"][0], pictures["perspective"][0]) == 0.0
    assert differ(pictures["off"][1], pictures["perspective"][1]) > 0.3
    assert pictures["off"][2] == pictures["perspective"][2]


@pytest.mark.parametrize("table", OPEN)
def test_no_two_actions_of_a_table_have_one_key(table):
    keys = [action.key for action in OPEN[table]().scene.actions]
    assert len(keys) == len(set(keys))


@pytest.mark.parametrize("far", [False, True])
def test_the_corner_that_is_dragged_lies_under_the_pointer(far: bool, monkeypatch):
    stage = OPEN["pool"](eye=True)
    inset = stage.scene.hand.inset
    length = inset.table.length
    end = 0.2 if far else length - 0.2  # where the balls lie: the view is at the other one
    monkeypatch.setattr(inset, "lying", lambda: ((0.3, end), [(1.0, end)]))
    box = inset.box
    x, y = inner_corner(box, inset.table)
    assert (box.left > 0.3 * length) is far
    wanted = y - 0.2 if far else y + 0.2
    inset.drag(x, wanted)
    assert inner_corner(inset.box, inset.table)[1] == pytest.approx(wanted, abs=0.003)


def test_lines_lie_on_the_bed_that_the_eye_sees():
    seen = []

    class Catching:
        def chain(self, points):
            seen.append(points)
            return []

    surface = pygame.Surface((16, 16), 0, 32)
    canvas = Canvas(Look(DARK, 1.0))
    canvas.begin(surface, surface.get_rect(), Camera())
    way = np.array(((0.1, 0.2), (0.6, 1.4)))
    flown = np.array(((0.1, 0.2, 0.0), (0.6, 1.4, 0.3)))
    lines = [Line(way, DARK.text1), Line(flown, DARK.text1)]
    draw_lines_seen(*canvas.raster_target, Catching(), lines, (1.0, 2.0), 1.0)
    canvas.end()
    assert seen[0].tolist() == [pytest.approx((-0.8, 0.4, 0.0)), pytest.approx((0.4, -0.1, 0.0))]
    assert seen[1][:, 2].tolist() == [0.0, 0.3]


def test_what_is_foreseen_ends_at_the_event_that_is_asked_for():
    stage = pool.straight_pot()
    frame = stage.scene.model.frame
    struck = Struck(frame, Stroke(1.5, pool.AT_THE_CORNER))
    trajectory = trajectory_of(struck)
    contacts = trajectory.rows[trajectory.rows[:, 1] <= BALL_POCKET]
    assert len(contacts) >= 2
    every, more = foresee(struck, len(contacts)), foresee(struck, len(contacts) + 1)
    assert every.last is None, "it ends with the last contact"
    end = trajectory.state_at(float(contacts[-1, 0])).positions[frame.layout.numbers.index(CUE_BALL)]
    assert every.after[-1] == pytest.approx(end, abs=1e-6)
    assert more.last is not None or more.after[-1] != pytest.approx(end, abs=1e-3)


@pytest.mark.parametrize(("guide", "ends"), [("whole", True), ("first", False)])
def test_the_view_from_the_cue_holds_what_the_picture_from_above_has(guide: str, ends: bool):
    """Beside the paths: rings at cushions, pots and ends; and, through the ball, where that sets off."""
    stage = pool.straight_pot()
    stage.scene.parameters.guide = guide
    frame = stage.scene.model.frame
    sight = foresee(Struck(frame, Stroke(1.5, pool.AT_THE_CORNER)), 30 if guide == "whole" else FIRST_BALL)
    radius = float(frame.layout.balls.radii[CUE_BALL])
    lines = lines_of(sight, radius)
    through = [line for line in lines if line.over]
    assert len(through) == 1
    begun = through[0].points
    assert begun[0] == pytest.approx(sight.target_place, abs=1e-6)
    assert float(np.hypot(*np.diff(begun, axis=0).T).sum()) == pytest.approx(SET_OFF)
    rings = [line for line in lines if len(line.points) == len(CIRCLE) and np.allclose(*line.points[[0, -1]])]
    middles = [tuple(line.points[:-1].mean(axis=0)) for line in rings]
    places = [*sight.bounces, *(path.points[-1] for path in sight.others if path.potted)]
    places += [sight.target_place, *([sight.last] if sight.last is not None else [])]
    assert middles == [pytest.approx(tuple(place), abs=1e-9) for place in places]
    assert (sight.last is not None) is ends


@pytest.mark.parametrize("table", ["pool", "snooker"])
def test_of_a_straight_stroke_the_way_of_the_first_ball_is_seen_through_it(table, monkeypatch):
    stage = OPEN[table](eye=True)
    stage.scene.parameters.guide = "first"
    stage.run(2)
    whole = drawn(stage)
    kept = view.EyePicture.draw

    def without(self, canvas, rect, furniture, eye, seen):
        kept(self, canvas, rect, furniture, eye, seen._replace(lines=[x for x in seen.lines if not x.over]))

    monkeypatch.setattr(view.EyePicture, "draw", without)
    assert differ(whole, drawn(stage)) > 0.0
