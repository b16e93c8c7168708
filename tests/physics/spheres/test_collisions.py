"""Worlds of colliding spheres over many steps: rest, overlap, fast spheres, candidates, memory."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.broadphase import HierarchicalGrid, SweepAndPrune, UniformGrid
from game.physics.effects import EffectSet
from game.physics.fields import DRAG, GRAVITY
from game.physics.rigid import PUSHES, ROTATION, WINDOW
from game.physics.spheres import ledger
from game.physics.spheres.collisions import CollidingSpheres
from game.physics.spheres.effects import COLLISIONS, FRICTION, IMPACT_TIMES, LEDGES, STRINGS, USUAL
from game.physics.spheres.planar_impulses import FLAT_COLUMNS, VX, VY, WEIGHT
from game.physics.spheres.planar_steps import lost_momentum
from game.physics.spheres.settings import CORRECTIONS, SCHEMES, surroundings_of
from game.physics.spheres.smooth_spheres import SmoothSpheres
from game.physics.spheres.spheres import SphereBodies
from tests.physics.spheres.colliding import BARE, RUBBING, heap_of, row_of, sums, two, world_of

G = 9.81


def state_bytes(world):
    return b"".join(np.ascontiguousarray(part).tobytes() for part in world.state())


# -- motion without contact -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("scheme", "part"), [("explicit-euler", 0.0), ("semi-implicit", 1.0), ("exact-flight", 0.5)]
)
def test_schemes_of_free_fall(scheme, part):
    """Euler's schemes are off by h v / 2 to either side; the parabola is exact."""
    world = world_of(SphereBodies([(0, 0)], [0.5], [(1, 2)]), effects=EffectSet([GRAVITY]), scheme=scheme)
    n, h = 60, 1 / 60
    for _ in range(n):
        world.step(h)
    exact = 2.0 - G * h * h * (n * (n - 1) / 2 + part * n)
    assert world.bodies.state.positions[0] == pytest.approx((1.0, exact, 0.0), abs=1e-12)
    assert world.bodies.velocities[0] == pytest.approx((1.0, 2.0 - G, 0.0), abs=1e-12)
    assert world.time == pytest.approx(1.0)


def test_orientation_by_euler_and_by_the_exponential_map():
    """Per step Euler turns by 2 atan(w h / 2): 9.97694782661295 rad in place of 10."""
    for scheme, angle in (("explicit-euler", 9.97694782661295), ("exact-flight", 10.0)):
        bodies = SphereBodies([(0, 0)], [0.5], None, [(0, 0, 10.0)])
        world = world_of(bodies, effects=EffectSet([ROTATION]), scheme=scheme)
        for _ in range(60):
            world.step(1 / 60)
        w, _, _, z = bodies.state.orientations[0]
        assert 2.0 * math.atan2(z, w) == pytest.approx(angle - 4.0 * math.pi, abs=1e-12)


def test_a_force_at_a_point_moves_and_turns():
    """C13.6: F h of momentum, r x F h of angular momentum; only during one step."""
    world = world_of(SphereBodies([(1, 1)], [0.5]), effects=BARE | PUSHES)
    world.apply_force(0, (3.0, 4.0, 0.0), (1.0, 1.5, 0.0))
    world.step(0.1)
    assert world.bodies.velocities[0] == pytest.approx((0.3, 0.4, 0.0))
    assert world.bodies.turning[0] == pytest.approx((0.0, 0.0, -0.15))
    world.step(0.1)
    assert world.bodies.velocities[0] == pytest.approx((0.3, 0.4, 0.0))
    with pytest.raises(ValueError, match="body 1"):
        world.apply_force(1, (0, 0, 0), (0, 0, 0))
    with pytest.raises(ValueError, match="force, point"):
        world.apply_force(0, (math.nan, 0, 0), (0, 0, 0))


def test_drag_never_reverses_a_motion():
    world = world_of(SphereBodies([(0, 0)], [0.5], [(1, 0)]), effects=BARE | DRAG, drag=1e6)
    world.step(0.1)
    assert 0.0 < world.bodies.velocities[0, 0] < 1e-4


