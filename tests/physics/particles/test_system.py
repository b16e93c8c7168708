"""The system: specialised kernels against the plain one, state, reports, what is refused."""

from __future__ import annotations

import math

import numba
import numpy as np
import pytest

from game.physics.effects import EffectSet
from game.physics.fields import ATTRACTOR, DRAG, GRAVITY, GROUND, QUADRATIC_DRAG, WHIRL, WIND
from game.physics.particles import (
    CALM,
    METHODS,
    OBSTACLES,
    PARTICLES,
    REPORTS,
    Discs,
    Emitter,
    Forces,
    ParticleSystem,
)
from game.physics.particles.flight import fly_alone
from game.physics.particles.pool import BY_HAND

FIELDS = GRAVITY | DRAG | QUADRATIC_DRAG | WIND | WHIRL | ATTRACTOR
LAW = Forces(9.81, 0.7, 0.05, 2.0, -0.5, 1.0, 1.5, 1.3, 0.4, 0.5, 0.2, 3.0)
EVERYTHING = FIELDS | GROUND | OBSTACLES


def cloud(n, seed=3):
    rng = np.random.default_rng(seed)
    return rng.uniform(-3, 3, (n, 2)), rng.uniform(-5, 5, (n, 2))


def fountain(**changes):
    settings = {
        "emitters": [Emitter(rate=2000.0, spread=0.3)],
        "solids": Discs([(0.1, 2.4), (-1, 1)], [0.45, 0.2]),
        "effects": EVERYTHING | REPORTS,
        "life": 0.8,
        "forces": LAW,
    }
    return ParticleSystem(1500, **{**settings, **changes})


@pytest.mark.parametrize("method", ["midpoint", "stormer-verlet", "exponential"])
def test_the_specialised_kernel_gives_the_very_bits_of_the_plain_one(method):
    """Fields alone: particle by particle by `fly_alone`, which knows method and mask only when it runs."""
    system = ParticleSystem(700, effects=FIELDS, method=method, forces=LAW, life=1e9, substeps=1)
    places, speeds = cloud(700)
    system.add(places, speeds)
    twin = np.hstack([places, speeds])
    for _ in range(3):
        system.step(0.01)
        twin = [
            fly_alone(METHODS.index(method), PARTICLES.mask(FIELDS), LAW, *row, 0.01)
            for row in np.asarray(twin).tolist()
        ]
    assert np.array_equal(system.positions, np.array(twin)[:, :2])
    assert np.array_equal(system.velocities, np.array(twin)[:, 2:])


def test_horizontal_motion_is_kept_where_nothing_acts_on_it():
    system = ParticleSystem(700, effects=GRAVITY | GRAVITY, life=1e9)
    places, speeds = cloud(700)
    system.add(places, speeds)
    system.step(0.5)
    assert np.array_equal(system.velocities[:, 0], speeds[:, 0])
    assert np.allclose(system.velocities[:, 1], speeds[:, 1] - 9.81 / 2, rtol=0, atol=1e-14)


@pytest.mark.compiled
@pytest.mark.parametrize("contact", ["end", "chord", "root"])
def test_nobody_ends_a_step_inside_a_solid(contact):
    """300 particles in a crowd of stones, thrown about by all fields, for two seconds."""
    rng = np.random.default_rng(5)
    stones = Discs(rng.uniform(-3, 3, (12, 2)), rng.uniform(0.1, 0.8, 12), rng.uniform(0, 1, 12))
    system = ParticleSystem(
        300, solids=stones, effects=EVERYTHING, forces=LAW, contact=contact, life=1e9, floor=-3.5
    )
    system.add(*cloud(300))
    for _ in range(240):
        system.step(1 / 120)
        # wedges narrower than the tolerance of eight rounds stay open by microns
        assert system.solids.sample(system.positions)[0].min() > -2e-3
        assert system.positions[:, 1].min() >= -3.5
    system.check()
    assert system.impacts > 1000


def test_the_neighbours_of_a_particle_are_nothing_to_it():
    """The flight of one is the same alone as among many, near the end of a block or not."""
    places, speeds = cloud(1400)
    stones = {"solids": Discs([(0.1, 0.4)], [0.7]), "effects": EVERYTHING, "forces": LAW, "life": 1e9}
    crowd = ParticleSystem(1400, **stones)
    crowd.add(places, speeds)
    for _ in range(60):
        crowd.step(1 / 60)
    for i in (0, 511, 512, 1023, 1399):
        alone = ParticleSystem(3, **stones)
        alone.add(places[i], speeds[i])
        for _ in range(60):
            alone.step(1 / 60)
        assert np.array_equal(alone.positions[0], crowd.positions[i])
        assert np.array_equal(alone.velocities[0], crowd.velocities[i])


