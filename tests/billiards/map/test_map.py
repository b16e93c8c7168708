"""The map at carom: what it says scores does, its groups, chances, tolerances and words."""

import math

import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import carom_shot
from game.billiards.game.games.carom_kinds import CUSHIONS
from game.billiards.map import carom as carom_map
from game.billiards.map.carom import GLANCE, Search, draw_map, whole_map
from game.billiards.map.grid import Grid, aims_of, neighbours
from game.billiards.map.hand import noise_of
from game.billiards.map.leaving import heat, leaving, next_chance
from game.billiards.map.routes import CUSHIONS as CUSHIONS_COLUMN
from game.billiards.map.routes import FIRST, INTO, touches
from game.billiards.map.tolerance import AS_MEANT, MISSED, tip_map, tolerance_of
from game.billiards.map.words import explain, hit_words, route_words, tip_words
from game.billiards.search.strokes import STEADY, Noise, draw_noise, with_noise
from game.billiards.simulation import simulate
from game.billiards.table.carom import BALL_RADIUS, RED, starting_position
from tests.billiards.map.positions import position_at
from tests.billiards.map.replays import replay

PLACES = np.array([[0.9, 0.7], [0.41, 1.1], [0.71, 2.13]])
QUICK = Search(aims=150, groups=6, candidates=3, first_draws=8, moves=8, draws=48)
D = 2.0 * BALL_RADIUS


@pytest.fixture(scope="module")
def position():
    return position_at(PLACES)


@pytest.fixture(scope="module")
def drawn(position):
    return whole_map(position, Noise(), QUICK)


def test_thousands_of_winners_score_when_they_are_replayed():
    found = replay(3000, seed=7, most_each=40)
    assert found.winners >= 3000 and found.positions >= 60
    assert found.failures == []


def test_all_strokes_of_the_grid_are_there_once(position):
    coarse = next(draw_map(position, Noise()))
    assert len(coarse.strokes) == len(coarse.codes) == 18_000
    assert len(np.unique(coarse.strokes, axis=0)) == 18_000
    assert sum(group.found for group in coarse.groups) == (coarse.codes > 0).sum()


def test_what_it_leaves_out_does_not_score(position, drawn):
    missed = np.flatnonzero(drawn.codes == 0)[::97]
    facts = position.play(drawn.strokes[missed]).facts
    assert (facts[:, CUSHIONS_COLUMN] < 3).all()


@pytest.mark.parametrize("cue", [0, 1])
def test_groups_have_one_order_of_touches(cue):
    position = position_at(PLACES, cue=cue)
    drawn = whole_map(position, Noise(), QUICK)
    assert len(drawn.groups) >= 3
    for group in drawn.groups:
        digits = touches(group.code)
        assert {5, 6} <= set(digits) and digits[-1] in (5, 6)
        assert sum(digit <= 4 for digit in digits) >= 3
        assert (drawn.codes[group.rows] == group.code).all()
        best = position.play(np.array([group.stroke]))
        assert position.wanted.scores(best)[0] and best.codes[0] == group.code
        assert ("yellow" if cue == 0 else "white") in route_words(group.code, cue)


def test_chances_are_those_of_other_draws(position):
    hand = Noise().scaled(2.0)
    drawn = whole_map(position, hand, QUICK._replace(draws=256))
    off = []
    for group in drawn.groups:
        noisy = with_noise(np.array([group.stroke], float), draw_noise(12345, 400), hand, BALL_RADIUS)
        share = float(position.wanted.scores(position.play(noisy)).mean())
        error = math.hypot(group.error, math.sqrt(share * (1.0 - share) / 400))
        assert abs(share - group.chance) < 4.0 * error
        off.append((share - group.chance) / error)
    assert abs(np.mean(off)) < 3.0 / math.sqrt(len(off))
    assert [g.chance for g in drawn.groups] == sorted((g.chance for g in drawn.groups), reverse=True)
    assert all(0.0 <= g.meant <= g.chance <= 1.0 for g in drawn.groups)


