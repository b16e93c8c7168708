"""A system of linked particles: sweeps against a naive twin, the hand, tearing, remembering, refusals."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.constraints import ATTACHMENTS, CONTACTS, LINKS, TEARING, PositionBasedDynamics, shapes
from game.physics.constraints.editing import speeds_of
from game.physics.fields import GRAVITY, GROUND

DT = 1.0 / 60.0


def floating(positions, links=(), **settings):
    """A system that no gravity pulls."""
    return PositionBasedDynamics(positions, links=links, gravity=0.0, **settings)


# -- sweeps ---------------------------------------------------------------------------------------------


def sweep(places, weights, links, rest, stiffness=None, softness=None, multipliers=None):
    """One sweep as the equations have it, over links in the order of the system."""
    for e, (a, b) in enumerate(links):
        n = places[b] - places[a]
        length = math.sqrt(n @ n)
        n = n / length
        if softness is None:
            move = stiffness * (length - rest[e]) / (weights[a] + weights[b])
        else:
            soft = weights[a] + weights[b] + softness
            move = (length - rest[e] - softness * multipliers[e]) / soft
            multipliers[e] += move
        places[a] += weights[a] * move * n
        places[b] -= weights[b] * move * n


@pytest.mark.parametrize("order", ["coloured", "natural", "reversed"])
@pytest.mark.parametrize("model", ["pbd", "pbd-even", "xpbd"])
def test_sweeps_are_those_of_the_equations(model, order):
    """A cloth that was stretched: runs that are solved together do what one link after the other does."""
    cloth = shapes.cloth((0.0, 0.0), 20, 5, 0.1)
    random = np.random.default_rng(2)
    places = 1.1 * np.asarray(cloth.positions) + random.uniform(-0.01, 0.01, (100, 2))
    weights = random.uniform(0.5, 2.0, 100)
    rest = np.full(len(cloth.links), 0.1)
    system = floating(
        places, cloth.links, inverse_masses=weights, rest_lengths=rest, stiffness=0.7, compliances=1e-3,
        order=order, model=model, iterations=3,
    )  # fmt: skip
    ordered = system.links.pairs[system._net.order]
    assert (order == "coloured") == bool(system._net.runs[:, 2].any())
    system.step(DT)
    multipliers = np.zeros(len(rest))
    for _ in range(3):
        if model == "xpbd":
            sweep(places, weights, ordered, rest, None, 1e-3 / DT**2, multipliers)
        else:
            k = 0.7 if model == "pbd" else 1.0 - 0.3 ** (1.0 / 3.0)
            sweep(places, weights, ordered, rest, k)
    assert np.abs(system.positions - places).max() < 1e-13


def test_nothing_floating_gains_momentum():
    system = floating(
        [(0.0, 0.0), (1.5, 0.0), (1.0, 1.0)], [(0, 1), (1, 2), (2, 0)], rest_lengths=[1.0, 1.0, 1.0],
        velocities=[(1.0, 0.0), (0.0, 2.0), (0.0, 0.0)],
    )  # fmt: skip
    for _ in range(10):
        system.step(DT)
    assert system.momentum()[:2] == pytest.approx((1.0, 2.0), abs=1e-12)


def test_energy_counts_from_the_floor():
    system = PositionBasedDynamics([(0.0, 3.0)], [0.5], velocities=[(3.0, 4.0)], gravity=10.0, floor=1.0)
    assert system.energy() == pytest.approx((25.0, 40.0))
    system.change(floor=-1e6)
    assert system.energy() == pytest.approx((25.0, 60.0))
    assert speeds_of(system).tolist() == [5.0]


# -- the hand -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("scheme", ["euler", "bdf2"])
def test_what_is_held_follows_the_hand_and_flies_on(scheme):
    system = floating([(0.0, 0.0), (5.0, 0.0)], scheme=scheme)
    system.grab(0)
    for i in range(1, 5):
        system.drag((0.1 * i, 0.0))
        system.step(DT)
        assert system.positions[0] == pytest.approx([0.1 * i, 0.0], abs=1e-12)
    assert system.held == 0 and system.inverse_masses[0] == 0.0
    system.check()
    system.release()
    assert system.held == -1 and system.inverse_masses[0] == 1.0
    system.step(DT)
    assert system.velocities[0] == pytest.approx([0.1 / DT, 0.0], rel=1e-9)
    assert system.positions[1].tolist() == [5.0, 0.0]


def test_the_speed_limit_keeps_momentum_only_where_it_is_not_met():
    def momentum(limit):
        system = PositionBasedDynamics(
            [(0.0, 0.0), (3.0, 0.0)], [1.0, 0.1], [(0, 1)], rest_lengths=[1.0], effects=LINKS | CONTACTS,
            speed_limit=limit,
        )  # fmt: skip
        system.step(0.1)
        return system.momentum()[0]

    assert momentum(100.0) == pytest.approx(0.0, abs=1e-12)
    light, heavy = 2.0 * 10 / 11 / 0.1, -2.0 * 1 / 11 / 0.1  # m/s, of the whole overlength in one step
    assert momentum(10.0) == pytest.approx(1.0 * min(light, 10.0) + 10.0 * heavy, rel=1e-9)


def test_the_hand_is_no_faster_than_the_speed_limit():
    system = floating([(0.0, 0.0)], speed_limit=6.0, substeps=2)
    system.grab(0)
    system.drag((30.0, 40.0))
    system.step(DT)
    assert system.positions[0] == pytest.approx([0.06, 0.08])


def test_a_fixed_particle_that_was_led_stands_where_it_is_let_go():
    system = PositionBasedDynamics([(0.0, 0.0)], 0.0)
    system.grab(0)
    system.drag((1.0, 1.0))
    system.step(DT)
    system.release()
    system.step(DT)
    assert system.positions[0] == pytest.approx([1.0, 1.0])
    assert system.velocities[0].tolist() == [0.0, 0.0]


# -- tearing --------------------------------------------------------------------------------------------


def test_links_tear_beyond_the_limit_and_hold_below():
    system = floating(
        [(0.0, 0.0), (1.49, 0.0), (3.0, 0.0)], [(0, 1), (1, 2)], rest_lengths=[1.0, 1.0], stiffness=0.0,
        stretch_limit=0.5,
    )  # fmt: skip
    system.change(effects=system.settings.effects.with_(TEARING))
    system.step(DT)
    assert (system.torn.tolist(), system.tears) == ([0, 1], 1)
    assert system.measure().worst_strain == pytest.approx(0.49)
    assert system.strains == pytest.approx([0.49, 0.0])


def test_a_rope_that_is_torn_has_no_pin_any_more():
    effects = PositionBasedDynamics([(0.0, 0.0)]).settings.effects.with_(TEARING).with_(ATTACHMENTS)
    system = PositionBasedDynamics(
        [(0.0, 0.0), (1.0, 0.0), (2.5, 0.0)], [0.0, 1.0, 1.0], [(0, 1), (1, 2)], rest_lengths=[1.0, 0.5],
        stiffness=0.0, gravity=0.0, stretch_limit=1.0, effects=effects,
    )  # fmt: skip
    system.step(DT)  # the attachment has brought the tip back to its reach before links are looked at
    assert system.positions[2] == pytest.approx([1.5, 0.0])
    system.cut(1)
    assert (system.torn.tolist(), system.tears) == ([0, 1], 1)
    system.cut(1)
    assert system.tears == 1
    system.fields[0, 2] = 9.0
    system.step(DT)
    assert system.positions[2, 0] > 7.0


def test_an_outline_without_one_of_its_links_keeps_no_area():
    square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
    for cut in (False, True):
        system = floating(square, [(0, 1), (1, 2), (2, 3), (0, 3)], areas=[[0, 1, 2, 3]], stiffness=0.0)
        if cut:
            system.cut(3)
        system.fields[0, 1:3] = 2.0  # twice as wide
        for _ in range(60):
            system.step(DT)
        now, rest = system.areas()
        assert rest == pytest.approx([1.0])
        assert now == pytest.approx([2.0 if cut else 1.0], abs=1e-6)


# -- contacts, the floor --------------------------------------------------------------------------------


def test_pairs_exchange_velocities_and_the_hidden_one_waits():
    system = floating(
        [(0.0, 0.0), (1.0, 0.0), (2.1, 0.0)], contacts=[(0, 1), (1, 2)], distances=0.5,
        velocities=[(6.0, 0.0), (0.0, 0.0), (0.0, 0.0)],
    )  # fmt: skip
    assert CONTACTS in system.settings.effects
    for _ in range(30):
        system.step(DT)
    assert system.velocities[:, 0] == pytest.approx([0.0, 0.0, 6.0], abs=1e-9)


@pytest.mark.parametrize("scheme", ["euler", "bdf2"])
def test_nothing_sinks_into_the_floor(scheme):
    system = PositionBasedDynamics([(0.0, 0.2), (1.0, 3.0)], scheme=scheme, floor=0.0, speed_limit=50.0)
    system.change(effects=GRAVITY | GROUND)
    for _ in range(120):
        system.step(DT)
        assert system.positions[:, 1].min() >= 0.0
    assert system.positions[:, 1] == pytest.approx([0.0, 0.0])


# -- remembering ----------------------------------------------------------------------------------------


def test_a_state_put_back_goes_on_to_the_last_bit():
    def make():
        cloth = shapes.cloth((0.0, 0.0), 6, 5, 0.2)
        effects = PositionBasedDynamics([(0.0, 0.0)]).settings.effects.with_(TEARING).with_(ATTACHMENTS)
        weights = np.where(np.arange(30) % 6 == 0, 0.0, 1.0)
        return PositionBasedDynamics(
            cloth.positions, weights, cloth.links, stretch_limit=0.4, effects=effects
        )

    first, second = make(), make()
    first.grab(14)
    for i in range(20):
        first.drag((0.2 * i, 0.3 * i))
        first.step(DT)
    assert first.tears > 0
    second.restore(type(first.state())(*(np.copy(part) for part in first.state())))
    assert (second.tears, second.held) == (first.tears, 14)
    for system in (first, second):
        system.release()
        for _ in range(10):
            system.step(DT)
        system.check()
    assert np.array_equal(first.fields, second.fields)


# -- refusals -------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"positions": []}, "positions: expected pairs of numbers"),
        ({"positions": [(0.0, math.nan)]}, "positions: "),
        ({"positions": [(0.0, 2e12)]}, "positions: "),
        ({"velocities": [(0.0, 0.0)]}, "velocities: "),
        ({"inverse_masses": [1.0]}, r"inverse_masses: expected 2 numbers, got shape \(1,\)"),
        ({"inverse_masses": [1.0, -1.0]}, r"inverse_masses\[1\] = .*-1.0"),
        ({"links": [(0.0, 1.0)]}, "links: expected pairs of whole numbers"),
        ({"links": [(0, 2)]}, r"links\[0\] = \[0, 2\]: there are particles 0 to 1"),
        ({"links": [(1, 1)]}, r"links\[0\] = \[1, 1\]: expected two different"),
        ({"areas": [[0, 1]]}, r"areas\[0\]: expected three or more different"),
        ({"positions": [(0, 0), (1, 0), (0, 1)], "areas": [[0, 1, 7]]}, "there are particles 0 to 2"),
        ({"model": "rubber"}, "model = 'rubber': expected one of pbd"),
        ({"iterations": 0}, "iterations = 0: expected a whole number"),
        ({"relaxation": 2.0}, "relaxation = 2.0: "),
    ],
)
def test_what_makes_no_sense_is_named(arguments, message):
    with pytest.raises(ValueError, match=message):
        PositionBasedDynamics(**{"positions": [(0.0, 0.0), (1.0, 0.0)], **arguments})


def test_refusals_change_nothing():
    system = PositionBasedDynamics([(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)], links=[(0, 1), (1, 2), (0, 2)])
    for call, message in (
        (lambda: system.step(0.0), "dt = 0.0"),
        (lambda: system.grab(3), "particle 3: there are 0 to 2"),
        (lambda: system.cut(-1), "link -1: there are 3"),
        (lambda: system.drag((1.0, math.inf)), "target: "),
        (lambda: system.change(solver="direct"), "direct"),  # three links in a ring are no chain
        (lambda: system.change(effects=PositionBasedDynamics([(0, 0)]).settings.effects, model="x"), "model"),
    ):
        with pytest.raises(ValueError, match=message):
            call()
    assert system.settings.solver == "gauss-seidel"
    system.step(DT)
    system.check()


@pytest.mark.parametrize("order", ["nonsense", "", None, 3])
def test_an_order_that_there_is_not_is_refused(order):
    for links in ((), [(0, 1)]):
        with pytest.raises(ValueError, match=r"^order = .*: expected one of coloured, natural, reversed$"):
            PositionBasedDynamics([(0.0, 0.0), (1.0, 0.0)], links=links, order=order)
