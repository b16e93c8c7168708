"""What of a cloth still holds, each rule against a plain twin of it on cloths with holes at random."""

from __future__ import annotations

import heapq
import math

import numpy as np
import pytest

from game.physics.cloth.holding import (
    LIGHTEST,
    SHORTER,
    burn_through,
    find_reach,
    name_pieces,
    take_ash,
    tear_out,
    tie,
    weigh,
)
from game.physics.cloth.layout import (
    CHAR,
    FUEL,
    HOT,
    INVERSE,
    NODE_ROWS,
    PATCH_ROWS,
    PER,
    THERE,
    WATER,
    Ties,
    X,
    Y,
    Z,
    make_ties,
)

NY, NX, SPACING, DRY = 4, 5, 0.25, 0.5
SEEDS = range(4)


def holed(seed: int) -> Ties:
    """A cloth of which a third of the meshes is lost, threads not looked at yet."""
    ties = make_ties(NY, NX)
    ties.whole[np.random.default_rng(seed).random((NY, NX)) < 0.35] = 0.0
    return ties


def flat() -> np.ndarray:
    nodes = np.zeros((NODE_ROWS, NY + 1, NX + 1))
    nodes[X], nodes[Y] = SPACING * np.arange(NX + 1)[None], -SPACING * np.arange(NY + 1)[:, None]
    nodes[THERE] = 1.0
    return nodes


def filled(seed: int) -> np.ndarray:
    patches = np.zeros((PATCH_ROWS, PER * NY, PER * NX))
    random = np.random.default_rng(seed + 100)
    for row, most in ((FUEL, DRY), (CHAR, 0.2 * DRY), (WATER, 0.3 * DRY)):
        patches[row] = most * random.random(patches.shape[1:])
    patches[HOT] = 300.0 + 500.0 * random.random(patches.shape[1:])
    return patches


def meshes(values: np.ndarray) -> np.ndarray:
    """(NY, NX, PER²) the patches of each mesh."""
    return values.reshape(NY, PER, NX, PER).swapaxes(1, 2).reshape(NY, NX, PER * PER)


def beside(whole: np.ndarray) -> np.ndarray:
    """(NY + 1, NX + 1, 4) the meshes above left, above right, below left, below right of each node."""
    wide = np.pad(whole, 1)
    return np.stack([wide[:-1, :-1], wide[:-1, 1:], wide[1:, :-1], wide[1:, 1:]], axis=2)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_mesh_burns_through_below_its_least_share_of_fuel_and_char_and_not_at_it(seed):
    ties, patches = holed(seed), filled(seed)
    share = meshes(patches[FUEL] + patches[CHAR]).mean(axis=2) / DRY
    gone = (ties.whole > 0.0) & (share < 0.55)
    expected = np.where(gone, -1.0, ties.whole)
    assert burn_through(patches, ties.whole, DRY, 0.55) == gone.sum() > 0
    assert np.array_equal(ties.whole, expected)
    even = np.zeros_like(patches)
    even[FUEL], even[CHAR], even[WATER] = 0.25 * DRY, 0.25 * DRY, 9.0
    assert burn_through(even, np.ones((NY, NX)), DRY, 0.5) == 0
    assert burn_through(even, np.ones((NY, NX)), DRY, 0.5 + 1e-12) == NY * NX


@pytest.mark.parametrize("seed", SEEDS)
def test_what_is_lost_takes_its_heat_and_mass_with_it_and_leaves_cold_empty_patches(seed):
    ties, patches = holed(seed), filled(seed)
    lost = (ties.whole > 0.0) & (np.random.default_rng(seed + 7).random((NY, NX)) < 0.5)
    ties.whole[lost] = -1.0
    of = np.repeat(np.repeat(lost, PER, axis=0), PER, axis=1)
    capacity, water_heat, ambient, area = 350.0, 4186.0, 293.15, 0.01
    before, ash = patches.copy(), np.array([1.0, 2.0, 3.0, 4.0])
    take_ash(patches, ties.whole, (capacity, water_heat, ambient, area), ash)
    heat = ((capacity + water_heat * before[WATER]) * (before[HOT] - ambient))[of].sum()
    masses = [before[row][of].sum() for row in (FUEL, CHAR, WATER)]
    assert ash == pytest.approx(np.array([1.0, 2.0, 3.0, 4.0]) + area * np.array([heat, *masses]), rel=1e-12)
    assert np.all(ties.whole[lost] == 0.0) and np.all(patches[HOT][of] == ambient)
    assert not patches[[FUEL, CHAR, WATER]][:, of].any()
    assert np.array_equal(patches[:, ~of], before[:, ~of])