@pytest.mark.parametrize("cue", [0, 1])
def test_ends_are_told_by_ball(cue):
    position = position_at(PLACES, cue=cue)
    group = whole_map(position, STEADY, QUICK).groups[0]
    shot = carom_shot(position.board.table, position.board.physics, PLACES, cue, group.stroke)
    final = simulate(shot).final
    expected = np.array([final[name] for name in ("white", "yellow", "red")])
    assert np.abs(group.ends - expected).max() < 1e-6


def test_a_steady_hand_never_misses_and_a_shaky_one_misses_more(position):
    steady = whole_map(position, STEADY, QUICK)
    assert all(group.chance == 1.0 for group in steady.groups)
    good, bad = (whole_map(position, Noise().scaled(k), QUICK).groups[0].chance for k in (0.5, 5.0))
    assert good > bad


def test_the_map_is_the_same_each_time(position, drawn):
    again = whole_map(position_at(PLACES), Noise(), QUICK)
    assert [(g.code, g.stroke, g.chance) for g in again.groups] == [
        (g.code, g.stroke, g.chance) for g in drawn.groups
    ]


def test_what_scores_with_more_cushions_scores_with_fewer(position, drawn):
    routes = position.play(drawn.strokes)
    none, one, three = (position.wanted._replace(cushions=k).scores(routes) for k in (0, 1, 3))
    assert none.sum() > one.sum() > three.sum() > 0
    assert not (three & ~one).any() and not (one & ~none).any()
    assert set(CUSHIONS.values()) == {0, 1, 3}


def test_from_the_starting_position_the_red_ball_comes_first():
    drawn = next(draw_map(position_at(starting_position(0), opening=True), Noise(), QUICK))
    assert drawn.groups and all(touches(group.code)[0] == 6 for group in drawn.groups)
    anyhow = next(draw_map(position_at(starting_position(0)), Noise(), QUICK))
    assert (anyhow.codes > 0).sum() > (drawn.codes > 0).sum()


def test_a_cushion_that_the_cue_ball_touches_does_not_count_at_first():
    places = PLACES.copy()
    places[0] = BALL_RADIUS, 1.0
    strokes = np.array([[2.0, math.pi, 0.0, 0.0, 0.0], [2.0, 2.8, 0.0, 0.0, 0.0]])
    against = position_at(places).play(strokes)
    places[0, 0] += 1e-3
    free = position_at(places).play(strokes)
    for lying, apart in zip(against.codes.tolist(), free.codes.tolist(), strict=True):
        if apart:
            assert touches(apart) == (1, *touches(lying))
    assert (free.facts[:, CUSHIONS_COLUMN] - against.facts[:, CUSHIONS_COLUMN]).max() <= 1


def test_a_ball_that_touches_the_cue_ball_is_not_played_into():
    places = PLACES.copy()
    places[RED] = places[0] + (D, 0.0)
    position = position_at(places, 0)
    for gap in (5e-5, 0.0):
        near = places.copy()
        near[RED] = places[0] + (D + gap, 0.0)
        position = position_at(near, 0)
        routes = position.play(np.array([[2.0, 0.0, 0.0, 0.0, 0.0], [2.0, 2.2, 0.0, 0.0, 0.0]]))
        assert routes.facts[:, INTO].tolist() == [1, 0]
    assert routes.facts[:, INTO].tolist() == [1, 0]
    assert routes.facts[0, FIRST] == 2
    drawn = next(draw_map(position, Noise(), QUICK))
    assert (position.play(drawn.strokes[drawn.codes > 0]).facts[:, INTO] == 0).all()


# -- the grid ---------------------------------------------------------------------------------------


def test_aims_are_at_all_balls_and_all_round():
    aims = aims_of(np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]), np.full(3, 0.03), 0, 120)
    assert len(aims) == 120 and (np.diff(aims) >= 0.0).all()
    for direction in (0.0, 0.5 * math.pi):
        assert (abs(aims - direction) < math.asin(0.06)).sum() >= 33
    assert np.diff(aims).max() < 0.3
    assert len(aims_of(np.array([[0.0, 0.0], [0.06, 0.0]]), np.full(2, 0.03), 0, 50)) == 50


