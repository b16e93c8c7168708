"""What is born of a star: how many, when, where, with what momentum; nobody's fate hangs on the others."""

import math

import numpy as np
import pytest

from game.physics.generations import CALM, EVERYTHING, Birth, Kind, StarSystem
from game.physics.generations import step as steps
from game.physics.generations.kinds import AT_BIRTH, AT_DEATH, AT_HIT

DT = 1.0 / 60.0
WEIGHTLESS = CALM._replace(gravity=0.0)


def grown(kinds, velocity=(0.0, 0.0), seconds=1.0, dt=DT, **options) -> StarSystem:
    system = StarSystem(kinds, **options)
    system.launch(kinds[0].name, (0.0, 100.0), velocity)
    for _ in range(round(seconds / dt)):
        system.step(dt)
        system.check()
    return system


@pytest.mark.parametrize("dt", [1.0 / 60.0, 1.0 / 59.0, 0.3])
def test_a_trail_has_its_spacing_whatever_the_step(dt):
    trail = Birth("trail", "spark", rate_per_s=1997.0, inherited=0.0)
    kinds = [Kind("shell", life_s=99.0, births=(trail,)), Kind("spark", life_s=99.0, capacity=5000)]
    system = StarSystem(kinds, air=WEIGHTLESS)
    system.launch("shell", (0.0, 100.0), (40.0, 0.0))
    for _ in range(round(2.0 / dt)):
        system.step(dt)
    places = np.sort(system.stars("spark")[steps.X])
    assert len(places) == math.floor(1997.0 * round(2.0 / dt) * dt + 1e-6) + 1
    assert np.allclose(np.diff(places), 40.0 / 1997.0, rtol=1e-9, atol=1e-11)


@pytest.mark.parametrize("pattern", ["sphere", "ring", "disc"])
def test_a_burst_keeps_the_momentum(pattern):
    burst = Birth("death", "star", 200, pattern=pattern, speed_m_s=60.0, speed_spread=0.3, scatter_m_s=5.0)
    kinds = [Kind("shell", life_s=0.51, births=(burst,)), Kind("star", life_s=9.0, capacity=200)]
    system = grown(kinds, (11.0, 7.0), 1.0, air=WEIGHTLESS)
    stars = system.stars("star")
    assert stars.shape[1] == 200
    bound = 4 * 200 * 2.0**-52 * 80.0
    assert abs(np.sum(stars[steps.VX] - 11.0)) < bound
    assert abs(np.sum(stars[steps.VY] - 7.0)) < bound
    assert abs(np.sum(stars[steps.VZ])) < bound
    assert np.std(stars[steps.VY]) > 10.0
    if pattern == "sphere":  # as much in each direction: a third of the mean square
        speeds = stars[[steps.VX, steps.VY, steps.VZ]] - np.array([[11.0], [7.0], [0.0]])
        squares = (speeds**2).mean(axis=1)
        assert squares == pytest.approx(squares.mean(), rel=0.25)


def test_a_burst_has_its_own_instant_within_the_step():
    kinds = [
        Kind("shell", life_s=0.505, births=(Birth("death", "star", 2, speed_m_s=30.0),)),
        Kind("star", life_s=9.0, capacity=2),
    ]
    coarse = grown(kinds, (10.0, 0.0), 1.0, dt=0.1, air=WEIGHTLESS).stars("star")
    fine = grown(kinds, (10.0, 0.0), 1.0, dt=0.001, air=WEIGHTLESS).stars("star")
    assert coarse[steps.BORN].tolist() == pytest.approx([0.505, 0.505], abs=1e-12)
    assert np.allclose(coarse[:2], fine[:2], atol=1e-9)


def test_birth_burst_and_fall_of_one_step_stand_in_the_order_of_time():
    kinds = [
        Kind(
            "shell",
            life_s=0.05,
            reports=True,
            births=(Birth("death", "star", 2, pattern="arms", speed_m_s=40.0),),
        ),
        Kind("star", life_s=9.0, reports=True, capacity=2, births=(Birth("hit", "dust", 4),)),
        Kind("dust", life_s=9.0, grounded=False, capacity=9),
    ]
    system = StarSystem(kinds, air=WEIGHTLESS)
    system.launch("shell", (0.0, 1.0), (0.0, 0.0))
    system.step(0.2)
    assert [(int(row[0]), int(row[1])) for row in sorted(system.reports.tolist(), key=lambda row: row[2])][
        -1
    ] == (
        AT_HIT,
        1,
    )
    whats = [(int(row[0]), int(row[1]), row[2]) for row in system.reports.tolist()]
    assert (AT_DEATH, 0, pytest.approx(0.05)) in whats
    assert (AT_BIRTH, 1, pytest.approx(0.05)) in whats
    assert (AT_HIT, 1, pytest.approx(0.05 + 1.0 / 40.0)) in whats
    assert system.stars("dust").shape[1] == 4
    assert system.tally(steps.LANDED) == 1