def test_the_window_mirrors():
    """C13.8: with restitution 1 the velocity is mirrored at each of four sides, and nothing leaves."""
    bodies = SphereBodies([(0.6, 0.7)], [0.5], [(3.0, 2.2)])
    world = world_of(bodies, window=(0, 0, 4, 3), effects=BARE | WINDOW)
    for _ in range(600):
        world.step(1 / 60)
        assert np.abs(bodies.velocities[0]).tolist() == pytest.approx([3.0, 2.2, 0.0], abs=1e-13)
        x, y, _ = bodies.state.positions[0]
        assert 0.5 - 0.06 <= x <= 3.5 + 0.06 and 0.5 - 0.06 <= y <= 2.5 + 0.06
    assert world.collisions >= 10


# -- overlap and rest -----------------------------------------------------------------------------------


@pytest.mark.parametrize("correction", ["split", "projection"])
def test_deep_overlap_gains_no_energy(correction):
    bodies = SphereBodies([(0, 0), (0.1, 0), (0.0, 0.1), (0.05, 0.05)], [0.5] * 4)
    world = world_of(bodies, correction=correction, passes=3)
    for _ in range(60):
        world.step(1 / 60)
        assert sums(world)[2] == 0.0
    assert world.overlap() <= 0.0051 + 1e-9


def test_pushes_that_are_speeds_do_gain_energy():
    """Baumgarte's way, to compare with; none leaves it as it is."""
    for correction, gains in (("baumgarte", True), ("none", False)):
        world = world_of(SphereBodies([(0, 0), (0.1, 0)], [0.5] * 2), correction=correction)
        for _ in range(60):
            world.step(1 / 60)
        assert (sums(world)[2] > 0.1) == gains
        assert (world.overlap() < 0.1) == gains


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("e", [0.0, 0.5, 0.9])
def test_a_stack_rests(scheme, e):
    """Five spheres on the ground for 60 s: no growth of energy, overlap up to the slop, no creep."""
    bodies = SphereBodies([(0, 0.5 + i) for i in range(5)], [0.5] * 5, inertias="solid")
    world = world_of(bodies, restitution=e, friction=0.5, window=(-2, 0, 2, 20), effects=USUAL, scheme=scheme)
    for _ in range(60):
        world.step(1 / 60)
    height = world.totals().potential
    for _ in range(59 * 60):
        world.step(1 / 60)
    totals = world.totals()
    assert totals.translational + totals.rotational < 1e-12
    assert abs(totals.potential - height) < 5 * G * 0.005
    assert world.overlap() <= 0.005 * (1 + 1e-6) + 1e-9
    assert np.abs(bodies.state.positions[:, 0]).max() < 1e-12


def test_a_bounce_ends_and_begins_with_the_right_height():
    """e = 0.8 from 1 m: up to e² of it (with impact times), and at rest within 10 s."""
    bodies = SphereBodies([(0, 1.5)], [0.5])
    world = world_of(
        bodies, restitution=0.8, window=(-2, 0, 2, 20), effects=USUAL | IMPACT_TIMES, scheme="exact-flight"
    )
    heights = []
    for _ in range(600):
        world.step(1 / 60)
        heights.append(bodies.state.positions[0, 1] - 0.5)
    first = math.sqrt(2.0 / G)
    up = heights[math.ceil(first * 60) : math.ceil((first + 2 * 0.8 * first) * 60)]
    assert max(up) == pytest.approx(0.64, abs=0.003)
    assert abs(heights[-1]) <= 0.005 and not bodies.velocities.any()


@pytest.mark.compiled
def test_a_heap_comes_to_rest_without_sinking_in():
    """150 discs: the plane's kernels, warm start, friction; deepest overlap and speed at the end."""
    bodies, window = heap_of(150, 15)
    world = world_of(
        bodies, restitution=0.0, friction=0.5, window=window, effects=USUAL, path="planar",
        broad_phase=UniformGrid((0, 0), (15, 15), 1.0), correction="projection",
    )  # fmt: skip
    for _ in range(420):
        world.step(1 / 60)
    assert world.planar()
    assert world.overlap() < 0.012
    assert world.totals().translational < 1e-3
    world.check()


