"""Contact models: closed forms, conservation laws, energy that never rises, all over their parameters."""

import math

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from game.billiards import Physics, Table, make_shot, simulate
from game.billiards.laws.contacts import BALL_MODELS, CUSHION_MODELS
from game.billiards.laws.contacts.cushion_han_2005 import bounce_han_2005 as inner_han
from game.billiards.laws.contacts.cushion_mathavan_2010 import STEPS, Impact, Motion, follow_impact
from game.billiards.laws.contacts.cushion_mathavan_2010 import bounce_mathavan_2010 as inner_mathavan
from game.billiards.laws.contacts.cushion_mathavan_2010 import follow_to_the_limit as inner_limit
from game.billiards.laws.contacts.cushion_stronge_2000 import bounce_stronge_2000 as inner_stronge
from game.billiards.laws.impacts import collide_pair, normal_between
from game.billiards.laws.lean import lean_kernel
from game.billiards.laws.state import FLOAT_ROWS, MASS, RADIUS, VX, VY, WX, WY, WZ, X
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS

OPEN = Table.open()
RAIL = Table.bare(1.27, 2.54)
speeds = st.floats(-8.0, 8.0)
spins = st.floats(-300.0, 300.0)
shares = st.floats(0.0, 1.0)


@lean_kernel
def bounce_han_2005(state, i, nx, ny, physics):
    """The inner kernel, with an entrance."""
    inner_han(state, i, nx, ny, physics)


@lean_kernel
def bounce_stronge_2000(state, i, nx, ny, physics):
    """The inner kernel, with an entrance."""
    inner_stronge(state, i, nx, ny, physics)


@lean_kernel
def bounce_mathavan_2010(state, i, nx, ny, physics):
    """The inner kernel, with an entrance."""
    inner_mathavan(state, i, nx, ny, physics)


@lean_kernel
def collide(state, physics):
    """Balls 0 and 1 collide; returns the unit vector between them."""
    nx, ny = normal_between(state, 0, 1)
    collide_pair(state, 0, 1, nx, ny, physics)
    return nx, ny


def _collide(model, velocities, spins, masses, radii, angle, **physics):
    """State (rows, 2) before and after two balls in contact collide."""
    reach = 2.0 * math.sqrt(radii[0] * radii[1])
    places = np.array([[0.0, 0.0], [reach * math.cos(angle), reach * math.sin(angle)]])
    shot = make_shot(
        OPEN, places, velocities, spins, radii=radii, masses=masses, physics=Physics(model, **physics)
    )
    state = np.zeros((FLOAT_ROWS, 2))
    state[X : WZ + 1] = shot.balls[:, :7].T
    state[RADIUS], state[MASS] = radii, masses
    before = state.copy()
    return before, state, np.array(collide(state, shot.constants))


def _energy(state):
    spin = 0.4 * state[RADIUS] ** 2 * (state[WX] ** 2 + state[WY] ** 2 + state[WZ] ** 2)
    return 0.5 * (state[MASS] * (state[VX] ** 2 + state[VY] ** 2 + spin)).sum()


@pytest.mark.parametrize("model", BALL_MODELS)
@settings(max_examples=150)
@given(
    st.tuples(*[speeds] * 4),
    st.tuples(*[spins] * 6),
    st.floats(0.2, 5.0),
    st.floats(0.5, 2.0),
    st.floats(0.0, 6.3),
    shares,
    st.floats(0.0, 1.5),
)
def test_ball_ball_keeps_momentum_and_never_gains_energy(model, v, w, mass_ratio, radius_ratio, angle, e, mu):
    masses = (BALL_MASS, BALL_MASS * mass_ratio)
    radii = (BALL_RADIUS, BALL_RADIUS * radius_ratio)
    physics = {"ball_restitution": e, "ball_friction": mu if mu > 1e-9 else 0.0}
    before, after, n = _collide(model, [v[:2], v[2:]], [w[:3], w[3:]], masses, radii, angle, **physics)
    closing = (before[VX, 0] - before[VX, 1]) * n[0] + (before[VY, 0] - before[VY, 1]) * n[1]
    assume(closing > 1e-9)
    scale = (before[MASS] * np.hypot(before[VX], before[VY])).sum()
    for row in (VX, VY):
        assert (after[MASS] * after[row]).sum() == pytest.approx(
            (before[MASS] * before[row]).sum(), abs=1e-14 * scale
        )
    assert _energy(after) <= _energy(before) * (1.0 + 1e-14)
    if masses[0] == masses[1] and radii[0] == radii[1]:
        parting = (after[VX, 1] - after[VX, 0]) * n[0] + (after[VY, 1] - after[VY, 0]) * n[1]
        wanted = closing * (1.0 if model == "elastic" else e)
        assert parting == pytest.approx(wanted, rel=1e-12, abs=1e-13)