def test_state_goes_on_exactly_where_it_was_taken():
    system = fountain(seed=9)
    system.solids.carry(0, (0.3, 0.1))
    for _ in range(70):
        system.step(1 / 60)
    kept = type(system.state())(*(np.array(part) for part in system.state()))
    for _ in range(50):
        system.step(1 / 60)
    other = fountain(seed=9)
    other.restore(kept)
    for _ in range(50):
        other.step(1 / 60)
    for now, then in zip(system.state(), other.state(), strict=True):
        assert np.array_equal(now, then)
    system.check()


def test_time_is_a_whole_number_of_steps():
    system = ParticleSystem(10)
    for _ in range(1000):
        system.step(0.1)
    assert system.time_s == 1000 * 0.1
    system.step(0.25)
    assert system.time_s == 1000 * 0.1 + 0.25


def test_reports_of_impacts_and_deaths():
    """One falls on a stone, one dies in mid-air at its instant."""
    system = ParticleSystem(
        10, solids=Discs([(0, -1)], [1.0]), effects=GRAVITY | OBSTACLES | REPORTS, life=0.25, contact="root"
    )
    system.add([(0, 0.1), (5, 0)], [(0, 0), (1, 2)])
    impacts, deaths = [], []
    while system.time_s < 0.4:
        system.step(0.02)
        for line in system.reports.tolist():
            (deaths if line[0] == 0.0 else impacts).append(line)
    assert len(impacts) == 1
    assert impacts[0][1] == BY_HAND * 2**40
    assert abs(impacts[0][7] - 1.5 * math.sqrt(2 * 9.81 * 0.1)) < 1e-12
    assert [line[2] for line in deaths] == pytest.approx([0.25, 0.25], abs=1e-15)
    assert np.allclose(deaths[1][3:7], (5.25, 0.5 - 4.905 / 16, 1, 2 - 9.81 / 4), rtol=0, atol=1e-13)


def test_reports_that_find_no_line_are_counted():
    system = ParticleSystem(
        100, emitters=[Emitter(rate=100.0)], effects=GRAVITY | REPORTS, life=0.01, report_lines=3
    )
    system.step(0.5)
    assert len(system.reports) == 3
    assert system.unreported == 46
    assert system.died == 49


def test_stones_get_the_momentum_that_particles_lose():
    system = ParticleSystem(200, solids=Discs([(0, 0)], [1.0], 0.7), effects=EffectSet([OBSTACLES]), life=1e9)
    places, speeds = cloud(200)
    system.add(places * 2 / np.linalg.norm(places, axis=1)[:, None], speeds)
    before = system.velocities.sum(axis=0)
    given = np.zeros(2)
    for _ in range(60):
        system.step(1 / 60)
        given += system.solids.impulses[0]
    after = system.velocities.sum(axis=0)
    assert np.allclose(before - after, given, rtol=0, atol=1e-10)
    assert np.linalg.norm(given) > 10


def test_drag_that_is_too_stiff_for_the_step_gets_substeps():
    for method, count in (("explicit-euler", 14), ("rk4", 14), ("stormer-verlet", 14), ("exponential", 1)):
        system = ParticleSystem(10, effects=GRAVITY | DRAG, method=method, forces=CALM._replace(drag=200.0))
        assert system.substeps_for(1 / 60) == count
        system.effects = GRAVITY | GRAVITY
        assert system.substeps_for(1 / 60) == 1


@pytest.mark.parametrize("form", ["list", "float32", "strided", "read-only", "integers"])
def test_any_form_of_numbers_will_do(form):
    places, speeds = np.round(np.array(cloud(6))).astype(np.float64) + 0.0
    given = {
        "list": places.tolist(),
        "float32": places.astype(np.float32),
        "strided": np.repeat(places, 2, axis=0)[::2],
        "read-only": places.copy(),
        "integers": places.astype(int),
    }[form]
    if form == "read-only":
        given.flags.writeable = False
    systems = []
    for values in (places, given):
        system = ParticleSystem(6, effects=GRAVITY | OBSTACLES, solids=Discs([(0, -2)], [1]))
        system.add(values, speeds)
        for _ in range(20):
            system.step(0.05)
        systems.append(system)
    assert np.array_equal(systems[0].positions, systems[1].positions)


