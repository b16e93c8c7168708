"""The grip of the hand: a patch is led along, the nearer the more."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.constraints import DAMPING, LINKS, PositionBasedDynamics, shapes
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY

DT = 1.0 / 60.0
PLACES = [(0.0, 0.0), (0.1, 0.0), (0.0, 0.1), (0.2, 0.0), (0.0, -0.05)]
MASSES = [1.0, 0.5, 2.0, 1.0, 0.0]  # 1/kg; the last is pinned


def loose(**settings):
    """Five particles without links or gravity, the last one pinned."""
    return PositionBasedDynamics(PLACES, MASSES, gravity=0.0, effects=EffectSet(), **settings)


def led(system, grip, target=(0.03, -0.06)):
    """Velocities in m/s of a step of a hand that takes the first."""
    system.grab(0, grip)
    system.drag(target)
    system.step(DT)
    system.check()
    return (system.positions - PLACES) / DT


@pytest.mark.parametrize("substeps", [1, 4])
def test_a_patch_goes_with_the_hand_by_the_biweight(substeps):
    """w = (1 - d²/R²)² with R = 0.2 m: 1 at the hand, 9/16 at 0.1 m, 0 at 0.2 m; the pinned one stays."""
    hand = np.array((0.03, -0.06)) / DT
    first = led(loose(), 0.2)
    assert first == pytest.approx(np.outer([1.0, 9 / 16, 9 / 16, 0.0, 0.0], hand))
    more = led(loose(substeps=substeps), 0.2)  # each substep leads the rest of it by the weight again
    share = np.mean([1.0 - (7 / 16) ** (k + 1) for k in range(substeps)])
    assert more[1] == pytest.approx(share * hand)


def test_without_a_radius_the_held_one_goes_alone():
    assert np.count_nonzero(led(loose(), 0.0)) == 2


def test_links_move_the_led_ones_by_what_is_left_of_their_inverse_mass():
    """A link of 0.1 m stretched to 0.2: of inverse masses 0.5 · 7/16 and 1, they share it so."""
    system = PositionBasedDynamics(
        [(0.0, 0.0), (0.1, 0.0), (0.3, 0.0)], [1.0, 0.5, 1.0], [(1, 2)], rest_lengths=0.1, gravity=0.0,
        effects=EffectSet([LINKS]), iterations=1,
    )  # fmt: skip
    system.grab(0, 0.2)
    system.step(DT)
    left = 0.5 * 7 / 16
    assert system.positions[1, 0] == pytest.approx(0.1 + 0.1 * left / (left + 1.0))
    assert system.own_inverse_masses() == pytest.approx([1.0, 0.5, 1.0])


def test_who_is_let_go_has_the_own_mass_again_and_goes_on():
    system = loose()
    led(system, 0.2)
    system.give_inverse_mass(2, 8.0)
    assert system.inverse_masses[2] == pytest.approx(7 / 16 * 8.0)
    system.release()
    assert system.inverse_masses == pytest.approx([1.0, 0.5, 8.0, 1.0, 0.0])
    before = system.positions
    system.step(DT)
    assert system.positions[1] - before[1] == pytest.approx(9 / 16 * np.array((0.03, -0.06)))


def test_a_state_remembers_whom_the_hand_leads():
    system = loose()
    led(system, 0.2)
    state = type(system.state())(*(array.copy() for array in system.state()))
    system.step(DT)
    after = system.positions
    system.release()
    system.restore(state)
    system.step(DT)
    assert np.array_equal(system.positions, after)
    system.release()
    assert system.inverse_masses == pytest.approx(MASSES)


def test_a_hand_in_a_cloth_is_no_spike():
    """Pulled sideways by 0.4 m at 8 m/s, what hangs 16 cm beside the hand comes along, or hardly."""
    follows = {}
    for grip in (0.0, 0.25):
        cloth = shapes.cloth((0.0, 0.0), 100, 100, 0.04, mass=0.01, pins="eighths")
        system = PositionBasedDynamics(
            cloth.positions, cloth.inverse_masses, cloth.links, substeps=16, iterations=1, damping=0.3,
            effects=EffectSet([GRAVITY, LINKS, DAMPING]),
        )  # fmt: skip
        index = shapes.cloth_index(100, 100)
        begin = system.positions
        system.grab(int(index[50, 50]), grip)
        for i in range(3):
            system.drag(begin[index[50, 50]] + ((i + 1) * 8.0 * DT, 0.0))
            system.step(DT)
        follows[grip] = (system.positions - begin)[index[50, 54], 0] / 0.4
    assert follows[0.0] < 0.3
    assert follows[0.25] > 0.6


@pytest.mark.parametrize("radius", [-0.1, float("nan"), float("inf")])
def test_a_radius_is_a_finite_number(radius):
    with pytest.raises(ValueError, match="radius"):
        loose().grab(0, radius)