def test_a_full_pool_is_counted_and_nobody_is_half_born():
    star = Kind("star", life_s=9.0, capacity=2_000, births=(Birth("trail", "spark", rate_per_s=30.0),))
    kinds = [
        Kind("shell", life_s=0.1, capacity=1, births=(Birth("death", "star", 200, speed_m_s=30.0),)),
        star,
        Kind("spark", life_s=9.0, capacity=10_000),
    ]
    system = StarSystem(kinds)
    for number in range(12):
        system.launch("shell", (10.0 * number, 50.0), (0.0, 20.0))
    assert len(system) == 1 and system.tally(steps.DROPPED) == 11  # a place for one shell, as declared
    kinds[0] = Kind("shell", life_s=0.1, capacity=12, births=(Birth("death", "star", 200, speed_m_s=30.0),))
    system = StarSystem(kinds)
    for number in range(12):
        system.launch("shell", (10.0 * number, 50.0), (0.0, 20.0))
    for _ in range(60):
        system.step(DT)
        system.check()
    assert system.stars("star").shape[1] == 2_000
    assert system.tally(steps.DROPPED) > 400


def test_no_fate_hangs_on_the_order_of_the_pool():
    kinds = [
        Kind(
            "shell",
            life_s=0.3,
            life_spread=0.5,
            capacity=40,
            births=(Birth("death", "star", 20, speed_m_s=9.0),),
        ),
        Kind("star", life_s=0.4, life_spread=0.5, drag_per_m=0.02, burns=0.7, capacity=900),
    ]
    systems = [StarSystem(kinds, seed=3), StarSystem(kinds, seed=3)]
    for number in range(40):
        for system in systems:
            system.launch("shell", (number, 50.0), (0.1 * number, 20.0))
    state = systems[1].state()
    order = np.random.default_rng(1).permutation(40)
    state.fields[:, :40] = state.fields[:, order]
    state.identities[:40] = state.identities[order]
    for _ in range(30):
        for system in systems:
            system.step(DT)
    sets = []
    for system in systems:
        stars = system.stars("star")
        sets.append(stars[:, np.argsort(system.identities("star"))].tolist())
    assert sets[0] == sets[1]
    assert len(sets[0][0]) > 100


def test_a_burning_star_dies_once_down_to_the_last_gram():
    kinds = [
        Kind("star", life_s=0.5, drag_per_m=0.5, burns=1.0, births=(Birth("death", "ash"),)),
        Kind("ash", life_s=99.0, capacity=3),
    ]
    system = grown(kinds, (50.0, 0.0), 1.0)
    assert system.stars("ash").shape[1] == 1


def test_births_do_not_drift_in_an_hour():
    trail = Birth("trail", "spark", rate_per_s=30.0, inherited=0.0)
    kinds = [
        Kind("shell", life_s=1e5, births=(trail,), grounded=False),
        Kind("spark", life_s=0.5, grounded=False, capacity=99),
    ]
    system = StarSystem(kinds, air=WEIGHTLESS)
    system.launch("shell", (0.0, 0.0), (0.0, 0.0))
    for _ in range(3600 * 10):
        system.step(0.1)
    assert system.tally(steps.MADE) == 1 + 3600 * 30 + 1


def test_a_step_again_gives_the_same_bits():
    burst = (Birth("death", "star", 20, speed_m_s=9.0),)
    system = grown(
        [Kind("shell", life_s=0.3, births=burst), Kind("star", life_s=3.0, capacity=99)], seconds=0.25
    )
    kept = type(system.state())(*(np.array(array) for array in system.state()))
    ends = []
    for _ in range(2):
        system.restore(kept)
        for _ in range(30):
            system.step(DT)
        ends.append([array.tobytes() for array in (system.stars("star"), system.identities("star"))])
    assert ends[0] == ends[1]


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        (Kind("a", life_s=0.0), "life_s"),
        (Kind("a", life_s=math.nan), "life_s"),
        (Kind("a", capacity=0), "capacity"),
        (Kind("a", drag_per_m=-1.0), "drag_per_m"),
        (Kind("a", exhaust_m_s=5.0), "burns"),
        (Kind("a", births=(Birth("death", "b"),)), "no such kind"),
        (Kind("a", births=(Birth("birth", "a"),)), "no end"),
        (Kind("a", births=(Birth("death", "a", 3),)), "even"),
        (Kind("a", births=(Birth("death", "a", -2),)), "count"),
        (Kind("a", births=(Birth("trail", "a"),)), "rate_per_s"),
        (Kind("a", births=(Birth("death", "a", pattern="shape"),)), "points"),
        (Kind("a", births=(Birth("death", "a", speed_m_s=math.inf),)), "speed_m_s"),
    ],
)
def test_what_makes_no_sense_is_refused_by_name(kind, said):
    with pytest.raises(ValueError, match=said):
        StarSystem([kind])