@pytest.mark.parametrize("correction", CORRECTIONS)
def test_the_planes_kernels_do_as_those_of_space(correction):
    """A heap that is thrown down: the same to rounding."""
    worlds = []
    for path in ("general", "planar"):
        bodies, window = heap_of(30, 6)
        bodies.set_velocities(np.tile((1.0, -2.0, 0.0), (30, 1)), np.tile((0.0, 0.0, 1.0), (30, 1)))
        worlds.append(
            world_of(bodies, restitution=0.3, friction=0.4, window=window, effects=USUAL | DRAG, path=path,
                     drag=0.1, correction=correction)
        )  # fmt: skip
    for _ in range(8):
        for world in worlds:
            world.step(1 / 60)
    general, planar = worlds
    assert not general.planar() and planar.planar()
    assert general.collisions > 0
    for a, b in zip(general.bodies.state, planar.bodies.state, strict=True):
        assert np.allclose(a, b, rtol=0, atol=1e-10)


def test_momentum_is_weighed_in_the_plane_as_well():
    """What the collisions of a part have lost together: walls and fixed bodies take what they are given."""
    bodies, window = heap_of(30, 6)
    bodies.set_velocities(np.tile((1.0, -2.0, 0.0), (30, 1)), np.tile((0.0, 0.0, 1.0), (30, 1)))
    world = world_of(bodies, restitution=0.8, friction=0.4, window=window, effects=USUAL, path="planar")
    for _ in range(60):
        world.step(1 / 60)
    assert world.planar() and world.collisions > 30
    entries = world.ledger()
    assert (entries[:, ledger.OTHER] < 0).any(), "walls were met"
    size = np.abs(world.bodies.state.momenta).sum() + np.abs(entries[:, ledger.JX : ledger.JZ + 1]).sum()
    assert entries[:, ledger.LOST_MOMENTUM].max() <= 1e-13 * size


def test_momentum_that_goes_amiss_is_found_in_the_plane():
    """The measure itself: 3 and 4 kg m/s that nobody took are 5 that are lost."""
    bodies = SphereBodies([(0, 0), (2, 0)], [0.5, 0.5], [(1, 0), (0, 0)], masses=[2.0, math.inf])
    flat = np.zeros((3, FLAT_COLUMNS))
    flat[0, VX], flat[0, WEIGHT] = 1.0, 0.5
    lost = getattr(lost_momentum, "py_func", lost_momentum)  # an inner kernel
    assert lost(bodies.state, flat, 0.0, 0.0) == 0.0
    flat[0, VX], flat[0, VY] = 2.5, 2.0
    assert lost(bodies.state, flat, 0.0, 0.0) == pytest.approx(5.0)
    assert lost(bodies.state, flat, -3.0, -4.0) == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize("path", ["general", "planar"])
@pytest.mark.parametrize("first", [False, True])
def test_what_a_fixed_body_takes_is_not_lost(path, first):
    """It stands first or second in the pair; nothing is lost, as at a wall."""
    places, speeds, masses = [(0, 0), (1.01, 0)], [(2, 0), (0, 0)], [1.0, math.inf]
    if first:
        places, speeds, masses = [(0, 0), (1.01, 0)], [(0, 0), (-2, 0)], masses[::-1]
    bodies = SphereBodies(places, [0.5, 0.5], speeds, masses=masses)
    world = world_of(bodies, effects=BARE, path=path)
    world.step(0.02)
    world.step(0.02)
    entry = world.ledger()[0]
    assert abs(entry[ledger.JX]) == pytest.approx(4.0)
    assert entry[ledger.LOST_MOMENTUM] < 1e-14 and entry[ledger.LOST_SPIN] < 1e-14


@pytest.mark.parametrize("part", [0.25, 0.8])
def test_explicit_euler_collides_before_the_gravity_of_its_part(part):
    """A sphere that meets the floor in the midst of a step: 2 g h slower than it should be, h until then."""
    h, g, speed = 0.1, 9.81, 3.0
    bodies = SphereBodies([(0.0, 0.5 + part * h * speed)], [0.5], [(0.0, -speed)])
    world = world_of(
        bodies, scheme="explicit-euler", effects=BARE | GRAVITY | WINDOW | IMPACT_TIMES, gravity=g,
        window=(-2, 0, 2, 3),
    )  # fmt: skip
    world.step(h)
    exact = speed + g * part * h - g * (1.0 - part) * h
    assert world.collisions == 1
    assert world.bodies.velocities[0, 1] - exact == pytest.approx(-2.0 * g * part * h, abs=1e-6)


