"""Rods, blocks, cubes, bricks, arches and ropes at their limits, by formulas and linear programmes."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import linprog, minimize_scalar

from game.physics.solids import Disc, Material, Polygon, SolidSettings, SolidWorld, box
from game.physics.solids.effects import GRAVITY, JOINTS, SLEEP, USUAL
from tests.physics.solids.setups import G, floor_world, run

AWAKE = USUAL.without(SLEEP)
ROUGH = Material(friction=10.0)


def leaning(world, width, height, tilt, material):
    """A block that stands on its lower right corner at x = 0, tilted by so much (rad) to the right."""
    s, c = math.sin(tilt), math.cos(tilt)
    place = 0.5 * (height * s - width * c), 0.5 * (height * c + width * s)
    return world.add_body(box(width, height, material=material), place, -tilt)


def test_the_tip_of_a_rod_arrives_with_its_speed():
    """L w, with w² = 3 g (cos theta0 - cos theta)/L, from 5 degrees to flat; at 70.5 degrees the foot weighs
    nothing, and no friction is enough.
    """
    length, tilt, t, held = 1.0, math.radians(5.0), 0.004, Material(friction=1e6)
    world, _ = floor_world(held, substeps=24, effects=AWAKE)
    rod = leaning(world, t, length, tilt, held)
    fastest = 0.0
    for _ in range(1000):
        world.step(1.0 / 960.0)
        fastest = max(fastest, -float(world.bodies.spins[rod]))
    assert fastest * length == pytest.approx(math.sqrt(3.0 * G * length * math.cos(tilt)), rel=0.01)


@pytest.mark.parametrize(("b", "h", "degrees"), [(0.25, 1.0, 5.0), (0.5, 1.0, 10.0)])
def test_a_rocking_block_keeps_its_share_of_spin(b, h, degrees):
    """1 - 3/2 sin² alpha, tan alpha = b/h (Housner 1963), and swings up to where that spin takes it."""
    alpha, p2 = math.atan(b / h), 3.0 * G / (4.0 * 0.5 * math.hypot(b, h))
    ratio, tilt = 1.0 - 1.5 * math.sin(alpha) ** 2, math.radians(degrees)
    world, _ = floor_world(ROUGH, substeps=4, effects=AWAKE)
    block = leaning(world, b, h, tilt, ROUGH)
    dt, spins = 1.0 / 1920.0, []
    for _ in range(int(0.6 / dt)):
        world.step(dt)
        spins.append(float(world.bodies.spins[block]))
    hit = int(np.argmax(spins))
    later = 8  # steps after the impact; gravity has slowed it since
    after = spins[hit + later] + p2 * math.sin(alpha) * later * dt
    exact = math.sqrt(2.0 * p2 * (math.cos(alpha - tilt) - math.cos(alpha)))
    assert spins[hit] == pytest.approx(exact, rel=0.01)
    assert (hit + 1) * dt == pytest.approx(time_to_impact(alpha, tilt, p2), rel=0.01)
    assert after / spins[hit] == pytest.approx(ratio, rel=0.01)


def time_to_impact(alpha, tilt, p2):
    """theta'' = -p² sin(alpha - theta), from rest to theta = 0: by small steps of the midpoint rule."""
    theta, speed, t, h = tilt, 0.0, 0.0, 1e-5
    while theta > 0.0:
        half = theta + 0.5 * h * speed
        speed -= h * p2 * math.sin(alpha - half)
        theta += h * speed
        t += h
    return t


@pytest.mark.parametrize(("part", "topples"), [(0.98, False), (1.02, True)])
def test_a_cube_caught_at_a_kerb_topples_from_its_speed(part, topples):
    """v² = 8/3 (sqrt 2 - 1) g a: momentum about the edge, then energy up to standing on it."""
    a, smooth = 1.0, Material(friction=0.0)
    world, _ = floor_world(smooth, substeps=32, effects=AWAKE)
    world.add_body(box(1.0, 0.004, material=smooth), (2.0, 0.002), kind="fixed")
    speed = part * math.sqrt(8.0 / 3.0 * (math.sqrt(2.0) - 1.0) * G * a)
    body = world.add_body(box(a, a, material=Material(friction=0.0)), (0.9, 0.5), velocity=(speed, 0.0))
    run(world, 3.0, 1.0 / 240.0)
    assert (abs(world.bodies.angles[body]) > 1.0) == topples


def least_foot_friction():
    """Largest of f/N = 3 s (3c - 2)/(3c - 1)² while a rod falls from upright about its foot."""
    demand = minimize_scalar(
        lambda t: -3.0 * math.sin(t) * (3.0 * math.cos(t) - 2.0) / (3.0 * math.cos(t) - 1.0) ** 2,
        bounds=(0.1, 0.8), method="bounded",
    )  # fmt: skip
    assert math.degrees(demand.x) == pytest.approx(35.0968, abs=0.01)
    return -demand.fun


def foot_of_rod(mu):
    """Where the foot of a rod of 1 m is when it has fallen from 2 to 42 degrees, m; it began at 0."""
    material, t = Material(friction=mu), 0.001
    world, _ = floor_world(material, substeps=24, effects=AWAKE)
    rod = leaning(world, t, 1.0, math.radians(2.0), material)
    while -world.bodies.angles[rod] < math.radians(42.0) and world.time < 3.0:
        world.step(1.0 / 960.0)
    angle = float(world.bodies.angles[rod])
    return float(world.bodies.positions[rod, 0]) + 0.5 * (math.sin(angle) + t * math.cos(angle))


def foot_by_theory(mu, h=2e-5):
    """The same, of a thin rod with Coulomb's friction, by small steps of its equations of motion."""
    theta, spin, x, v, sliding = math.radians(2.0), 0.0, 0.0, 0.0, False
    half, inertia = 0.5, 1.0 / 12.0
    while theta < math.radians(42.0):
        s, c = math.sin(theta), math.cos(theta)
        turning = half * s * G / (inertia + half * half)
        normal = G - half * s * turning - half * c * spin**2
        rub = half * c * turning - half * s * spin**2
        if sliding or abs(rub) > mu * normal:
            sliding = True
            lever = s - mu * c  # of the force about the centre, in halves of the rod; it slips backwards
            normal = (G - half * c * spin**2) / (1.0 + half * half * s * lever / inertia)
            turning = normal * half * lever / inertia
            v += h * (mu * normal - half * c * turning + half * s * spin**2)
            x += h * v
            sliding = v < 0.0
        v = v if sliding else 0.0
        spin += h * turning
        theta += h * spin
    return x