@pytest.mark.parametrize("seed", SEEDS)
def test_threads_and_nodes_are_there_beside_a_whole_mesh_and_an_empty_hook_lets_go(seed):
    ties, nodes, hooked = holed(seed), flat(), np.ones(2)
    ties.across[:], ties.along[:] = 9.0, 9.0
    tie(nodes, ties, hooked)
    whole = ties.whole
    assert np.array_equal(nodes[THERE], beside(whole).max(axis=2))
    rows, columns = np.pad(whole, ((1, 1), (0, 0))), np.pad(whole, ((0, 0), (1, 1)))
    assert np.array_equal(ties.across, np.maximum(rows[:-1], rows[1:]))
    assert np.array_equal(ties.along, np.maximum(columns[:, :-1], columns[:, 1:]))
    assert hooked.tolist() == [whole[0, 0], whole[0, -1]]


def test_each_hook_lets_go_by_itself():
    for corner, left in ((0, [0.0, 1.0]), (-1, [1.0, 0.0])):
        ties, nodes, hooked = make_ties(NY, NX), flat(), np.ones(2)
        ties.whole[0, corner] = 0.0
        tie(nodes, ties, hooked)
        assert hooked.tolist() == left


@pytest.mark.parametrize("seed", SEEDS)
def test_a_node_weighs_a_quarter_of_the_meshes_around_it_wet_and_at_least_so_much(seed):
    ties, patches, nodes = holed(seed), filled(seed), flat()
    patches[:, :PER, :PER] = 0.0  # nothing left of the first mesh
    ties.whole[0, 0], ties.whole[0, 1], ties.whole[1, 0] = 1.0, 0.0, 0.0
    tie(nodes, ties, np.ones(2))
    mesh = SPACING * SPACING
    weigh(nodes, patches, ties.whole, mesh, DRY)
    per = meshes(patches[FUEL] + patches[CHAR] + patches[WATER]).mean(axis=2) * (ties.whole > 0.0)
    mass = 0.25 * mesh * beside(per).sum(axis=2)
    least = LIGHTEST * 0.25 * mesh * DRY
    there = nodes[THERE] > 0.0
    assert nodes[INVERSE][there] == pytest.approx(1.0 / np.maximum(mass, least)[there], rel=1e-12)
    assert not nodes[INVERSE][~there].any() and nodes[INVERSE, 0, 0] == pytest.approx(1.0 / least)


@pytest.mark.parametrize("seed", SEEDS)
def test_the_way_to_a_hook_is_the_shortest_over_threads_and_diagonals(seed):
    """A twin by Dijkstra's rule; a way counts a little shorter, but never less than straight."""
    ties, nodes, hooked = holed(seed), flat(), np.ones(2)
    ties.whole[0, 0] = ties.whole[0, -1] = 1.0
    tie(nodes, ties, hooked)
    find_reach(nodes, ties, hooked, SPACING)
    for k in range(2):
        ways = dijkstra(ties, (0, NX * k))
        for j in range(NY + 1):
            for i in range(NX + 1):
                straight = SPACING * math.hypot(j, i - NX * k)
                expected = max(straight, SHORTER * ways.get((j, i), math.inf))
                assert ties.reach[k, j, i] == pytest.approx(expected, rel=1e-12), (k, j, i)
    find_reach(nodes, ties, np.array([0.0, 1.0]), SPACING)
    assert np.all(np.isinf(ties.reach[0])) and ties.reach[1, 0, NX] == 0.0


def dijkstra(ties: Ties, start: tuple[int, int]) -> dict[tuple[int, int], float]:
    found: dict[tuple[int, int], float] = {}
    waiting = [(0.0, start)]
    while waiting:
        far, (j, i) = heapq.heappop(waiting)
        if (j, i) in found:
            continue
        found[j, i] = far
        for dj in (-1, 0, 1):
            for di in (-1, 0, 1):
                b, a = j + dj, i + di
                if (dj, di) == (0, 0) or not (0 <= b <= NY and 0 <= a <= NX):
                    continue
                if dj == 0:
                    held = ties.across[j, min(i, a)]
                elif di == 0:
                    held = ties.along[min(j, b), i]
                else:
                    held = ties.whole[min(j, b), min(i, a)]
                if held > 0.0:
                    heapq.heappush(waiting, (far + SPACING * math.hypot(dj, di), (b, a)))
    return found


@pytest.mark.parametrize("seed", range(8))
def test_pieces_are_the_meshes_that_hold_together_also_at_corners(seed):
    ties = holed(seed)
    if seed >= 4:  # more holes, more pieces
        ties.whole[np.random.default_rng(seed + 50).random((NY, NX)) < 0.5] = 0.0
    names, stack = np.full((NY, NX), 77, dtype=np.int64), np.zeros((NY * NX, 2), dtype=np.int64)
    count = name_pieces(ties.whole, names, stack)
    expected, pieces = np.full((NY, NX), -1), 0
    for start in np.argwhere(ties.whole > 0.0).tolist():
        if expected[tuple(start)] >= 0:
            continue
        front = [tuple(start)]
        while front:
            j, i = front.pop()
            if 0 <= j < NY and 0 <= i < NX and ties.whole[j, i] > 0.0 and expected[j, i] < 0:
                expected[j, i] = pieces
                front += [(j + b, i + a) for b in (-1, 0, 1) for a in (-1, 0, 1)]
        pieces += 1
    assert count == pieces and np.array_equal(names, expected)