# -- fast spheres ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("scheme", SCHEMES)
def test_fast_and_small(scheme):
    """300 m/s against 1 cm: through in steps, hit with impact times, as without any step."""
    places, speeds, radii = [(-2.0, 0.004), (0.0, 0.0)], [(300.0, 0.0), (0.0, 0.0)], [0.01, 0.02]
    exact = SmoothSpheres(places, speeds, radii)
    exact.fly(0.1)
    for effects, hits in ((BARE, 0), (BARE | IMPACT_TIMES, 1)):
        bodies = SphereBodies(places, radii, speeds)
        world = world_of(bodies, effects=effects, scheme=scheme)
        for _ in range(6):
            world.step(1 / 60)
        assert world.collisions == hits
        if hits:
            assert np.allclose(bodies.state.positions, exact.positions, rtol=0, atol=1e-9)


def test_impact_times_are_exact_until_chaos():
    """Eleven spheres and walls: positions of the event-driven run to rounding, at any step."""
    r, step = 0.24, 0.49
    places = [(-2.0, 0.02)] + [
        (math.sqrt(0.75) * step * i, step * (k - 0.5 * i)) for i in range(4) for k in range(i + 1)
    ]
    speeds = np.zeros((11, 2))
    speeds[0, 0] = 5.0
    window = (-4, -3, 4, 3)
    exact = SmoothSpheres(places, speeds, r, window=window)
    exact.fly(1.0)
    assert exact.impacts > 10
    for scheme in SCHEMES:
        bodies = SphereBodies(places, [r] * 11, speeds)
        world = world_of(bodies, window=window, effects=BARE | WINDOW | IMPACT_TIMES, scheme=scheme)
        for _ in range(60):
            world.step(1 / 60)
        assert np.abs(bodies.state.positions - exact.positions).max() < 1e-11
        assert world.collisions == exact.impacts


def test_impact_times_under_gravity_and_at_ledges():
    exact = SmoothSpheres([(0, 2), (1.3, 3)], [(1, 0), (-0.3, 0)], 0.3, gravity=G, window=(-2, 0, 2, 6))
    exact.fly(2.0)
    bodies = SphereBodies([(0, 2), (1.3, 3)], [0.3] * 2, [(1, 0), (-0.3, 0)])
    effects = BARE | WINDOW | GRAVITY | IMPACT_TIMES
    world = world_of(bodies, window=(-2, 0, 2, 6), effects=effects, scheme="exact-flight")
    for _ in range(120):
        world.step(1 / 60)
    assert np.abs(bodies.state.positions - exact.positions).max() < 1e-10
    for height, hits in ((0.0, 1), (1.0, 1), (1.2, 0)):
        bullet = SphereBodies([(-3, height)], [0.1], [(200, 0)])
        world = world_of(
            bullet, effects=EffectSet([LEDGES]) | IMPACT_TIMES, around={"ledges": [(0, -1, 0, 1)]}
        )
        for _ in range(3):
            world.step(1 / 60)
        assert (bullet.velocities[0, 0] < 0.0) == bool(hits)


def test_energy_of_elastic_spheres_stays_over_many_collisions():
    bodies = SphereBodies(
        [(x + 0.5, y + 0.5) for x in range(5) for y in range(3)], [0.3] * 15,
        [(math.sin(3 * i), math.cos(5 * i)) for i in range(15)],
    )  # fmt: skip
    world = world_of(bodies, window=(0, 0, 5, 3), effects=BARE | WINDOW | IMPACT_TIMES)
    before = sums(world)[2]
    for _ in range(300):
        world.step(1 / 30)
    assert world.collisions > 100
    assert sums(world)[2] == pytest.approx(before, rel=1e-13)


# -- strings --------------------------------------------------------------------------------------------


def cradle(**settings):
    r, length, count, swing = 0.3, 3.0, 5, math.radians(40)
    ties = [(2 * r * i, 0.0, 0.0, length) for i in range(count)]
    places = [(x, -length) for x, *_ in ties]
    places[0] = (-length * math.sin(swing), -length * math.cos(swing))
    around = {"hung": range(count), "strings": ties}
    effects = BARE | GRAVITY | STRINGS
    return world_of(SphereBodies(places, [r] * count), effects=effects, around=around,
                    correction="projection", substeps=16, **settings)  # fmt: skip


