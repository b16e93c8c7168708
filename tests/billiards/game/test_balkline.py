"""Balkline, article by article (UMB 53, 54, 72 to 74): what a stroke leaves, what the next must do."""

import math

import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import new_carom
from game.billiards.game.games.carom import Carom
from game.billiards.game.games.carom_zones import ENTERED, INSIDE
from game.billiards.map.carom import GLANCE, whole_map
from game.billiards.players.carom import position_of
from game.billiards.search.strokes import Noise
from game.billiards.table import balk
from game.billiards.table.carom import CAROM_LENGTH, CAROM_WIDTH, RED, YELLOW
from tests.billiards.game.test_carom import APART, did

BOXED = np.array([[1.2, 2.5], [0.2, 0.30], [0.3, 0.38]])  # both object balls in the lower left box
ASTRIDE = np.array([[1.2, 2.5], [0.2, 0.46], [0.2, 0.49]])  # on either side of a line, not at its end
ANCHORED = np.array([[1.2, 2.5], [0.05, 0.45], [0.12, 0.50]])  # astride the line, in the anchor at its end
BOTH = np.array([[1.2, 2.5], [0.05, 0.42], [0.12, 0.45]])  # in a box and in the anchor


def game(kind="balkline-47-2", **fields) -> Carom:
    return Carom(kind=kind, **({"opening": False} | fields))


def fouls(verdict) -> list[str]:
    return [foul.kind for foul in verdict.fouls]


# -- 72, 73: lines, boxes and anchors --------------------------------------------------------------


@pytest.mark.parametrize(
    ("barred", "boxes", "anchors"), [(balk.BALKLINE_47_2, 9, 8), (balk.BALKLINE_71_2, 6, 6)]
)
def test_72_73_boxes_cover_the_bed_and_anchors_lie_astride_the_ends_of_lines(barred, boxes, anchors):
    assert (len(barred.boxes), len(barred.anchors)) == (boxes, anchors)
    for x in np.linspace(0.01, CAROM_WIDTH - 0.01, 30).tolist():
        for y in np.linspace(0.01, CAROM_LENGTH - 0.01, 31).tolist():
            assert sum(bool(zone.holds((x, y))) for zone in barred.boxes) == 1
    for anchor in barred.anchors:
        xs, ys = zip(*anchor.corners, strict=True)
        assert max(xs) - min(xs) == pytest.approx(0.178) and max(ys) - min(ys) == pytest.approx(0.178)
        assert {min(xs), CAROM_WIDTH - max(xs), min(ys), CAROM_LENGTH - max(ys)} & {0.0}  # on a cushion
        touched = [zone for zone in barred.boxes if any(zone.holds(corner) for corner in anchor.corners)]
        assert len(touched) == 2


def test_73_lines_of_47_and_71():
    assert pytest.approx(0.4733, abs=1e-4) == balk.BOX_47 and balk.BOX_71 == 0.71
    zones = balk.BALKLINE_47_2.boxes
    assert balk.zone_at(zones, (0.4732, 0.1)) != balk.zone_at(zones, (0.4734, 0.1))
    zones = balk.BALKLINE_71_2.boxes
    assert balk.zone_at(zones, (0.709, 0.1)) != balk.zone_at(zones, (0.711, 0.1))
    assert balk.zone_at(zones, (0.3, 0.709)) != balk.zone_at(zones, (0.3, 0.711))


def test_corners_of_the_drawn_zones_bound_them():
    for zone in (*balk.CORNERS, *balk.BALKLINE_47_2.boxes, *balk.BALKLINE_47_2.anchors):
        middle = np.mean(zone.corners, axis=0)
        for corner in np.array(zone.corners):
            inside = middle + 0.999 * (corner - middle)
            assert zone.holds(inside)
            outside = middle + 1.001 * (corner - middle)
            within_bed = 0.0 < outside[0] < CAROM_WIDTH and 0.0 < outside[1] < CAROM_LENGTH
            assert not (within_bed and zone.holds(outside))


# -- 53, 54, 73: two strokes ---------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["balkline-47-2", "balkline-71-2"])
def test_73_a_point_may_leave_both_in_a_box_and_the_next_must_drive_one_out(kind):
    entered = game(kind).judge(did("ry", BOXED))
    assert entered.scored and entered.game.inside == ENTERED
    inside = entered.game.judge(did("ry", BOXED))
    assert inside.scored and inside.game.inside == INSIDE
    stayed = inside.game.judge(did("ry", BOXED))
    assert not stayed.scored and fouls(stayed) == ["corner"] and stayed.game.turn == 1
    out = inside.game.judge(did("ry", APART, left_corner=(RED,)))
    assert out.scored and out.game.inside == 0


def test_53_a_ball_that_left_and_came_back_has_entered_anew():
    back = game(inside=INSIDE).judge(did("ry", BOXED, left_corner=(YELLOW,)))
    assert back.scored and back.game.inside == ENTERED


