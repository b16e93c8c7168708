"""The next possible time of contact is never after the true one; a step obeys the bound and repeats."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.spacetime.effects import SPACE_TIME, TIMED
from game.physics.spacetime.motion import HORIZON, VX, Grip, Laws, horn_time, pair_time
from game.physics.spacetime.world import TimedBody, TimedWorld

DT = 1.0 / 240.0
LAWS = Laws(12.0, 0.0, 0.9, 3.0, 3.0)
FREE = Grip(-1, 0.0, 0.0, 1.0)


def heap(seed: int, count: int = 8, laws: Laws = LAWS) -> TimedWorld:
    chance = np.random.default_rng(seed)
    kinds = ("star", "comb", "letter", "coast")
    bodies = [
        TimedBody(
            kinds[k % 4], k % 3, 0.45, (-2.0 + 1.3 * (k % 4), -0.8 + 1.6 * (k // 4)),
            float(chance.uniform(0, 6)),
            tuple(chance.uniform(-1.5, 1.5, 2).tolist()), float(chance.uniform(-3, 3)),
            tuple(chance.uniform(-12, 12, 2).tolist()),
        )
        for k in range(count)
    ]  # fmt: skip
    return TimedWorld(bodies, (3.0, 3.0), laws)


def test_the_horn_time_is_the_first_root_and_never_past_it():
    chance = np.random.default_rng(4)
    met = 0
    for _ in range(300):
        d, v = chance.uniform(-4, 4, 2), chance.uniform(-5, 5, 2)
        reach, bound = float(chance.uniform(0.1, 1.5)), float(chance.choice([0.0, 0.5, 9.0]))
        found = horn_time(*d.tolist(), *v.tolist(), reach, bound)
        t = np.linspace(0.0, HORIZON, 200_001)
        gap = np.hypot(d[0] + v[0] * t, d[1] + v[1] * t) - reach - bound * t * t
        first = t[np.argmax(gap <= 0.0)] if np.any(gap <= 0.0) else HORIZON
        assert found <= first + 1e-9
        assert (
            found >= first - 6e-5 or np.min(np.abs(gap)) < 1e-4
        )  # not needlessly early, but at a mere graze
        met += first < HORIZON
    assert met > 100


def test_no_motion_within_the_bound_meets_sooner():
    """Random forces, up to the bound, against the time that was promised at the beginning."""
    chance = np.random.default_rng(7)
    tight = 0
    for trial in range(150):
        a, b = (str(kind) for kind in chance.choice(["star", "comb", "letter", "coast"], 2))
        toward, aside = float(chance.uniform(0.0, 3.0)), float(chance.uniform(-0.3, 0.3))
        turned, spins = chance.uniform(0.0, 6.0, 2).tolist(), chance.uniform(-4.0, 4.0, 2).tolist()
        world = TimedWorld(
            [TimedBody(a, 0, 0.5, (-1.0, 0.0), turned[0], (toward, 0.0), spins[0]),
             TimedBody(b, 1, 0.5, (0.4, aside), turned[1], (-toward, 0.0), spins[1])],
            (90.0, 90.0), LAWS,
        )  # fmt: skip
        apart = world.exact(0, 1)
        promised = pair_time(world.fields, world.makes, 0, 1, apart, LAWS.bound)
        rough = pair_time(world.fields, world.makes, 0, 1, 0.0, LAWS.bound)
        assert promised >= rough
        world.makes[0, 3:] = (12.0, 0.0) if trial % 2 else chance.uniform(-8, 8, 2)
        world.makes[1, 3:] = (-12.0, 0.0) if trial % 2 else chance.uniform(-8, 8, 2)
        met = math.inf
        for step in range(400):
            world.step(0.002, 0, FREE, EffectSet([SPACE_TIME]))
            if world.exact(0, 1) == 0.0:
                met = 0.002 * (step + 1)
                break
        assert promised <= met
        tight += met < math.inf and promised > 0.5 * met
    assert tight > 30  # and the promise is worth something


@pytest.mark.parametrize("seed", range(4))
def test_nothing_is_missed_while_bodies_bounce_and_are_pushed(seed):
    world = heap(seed)
    tested = 0
    for _ in range(300):
        world.step(DT, 100_000, FREE, TIMED.known)
        tested += world.due
        assert world.missed() == 0
    assert world.bounces > 0 and tested < 300 * 28
    world.check()


def test_hand_and_gravity_together_stay_within_the_bound():
    world = heap(1, 2, LAWS._replace(gravity=9.81))
    for step in range(200):
        before = world.fields[VX : VX + 2].copy()
        world.step(DT, 0, Grip(0, 2.5 * (-1) ** (step // 9), 2.0, 900.0), EffectSet([SPACE_TIME, GRAVITY]))
        change = np.hypot(*(world.fields[VX : VX + 2] - before)) / DT
        assert np.all(change[~world.kicked] <= 12.0 * (1.0 + 1e-9))


def test_a_bounce_keeps_momentum_and_makes_no_energy():
    world = TimedWorld(
        [TimedBody("coast", 0, 0.5, (-1.0, 0.1), 0.3, (2.0, 0.0)),
         TimedBody("star", 1, 0.4, (1.0, 0.0), 0.0, (-1.0, 0.0))],
        (90.0, 90.0), LAWS._replace(restitution=1.0),
    )  # fmt: skip

    def sums():
        mass, inertia = world.makes[:, 0], world.makes[:, 1]
        x, y, _, vx, vy, spin = world.fields
        turning = float(np.sum(mass * (x * vy - y * vx) + inertia * spin))
        energy = float(np.sum(mass * (vx**2 + vy**2) + inertia * spin**2))
        return float(np.sum(mass * vx)), float(np.sum(mass * vy)), turning, energy

    before = sums()
    while not world.bounces:
        world.step(DT, 100_000, FREE, TIMED.known)
    assert sums() == pytest.approx(before, rel=1e-9, abs=1e-12)
    assert world.fields[VX, 0] < 2.0


def test_steps_repeat_bit_by_bit_and_go_on_after_a_restore():
    one, other = heap(3), heap(3)
    for _ in range(120):
        one.step(DT, 60, FREE, TIMED.known)
        other.step(DT, 60, FREE, TIMED.known)
    assert one.fields.tobytes() == other.fields.tobytes() and one.times.tobytes() == other.times.tobytes()
    kept = type(one.state())(*(part.copy() for part in one.state()))
    for _ in range(60):
        one.step(DT, 60, FREE, TIMED.known)
    other.restore(kept)
    for _ in range(60):
        other.step(DT, 60, FREE, TIMED.known)
    assert one.fields.tobytes() == other.fields.tobytes()


def test_the_budget_is_kept_and_who_waits_longest_comes_first():
    world = TimedWorld(
        [TimedBody("comb", 0, 0.6, (0.1 * k, 0.0), 0.4 * k) for k in range(10)], (3.0, 3.0), LAWS
    )
    waited = 0
    for _ in range(60):
        world.step(DT, 20, FREE, EffectSet([SPACE_TIME]))
        assert world.tests <= 20
        waited = max(waited, int(np.count_nonzero(world.times[np.triu_indices(10, 1)] <= 0.0)))
    assert waited == 25  # of 45 at first
    assert np.all(world.times[np.triu_indices(10, 1)] > world.now - 6.0 * DT)


def test_without_bounds_every_pair_is_tested_and_the_motion_is_the_same():
    lazy, eager = heap(2), heap(2)
    due = [0, 0]
    for _ in range(100):
        lazy.step(DT, 100_000, FREE, TIMED.known)
        eager.step(DT, 100_000, FREE, TIMED.known.without(SPACE_TIME))
        due[0] += lazy.due
        due[1] += eager.due
    assert due[1] == 100 * 28 and due[0] < 0.3 * due[1]
    assert np.allclose(lazy.fields, eager.fields, rtol=0.0, atol=1e-9)


@pytest.mark.parametrize("field", ["bound", "restitution"])
def test_nonsense_is_refused(field):
    world = heap(0, 2)
    with pytest.raises(ValueError, match=field):
        world.set_laws(LAWS._replace(**{field: -1.0}))
    with pytest.raises(ValueError, match="dt"):
        world.step(0.0, 10, FREE, TIMED.known)
    with pytest.raises(ValueError, match="bodies"):
        TimedWorld([], (1.0, 1.0), LAWS)
    with pytest.raises(ValueError, match="size"):
        TimedWorld([TimedBody("star", 0, 0.0, (0.0, 0.0))], (1.0, 1.0), LAWS)


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 1, 0), (1, 0, 2)])
def test_an_impact_renews_the_times_of_both(order):
    """With no acceleration at all the two at rest would never meet, until one of them is hit."""
    row = [
        TimedBody("star", 0, 0.3, (-1.5, 0.0), 0.0, (2.0, 0.0)),
        TimedBody("star", 0, 0.3, (-0.5, 0.0)),
        TimedBody("star", 0, 0.3, (0.8, 0.0)),
    ]
    world = TimedWorld([row[k] for k in order], (90.0, 90.0), LAWS._replace(bound=0.0))
    for _ in range(600):
        world.step(DT, 100_000, FREE, TIMED.known)
        assert world.missed() == 0
    assert world.bounces >= 2
