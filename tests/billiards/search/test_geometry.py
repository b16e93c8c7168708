"""Geometry of pots: windows, lanes and candidates, against exact play and against the line of aim."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.billiards import Physics, Table, simulate_many
from game.billiards.game.arrangement import arrange
from game.billiards.laws.lean import lean_kernel
from game.billiards.laws.state import BALL_POCKET
from game.billiards.search.candidates import (
    AIM,
    BALL,
    BANK,
    CHANCE,
    COMBINATION,
    DIRECT,
    INTO,
    KICK,
    KIND,
    KINDS,
    SPREAD,
    VIA,
    WINDOW,
)
from game.billiards.search.lanes import (
    GATE_X,
    JAW_RADIUS,
    LEFT_X,
    LEFT_Y,
    RIGHT_X,
    RIGHT_Y,
    gates_of,
    pocket_window,
)
from game.billiards.search.looking import Effort, look
from game.billiards.search.rating import Aims
from game.billiards.search.strokes import Board, Noise, draw_noise
from game.billiards.search.view import View
from game.billiards.table.aim import first_contact
from game.billiards.table.rack import BALL_RADIUS as R
from tests.billiards.search.search_tables import POOL, scattered, unlike_balls


def every(layout):
    """Any ball, by any kind of shot."""
    bits = ((1 << len(layout.numbers)) - 1) & ~1
    return Aims(bits, bits, bits, solo=True)


def candidates(places, kinds=KINDS, aims=None, balls=None):
    """View and candidates of a table."""
    layout = places if not isinstance(places, dict) else arrange(places, balls)
    view = View(Board(layout, POOL), Noise())
    return view, view.candidates(every(layout) if aims is None else aims, kinds, 400)


def test_gates_have_their_jaws_left_and_right():
    gates = gates_of(POOL)
    middle = np.array([POOL.width, POOL.length]) / 2.0
    for gate in gates:
        assert gate[JAW_RADIUS] > 0.0
        axis = gate[GATE_X : GATE_X + 2] - middle
        for x, y, sign in ((LEFT_X, LEFT_Y, 1.0), (RIGHT_X, RIGHT_Y, -1.0)):
            jaw = gate[[x, y]] - middle
            assert sign * (axis[0] * jaw[1] - axis[1] * jaw[0]) > 0.0
    assert (gates_of(Table.open())[:, JAW_RADIUS] == 0.0).all()


@lean_kernel
def windows_of(gates, places, radius, out):
    """Middle and half width of every pocket's window for balls at places (k, 2), to out (k, p, 2)."""
    for k in range(places.shape[0]):
        for p in range(gates.shape[0]):
            middle, half = pocket_window(gates, p, places[k, 0], places[k, 1], radius)
            out[k, p, 0] = middle
            out[k, p, 1] = half


