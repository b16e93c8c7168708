"""How a star flies, against closed forms: drag, wind, burning, thrust, terminal speed; orders of methods."""

import math

import numpy as np
import pytest

from game.physics.effects import EffectSet
from game.physics.generations import CALM, EVERYTHING, METHODS, Kind, StarSystem
from game.physics.generations.step import VX, VY, VZ, X, Y, Z

DT = 1.0 / 240.0
G = CALM.gravity


def fly(kind: Kind, velocity, until: float, dt: float = DT, effects: EffectSet = EVERYTHING, **options):
    """The star (fields) of a kind after a flight from the origin."""
    system = StarSystem([kind], effects=effects, **options)
    system.launch(kind.name, (0.0, 0.0), velocity)
    for _ in range(round(until / dt)):
        system.step(dt)
    return system.stars(kind.name)[:, 0]


def free(**options) -> Kind:
    return Kind("star", life_s=1000.0, grounded=False, **options)


def landing(kind: Kind, velocity, dt: float = DT, method: str = "split-drag") -> tuple[float, float, float]:
    """Where (m) and when (s) a star comes down, and how high it was at most at the ends of steps."""
    system = StarSystem([kind], method=method)
    system.launch(kind.name, (0.0, 0.0), velocity)
    top = 0.0
    while len(system):
        system.step(dt)
        top = max(top, float(np.max(system.stars(kind.name)[Y], initial=0.0)))
    fall = system.reports[-1]
    return float(fall[3]), float(fall[2]), top


def launched(speed: float, degrees: float) -> tuple[float, float]:
    return speed * math.cos(math.radians(degrees)), speed * math.sin(math.radians(degrees))


def test_range_with_linear_drag():
    x, t, _ = landing(Kind("star", life_s=99.0, linear_drag_per_s=0.5, reports=True), launched(50.0, 60.0))
    # x = v tau (1 - exp(-t / tau)), t by Lambert's W
    assert (x, t) == (pytest.approx(47.64628847863508, rel=1e-4), pytest.approx(6.112059104745787, rel=1e-4))


@pytest.mark.parametrize(
    ("speed", "degrees", "terminal", "expected"),
    [
        (60.0, 60.0, 25.0, (69.07647677151694, 6.221710384511987, 47.91709230075274)),
        (20.0, 45.0, 30.0, (30.715588443950264, 2.657361981068671, 8.681032)),
    ],
)
def test_range_with_quadratic_drag(speed, degrees, terminal, expected):
    kind = Kind("star", life_s=99.0, drag_per_m=G / terminal**2, reports=True)
    x, t, top = landing(kind, launched(speed, degrees))
    assert x == pytest.approx(expected[0], rel=1e-4)
    assert t == pytest.approx(expected[1], rel=1e-4)
    assert top == pytest.approx(expected[2], rel=1e-4)


def test_a_burst_reaches_its_radius():
    star = fly(free(drag_per_m=0.03), (60.0, 0.0), 1.5, effects=EVERYTHING.without("gravity"))
    assert star[X] == pytest.approx(math.log(1.0 + 0.03 * 60.0 * 1.5) / 0.03, rel=1e-5)
    assert star[VX] == pytest.approx(60.0 / (1.0 + 0.03 * 60.0 * 1.5), rel=1e-12)


@pytest.mark.parametrize("method", METHODS)
def test_a_star_flies_the_same_whichever_way_it_goes(method):
    """Away from who looks as along the ground, and slantwise by the speed in all three directions."""
    aside, back = (StarSystem([free(drag_per_m=0.03)], method=method) for _ in range(2))
    aside.launch("star", (0.0, 0.0), (50.0, 20.0))
    back.launch("star", (0.0, 0.0), (30.0, 20.0))
    back.stars("star")[VZ, 0] = 40.0  # the same speed along the ground
    for system in (aside, back):
        for _ in range(240):
            system.step(DT)
    star, other = aside.stars("star")[:, 0], back.stars("star")[:, 0]
    assert other[[X, Z]] == pytest.approx(star[X] * np.array((0.6, 0.8)), rel=1e-12)
    assert other[[VX, VZ]] == pytest.approx(star[VX] * np.array((0.6, 0.8)), rel=1e-12)
    assert other[[Y, VY]] == pytest.approx(star[[Y, VY]], rel=1e-12)


def test_a_rocket_is_driven_along_its_way_in_depth_too():
    systems = [StarSystem([free(exhaust_m_s=800.0, burns=0.5)]) for _ in range(2)]
    for system, (vx, vz) in zip(systems, ((50.0, 0.0), (30.0, 40.0)), strict=True):
        system.launch("star", (0.0, 0.0), (vx, 20.0))
        system.stars("star")[VZ, 0] = vz
        for _ in range(240):
            system.step(DT)
    star, other = (system.stars("star")[:, 0] for system in systems)
    assert other[[X, Z]] == pytest.approx(star[X] * np.array((0.6, 0.8)), rel=1e-12)
    assert other[[Y, VY]] == pytest.approx(star[[Y, VY]], rel=1e-12)