def test_the_foot_of_a_falling_rod_slips_below_a_friction_of_0_37():
    limit = least_foot_friction()
    slips, holds = foot_of_rod(0.98 * limit), foot_of_rod(1.02 * limit)
    assert slips < 0.0 < holds < 1e-4  # what holds creeps forwards
    assert foot_by_theory(1.02 * limit) == 0.0
    assert slips - holds == pytest.approx(foot_by_theory(0.98 * limit), rel=0.1)


def arch_limit(count):
    """Least thickness over mean radius of a semicircular arch of straight voussoirs, friction large:
    bisected; a thrust line exists where pushes at the ends of joints balance the weights (Heyman 1966).
    """
    low, high = 0.05, 0.2
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if arch_stands(count, middle, 10.0) else (middle, high)
    return high


def arch_stands(count, thickness, mu):
    """Whether pushes at both ends of each joint, and friction, balance all voussoirs (radius 1)."""
    turns = np.linspace(0.0, math.pi, count + 1)
    rays = np.stack([np.cos(turns), np.sin(turns)], axis=1)
    across = np.stack([-np.sin(turns), np.cos(turns)], axis=1)  # from the stone before to the one after
    rows = np.zeros((3 * count, 4 * (count + 1)))  # of each joint: two pushes, two rubs
    load = np.zeros(3 * count)
    for k in range(count):
        ends = [(1.0 + s * 0.5 * thickness) * rays[j] for j in (k, k + 1) for s in (-1.0, 1.0)]
        corners = np.array([ends[0], ends[1], ends[3], ends[2]])
        area, centre = area_of(corners)
        for j, sign in ((k, 1.0), (k + 1, -1.0)):
            for end, s in enumerate((-1.0, 1.0)):
                arm = (1.0 + s * 0.5 * thickness) * rays[j] - centre
                for column, way in ((4 * j + end, across[j]), (4 * j + 2 + end, rays[j])):
                    rows[3 * k : 3 * k + 2, column] = sign * way
                    rows[3 * k + 2, column] = sign * (arm[0] * way[1] - arm[1] * way[0])
        load[3 * k + 1] = area
    pushes = [(0.0, None), (0.0, None), (None, None), (None, None)] * (count + 1)
    cone = np.zeros((4 * (count + 1), 4 * (count + 1)))
    for j in range(count + 1):
        for end in range(2):
            for k, sign in enumerate((1.0, -1.0)):
                cone[4 * j + 2 * end + k, [4 * j + end, 4 * j + 2 + end]] = -mu, sign
    found = linprog(np.zeros(rows.shape[1]), cone, np.zeros(len(cone)), rows, load, bounds=pushes)
    return found.status == 0