@pytest.mark.compiled
def test_newtons_cradle_behaves_like_one():
    """One comes, one leaves, to the same height; the others stay. For four swings."""
    world = cradle()
    start = world.totals()
    highest = np.zeros(5)
    period = 2 * math.pi * math.sqrt(3.0 / G) * (1 + math.radians(40) ** 2 / 16)
    for _ in range(round(2 * period * 120)):
        world.step(1 / 120)
        highest = np.maximum(highest, world.bodies.state.positions[:, 1] + 3.0)
    drop = 3.0 * (1 - math.cos(math.radians(40)))
    assert highest[4] == pytest.approx(drop, rel=1e-3)
    assert highest[0] == pytest.approx(drop, rel=1e-3)
    assert highest[1:4].max() < 1e-5
    assert world.totals().energy == pytest.approx(start.energy, abs=1e-3 * drop * G)


def test_a_pendulum_keeps_its_energy_and_period():
    """Small swing: T = 2 π √(l / g); the string stays as long as it is."""
    length, swing = 1.0, 0.02
    bodies = SphereBodies([(length * math.sin(swing), -length * math.cos(swing))], [0.1])
    around = {"hung": [0], "strings": [(0, 0, 0, length)]}
    world = world_of(bodies, effects=EffectSet([GRAVITY]) | STRINGS, around=around)
    period = 2 * math.pi * math.sqrt(length / G)
    steps = round(10 * period * 480)
    for _ in range(steps):
        world.step(10 * period / steps)
        x, y, _ = bodies.state.positions[0]
        assert math.hypot(x, y) == pytest.approx(length, abs=1e-9)
    assert bodies.state.positions[0, 0] == pytest.approx(length * math.sin(swing), abs=2e-4)


# -- candidates, determinism, memory --------------------------------------------------------------------

BROAD_PHASES = {
    "grid": lambda: UniformGrid((0, 0), (8, 8), 1.0),
    "hierarchical": HierarchicalGrid,
    "sweep and prune": SweepAndPrune,
}


@pytest.mark.parametrize("name", BROAD_PHASES)
def test_any_broad_phase_gives_the_run_of_brute_force(name):
    """The same contacts in the same order, so the same bits."""
    digests = []
    for broad_phase in (None, BROAD_PHASES[name]()):
        bodies, window = heap_of(40, 8)
        world = world_of(
            bodies, restitution=0.4, friction=0.3, window=window, effects=USUAL, broad_phase=broad_phase
        )
        for _ in range(60):
            world.step(1 / 60)
        digests.append(b"".join(part.tobytes() for part in bodies.state))
    assert digests[0] == digests[1]


def test_steps_after_a_restored_state_are_the_same():
    bodies, window = heap_of(40, 8)
    world = world_of(bodies, restitution=0.3, friction=0.4, window=window, effects=USUAL)
    for _ in range(40):
        world.step(1 / 60)
    kept = type(world.state())(*(part.copy() for part in world.state()))
    after = []
    for _ in range(2):
        for _ in range(40):
            world.step(1 / 60)
        after.append(state_bytes(world))
        world.restore(kept)
    assert after[0] == after[1]


def test_what_composed_bodies_exchange_is_in_the_ledger():
    """Two bodies of three spheres each, tilted in space: no principal axis is an axis of the world."""
    part = np.array([(0.0, 0.0, 0.0), (1.1, 0.3, -0.2), (0.2, 0.9, 0.6)])
    places = np.concatenate([part, part[:, [1, 2, 0]] + (2.4, 0.2, 0.1)])
    bodies = SphereBodies(
        places, [0.5] * 6, [(1.0, 0.1, 0.2), (-2.0, 0.0, 0.3)], [(0.3, -1.0, 0.5), (0.2, 0.7, -0.4)],
        owners=[0, 0, 0, 1, 1, 1], inertias="solid",
    )  # fmt: skip
    world = world_of(bodies, restitution=0.6)
    before = world.totals()
    while not world.collisions:
        world.step(1e-3)
    (entry,) = world.ledger()[:1]
    assert entry[ledger.LOST_MOMENTUM] < 1e-12 and entry[ledger.LOST_SPIN] < 1e-12
    assert np.abs(entry[ledger.JX : ledger.JZ + 1]).max() > 0.1
    assert world.totals().momentum == pytest.approx(before.momentum, abs=1e-12)
    assert world.totals().spin == pytest.approx(before.spin, abs=1e-2)  # a step turns what tumbles