def test_neighbours_are_those_next_in_one_variable():
    keys = np.zeros((4, 2, 1, 3), np.int64)
    keys[0, 0, 0, 1] = keys[3, 0, 0, 1] = keys[0, 1, 0, 1] = keys[0, 0, 0, 2] = 7
    keys[1, 0, 0, 1] = 8
    found = neighbours(keys.ravel(), keys.shape).reshape(keys.shape)
    assert found[0, 0, 0, 1] == 3  # round the aims, the other speed, the next tip; not the 8
    assert found[3, 0, 0, 1] == 1 and found[1, 0, 0, 1] == 0 and found[2, 1, 0, 0] == 0


def test_a_grid_is_the_product_of_its_values():
    grid = Grid(np.array([0.1, 0.2]), np.array([1.0, 2.0]), np.array([0.0]), np.array([-0.3, 0.3]))
    assert grid.strokes[:3].tolist() == [[1, 0.1, 0, 0, -0.3], [1, 0.1, 0, 0, 0.3], [2, 0.1, 0, 0, -0.3]]
    assert grid.strokes.shape == (8, 5)


# -- tolerance, tip, ends ---------------------------------------------------------------------------


def test_within_its_tolerance_a_stroke_scores_and_beyond_it_misses(position, drawn):
    group = drawn.groups[0]
    tolerance = tolerance_of(position, group.stroke)
    for column, sides in zip((1, 0, 3, 4), tolerance, strict=True):
        for sign, reach in zip((-1.0, 1.0), sides, strict=True):
            tried = np.repeat(np.array([group.stroke], float), 3, axis=0)
            tried[:, column] += sign * reach * np.array([0.0, 0.999999, 1.0])
            assert position.wanted.scores(position.play(tried))[[0, 2]].all()
    worse = np.repeat(np.array([group.stroke], float), 2, axis=0)
    worse[:, 1] += (-1.3 * max(tolerance.aim[0], 1e-3), 1.3 * max(tolerance.aim[1], 1e-3))
    assert tolerance.aim[0] + tolerance.aim[1] > 0.0
    assert not position.wanted.scores(position.play(worse)).all()


def test_a_stroke_that_misses_has_no_tolerance(position, drawn):
    stroke = Stroke(*drawn.strokes[np.flatnonzero(drawn.codes == 0)[0]].tolist())
    assert all(sides == (0.0, 0.0) for sides in tolerance_of(position, stroke))


def test_the_map_of_the_tip_is_what_strokes_do(position, drawn):
    stroke = drawn.groups[0].stroke._replace(tip_left=0.0, tip_up=0.0)
    picture = tip_map(position, stroke, 13)
    assert picture.shape == (13, 13) and picture[0, 0] == -1
    middle = position.wanted.scores(position.play(np.array([stroke])))[0]
    assert picture[6, 6] == (AS_MEANT if middle else MISSED)
    for row, column, left, up in ((6, 3, 0.3, 0.0), (3, 6, 0.0, 0.3), (9, 9, -0.3, -0.3)):
        scores = position.wanted.scores(position.play(np.array([stroke._replace(tip_left=left, tip_up=up)])))[
            0
        ]
        assert (picture[row, column] > MISSED) == scores


def test_what_a_stroke_leaves(position, drawn):
    group = drawn.groups[0]
    assert group.ends.shape[1:] == (3, 2)
    assert len(group.ends) == round(group.chance * QUICK.draws)
    value = leaving(position, group, Noise())
    assert 0.0 < value <= 1.0
    assert value == leaving(position, group, Noise())
    assert leaving(position, group._replace(ends=group.ends[:0]), Noise()) == 0.0
    assert next_chance(position, np.zeros((3, 2)), Noise()) == 0.0