def area_of(corners):
    """Area and centroid of a polygon."""
    after = np.roll(corners, -1, axis=0)
    cross = corners[:, 0] * after[:, 1] - corners[:, 1] * after[:, 0]
    area = 0.5 * cross.sum()
    return area, ((corners + after) * cross[:, None]).sum(axis=0) / (6.0 * area)


def arch_holds(count, thickness, mu, seconds=6.0):
    """Whether such an arch of radius 10 m stands in the world; 31 stones need 64 substeps."""
    world, _ = floor_world(Material(friction=mu), substeps=64 if count > 15 else 32, effects=AWAKE)
    turn, half = math.pi / count, 5.0 * thickness
    for k in range(count):
        rays = [np.array([math.cos(a), math.sin(a)]) for a in (k * turn, (k + 1) * turn)]
        corners = [(10.0 + s * half) * rays[i] for i, s in ((0, -1), (0, 1), (1, 1), (1, -1))]
        stone = world.add_body(Polygon(corners, material=Material(friction=mu)))
        if k == count // 2:
            key, before = stone, float(world.bodies.positions[stone, 1])
    run(world, seconds)
    return world.bodies.positions[key, 1] > before - 0.1


@pytest.mark.parametrize("count", [7, 15, 31])
def test_an_arch_stands_from_the_thickness_that_statics_says(count):
    limit = arch_limit(count)
    assert not arch_holds(count, 0.98 * limit, 0.8)
    assert arch_holds(count, 1.02 * limit, 0.8)


def test_many_voussoirs_come_to_the_arch_of_milankovitch():
    """0.10748 of the radius (1907), for curved voussoirs without end."""
    assert arch_limit(61) == pytest.approx(0.10748, rel=2e-3)


def test_an_arch_needs_its_friction():
    """Fifteen voussoirs, 0.15 thick: 0.3484 by the linear programme."""
    low, high = 0.2, 0.6
    for _ in range(30):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if arch_stands(15, 0.15, middle) else (middle, high)
    assert high == pytest.approx(0.348376, rel=1e-4)
    assert not arch_holds(15, 0.15, 0.97 * high, 10.0)
    assert arch_holds(15, 0.15, 1.03 * high, 10.0)


def ten_bricks_stand(part, substeps):
    """Whether ten bricks, each so much of L / 2 k over the one below, stand for six seconds."""
    world, _ = floor_world(substeps=substeps, effects=AWAKE)
    world.add_body(box(1.0, 0.2), (0.0, 0.1), kind="fixed")
    x, top = 0.0, 0
    for level, k in enumerate(range(10, 0, -1)):
        x += part / (2 * k)
        top = world.add_body(box(1.0, 0.2), (x, 0.3 + 0.2 * level))
    height = float(world.bodies.positions[top, 1])
    run(world, 6.0)
    return bool(world.bodies.positions[top, 1] > height - 0.05)


@pytest.mark.parametrize(("part", "stands"), [(1.0 - 0.0034, True), (1.0 + 0.0034, False)])
def test_ten_bricks_overhang_by_the_harmonic_series(part, stands):
    """To 5 mm of 1.4645 m."""
    assert ten_bricks_stand(part, 256) == stands


def test_softer_contacts_tip_earlier_by_a_quarter_for_four_times_the_substeps():
    """They sink by the square of a substep, and the edge with them: found 0.033, 0.009, 0.002."""
    least = [0.0, 0.0, 0.0]
    for i, substeps in enumerate((16, 64, 256)):
        low, high = 0.96, 1.02
        for _ in range(7):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if ten_bricks_stand(middle, substeps) else (low, middle)
        least[i] = 1.0 - low
    assert 0.15 < least[1] / least[0] < 0.4
    assert 0.1 < least[2] / least[1] < 0.4