def test_the_ledger_keeps_the_last_collisions():
    bodies = SphereBodies([(0, 0), (1.2, 0)], [0.5] * 2, [(9, 0), (-9, 0)])
    world = world_of(bodies, window=(-0.6, -2, 1.9, 2), effects=BARE | WINDOW)
    for _ in range(2_000):
        world.step(1 / 30)
        if world.collisions > 300:
            break
    entries = world.ledger()
    assert len(entries) == len(world.ring)
    assert np.all(np.diff(entries[:, 0]) >= 0.0)
    assert entries[:, 14:].max() < 1e-13


@settings(max_examples=15, deadline=None)
@given(
    places=st.lists(st.tuples(st.floats(-1, 1), st.floats(-1, 1), st.floats(-1, 1)), min_size=1, max_size=7),
    seed=st.integers(0, 1000),
)
def test_momentum_of_any_crowd(places, seed):
    """Spheres that overlap as they like, in space: P conserved, nothing but finite, energy not gained."""
    random = np.random.default_rng(seed)
    n = len(places)
    bodies = SphereBodies(
        places, random.uniform(0.05, 0.5, n), random.normal(0, 3, (n, 3)), random.normal(0, 3, (n, 3)),
        masses=random.uniform(0.1, 10, n), inertias="solid",
    )  # fmt: skip
    world = world_of(bodies, restitution=0.7, friction=0.5, effects=RUBBING | ROTATION)
    before = sums(world)
    for _ in range(20):
        world.step(1 / 60)
    after = sums(world)
    world.check()
    size = np.abs(bodies.state.momenta).sum() + np.abs(before[0]).sum() + 1.0
    assert np.abs(after[0] - before[0]).max() < 1e-12 * size
    assert after[2] <= before[2] * (1 + 1e-12)


# -- the door -------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "make",
    [
        lambda: SphereBodies([], []),
        lambda: SphereBodies([(math.nan, 0)], [1]),
        lambda: SphereBodies([(1e300, 0)], [1]),
        lambda: SphereBodies([(0, 0)], [0]),
        lambda: SphereBodies([(0, 0)], [-1]),
        lambda: SphereBodies([(0, 0)], [1], masses=[0]),
        lambda: SphereBodies([(0, 0)], [1], masses=[math.nan]),
        lambda: SphereBodies([(0, 0)], [1], [(math.inf, 0)]),
        lambda: SphereBodies([(0, 0)], [1], [(1, 0)], masses=[math.inf]),
        lambda: SphereBodies([(0, 0)], [1], orientations=[(0, 0, 0, 0)]),
        lambda: SphereBodies([(0, 0)], [1], inertias=[0.0]),
        lambda: SphereBodies([(0, 0)], [1], inertias="heavy"),
        lambda: SphereBodies([(0, 0)], [1], inertias=[np.diag((1, 1, -1))]),
        lambda: SphereBodies([(0, 0)] * 2, [1] * 2, owners=[0, 2]),
        lambda: SphereBodies([(0, 0)] * 2, [1] * 2, owners=[0, 0], masses=[1, math.inf]),
        lambda: SphereBodies([(0, 0)], [1], kinds=[-1]),
        lambda: CollidingSpheres(SphereBodies([(0, 0)], [1], kinds=[3])),
        lambda: CollidingSpheres(SphereBodies([(0, 0)], [1]), iterations=0),
        lambda: CollidingSpheres(SphereBodies([(0, 0)], [1]), scheme="leapfrog"),
        lambda: CollidingSpheres(SphereBodies([(0, 0)], [1]), gravity=math.nan),
        lambda: CollidingSpheres(SphereBodies([(0, 0)], [1])).step(0.0),
        lambda: CollidingSpheres(SphereBodies([(0, 0)], [1])).step(math.nan),
        lambda: surroundings_of((1, 0, 0, 1)),
        lambda: surroundings_of(ledges=[(0, 0, 0, 0)]),
        lambda: surroundings_of(hung=[0], strings=[(0, 0, 0, 0)]),
        lambda: surroundings_of(hung=[0.5], strings=[(0, 0, 0, 1)]),
        lambda: CollidingSpheres(
            SphereBodies([(0, 0)], [1]), surroundings_of(hung=[1], strings=[(0, 0, 0, 1)])
        ),
    ],
)
def test_nonsense_is_refused(make):
    with pytest.raises(ValueError, match=r"\w"):
        make()