def test_53_balls_on_either_side_of_a_line_are_free():
    verdict = game().judge(did("ry", ASTRIDE))
    assert verdict.scored and verdict.game.counts == (0, 0)
    assert verdict.game.judge(did("ry", ASTRIDE)).game.counts == (0, 0)


def test_72_an_anchor_bars_balls_that_lie_astride_its_line():
    entered = game().judge(did("ry", ANCHORED)).game
    assert entered.counts == (0, ENTERED)
    inside = entered.judge(did("ry", ANCHORED)).game
    assert inside.counts == (0, INSIDE)
    stayed = inside.judge(did("ry", ANCHORED))
    assert fouls(stayed) == ["corner"] and "anchor" in stayed.words[0]
    assert inside.judge(did("ry", ASTRIDE, left_anchor=(RED,))).scored


def test_72_box_and_anchor_are_counted_apart():
    entered = game(inside=ENTERED).judge(did("ry", BOTH)).game
    assert entered.counts == (INSIDE, ENTERED)
    stayed = entered.judge(did("ry", BOTH))  # the box is due, the anchor is not
    assert [foul.words for foul in stayed.fouls] == [
        "Both balls stayed in the box; one of them must leave it."
    ]


def test_54_a_player_who_comes_to_such_a_position_has_entered():
    rest = np.array([[0.2, 0.3], [1.2, 2.5], [0.3, 0.38]])  # white and red, for the player of the yellow
    assert game().judge(did("r", rest)).game.counts == (ENTERED, 0)


# -- 74: one stroke --------------------------------------------------------------------------------


def test_74_with_one_stroke_every_point_from_a_box_must_drive_one_out():
    entered = game("balkline-47-1").judge(did("ry", BOXED))
    assert entered.scored and entered.game.inside == ENTERED
    assert fouls(entered.game.judge(did("ry", BOXED))) == ["corner"]
    assert entered.game.judge(did("ry", APART, left_corner=(RED,))).scored


def test_73_is_unlike_straight_rail_where_only_corners_are_barred():
    assert game("straight-rail").judge(
        did("ry", np.array([[1.2, 2.5], [0.4, 0.4], [0.3, 0.45]]))
    ).game.counts == (0, 0)


# -- the search follows the rule -------------------------------------------------------------------


def test_what_must_be_left_is_asked_of_the_search():
    frame = new_carom(game()).replace(places=tuple(map(tuple, BOXED.tolist())))
    assert position_of(frame).wanted.leave == ()
    due = frame.replace(game=game(inside=INSIDE))
    (zone,) = position_of(due).wanted.leave
    assert zone.holds(BOXED[YELLOW]) and zone.holds(BOXED[RED])
    one = frame.replace(game=game("balkline-47-1", inside=ENTERED))
    assert len(position_of(one).wanted.leave) == 1


def test_strokes_that_are_found_drive_a_ball_out_and_the_referee_agrees():
    places = ((0.40, 0.44), (0.30, 0.30), (0.24, 0.40))
    due = new_carom(game(inside=INSIDE)).replace(places=places)
    found = whole_map(position_of(due), Noise(), GLANCE).groups
    assert found
    for group in found:
        played = due.play(group.stroke)
        assert played.verdict.scored, played.verdict.words
        assert played.summary.left_corner
    free = due.replace(game=game())
    scoring = [np.flatnonzero(whole_map(position_of(at), Noise(), GLANCE).codes) for at in (due, free)]
    assert set(scoring[0]) < set(scoring[1])  # some score in the open, and not from the box


def test_a_ball_seen_outside_its_box_has_left_it():
    frame = new_carom(game(inside=INSIDE)).replace(places=((0.20, 0.20), (0.2, 0.40), (0.40, 0.20)))
    soft = frame.play(Stroke(0.15, 0.5 * math.pi)).summary
    hard = frame.play(Stroke(3.0, 0.5 * math.pi)).summary
    assert YELLOW in hard.left_corner and YELLOW not in soft.left_corner


def test_53_a_placed_position_has_entered_and_the_opening_has_not():
    assert game().coming_to(BOXED).counts == (ENTERED, 0)
    assert game("one-cushion").coming_to(BOXED).counts == (0, 0)
    opening = Carom(kind="balkline-47-2")
    assert opening.coming_to(opening.start()).counts == (0, 0)


def test_the_first_point_from_a_box_need_not_leave_it_where_two_are_given():
    """53, 54: what the search must drive out is what the referee will ask for."""
    for kind, first in (("balkline-47-2", 0), ("balkline-47-1", 1)):
        entering = game(kind).coming_to(BOXED)
        assert entering.inside == ENTERED
        assert len(entering.must_leave(BOXED)) == first, kind