@pytest.mark.parametrize(("count", "length"), [(2, 0.5), (10, 0.1)])
def test_a_chain_of_rods_swings_in_its_modes(count, length):
    """Eigenvalues of the small swings of pinned uniform rods; let go in a mode, all rods keep its shape."""
    k = np.arange(count)
    behind = count - 1 - np.maximum.outer(k, k)  # whole rods beyond both
    mass = length**2 * (behind + 0.5 - np.eye(count) * (0.5 - 1.0 / 3.0))
    stiff = np.diag(G * length * (count - k - 0.5))
    values, shapes = np.linalg.eig(np.linalg.solve(mass, stiff))
    order = np.argsort(values)
    for mode in (0, 1):
        rate, shape = math.sqrt(values[order[mode]]), shapes[:, order[mode]]
        angles = 0.02 * shape / np.abs(shape).max()
        world = SolidWorld(SolidSettings(effects=GRAVITY | JOINTS, substeps=16))
        before = world.add_body(Disc(0.1), kind="fixed")
        at, rods = np.zeros(2), []
        for angle in angles:
            way = length * np.array([math.sin(angle), -math.cos(angle)])
            rod = world.add_body(box(length, 1e-3), at + 0.5 * way, angle - 0.5 * math.pi)
            world.add_joint("pin", before, rod, at)
            at, before = at + way, rod
            rods.append(rod)
        quarter = 0.5 * math.pi / rate
        run(world, 4.0 * quarter, 4.0 * quarter / 240)
        found = world.bodies.angles[rods] + 0.5 * math.pi
        assert found == pytest.approx(angles, abs=1e-3), mode  # after a whole period: as at the beginning
        spins = world.bodies.spins[rods]
        assert np.abs(spins).max() < 0.05 * 0.02 * rate


def test_floors_fall_on_floors():
    """Each impact shares the momentum; the floors below weigh nothing until they are hit."""
    count, height = 10, 3.0
    speed = when = 0.0
    for k in range(1, count + 1):
        after = math.sqrt(speed**2 + 2.0 * G * height)
        when += (after - speed) / G
        speed = after * k / (k + 1)
    smooth = Material(friction=0.0)
    world = SolidWorld(SolidSettings(substeps=8, effects=AWAKE))
    t = 0.02
    floors = [
        world.add_body(box(1.0, t, material=smooth), (0.0, -k * height - k * t), gravity_scale=float(k == 0))
        for k in range(count + 1)
    ]
    hit, dt = 0, 1.0 / 480.0
    while hit < count and world.time < 6.0:
        world.step(dt)
        if world.bodies.velocities[floors[hit + 1], 1] < -0.1:
            hit += 1
            world.bodies.gravity_scales[floors[hit]] = 1.0
    assert world.time == pytest.approx(when, rel=0.01)


@pytest.mark.parametrize(("part", "holds"), [(0.97, True), (1.03, False)])
def test_a_rope_over_a_drum_holds_by_the_law_of_capstans(part, holds):
    """exp(mu phi) (Euler 1769): many small links over half a turn, a load at each end."""
    mu, r, links = 0.3, 1.0, 40
    material = Material(friction=mu)
    world, _ = floor_world(material, substeps=24, effects=AWAKE)
    world.add_body(Disc(r - 0.02, material=material), (0.0, 20.0), kind="fixed")
    bead = Disc(0.02, material=Material(density=0.2 / (math.pi * 0.02**2), friction=mu))
    turn, before, loads = math.pi / links, -1, []

    def place(angle):
        return r * math.cos(angle), 20.0 + r * math.sin(angle)

    for k in range(links):
        angle = math.pi - (k + 0.5) * turn
        link = world.add_body(bead, place(angle), gravity_scale=0.0)
        if before < 0:
            loads.append(hang(world, link, place(math.pi), 1.0))
        else:
            world.add_joint("pin", before, link, place(angle + 0.5 * turn))
        before = link
    loads.append(hang(world, before, place(0.0), part * math.exp(mu * math.pi)))
    start = float(world.bodies.positions[loads[1], 1])
    run(world, 3.0)
    moved = start - float(world.bodies.positions[loads[1], 1])
    assert (moved < 0.01) if holds else (moved > 0.2)


def hang(world, link, place, mass):
    """A weight of so many kg, 1 m below a place."""
    weight = world.add_body(Disc(0.1, material=Material(mass / (math.pi * 0.01))), (place[0], place[1] - 1.0))
    world.add_joint("rope", link, weight, place, (place[0], place[1] - 1.0))
    return weight