def test_heat_counts_ends_in_cells():
    ends = np.array([[0.1, 0.1], [0.1, 0.2], [1.4, 2.8], [1.4, 0.1]])
    cells = heat(ends, 2, 4)
    assert cells.shape == (4, 2) and cells.sum() == 1.0
    assert cells[0, 0] == 0.5 and cells[0, 1] == 0.25 and cells[3, 1] == 0.25
    assert heat(ends[:0], 2, 4).sum() == 0.0


# -- words ------------------------------------------------------------------------------------------


def test_routes_in_words():
    code = 0
    for digit in (6, 1, 3, 2, 5):
        code = 8 * code + digit
    assert route_words(code, 0) == "red, long, short, long, yellow"
    assert route_words(code, 1) == "red, long, short, long, white"


def test_hits_and_tips_in_words(position, drawn):
    def at(code, azimuth):
        return hit_words(position, drawn.groups[0]._replace(code=code, stroke=Stroke(2.0, azimuth)))

    dx, dy = (PLACES[RED] - PLACES[0]).tolist()
    aim, reach = math.atan2(dy, dx), D / math.hypot(dx, dy)
    assert at(6 * 8 + 5, aim) == "the red ball full"
    assert at(6 * 8 + 5, aim + math.asin(0.5 * reach)) == "the red ball half full on its left"
    assert at(6 * 8 + 5, aim - math.asin(0.9 * reach)) == "the red ball thinly on its right"
    assert at(1 * 64 + 6 * 8 + 5, aim) == "the left cushion first"
    assert tip_words(Stroke(1.0, 0.0)) == "in the centre"
    assert tip_words(Stroke(1.0, 0.0, 0.0, 0.5, 0.3)) == "above the centre, with much left side"
    assert tip_words(Stroke(1.0, 0.0, 0.0, -0.2, -0.3)) == "below the centre, with some right side"


def test_a_choice_is_explained_in_sentences(position, drawn):
    group = drawn.groups[0]
    said = explain(position, group, tolerance_of(position, group.stroke))
    assert f"{round(100 * group.chance)} times in 100" in " ".join(said)
    assert route_words(group.code, 0) in " ".join(said)
    assert "degrees" in said[-1] and all(sentence.endswith(".") for sentence in said)
    assert any("kiss" in sentence for sentence in explain(position, group._replace(kisses=1)))


# -- a hand that is measured ------------------------------------------------------------------------


def test_the_noise_of_a_hand_is_found_from_its_strokes():
    meant = Stroke(2.0, 3.1, 0.0, 0.1, 0.2)
    noise = Noise().scaled(2.0)
    made = with_noise(np.array([meant], float), draw_noise(5, 4000), noise, BALL_RADIUS)
    found = noise_of([(meant, Stroke(*row)) for row in made.tolist()], BALL_RADIUS)
    for name in ("tip", "azimuth", "speed"):
        assert getattr(found, name) == pytest.approx(getattr(noise, name), rel=0.05)
    assert noise_of([(meant, meant)] * 4, BALL_RADIUS) is None
    turned = [(meant, meant._replace(azimuth=3.1 - 2.0 * math.pi))] * 5
    assert noise_of(turned, BALL_RADIUS).azimuth == pytest.approx(0.0, abs=1e-9)


def test_a_glance_is_a_smaller_map(position):
    assert len(next(draw_map(position, Noise(), GLANCE)).strokes) < 3000


def test_without_a_ball_to_aim_at_the_aims_go_evenly_all_round():
    aims = aims_of(np.array([(0.5, 0.5)]), np.array([0.03]), 0, 8)
    assert aims == pytest.approx(np.pi * (2.0 * np.arange(8) + 1.0) / 8.0 - np.pi, abs=1e-12)


def test_a_better_stroke_is_sought_within_what_a_tip_can_do(position, monkeypatch):
    monkeypatch.setattr(carom_map, "LARGEST_TIP", 0.05)  # nearer to the middle than the grid's tips are
    found = whole_map(position, Noise(), QUICK).groups
    tips = [math.hypot(group.stroke.tip_left, group.stroke.tip_up) for group in found]
    assert found and max(tips) <= 0.05 + 1e-12 and max(tips) > 0.04