@pytest.mark.parametrize(
    ("changes", "word"),
    [
        ({"capacity": 0}, "capacity"),
        ({"capacity": 2.5}, "capacity"),
        ({"capacity": 10**9}, "capacity"),
        ({"method": "euler"}, "method"),
        ({"contact": "none"}, "contact"),
        ({"life": 0.0}, "life"),
        ({"life": math.nan}, "life"),
        ({"life": math.inf}, "life"),
        ({"floor": math.nan}, "floor"),
        ({"floor_restitution": 1.5}, "floor_restitution"),
        ({"forces": CALM._replace(gravity=math.inf)}, "gravity"),
        ({"forces": CALM._replace(drag=-1.0)}, "drag"),
        ({"forces": CALM._replace(pull=-1.0)}, "pull"),
        ({"forces": CALM._replace(whirl_core=0.0)}, "whirl_core"),
        ({"seed": -1}, "seed"),
        ({"substeps": 65}, "substeps"),
        ({"substeps": -1}, "substeps"),
    ],
)
def test_absurd_settings_are_refused(changes, word):
    with pytest.raises(ValueError, match=word):
        ParticleSystem(**{"capacity": 10, **changes})


@pytest.mark.parametrize(
    ("field", "value"),
    [("position", (math.nan, 0)), ("rate", -1.0), ("rate", math.inf), ("rate", 1e9), ("speed", math.nan),
     ("spread", 4.0), ("axis", math.inf), ("speed_range", 2.0), ("width", -1.0)],
)  # fmt: skip
def test_absurd_emitters_are_refused(field, value):
    with pytest.raises(ValueError, match=field):
        Emitter(**{field: value})


@pytest.mark.parametrize("dt", [0.0, -0.1, math.nan, math.inf])
def test_absurd_steps_are_refused(dt):
    system = fountain()
    with pytest.raises(ValueError, match="dt"):
        system.step(dt)
    assert system.time_s == 0.0


def test_absurd_particles_are_refused():
    system = ParticleSystem(10)
    for places, speeds, word in (
        ([(0, math.nan)], [(0, 0)], "positions"),
        ([(0, 0)], [(math.inf, 0)], "velocities"),
        ([(0, 1e300)], [(0, 0)], "positions"),
        ([(0, 0), (1, 1)], [(0, 0)], "velocities"),
    ):
        with pytest.raises(ValueError, match=word):
            system.add(places, speeds)
    assert len(system) == 0


def test_effects_of_other_rooms_are_refused():
    from game.billiards.lecture.state import POCKETS

    with pytest.raises(ValueError, match=POCKETS.name):
        ParticleSystem(10, effects=GRAVITY | POCKETS)


def test_no_instruction_that_rounds_otherwise_elsewhere():
    """Fused multiply-adds would give other bits on another processor."""
    from game.physics.particles.advance import make_advance

    system = fountain()
    system.step(0.01)
    kernel = make_advance(METHODS.index("verlet"), PARTICLES.mask(EVERYTHING))
    if not hasattr(kernel, "inspect_asm"):
        pytest.skip("kernels are not compiled")
    fresh = numba.njit(nogil=True, error_model="numpy")(kernel.py_func)  # code from the disk cannot be read
    fresh.compile(kernel.signatures[0])
    code = "".join(fresh.inspect_asm().values())
    assert "mulpd" in code
    assert "fmadd" not in code


@pytest.mark.parametrize("index", [-1, 1])
def test_an_emitter_that_is_not_there_cannot_be_moved(index):
    system = ParticleSystem(10, emitters=[Emitter()])
    with pytest.raises(ValueError, match="emitter"):
        system.place_emitter(index, (0.0, 0.0))
    with pytest.raises(ValueError, match="emitter"):
        system.change_emitter(index, Emitter(rate=5.0))


@pytest.mark.parametrize("lines", [-1, 2.5, True])
def test_room_for_reports_is_a_whole_number(lines):
    with pytest.raises(ValueError, match="report_lines"):
        ParticleSystem(10, report_lines=lines)