class TestTearing:
    """limits: a whole thread bears a strain of 1/2."""

    LIMITS = (0.5, SPACING, DRY)

    @staticmethod
    def pulled(column: int, length: float) -> np.ndarray:
        """All threads across between two columns are so long, beside what they should be."""
        nodes = flat()
        nodes[X, :, column + 1 :] += (length - 1.0) * SPACING
        return nodes

    def torn(self, nodes, ties, patches) -> set[tuple[int, int]]:
        count = tear_out(nodes, ties, patches, self.LIMITS)
        lost = {tuple(place) for place in np.argwhere(ties.whole < 0.0).tolist()}
        assert count == len(lost)
        return lost

    @staticmethod
    def whole() -> tuple[Ties, np.ndarray]:
        patches = np.zeros((PATCH_ROWS, PER * NY, PER * NX))
        patches[FUEL] = DRY
        return make_ties(NY, NX), patches

    def test_a_thread_bears_its_strain_and_no_more(self):
        ties, patches = self.whole()
        assert self.torn(self.pulled(2, 1.5), ties, patches) == set()
        assert self.torn(self.pulled(2, 1.5 + 1e-9), ties, patches) == {(j, 2) for j in range(NY)}

    def test_a_thread_stretched_in_depth_or_downwards_tears_too(self):
        for axis, shift in ((Y, 0.51), (Z, 2.0)):
            ties, patches = self.whole()
            nodes = flat()
            nodes[axis, 3:] -= shift * SPACING
            assert self.torn(nodes, ties, patches) == {(2, i) for i in range(NX)}

    def test_the_weaker_mesh_beside_the_thread_goes_the_later_of_equals(self):
        for weak in (0, 1):
            ties, patches = self.whole()
            # the thread down between the meshes (1, 1) and (1, 2)
            nodes = flat()
            nodes[Z, 2:] = 1.4 * SPACING
            ties.across[:], ties.along[:] = 0.0, 0.0
            ties.along[1, 2] = 1.0
            patches[FUEL, PER : 2 * PER, PER * (1 + weak) : PER * (2 + weak)] = 0.9 * DRY
            assert self.torn(nodes, ties, patches) == {(1, 1 + weak)}
        ties, patches = self.whole()
        ties.across[:], ties.along[:] = 0.0, 0.0
        ties.along[1, 2] = 1.0
        assert self.torn(nodes, ties, patches) == {(1, 2)}

    @pytest.mark.parametrize(("left", "bears"), [(1.0, 0.5), (0.5, 0.25), (0.12, 0.06), (0.05, 0.05)])
    def test_a_burnt_thread_bears_in_proportion_to_what_is_left_and_a_tenth_at_least(self, left, bears):
        for strain, lost in ((bears - 1e-6, set()), (bears + 1e-6, {(0, 0)})):
            ties, patches = self.whole()
            patches[FUEL, :PER, :PER] = left * DRY
            ties.across[:], ties.along[:] = 0.0, 0.0
            ties.across[0, 0] = 1.0  # at the rim: one mesh beside it
            assert self.torn(self.pulled(0, 1.0 + strain), ties, patches) == lost

    def test_of_two_meshes_the_mean_counts_and_of_an_empty_one_and_none_the_empty(self):
        for strain, lost in ((0.375 - 1e-6, set()), (0.375 + 1e-6, {(0, 1)})):
            ties, patches = self.whole()
            patches[FUEL, PER : 2 * PER, :] = 0.0  # the second row has char only
            patches[CHAR, PER : 2 * PER, :] = 0.5 * DRY
            ties.across[:], ties.along[:] = 0.0, 0.0
            ties.across[1, 1] = 1.0
            expected = {(1, 1)} if lost else set()
            assert self.torn(self.pulled(1, 1.0 + strain), ties, patches) == expected
        ties, patches = self.whole()
        patches[:] = 0.0
        ties.across[:], ties.along[:] = 0.0, 0.0
        ties.across[0, 1] = 1.0
        assert self.torn(self.pulled(1, 1.2), ties, patches) == {(0, 1)}

    def test_threads_that_are_gone_and_those_without_a_mesh_tear_nothing(self):
        ties, patches = self.whole()
        ties.across[:], ties.along[:] = 0.0, 0.0
        assert self.torn(self.pulled(2, 3.0), ties, patches) == set()
        ties, patches = self.whole()
        ties.whole[:] = 0.0
        assert self.torn(self.pulled(2, 3.0), ties, patches) == set()