@pytest.mark.parametrize(
    ("name", "least", "most"),
    [
        ("life_s", 1e-6, 1e6), ("life_spread", 0.0, 0.99), ("weight", -100.0, 100.0),
        ("linear_drag_per_s", 0.0, 1e9), ("drag_per_m", 0.0, 1e9), ("burns", 0.0, 1.0),
        ("exhaust_m_s", 0.0, 1e5), ("capacity", 1, 2**21),
    ],
)  # fmt: skip
def test_numbers_of_a_kind_have_bounds(name, least, most):
    for number in (least - abs(most), 1.001 * most, math.nan):
        with pytest.raises(ValueError, match=name):
            StarSystem([Kind("a", **{name: number})])


@pytest.mark.parametrize(
    ("name", "least", "most"),
    [
        ("count", 1, 4096), ("rate_per_s", 0.0, 1e6), ("speed_m_s", 0.0, 1e5), ("speed_spread", 0.0, 1.0),
        ("inherited", -1.0, 1.0), ("angle_deg", -360.0, 360.0), ("spread_deg", 0.0, 180.0),
        ("scatter_m_s", 0.0, 1e5),
    ],
)  # fmt: skip
def test_numbers_of_a_birth_have_bounds(name, least, most):
    StarSystem([Kind("a", births=(Birth("death", "a", **{name: least}),))])
    for number in (least - abs(most), 1.001 * most, math.nan):
        with pytest.raises(ValueError, match=name):
            StarSystem([Kind("a", births=(Birth("death", "a", **{name: number}),))])


def test_launches_and_steps_that_make_no_sense_are_refused():
    system = StarSystem([Kind("a")])
    for place in ((math.nan, 0.0), (1e300, 0.0)):
        with pytest.raises(ValueError, match="position"):
            system.launch("a", place, (0.0, 0.0))
    with pytest.raises(ValueError, match="kind"):
        system.launch("b", (0.0, 0.0), (0.0, 0.0))
    for dt in (0.0, -1.0, math.inf, math.nan):
        with pytest.raises(ValueError, match="dt"):
            system.step(dt)
    with pytest.raises(ValueError, match="method"):
        StarSystem([Kind("a")], method="euler")
    with pytest.raises(ValueError):
        StarSystem([Kind("a")], air=CALM._replace(wind=math.nan), effects=EVERYTHING)


def test_a_ring_is_tilted_and_flattened():
    ring = Birth("death", "star", 40, pattern="ring", speed_m_s=10.0, spread_deg=60.0, angle_deg=90.0)
    kinds = [Kind("shell", life_s=0.5, births=(ring,)), Kind("star", life_s=9.0, capacity=40)]
    stars = grown(kinds, seconds=1.0, air=WEIGHTLESS).stars("star")
    assert np.allclose((stars[steps.VX] / 5.0) ** 2 + (stars[steps.VY] / 10.0) ** 2, 1.0)
    assert np.ptp(stars[steps.VY]) > 19.0
    assert np.allclose((stars[[steps.VX, steps.VY, steps.VZ]] ** 2).sum(axis=0), 100.0)  # a true circle


def test_what_falls_ends_on_the_ground_and_children_keep_the_depth():
    kinds = [
        Kind("star", life_s=99.0, reports=True, births=(Birth("hit", "dust"),)),
        Kind("dust", life_s=99.0),
    ]
    kinds[1] = Kind("dust", life_s=99.0, weight=0.0, grounded=False)
    system = StarSystem(kinds, ground=-3.0)
    system.launch("star", (0.0, 1.7), (3.0, 0.0), depth=2.5)
    while not len(system.stars("dust")[0]):
        system.step(0.07)
    fall = system.reports[-1]
    assert fall[4] == -3.0
    assert fall[2] == pytest.approx(math.sqrt(2.0 * 4.7 / CALM.gravity), rel=1e-9)
    assert fall[5] == system.stars("dust")[steps.Z, 0] == 2.5
    assert system.stars("dust")[steps.VX, 0] == 3.0


@pytest.mark.parametrize("height", [0.37, 1.03, 2.9, 7.77, 11.3])
def test_what_lands_is_on_the_ground_to_the_last_bit(height):
    kinds = [
        Kind("star", life_s=99.0, reports=True, births=(Birth("hit", "dust"),)),
        Kind("dust", life_s=99.0, weight=0.0, grounded=False),
    ]
    system = StarSystem(kinds, ground=-3.1)
    system.launch("star", (0.0, -3.1 + height), (3.0, 0.4))
    while not len(system.stars("dust")[0]):
        system.step(0.07)
    assert system.reports[-1][4] == -3.1


def test_an_updraught_carries_smoke_upwards():
    smoke = Kind("smoke", life_s=99.0, linear_drag_per_s=1e6, grounded=False)
    for method in ("split-drag", "rk4"):
        system = StarSystem([smoke], air=WEIGHTLESS._replace(updraught=2.0), method=method)
        system.launch("smoke", (0.0, 5.0), (0.0, 2.0))
        system.step(1e-7)
        assert system.stars("smoke")[steps.VY, 0] == pytest.approx(2.0)