def _slip(state, n3):
    """Slip (3,) m/s of the surface of ball 0 on that of ball 1, and spins times radii."""
    v = np.array([[*state[VX : VY + 1, k], 0.0] for k in range(2)])
    turning = np.array([state[RADIUS, k] * state[WX : WZ + 1, k] for k in range(2)])
    slip = v[0] - v[1] + np.cross(turning.sum(axis=0), n3)
    return slip - (slip @ n3) * n3, turning


@pytest.mark.parametrize("radii", [(BALL_RADIUS, BALL_RADIUS), (BALL_RADIUS, 0.8 * BALL_RADIUS)])
@settings(max_examples=25)
@given(
    st.floats(0.1, 8.0), st.floats(-1.4, 1.4), st.tuples(*[spins] * 6), st.floats(0.2, 5.0),
    st.floats(0.0, 6.3),
)  # fmt: skip
def test_friction_is_an_impulse_against_the_slip_and_its_moment_turns_both_balls(
    radii, speed, cut, w, mass_ratio, angle
):
    """Vectors in space, written anew: after Newton's law along n, P against the slip that is left, and
    I_k dw_k = r_k n x P of both balls; n is tilted where one is larger.
    """
    masses = (BALL_MASS, BALL_MASS * mass_ratio)
    v = (speed * math.cos(angle + cut), speed * math.sin(angle + cut))
    before, after, n = _collide(
        "frictional", [v, (0.0, 0.0)], [w[:3], w[3:]], masses, radii, angle, ball_friction=0.3,
        ball_restitution=0.9,
    )  # fmt: skip
    pushed = before.copy()
    impulse = 1.9 * (np.array(v) @ n) / (1.0 / masses[0] + 1.0 / masses[1])
    pushed[VX : VY + 1] += impulse * n[:, None] * (-1.0 / masses[0], 1.0 / masses[1])
    sine = (radii[1] - radii[0]) / (radii[0] + radii[1])
    n3 = np.array([*(math.sqrt(1.0 - sine * sine) * n), sine])
    slip, turning = _slip(pushed, n3)
    moments = 0.4 * np.array(masses)[:, None] * (_slip(after, n3)[1] - turning)
    assert moments[0] == pytest.approx(moments[1], rel=1e-9, abs=1e-13)
    across = np.array([-n[1], n[0], 0.0])
    assume(abs(slip @ across) > 1e-3)
    given_to_0 = masses[0] * (after[VX : VY + 1, 0] - pushed[VX : VY + 1, 0])
    share = (given_to_0 @ across[:2]) / (slip @ across)
    assert share <= 0.0
    assert moments[0] == pytest.approx(np.cross(n3, share * slip), rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("model", [name for name in BALL_MODELS if name != "elastic"])
def test_balls_that_do_not_slip_are_not_rubbed(model):
    """Head on and without spin: Newton's law of restitution alone, and not a number that is none."""
    _, after, _ = _collide(
        model, [(2.0, 0.0), (0.0, 0.0)], np.zeros((2, 3)), [BALL_MASS] * 2, [BALL_RADIUS] * 2, 0.0,
        ball_restitution=0.8,
    )  # fmt: skip
    assert after[VX] == pytest.approx((0.2, 1.8), rel=1e-14)
    assert np.array_equal(after[VY], (0.0, 0.0)) and not after[WX : WZ + 1].any()


def test_half_ball_hit():
    """30 degrees, e = 0.95: speeds, angle between the balls, share of the energy kept."""
    n = np.array([math.cos(math.pi / 6), math.sin(math.pi / 6)])
    before, after, _ = _collide(
        "frictional",
        [(1.0, 0.0), (0.0, 0.0)],
        np.zeros((2, 3)),
        [BALL_MASS] * 2,
        [BALL_RADIUS] * 2,
        math.pi / 6,
        ball_friction=0.0,
    )
    cue, ball = after[VX : VY + 1, 0], after[VX : VY + 1, 1]
    assert np.hypot(*ball) == pytest.approx(0.844374768689828, rel=1e-14)
    assert np.hypot(*cue) == pytest.approx(0.50046853047919, rel=1e-14)
    angle = math.degrees(math.acos(cue @ ball / np.hypot(*cue) / np.hypot(*ball)))
    assert angle == pytest.approx(87.5205688410141, rel=1e-12)
    assert _energy(after) / _energy(before) == pytest.approx(0.9634375, rel=1e-14)
    assert ball / np.hypot(*ball) == pytest.approx(n, abs=1e-15)


@pytest.mark.parametrize(
    ("cut", "deflection"),
    [
        (15, 28.1622125845499),
        (30, 33.6704965083151),
        (45, 29.0546040990771),
        (60, 20.6330010833223),
        (28.1255057020557, 33.7489885958886),
    ],
)
def test_a_rolling_cue_ball_is_deflected_as_the_thirty_degree_rule_says(cut, deflection):
    angle = math.radians(cut)
    reach = 2.0 * BALL_RADIUS
    way = 0.3
    contact = np.array([way - reach * math.cos(angle), -reach * math.sin(angle)])
    shot = make_shot(
        OPEN,
        [contact - [0.2, 0.0], [way, 0.0]],
        [(1.0, 0.0), (0.0, 0.0)],
        [(0.0, 1.0 / BALL_RADIUS, 0.0), (0.0, 0.0, 0.0)],
        motions=["rolling", "stationary"],
        physics=Physics("elastic", "mirror"),
    )
    trajectory = simulate(shot)
    hit = next(e.time for e in trajectory.events if e.type == "ball-ball")
    rolls = next(
        e.time for e in trajectory.events if e.time > hit and e.type == "sliding-rolling" and e.ids == ("0",)
    )
    vx, vy = trajectory.state_at(rolls).velocities[0]
    assert math.degrees(math.atan2(-vy, vx)) % 360.0 == pytest.approx(deflection, rel=1e-9)


def test_the_physical_limit_throws_more_than_the_reference_rule():
    """mu (1 + e)/2 against mu e: the share shows in the thrown ball's sideways speed."""
    sideways = []
    for model in ("frictional", "wallace-1988"):
        _, after, n = _collide(
            model,
            [(2.0, 0.0), (0.0, 0.0)],
            np.zeros((2, 3)),
            [BALL_MASS] * 2,
            [BALL_RADIUS] * 2,
            math.pi / 4,
            ball_restitution=0.8,
        )
        sideways.append(abs(after[VX, 1] * -n[1] + after[VY, 1] * n[0]))
    closing = 2.0 * math.cos(math.pi / 4)
    assert sideways[0] == pytest.approx(0.05 * 0.8 * closing, rel=1e-13)
    assert sideways[1] == pytest.approx(0.05 * 0.9 * closing, rel=1e-13)


def test_alciatore_friction_falls_with_slip():
    throws = []
    for slip_spin in (5.0, 50.0, 200.0):
        _, after, _ = _collide(
            "alciatore-2006",
            [(1.0, 0.0), (0.0, 0.0)],
            [(0.0, 0.0, slip_spin), (0.0, 0.0, 0.0)],
            [BALL_MASS] * 2,
            [BALL_RADIUS] * 2,
            0.0,
        )
        mu = 0.009951 + 0.108 * math.exp(-1.088 * BALL_RADIUS * slip_spin)
        assert abs(after[VY, 1]) == pytest.approx(min(mu * 0.975, BALL_RADIUS * slip_spin / 7.0), rel=1e-12)
        throws.append(abs(after[VY, 1]))
    assert throws[1] > throws[2]


def test_sticking_stops_the_slip():
    _, after, _ = _collide(
        "wallace-1988",
        [(1.0, 0.0), (0.0, 0.0)],
        [(0.0, 0.0, 2.0), (0.0, 0.0, 0.0)],
        [BALL_MASS, 2.0 * BALL_MASS],
        [BALL_RADIUS] * 2,
        0.0,
        ball_friction=0.5,
    )
    slip = after[VY, 0] - after[VY, 1] + BALL_RADIUS * (after[WZ, 0] + after[WZ, 1])
    assert slip == pytest.approx(0.0, abs=1e-16)


def test_unequal_balls_touch_at_twice_the_geometric_mean_of_their_radii():
    radii = (0.02, 0.04)
    shot = make_shot(
        OPEN,
        [[0.0, 0.0], [0.5, 0.0]],
        [(1.0, 0.0), (0.0, 0.0)],
        radii=radii,
        masses=(0.1, 0.8),
        physics=Physics("elastic", "mirror"),
    )
    trajectory = simulate(shot)
    hit = next(e.time for e in trajectory.events if e.type == "ball-ball")
    state = trajectory.state_at(hit)
    assert state.positions[1, 0] - state.positions[0, 0] == pytest.approx(
        2.0 * math.sqrt(0.02 * 0.04), rel=1e-14
    )
    before = trajectory.state_at(np.nextafter(hit, 0.0)).velocities[0, 0]
    assert state.velocities[:, 0] == pytest.approx([before * -0.7 / 0.9, before * 0.2 / 0.9], rel=1e-12)


BOUNCES = {
    "han-2005": bounce_han_2005,
    "mathavan-2010": bounce_mathavan_2010,
    "stronge-2000": bounce_stronge_2000,
}


def _bounce(model, velocity, spin, normal_angle=0.3, **physics):
    shot = make_shot(RAIL, [[0.6, 0.6]], [velocity], [spin], physics=Physics("elastic", model, **physics))
    state = np.zeros((FLOAT_ROWS, 1))
    state[X : WZ + 1, 0] = shot.balls[0, :7]
    state[RADIUS], state[MASS] = BALL_RADIUS, BALL_MASS
    nx, ny = math.cos(normal_angle), math.sin(normal_angle)
    before = state.copy()
    BOUNCES[model](state, 0, nx, ny, shot.constants)
    return before, state, np.array([nx, ny])


@pytest.mark.parametrize("model", ["han-2005", "mathavan-2010", "stronge-2000"])
@settings(max_examples=150)
@given(st.tuples(speeds, speeds), st.tuples(spins, spins, spins), st.floats(0.0, 0.98), st.floats(0.001, 0.6))
@example((0.0, -1.0), (0.0, 15.0, 0.0), 0.125, 0.5)  # the spin's friction outweighs so weak a push
def test_a_cushion_turns_the_ball_round_and_never_gives_energy(model, velocity, spin, e, mu):
    before, after, n = _bounce(model, velocity, spin, cushion_restitution=e, cushion_friction=mu)
    approach = -(before[VX, 0] * n[0] + before[VY, 0] * n[1])
    assume(approach > 1e-6)
    assert after[VX, 0] * n[0] + after[VY, 0] * n[1] >= -1e-12 * (1.0 + approach)
    assert _energy(after) <= _energy(before) * (1.0 + 1e-13)


@pytest.mark.parametrize("model", ["han-2005", "mathavan-2010", "stronge-2000"])
@given(st.floats(0.1, 8.0), st.floats(-1.2, 1.2), spins, spins, spins)
def test_cushion_models_are_mirror_symmetric(model, speed, angle, wx, wy, wz):
    v = (-speed * math.cos(angle), speed * math.sin(angle))
    _, one, _ = _bounce(model, v, (wx, wy, wz), 0.0)
    _, other, _ = _bounce(model, (v[0], -v[1]), (-wx, wy, -wz), 0.0)
    # mirrored in the x axis: vy turns round, and of the spin x and z
    assert other[VX : WZ + 1, 0].tolist() == (one[VX : WZ + 1, 0] * [1, -1, -1, 1, -1]).tolist()


def test_han_stick_branch_stops_the_slip_of_a_level_nose():
    """h = R: th = 0, where the decoupled formula is exact: no slip along the rail or upwards is left."""
    table = Table.bare(1.27, 2.54, cushion_height=BALL_RADIUS)
    shot = make_shot(
        table,
        [[0.6, 0.6]],
        [(-3.0, 0.2)],
        [(0.0, 0.0, 4.0)],
        physics=Physics("elastic", "han-2005", cushion_friction=0.5),
    )
    state = np.zeros((FLOAT_ROWS, 1))
    state[X : WZ + 1, 0] = shot.balls[0, :7]
    state[RADIUS], state[MASS] = BALL_RADIUS, BALL_MASS
    bounce_han_2005(state, 0, 1.0, 0.0, shot.constants)
    assert state[VX, 0] == pytest.approx(0.85 * 3.0, rel=1e-14)
    # the ball's surface at the nose, at -R x: v + w x r
    assert state[VY, 0] - BALL_RADIUS * state[WZ, 0] == pytest.approx(0.0, abs=1e-15)


def test_han_falls_back_where_the_formula_would_drive_the_ball_through():
    table = Table.bare(1.27, 2.54, cushion_height=1.9 * BALL_RADIUS)
    shot = make_shot(table, [[0.6, 0.6]], [(-3.0, 0.0)], physics=Physics("elastic", "han-2005"))
    state = np.zeros((FLOAT_ROWS, 1))
    state[X : WZ + 1, 0] = shot.balls[0, :7]
    state[RADIUS], state[MASS] = BALL_RADIUS, BALL_MASS
    bounce_han_2005(state, 0, 1.0, 0.0, shot.constants)
    assert state[VX, 0] >= 0.0


def test_mathavan_without_friction_returns_the_restitution():
    before, after, n = _bounce(
        "mathavan-2010", (-2.0, 0.5), (0.0, 0.0, 0.0), 0.0, cushion_friction=0.0, sliding=0.0
    )
    assert after[VX, 0] == pytest.approx(-0.85 * before[VX, 0], rel=1e-12)
    assert after[VY, 0] == before[VY, 0] and not after[WX : WZ + 1].any()
    assert n[0] == 1.0


@lean_kernel
def follow(motion, impact, steps):
    """The inner kernel, with an entrance."""
    return follow_impact(motion, impact, steps)


def test_mathavan_converges_with_its_steps():
    """Ball, rail and cloth of the paper; measured against the outcome of ten times as many steps."""
    arguments = Motion(1.0, 1.5, 20.0, -30.0, 40.0), Impact(0.02625, 0.1406, 0.4, 0.98, 0.14, 0.212)
    outcomes = {steps: np.array(follow(*arguments, steps)) for steps in (10, 100, 1000)}
    scale = np.array([1.5, 1.5, 57.0, 57.0, 57.0])
    coarse = (np.abs(outcomes[10] - outcomes[1000]) / scale).max()
    fine = (np.abs(outcomes[100] - outcomes[1000]) / scale).max()
    assert fine < 0.01 and fine < 0.3 * coarse


@lean_kernel
def follow_to_the_limit(motion, impact, steps):
    """The inner kernel, with an entrance."""
    return inner_limit(motion, impact, steps)


def test_mathavan_is_as_near_to_its_limit_as_it_says():
    """Against 20,000 steps, of the speed of ball and surface; most impacts are a thousand times nearer."""
    rng = np.random.default_rng(4)
    errors = []
    for _ in range(400):
        speed, angle = rng.uniform(0.05, 6.0), rng.uniform(-1.4, 1.4)
        spin = rng.uniform(-1.5, 1.5, 3) * speed / BALL_RADIUS
        models = rng.uniform(0.3, 0.98), rng.uniform(0.02, 0.5), rng.uniform(0.05, 0.6)
        motion = Motion(speed * math.sin(angle), speed * math.cos(angle), *spin)
        ball = motion, Impact(BALL_RADIUS, 0.17, 0.27, *models)
        scale = np.array([1.0, 1.0, BALL_RADIUS, BALL_RADIUS, BALL_RADIUS])
        difference = np.array(follow_to_the_limit(*ball, STEPS)) - follow(*ball, 20_000)
        errors.append(np.abs(scale * difference).max() / np.linalg.norm(scale * motion))
    assert max(errors) < 2e-3 and np.median(errors) < 1e-5


@pytest.mark.parametrize("model", ["han-2005", "mathavan-2010", "stronge-2000"])
def test_running_side_quickens_the_ball_along_the_rail(model):
    """Mathavan's eq. 12: the surface slips along the rail at vx - wz R cos(th) at the nose, and friction
    opposes that. Moving along +y by the left rail, a ball that turns with wz > vy/R is dragged on:
    running side. One that turns the other way is held back: check side."""
    along = {}
    for wz in (-60.0, 0.0, 60.0):
        _, after, _ = _bounce(model, (-1.0, 1.0), (0.0, 0.0, wz), 0.0)
        along[wz] = after[VY, 0]
    assert along[-60.0] < along[0.0] < 1.0 < along[60.0]


def test_every_model_can_be_named():
    for ball in BALL_MODELS:
        for cushion in CUSHION_MODELS:
            shot = make_shot(
                RAIL, [[0.6, 0.6], [0.6, 1.6]], [(0.1, 2.0), (0.0, 0.0)], physics=Physics(ball, cushion)
            )
            assert {"ball-ball", "ball-cushion"} <= {e.type for e in simulate(shot).events}


@pytest.mark.parametrize("radii", [(0.02, 0.04), (0.04, 0.02), (0.03, 0.03)])
def test_friction_of_unequal_balls_is_limited_by_the_impulse_along_the_true_normal(radii):
    """mu P/cos(phi): the horizontal part P of the normal impulse is cos(phi) of the whole."""
    masses, mu, e = (0.1, 0.3), 0.05, 0.9
    before, after, n = _collide(
        "wallace-1988", [(1.0, 2.0), (0.0, -1.0)], np.zeros((2, 3)), masses, radii, 0.0,
        ball_friction=mu, ball_restitution=e,
    )  # fmt: skip
    closing = float(n @ (before[VX : VY + 1, 0] - before[VX : VY + 1, 1]))
    pushed = (1.0 + e) * closing * masses[0] * masses[1] / sum(masses)
    cosine = 2.0 * math.sqrt(radii[0] * radii[1]) / sum(radii)
    for ball in range(2):
        turned = float(np.linalg.norm(after[WX : WZ + 1, ball] - before[WX : WZ + 1, ball]))
        rubbed = 0.4 * masses[ball] * radii[ball] * turned
        assert rubbed == pytest.approx(mu * pushed / cosine, rel=1e-12)


def _mathavan_by_vectors(v, w, mass, radius, sine, e, mu_nose, mu_cloth, steps):
    """The paper's impact with vectors: v, w (3,) in its frame, y into the rail."""
    cosine = math.sqrt(1.0 - sine * sine)
    v, w, normal = np.array(v), np.array(w), np.array([0.0, cosine, sine])
    nose, foot = radius * normal, np.array([0.0, 0.0, -radius])
    step, stored, owed = mass * v[1] / (cosine * steps), 0.0, math.inf
    while owed > 0.0:
        here = v + np.cross(w, nose)
        slip = here - (here @ normal) * normal
        rubbing = -mu_nose * step * slip / max(np.linalg.norm(slip), 1e-12)
        push = -step * normal + rubbing
        down = max(-push[2], 0.0)
        skid = (v + np.cross(w, foot)) * (1.0, 1.0, 0.0)
        drag = -mu_cloth * down * skid / max(np.linalg.norm(skid), 1e-12)
        pressed = 0.5 * step * cosine * (v[1] + v[1] - step * cosine / mass)
        v = v + (push + drag) * (1.0, 1.0, 0.0) / mass  # the cloth takes what is vertical
        w = w + 2.5 / (mass * radius * radius) * (np.cross(nose, push) + np.cross(foot, drag))
        stored += max(pressed, 0.0)
        if v[1] <= 0.0 and owed == math.inf:
            owed = e * e * stored
        owed += min(pressed, 0.0)
    return v, w


@pytest.mark.parametrize("wx", [-90.0, -20.0, 90.0])
def test_mathavan_against_the_papers_equations_in_vectors(wx):
    """Draw, a little follow, and overspin: friction at the nose rubs the ball up or down."""
    ball = (0.140, 0.02625, 0.4, 0.8, 0.14, 0.212)
    v, w = _mathavan_by_vectors((0.7, 1.5, 0.0), (wx, 20.0, 15.0), *ball, 4000)
    mass, radius, *models = ball
    got = follow_to_the_limit(Motion(0.7, 1.5, wx, 20.0, 15.0), Impact(radius, mass, *models), STEPS)
    assert got[:2] == pytest.approx(v[:2], abs=0.01)
    assert radius * np.array(got[2:]) == pytest.approx(radius * w, abs=0.01)