def test_a_ball_within_its_window_falls_and_one_outside_does_not():
    """The windows against balls rolled at 1.6 m/s, at shares of the half window from its middle."""
    rng = np.random.default_rng(4)
    places = rng.uniform((0.1, 0.1), (POOL.width - 0.1, POOL.length - 0.1), (60, 2))
    windows = np.empty((60, 6, 2))
    gates = gates_of(POOL)
    windows_of(gates, places, R, windows)
    shares = np.array([-1.8, -0.7, 0.0, 0.7, 1.8])
    shots, pockets = [], []
    for k, place in enumerate(places):
        alone = arrange({1: tuple(place)}).shot(POOL, Physics())
        for p in range(6):
            middle, half = windows[k, p]
            if half <= 0.0 or np.hypot(*(gates[p, :2] - place)) > 1.5:
                continue
            for angle in middle + shares * half:
                velocity = 1.6 * np.array([math.cos(angle), math.sin(angle)])
                shots.append(alone.struck(0, velocity, (-velocity[1] / R, velocity[0] / R, 0.0)))
            pockets.append(p)
    run = simulate_many(shots, until=2.5)
    fell = np.array(
        [
            any(int(row[1]) == BALL_POCKET and int(row[3]) == pockets[i // 5] for row in rows)
            for i, rows in enumerate(run.rows)
        ]
    ).reshape(-1, 5)
    assert len(fell) > 150
    inside, outside = fell[:, 1:4].mean(axis=0), fell[:, [0, 4]].mean(axis=0)
    assert inside.min() > 0.9 and outside.max() < 0.1


@pytest.mark.compiled
@given(st.integers(0, 400))
def test_the_cue_ball_first_meets_what_a_candidate_says(seed):
    layout = scattered(seed, 9, unlike_balls(seed))
    _, found = candidates(layout)
    places, radii = layout.positions, layout.radii
    in_play = np.ones(len(radii), bool)
    assert len({tuple(c[[BALL, INTO, KIND, VIA, AIM]]) for c in found}) == len(found)
    for c in found:
        first = first_contact(0, float(c[AIM]), places, radii, in_play, POOL)
        kind = int(c[KIND])
        if kind == KICK:
            assert first.kind != "ball"
        else:
            target = int(c[VIA]) if kind == COMBINATION else int(c[BALL])
            if first.kind == "cushion":  # the last two millimetres beside a rail are left to exact play
                gap = math.dist(first.ghost, places[target]) - 2.0 * math.sqrt(radii[0] * radii[target])
                assert gap < 0.03
            else:
                assert (first.kind, first.target) == ("ball", target)
            assert (c[VIA] >= 0) == (kind == COMBINATION)
        assert c[SPREAD] > 0.0 and c[WINDOW] > 0.0 and 0.0 < c[CHANCE] <= 1.0


def test_a_straight_pot_is_aimed_straight():
    _, found = candidates({0: (0.9, 1.27), 1: (0.4, 1.27)}, ("direct",))
    best = found[0]
    assert (int(best[BALL]), int(best[INTO])) == (1, 2)
    assert math.cos(best[AIM]) == pytest.approx(-1.0, abs=1e-9)


def test_a_ball_in_the_way_takes_the_candidate_away():
    places = {0: (0.9, 1.27), 1: (0.4, 1.27)}
    for blocker in ((0.65, 1.27), (0.2, 1.27), (0.65, 1.27 + 1.9 * R), (0.2, 1.27 - 1.9 * R)):
        _, found = candidates(places | {2: blocker}, ("direct",))
        assert not any((int(c[BALL]), int(c[INTO])) == (1, 2) for c in found)
    _, found = candidates(places | {2: (0.65, 1.27 + 2.2 * R)}, ("direct",))
    assert any((int(c[BALL]), int(c[INTO])) == (1, 2) for c in found)


def test_banks_and_kicks_are_mirror_images():
    view, found = candidates({0: (0.9, 0.75), 1: (0.635, 1.0)}, ("bank",))
    direction = math.atan2(POOL.pockets[3, 1] - 1.0, 2.0 * R - view.geometry.gates[3, GATE_X] - 0.635)
    ghost = (0.635 - 2 * R * math.cos(direction), 1.0 - 2 * R * math.sin(direction))
    aim = math.atan2(ghost[1] - 0.75, ghost[0] - 0.9)
    banks = [c for c in found if int(c[INTO]) == 3]
    assert min(abs(c[AIM] - aim) for c in banks) < 1e-9 and {int(c[KIND]) for c in found} == {BANK}
    _, found = candidates({0: (0.635, 0.6), 1: (0.3, 2.0)}, ("kick",))
    kick = next(c for c in found if int(c[INTO]) == 4 and math.cos(c[AIM]) > 0.0)
    # seen in the mirror of the right rail, the cue ball runs straight to within a ball of the other
    start = np.array([2.0 * (POOL.width - R) - 0.635, 0.6])
    path = np.array([-math.cos(kick[AIM]), math.sin(kick[AIM])])
    dx, dy = np.array([0.3, 2.0]) - start
    assert abs(dx * path[1] - dy * path[0]) < 2 * R and dx * path[0] + dy * path[1] > 0.0


@pytest.mark.parametrize("kinds", [("direct",), ("bank",), ("kick",), ("combination",)])
@pytest.mark.parametrize("turned", [(1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)])
def test_a_table_seen_in_a_mirror_has_the_mirrored_candidates(kinds, turned):
    """All four rails and six pockets alike: what is said of one is said of its image."""
    size, signs = np.array([POOL.width, POOL.length]), np.array(turned)
    places = {0: (0.8, 0.7), 1: (0.5, 1.3), 2: (0.95, 1.9), 3: (0.25, 0.45)}
    there = {number: tuple(np.where(signs < 0.0, size - place, place)) for number, place in places.items()}

    def told(found, back):
        """Ball, ball by way of, pocket's place, aim and numbers, those of a mirror turned back."""
        rows = []
        for one in found:
            pocket = np.where(
                back < 0.0, size - POOL.pockets[int(one[INTO]), :2], POOL.pockets[int(one[INTO]), :2]
            )
            aim = back * (math.cos(one[AIM]), math.sin(one[AIM]))
            rows.append((one[BALL], one[VIA], *pocket, *aim, one[SPREAD], one[WINDOW], one[CHANCE]))
        return sorted(np.round(rows, 7).tolist())

    here, mirrored = (candidates(at, kinds)[1] for at in (places, there))
    assert len(here) > 0
    np.testing.assert_allclose(told(mirrored, signs), told(here, np.ones(2)), rtol=0.0, atol=1e-6)


def test_combinations_only_by_way_of_what_may_be_hit():
    places = {0: (0.9, 1.27), 1: (0.5, 1.27), 2: (0.3, 1.27)}
    _, found = candidates(places, ("combination",))
    best = found[0]
    assert (int(best[BALL]), int(best[VIA]), int(best[INTO])) == (2, 1, 2)
    none = Aims(first=0b100, score=0b100, needed=0b110)
    _, found = candidates(places, ("direct", "combination"), none)
    assert not any(int(c[VIA]) == 1 for c in found)
    only = Aims(first=0b010, score=0b100, needed=0b110)
    _, found = candidates(places, ("direct", "combination"), only)
    assert {int(c[KIND]) for c in found} == {COMBINATION} and {int(c[BALL]) for c in found} == {2}


def test_the_likeliest_are_kept_when_there_are_too_many():
    layout = scattered(3)
    view = View(Board(layout, POOL), Noise())
    full = view.candidates(every(layout), KINDS, 10_000)
    few = view.candidates(every(layout), KINDS, 7)
    assert len(few) == 7 and np.array_equal(few, full[:7])
    assert (np.diff(full[:, CHANCE]) <= 0.0).all()


def test_an_unsteady_hand_has_less_of_a_chance_and_a_steady_one_is_sure():
    layout = arrange({0: (0.9, 1.0), 1: (0.4, 1.5)})
    chances = []
    for factor in (0.0, 0.5, 1.0, 2.0, 4.0):
        view = View(Board(layout, POOL), Noise().scaled(factor))
        chances.append(view.candidates(every(layout), ("direct",), 1)[0, CHANCE])
    assert chances[0] > 0.999 and all(a > b for a, b in pairwise(chances))


@pytest.mark.compiled
def test_the_chance_is_about_what_play_gives():
    """Estimated chances of direct pots against noisy strokes of one speed, over many tables."""
    effort = Effort(
        kinds=("direct",), speeds=(1.6,), ups=(0.0,), lefts=(0.0,), candidates=20, finalists=60, samples=64,
    )  # fmt: skip
    pairs = []
    for seed in range(24):
        layout = scattered(seed, 3)
        view = View(Board(layout, POOL), Noise())
        looked = look(view, every(layout), effort, draw_noise(seed, 64))
        best: dict[tuple[float, float], tuple[float, float]] = {}
        for c, chance in zip(looked.candidates, looked.chance.tolist(), strict=True):
            key = (c[BALL], c[INTO])
            best[key] = (float(c[CHANCE]), max(chance, best.get(key, (0.0, 0.0))[1]))
        pairs += best.values()
    estimated, played = np.array(pairs).T
    assert np.corrcoef(estimated, played)[0, 1] > 0.8
    assert abs((estimated - played).mean()) < 0.08


def test_direct_is_the_first_kind():
    assert KINDS[DIRECT] == "direct" and KINDS[COMBINATION] == "combination"