def test_a_burning_star_feels_the_air_more():
    star = fly(
        Kind("star", life_s=2.0, drag_per_m=0.02, burns=1.0, grounded=False),
        (50.0, 0.0),
        1.5,
        effects=EVERYTHING.without("gravity"),
    )
    # 1 / v = 1 / v0 - c tau ln(1 - t / tau)
    assert star[VX] == pytest.approx(13.253498772671689, rel=1e-4)
    assert star[X] == pytest.approx(41.42238505153175, rel=1e-4)
    unburnt = fly(
        Kind("star", life_s=2.0, drag_per_m=0.02, burns=1.0, grounded=False),
        (50.0, 0.0),
        1.5,
        effects=EVERYTHING.without("gravity").without("burning"),
    )
    assert unburnt[VX] == pytest.approx(50.0 / (1.0 + 0.02 * 50.0 * 1.5), rel=1e-12)


def test_a_rocket_reaches_the_speed_of_tsiolkovsky():
    rocket = Kind("rocket", life_s=1.5, burns=1.0 / 3.0, exhaust_m_s=300.0, grounded=False, reports=True)
    system = StarSystem([rocket])
    system.launch("rocket", (0.0, 0.0), (0.0, 0.0))
    while len(system):
        system.step(DT)
    end = system.reports[-1]
    assert end[7] == pytest.approx(300.0 * math.log(1.5) - 1.5 * G, rel=1e-9)
    assert end[4] == pytest.approx(74.0451527026521, rel=1e-3)


def test_a_driven_star_without_gravity_goes_the_way_of_tsiolkovsky():
    rocket = Kind("rocket", life_s=1.0, burns=0.5, exhaust_m_s=100.0, grounded=False, reports=True)
    system = StarSystem([rocket], effects=EVERYTHING.without("gravity"))
    system.launch("rocket", (0.0, 0.0), (0.0, 0.0))
    system.step(1.0)
    assert system.reports[-1][4] == pytest.approx(100.0 * (1.0 - 0.5 / 0.5 * math.log(2.0)), rel=1e-12)


def test_terminal_speed_and_the_time_to_it():
    terminal = 22.381603387889037
    star = fly(free(drag_per_m=G / terminal**2), (0.0, 0.0), 6.0, dt=0.01)
    assert -star[VY] == pytest.approx(terminal * math.tanh(G * 6.0 / terminal), rel=1e-5)


def test_wind_carries_what_drags():
    star = fly(free(linear_drag_per_s=1.25), (0.0, 0.0), 3.0, air=CALM._replace(wind=6.0))
    assert star[X] == pytest.approx(13.312885180108843, rel=1e-4)
    assert fly(free(), (0.0, 0.0), 3.0, air=CALM._replace(wind=6.0))[X] == 0.0


def test_wind_grows_with_height_up_to_the_ceiling():
    air = CALM._replace(gravity=0.0, wind=2.0, shear=0.1, ceiling=20.0)
    for height, expected in ((-5.0, 2.0), (10.0, 4.0), (20.0, 6.0), (300.0, 6.0)):
        system = StarSystem([free(linear_drag_per_s=1e9)], air=air, ground=-100.0)
        system.launch("star", (0.0, height), (0.0, 0.0))
        system.step(0.01)
        assert system.stars("star")[VX, 0] == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("method", "order"),
    [("split-drag", 2), ("explicit-euler", 1), ("semi-implicit-euler", 1), ("midpoint", 2), ("rk4", 4)],
)
def test_orders_of_the_methods(method, order):
    kind = free(drag_per_m=0.02, linear_drag_per_s=0.3)
    right = fly(kind, (40.0, 30.0), 1.0, dt=1.0 / 4096, method="rk4", air=CALM._replace(wind=5.0, shear=0.01))
    errors = []
    for steps in (32, 64):
        air = CALM._replace(wind=5.0, shear=0.01)
        star = fly(kind, (40.0, 30.0), 1.0, dt=1.0 / steps, method=method, air=air)
        errors.append(math.hypot(star[X] - right[X], star[Y] - right[Y]))
    assert math.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.25)


@pytest.mark.parametrize("field", ["linear_drag_per_s", "drag_per_m"])
def test_stiff_drag_goes_to_the_wind_and_never_past_it(field):
    kind = free(**{field: 1000.0 / DT})
    star = fly(
        kind, (300.0, -5.0), 5 * DT, air=CALM._replace(wind=7.0), effects=EVERYTHING.without("gravity")
    )
    assert 7.0 <= star[VX] <= 7.01 if field == "linear_drag_per_s" else 7.0 <= star[VX] < 7.2
    assert -1e-3 < star[VY] <= 0.0


@pytest.mark.parametrize("effect", ["gravity", "drag", "quadratic-drag", "wind", "burning", "thrust"])
@pytest.mark.parametrize("method", METHODS)
def test_an_effect_that_is_off_equals_its_number_at_zero(effect, method):
    numbers = {"linear_drag_per_s": 0.4, "drag_per_m": 0.01, "burns": 0.5, "exhaust_m_s": 20.0}
    zero = {"drag": "linear_drag_per_s", "quadratic-drag": "drag_per_m", "thrust": "exhaust_m_s"}
    air = CALM._replace(wind=4.0, shear=0.05)
    still = {"gravity": air._replace(gravity=0.0), "wind": air._replace(wind=0.0)}.get(effect, air)
    without = dict(numbers)
    if effect in zero:
        without[zero[effect]] = 0.0
    if effect == "burning":
        numbers["exhaust_m_s"] = without["exhaust_m_s"] = 0.0
        without["burns"] = 0.0
    off = fly(free(**numbers), (9.0, 8.0), 0.5, effects=EVERYTHING.without(effect), air=air, method=method)
    nought = fly(free(**without), (9.0, 8.0), 0.5, air=still, method=method)
    assert off[:4].tolist() == nought[:4].tolist()
