"""Many plates: hard cases of flight, wind, bend and landing; energy never rises; what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.constraints.effects import CONTACTS
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY, GROUND, QUADRATIC_DRAG, WIND
from game.physics.plates import Gust, GustyWind, Plate, Plates, PlateSettings
from game.physics.plates.checks import slopes_of
from game.physics.plates.effects import BENDING, CIRCULATION, GUST_INERTIA
from game.physics.plates.flight import WIND as ROWS_OF_WIND
from game.physics.plates.law import BEND, BEND_RATE, MASS_Y, SPIN, THETA, VX, VY, WEIGHT, X, Y
from game.physics.surfaces import ConstantField, FunctionField

FLIGHT = GRAVITY | QUADRATIC_DRAG | CIRCULATION | BENDING
LEAF = Plate(half_chord=0.03, inertia=1.1, thickness=0.05, curl=0.3, bend_hz=8.0)


def fly(world: Plates, seconds: float, dt: float = 1.0 / 240.0) -> Plates:
    for _ in range(round(seconds / dt)):
        world.step(dt)
        world.check()
    return world


def many(count: int, seed: int = 1, **more) -> Plates:
    random = np.random.default_rng(seed)
    kinds = [
        Plate(float(a), float(i), 0.05, curl=float(q), bend_hz=float(f))
        for a, i, q, f in zip(
            random.uniform(0.01, 0.05, count), random.uniform(0.3, 3.0, count),
            random.uniform(-0.8, 0.8, count), random.uniform(3.0, 30.0, count), strict=True,
        )
    ]  # fmt: skip
    places = np.stack(
        [random.uniform(-1, 1, count), random.uniform(2, 3, count), random.uniform(-3, 3, count)], 1
    )
    return Plates(kinds, places, **more)


def test_at_rest_and_along_its_axes_nothing_is_divided_by_zero():
    """H1."""
    for velocity in ((0.0, 0.0), (1.0, 0.0), (0.0, -1.0), (1e-300, 0.0)):
        world = Plates(effects=FLIGHT)
        world.add(Plate(), (0.0, 0.0), 0.0, velocity)
        fly(world, 0.5)
        world = Plates(effects=EffectSet([QUADRATIC_DRAG]))
        world.add(Plate(), (0.0, 0.0), 0.0, velocity)
        fly(world, 0.1)
        assert math.hypot(*world.velocities[0]) <= math.hypot(*velocity)


@pytest.mark.parametrize("inertia", [1e-3, 1e3])
def test_very_light_and_very_heavy(inertia):
    """H2: each comes to the speed at which drag is its weight."""
    plate = Plate(0.02, inertia, 0.0)
    world = Plates([plate], [(0.0, 0.0, 0.0)], effects=FLIGHT)
    fly(world, 40.0 * plate.time * max(1.0, inertia), plate.time * max(0.2, 0.02 * inertia))
    assert -world.velocities[0, 1] == pytest.approx(plate.broadside, rel=1e-6)
    tilted = Plates([plate], [(0.0, 0.0, 0.3)], effects=FLIGHT)
    fly(tilted, 100.0 * plate.time, 0.1 * plate.time)
    assert np.max(np.abs(tilted.velocities)) < 10.0 * plate.speed


def test_a_disc_is_not_turned_and_no_thickness_is_a_plate():
    """H3: at beta = 1 the torque of u_x u_y is nothing."""
    disc = Plate(0.02, 1.5, 1.0, torque=0.0, torque_2=0.0)
    world = Plates(effects=FLIGHT)
    world.add(disc, (0.0, 0.0), 0.4, (1.0, -2.0))
    fly(world, 1.0)
    assert world.spins[0] == 0.0 and world.angles[0] == 0.4
    thin = Plates([Plate(0.02, 1.1, 0.0)], [(0.0, 0.0, 0.2)], effects=FLIGHT)
    fly(thin, 1.0)
    assert abs(thin.spins[0]) > 0.1


def test_a_gust_in_one_step_takes_along_as_added_mass_says():
    """H4: broadside, (1 + beta)/(I + 1) of the jump at once; then it goes with the wind and never past it."""
    plate = Plate(0.03, 1.1, 0.05)
    upright = math.pi / 2.0
    for effects, at_once in ((FLIGHT | WIND | GUST_INERTIA, 20.0 * 1.05 / 2.1), (FLIGHT | WIND, 0.0)):
        wind = GustyWind(0.0, floor=None)
        world = Plates([plate], [(0.0, 0.0, upright)], effects=effects, wind=wind)
        world.settings = PlateSettings(gravity=0.0)
        world.step(1e-6)
        wind.set_wind(20.0)
        world.step(1e-6)
        assert world.velocities[0, 0] == pytest.approx(at_once, abs=0.02)
        for _ in range(240):
            world.step(1.0 / 240.0)
            assert world.velocities[0, 0] <= 20.0 + 1e-9
        assert world.velocities[0, 0] == pytest.approx(20.0, abs=1.5)


def test_in_a_wind_that_falls_freely_a_plate_falls_with_it():
    """Where the air itself falls with gravity a plate at rest in it stays so: buoyancy and inertia cancel."""
    wind = FunctionField(
        lambda points, time: np.stack([0 * points[:, 0], np.full(len(points), -9.81 * time)], 1)
    )
    world = Plates([LEAF], [(0.0, 0.0, 0.7)], effects=FLIGHT | WIND | GUST_INERTIA, wind=wind)
    fly(world, 1.0)
    assert world.velocities[0] == pytest.approx((0.0, -9.81), abs=1e-6)
    assert world.positions[0] == pytest.approx((0.0, -4.905), abs=1e-6)
    assert world.angles[0] == pytest.approx(0.7, abs=1e-9)


def test_wind_is_relative():
    """In an even wind all goes as in still air, carried along."""
    still = Plates([LEAF], [(0.0, 0.0, 0.3)], effects=FLIGHT)
    windy = Plates(effects=FLIGHT | WIND | GUST_INERTIA, wind=ConstantField((3.0, 0.5)))
    windy.add(LEAF, (0.0, 0.0), 0.3, (3.0, 0.5))
    fly(still, 1.0)
    fly(windy, 1.0)
    moved = windy.rows[:, 0] - still.rows[:, 0]
    # in still air what the method errs by in energy is taken back, in wind it is not
    assert moved[[X, Y, VX, VY]] == pytest.approx((3.0, 0.5, 3.0, 0.5), abs=2e-4)
    assert moved[THETA] == pytest.approx(0.0, abs=2e-3)


@pytest.mark.parametrize("floor", [0.0, None])
def test_gusts_have_the_slopes_they_say_and_no_divergence(floor):
    wind = GustyWind(1.5, 0.4, floor, shelters=[(0.0, 0.8, 1.0, 0.5, 0.1)])
    wind.add(Gust((0.2, 0.7), -0.3, 2.0, (0.8, 0.3), 0.6, (1.5, 2.0), 0.7))
    wind.add(Gust((-0.5, 1.2), 0.2, 1.0, (-0.4, 0.0), 0.4, (0.0, -2.0), -1.0))
    places = np.random.default_rng(1).uniform((-1.5, 0.05), (1.5, 2.0), (60, 2)).T.copy()
    exact, found = np.zeros((ROWS_OF_WIND, 60)), np.zeros((ROWS_OF_WIND, 60))
    wind.feel(places, 0.55, exact)
    slopes_of(wind, places, 0.55, found, 1e-5)
    assert np.max(np.abs(exact - found)) < 2e-8 * np.max(np.abs(exact))
    lean = 0.1 * (1.0 - places[1])
    outside = ~((places[0] > lean) & (places[0] < 0.8 - lean) & (places[1] < 1.0))
    assert 5 < np.count_nonzero(~outside) < 40
    assert np.max(np.abs(exact[2] + exact[5])[outside]) < 1e-12
    if floor is not None:
        ground = wind.sample([(x, 0.0) for x in np.linspace(-2.0, 2.0, 9)], 0.55)
        assert np.max(np.abs(ground[:, 1])) < 1e-14
    wind.forget(1.2)
    assert wind.count == 1


def test_a_hundred_turns_a_unit_are_bounded():
    """H5: the drag law slows a plate that spins absurdly, and nothing else grows."""
    plate = Plate(0.02, 1.1)
    world = Plates(effects=FLIGHT)
    world.add(plate, (0.0, 0.0), 0.0, (0.1, 0.0), 100.0 / plate.time)
    before = world.energy()[0]
    spin = 100.0 / plate.time
    for _ in range(240):
        world.step(1.0 / 240.0)
        assert abs(world.spins[0]) <= spin
        assert world.energy()[0] <= before
        before = world.energy()[0]
    assert abs(world.spins[0]) < 2.0 / plate.time


@pytest.mark.parametrize("method", ["rk4", "midpoint", "explicit-euler"])
@pytest.mark.parametrize("dt", [1 / 240, 1 / 30])
def test_in_still_air_no_leaf_ever_gains_energy(method, dt):
    """H8: bending ones, at a step that is too long as well."""
    world = many(200, effects=FLIGHT, method=method)
    before, most = world.energy(), np.max(world.energy())
    for _ in range(round(4.0 / dt)):
        world.step(dt)
        now = world.energy()
        assert np.max(now - before) <= 1e-9 * most
        before = now
    world.check()


def test_the_law_itself_only_takes():
    """H8 without what is taken back: in a wind of nothing bent, balanced leaves only lose energy."""
    random = np.random.default_rng(3)
    kinds = [
        Plate(0.03, float(i), 0.05, curl=float(q), bend_hz=6.0, balance=float(e), damping=0.0)
        for i, q, e in zip(
            random.uniform(0.4, 2.0, 60),
            random.uniform(-0.9, 0.9, 60),
            random.uniform(-0.4, 0.4, 60),
            strict=True,
        )
    ]
    places = np.stack([np.zeros(60), np.zeros(60), random.uniform(-3.0, 3.0, 60)], axis=1)
    world = Plates(kinds, places, effects=FLIGHT | WIND, wind=ConstantField((0.0, 0.0)))
    before, motion = world.energy(), 1e-9
    for _ in range(1500):
        world.step(1.0 / 1500.0)
        now = world.energy()
        assert np.max(now - before) <= 1e-8 * motion
        before, motion = now, max(motion, float(np.max(world.laws[MASS_Y] * world.rows[VY] ** 2)) * 0.01)


def test_halves_of_a_bent_plate_are_dragged_as_it_turns():
    """Without torques of its own a flat plate that turns on the spot turns on, a bent one comes to a stop."""
    for curl, turns_on in ((0.0, True), (0.8, False)):
        world = Plates(effects=EffectSet([QUADRATIC_DRAG]))
        world.add(Plate(0.03, 1.0, 0.05, curl=curl, torque=0.0, torque_2=0.0), (0.0, 0.0), 0.0, spin=20.0)
        fly(world, 2.0)
        assert bool(world.spins[0] == 20.0) == turns_on
        assert turns_on or 0.0 < world.spins[0] < 12.0


def test_with_its_mass_ahead_of_the_middle_a_plate_glides_that_way():
    for ahead in (0.2, -0.2):
        world = Plates([Plate(0.03, 0.5, 0.05, balance=ahead)], [(0.0, 0.0, 0.0)], effects=FLIGHT)
        fly(world, 6.0)
        fell = -world.rows[Y, 0]
        assert 0.7 < world.rows[X, 0] * math.copysign(1.0, ahead) / fell < 3.0


def test_permuted_leaves_are_the_same_leaves():
    """H7: in flight to the last bit, whatever stands beside them."""
    world = many(1000, effects=FLIGHT | WIND | GUST_INERTIA, wind=GustyWind(2.0, 0.5))
    other = many(0, effects=FLIGHT | WIND | GUST_INERTIA, wind=GustyWind(2.0, 0.5))
    order = np.random.default_rng(5).permutation(1000)
    other.rows, other.laws = world.rows[:, order].copy(), world.laws[:, order].copy()
    other.felt = world.felt[:, order].copy()
    other.restore(other.state())
    other._make_room()
    for _ in range(30):
        world.step(1.0 / 60.0)
        other.step(1.0 / 60.0)
    assert np.array_equal(world.rows[:, order], other.rows)


def test_bend_is_soft_in_a_gust_and_springs_back():
    plate = LEAF._replace(curl=0.0, bend_hz=3.0)
    wind = GustyWind(0.0, floor=None)
    world = Plates([plate], [(0.0, 0.0, 0.0)], effects=FLIGHT | WIND | GUST_INERTIA, wind=wind)
    world.settings = PlateSettings(gravity=0.0)
    world.add(plate._replace(bend_hz=0.0), (1.0, 0.0))
    wind.add(Gust((0.0, 0.0), 0.0, 0.3, size=10.0, blows=(0.0, 6.0)))
    bends = []
    for _ in range(480):
        world.step(1.0 / 240.0)
        bends.append(world.rows[BEND].copy())
    soft, stiff = np.abs(np.array(bends)).T
    assert np.max(stiff) == 0.0
    assert np.max(soft) > 0.05 and np.max(soft[-60:]) < 0.2 * np.max(soft)


@pytest.mark.parametrize("angle", [0.0, 0.3, math.pi / 2.0])
def test_it_lands_flat_tilted_and_on_edge_and_comes_to_rest(angle):
    """H6."""
    world = Plates([LEAF], [(0.0, 0.25, angle)], effects=FLIGHT | GROUND)
    fly(world, 6.0)
    assert np.max(np.abs(world.velocities)) < 1e-3 and abs(world.spins[0]) < 5e-3
    assert 0.0 < world.rows[Y, 0] < 0.035
    where = world.positions
    fly(world, 1.0)
    assert np.max(np.abs(world.positions - where)) < 1e-5


def test_leaves_land_on_leaves_and_stay_a_heap():
    """H6: stacked; none passes through the ground or a wall, the heap is higher than one leaf."""
    walls = [(-0.045, 0.0, -0.045, 1.5), (0.045, 0.0, 0.045, 1.5)]
    kinds = [LEAF._replace(curl=0.1, bend_hz=15.0)] * 12
    places = [(0.005 * (-1) ** k, 0.1 + 0.06 * k, 0.2 * (-1) ** k) for k in range(12)]
    world = Plates(kinds, places, effects=FLIGHT | GROUND | CONTACTS, walls=walls)
    before, worst = world.energy().sum(), 0.0
    for _ in range(240 * 6):
        world.step(1.0 / 240.0)
        now = world.energy().sum()
        worst, before = max(worst, now - before), now
    world.check()
    assert np.all(np.abs(world.rows[X]) < 0.045) and np.all(world.rows[Y] > -5e-4)
    assert np.max(world.rows[Y]) > 0.015
    assert np.median(np.hypot(*world.velocities.T)) < 5e-3
    without = Plates(kinds, places, effects=FLIGHT | GROUND, walls=walls)
    fly(without, 6.0)
    assert np.max(without.rows[Y]) < np.max(world.rows[Y])


def test_friction_holds_a_leaf_in_a_breeze_below_its_limit_and_not_above():
    """Edge on to the wind: drag (A - B) w² against mu (I - beta) g pi a; both sides of it by 10 %."""
    plate = Plate(0.03, 1.1, 0.05)
    limit = plate.speed * math.sqrt(0.5 * math.pi / (plate.drag - plate.drag_turn))
    for share, moves in ((0.9, False), (1.1, True)):
        world = Plates(
            [plate], [(0.0, 0.0015, 0.0)], effects=FLIGHT | GROUND | WIND, wind=GustyWind(share * limit)
        )
        fly(world, 1.0)
        assert bool(abs(world.rows[X, 0]) > 0.05) == moves


def test_far_away_and_mirrored():
    here = Plates([LEAF], [(0.0, 0.0, 0.3)], effects=FLIGHT)
    far = Plates([LEAF], [(1e5, 0.0, 0.3)], effects=FLIGHT)
    mirrored = Plates([LEAF], [(0.0, 0.0, -0.3)], effects=FLIGHT)
    for world in (here, far, mirrored):
        fly(world, 2.0)
    assert far.rows[X, 0] - 1e5 == pytest.approx(here.rows[X, 0], abs=1e-6)
    assert np.array_equal(mirrored.rows[[X, Y, THETA, SPIN, BEND]] * [[-1], [1], [-1], [-1], [1]],
                          here.rows[[X, Y, THETA, SPIN, BEND]])  # fmt: skip


def test_a_state_comes_back():
    """In the air, and in a heap, whose contacts begin with the impulses of the step before."""
    effects = FLIGHT | GROUND | CONTACTS | WIND | GUST_INERTIA
    flying = many(20, effects=effects, wind=GustyWind(1.0))
    heap = Plates([LEAF] * 8, [(0.01 * k, 0.02 + 0.02 * k, 0.1) for k in range(8)], effects=effects)
    for world, before in ((flying, 0.01), (heap, 0.5)):
        fly(world, before, 0.01)
        kept = type(world.state())(*(np.copy(part) for part in world.state()))
        fly(world, 0.3)
        end = world.rows.copy()
        world.remove(3)
        world.restore(kept)
        fly(world, 0.3)
        assert np.array_equal(world.rows, end)
    assert len(heap.warm) > 8


@pytest.mark.parametrize(
    ("field", "value"),
    [("half_chord", 0.0), ("inertia", math.nan), ("inertia", 0.01), ("thickness", -0.1), ("drag", 0.5),
     ("torque", -1.0), ("curl", 2.0), ("bend_hz", math.inf), ("half_chord", 1e300), ("half_chord", 1e-300)],
)  # fmt: skip
def test_nonsense_plates_are_refused_in_one_line(field, value):
    with pytest.raises(ValueError, match=field) as error:
        Plates([Plate()._replace(**{field: value})], [(0.0, 0.0, 0.0)])
    assert "\n" not in str(error.value)


def test_other_nonsense_is_refused():
    world = Plates([Plate()], [(0.0, 0.0, 0.0)])
    for wrong in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(ValueError, match="dt"):
            world.step(wrong)
    with pytest.raises(ValueError, match="places"):
        Plates([Plate()], [(0.0, math.nan, 0.0)])
    with pytest.raises(ValueError, match="velocity"):
        world.add(Plate(), (0.0, 0.0), 0.0, (math.inf, 0.0))
    with pytest.raises(ValueError, match="method"):
        Plates(method="leapfrog")
    with pytest.raises(ValueError, match="walls"):
        Plates(walls=[(0.0, 1.0, 2.0)])
    with pytest.raises(ValueError, match="gravity"):
        Plates(settings=PlateSettings(gravity=math.nan))
    for name, value in (("size", 0.0), ("lasts", math.nan), ("blows", (1e9, 0.0))):
        with pytest.raises(ValueError, match=f"gust.{name}"):
            GustyWind().add(Gust((0.0, 0.0), 0.0, 1.0)._replace(**{name: value}))


def test_what_is_not_finite_is_found_at_the_end_of_the_step():
    world = Plates([Plate()], [(0.0, 0.0, 0.0)])
    world.rows[SPIN, 0] = math.nan
    world.step(0.01)
    with pytest.raises(FloatingPointError, match="plate 0"):
        world.check()


def test_columns_of_the_law():
    world = Plates([Plate(0.02, 1.1, 0.05)], [(0.0, 0.0, 0.0)])
    assert world.laws[MASS_Y, 0] == pytest.approx(2.1) and world.laws[WEIGHT, 0] == pytest.approx(1.05)


@pytest.mark.parametrize(("effects", "fast"), [(FLIGHT, 0.0), (FLIGHT, 0.5), (EffectSet([GRAVITY]), 2.0)])
def test_leaves_of_all_kinds_fly_as_each_would_alone(effects, fast):
    """To the last bit, with as many substeps as each needs: no lane reads another's numbers."""
    random = np.random.default_rng(8)
    kinds = [
        Plate(float(a), float(i), 0.05, curl=0.2, bend_hz=float(f))
        for a, i, f in zip(
            10.0 ** random.uniform(-2.3, -1.0, 6), 10.0 ** random.uniform(-1.5, 0.8, 6),
            random.uniform(1.0, 40.0, 6), strict=True,
        )
    ]  # fmt: skip
    places = random.uniform(-1.0, 1.0, (6, 3))
    speeds = fast * random.standard_normal((2, 6))

    def flown(chosen):
        world = Plates([kinds[k] for k in chosen], places[chosen], effects=effects)
        world.rows[[VX, VY]] = speeds[:, chosen]
        world.step(1.0 / 60.0)
        return world.rows

    together = flown(np.arange(6))
    for k in range(6):
        assert np.array_equal(together[:, k], flown(np.array([k]))[:, 0]), k


def test_rigid_straight_leaves_fly_the_same_with_and_without_bent_ones_beside_them():
    """To the last bit: a block of lanes leaves out the bend only if none is bent, opens, or can bend."""
    kinds = [Plate(), Plate(curl=0.3), Plate(bend_hz=15.0), Plate(), Plate(inertia=0.4)]
    random = np.random.default_rng(11)
    places = random.uniform(-1.0, 1.0, (len(kinds), 3))

    def flown(chosen):
        world = Plates([kinds[k] for k in chosen], places[chosen], effects=FLIGHT)
        world.rows[VX] = 1.0
        world.rows[BEND_RATE, chosen == 3] = 5.0  # struck: it opens although nothing closes it
        for _ in range(20):
            world.step(1.0 / 240.0)
        return world.rows

    whole = np.arange(40) % len(kinds)  # blocks that are full, and one that is not
    together = flown(whole)
    for k in range(len(kinds)):
        alone = flown(np.full(16, k))
        for column in np.flatnonzero(whole == k):
            assert np.array_equal(together[:, column], alone[:, 0]), k
        assert np.array_equal(alone, np.repeat(alone[:, :1], 16, axis=1))
    assert together[BEND, 3] != 0.0 != together[BEND, 2]