def test_what_is_refused_changes_nothing():
    world = world_of(two((1, 0, 0), [(0, 0, 0)] * 2, 1.0))
    before = world.settings
    with pytest.raises(ValueError, match="passes"):
        world.change(passes=-1)
    assert world.settings == before


def test_forms_of_input():
    """Lists, integers, single precision, arrays that are not contiguous: the same as plain arrays."""
    plain = row_of([1.0, 0.0])
    others = SphereBodies(
        np.asfortranarray(np.array([(0, 0, 0), (1, 0, 0)], dtype=np.float32)), [0.5, 0.5],
        ((1, 0), (-0.0, 0)), masses=1,
    )  # fmt: skip
    for a, b in zip(plain.state, others.state, strict=True):
        assert np.array_equal(a, b)


def test_far_from_the_origin():
    """The same collision a kilometre off, to the rounding of the places."""
    after = []
    for off in (0.0, 1000.0):
        bodies = SphereBodies([(off, off), (off + 1.0, off)], [0.5] * 2, [(1, 0), (0, 0)])
        world = world_of(bodies, restitution=0.5)
        world.step(0.01)
        after.append(bodies.velocities)
    assert np.allclose(after[0], after[1], rtol=0, atol=1e-12)


def test_effects_that_are_off_do_nothing():
    bodies = two((0.9, 0, 0), [(1, 0, 0), (0, 2, 0)], 1.0, [(0, 0, 1), (0, 0, 0)])
    world = world_of(bodies, friction=0.5, effects=EffectSet(()), gravity=9.81)
    world.step(0.1)
    assert bodies.velocities.tolist() == [[1, 0, 0], [0, 2, 0]]
    assert np.array_equal(bodies.state.orientations[:, 0], [1, 1])
    world.change(effects=COLLISIONS | FRICTION)
    world.step(0.1)
    assert world.collisions == 1


def test_a_force_that_waits_is_restored_as_well():
    """Kept between `apply_force` and the step: the step after it is the same."""
    world = world_of(two((2, 0, 0), [(0, 0, 0)] * 2, 1.0), effects=BARE | PUSHES)
    world.apply_force(1, (3.0, 4.0, 0.0), (2.0, 0.5, 0.0))
    kept = type(world.state())(*(part.copy() for part in world.state()))
    world.step(0.1)
    pushed = state_bytes(world)
    assert world.bodies.velocities[1] == pytest.approx((0.3, 0.4, 0.0))
    world.step(0.1)
    world.restore(kept)
    world.step(0.1)
    assert state_bytes(world) == pushed


@pytest.mark.parametrize("path", ["general", "planar"])
@pytest.mark.parametrize(
    ("e", "quotient"), [(0.0, 1.0), (0.5, 0.75), (0.9, 0.19), (0.95, 0.19), (0.999, 0.19), (1.0, 2.0)]
)
def test_the_speed_from_which_a_contact_bounces(path, e, quotient):
    """4 g h / (1 - e²), no more than at e = 0.9; 2 g h at e = 1. A little faster bounces, slower does not."""
    h = 1.0 / 60.0
    limit = 4.0 * G * h / quotient
    for factor in (1.0 - 1e-6, 1.0 + 1e-6):
        bodies = SphereBodies([(0.0, 0.5), (9.0, 5.0)], [0.5] * 2, [(0.0, -factor * limit), (0.0, 0.0)])
        world = world_of(bodies, restitution=e, window=(-2, 0, 20, 20), effects=USUAL, path=path)
        world.step(h)
        assert world.collisions == int(factor > 1.0)
