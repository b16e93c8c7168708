"""The cushion of Stronge 2000 against a naive twin and its limits; the restitution that falls with speed."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from game.billiards.laws.state import BALL_CUSHION
from game.billiards.shot.physics import Physics, ShotError
from game.billiards.shot.shot import Shot, make_shot
from game.billiards.shot.shot_file import parse_shot
from game.billiards.shot.shot_writing import shot_data
from game.billiards.simulation import simulate_exact
from game.billiards.table.table import Table

RADIUS = 0.03
HEIGHT = 0.037
STRONGE = Physics(
    cushion="stronge-2000", cushion_restitution=0.8, cushion_friction=0.25, sliding=0.0, spinning=0.0
)


def shot_at(velocity: tuple[float, float], spin: tuple[float, float, float], physics: Physics) -> Shot:
    """A ball on its way to the right cushion, on a cloth that does not rub."""
    table = Table.bare(1.0, 2.0, HEIGHT)
    return make_shot(table, [[0.9, 1.0]], [velocity], [spin], radii=RADIUS, physics=physics)


def bounced(velocity: tuple[float, float], spin: tuple[float, float, float], physics: Physics) -> np.ndarray:
    """Velocity (2) and spin (3) after the first cushion."""
    played = simulate_exact(shot_at(velocity, spin, physics), until=1.0)
    assert int(played.rows[0, 1]) == BALL_CUSHION
    state = played.state_at(float(played.times[0]))
    return np.concatenate([state.velocities[0], state.spins[0]])


def twin(
    velocity: tuple[float, float], spin: tuple[float, float, float], p: Physics, steps: int
) -> np.ndarray:
    """The same by vectors of space, the tangential spring as one vector, in many plain steps."""
    sine = HEIGHT / RADIUS - 1.0
    into = np.array([math.sqrt(1.0 - sine * sine), 0.0, sine])  # from the ball's centre to the nose
    v, w = np.array([*velocity, 0.0]), np.array(spin)
    closing = float(v @ into)
    e = p.cushion_restitution
    slip = v + RADIUS * np.cross(w, into)
    slip -= (slip @ into) * into
    pulled, stretch = np.zeros(3), np.zeros(3)
    end = 0.5 * math.pi * (1.0 + e)
    dt = end / steps
    for k in range(steps):
        t = (k + 0.5) * dt
        force = math.sin(t) if t < 0.5 * math.pi else math.cos((t - 0.5 * math.pi) / e)
        limit = p.cushion_friction * closing * force * p.cushion_compliance
        stretch = stretch + dt * slip
        length = float(np.linalg.norm(stretch))
        if length > limit:
            stretch *= limit / length
        change = -dt * stretch / p.cushion_compliance
        pulled += change
        slip = slip + 3.5 * change
    push = pulled - (1.0 + e) * closing * into
    v = v + push
    w = w + 2.5 / RADIUS * np.cross(into, pulled)
    return np.array([v[0], v[1], *w])


CASES = [
    ((1.5, 0.4), (0.0, 0.0, 0.0)),
    ((1.0, -1.2), (20.0, 33.0, 40.0)),
    ((2.0, 0.1), (-3.0, 66.0, -60.0)),
    ((0.4, 2.0), (-66.0, 13.0, 5.0)),
]


@pytest.mark.parametrize(("velocity", "spin"), CASES)
@pytest.mark.parametrize("compliance", [0.3, 1.5, 4.0])
def test_a_bounce_is_that_of_a_naive_twin(velocity, spin, compliance) -> None:
    physics = STRONGE._replace(cushion_compliance=compliance)
    speed = math.hypot(*velocity) + RADIUS * math.hypot(*spin)
    difference = bounced(velocity, spin, physics) - twin(velocity, spin, physics, 20_000)
    difference[2:] *= RADIUS
    assert np.abs(difference).max() < 2e-3 * speed


def test_without_friction_it_is_han() -> None:
    for velocity, spin in CASES:
        smooth = STRONGE._replace(cushion_friction=0.0)
        han = bounced(velocity, spin, smooth._replace(cushion="han-2005"))
        np.testing.assert_allclose(bounced(velocity, spin, smooth), han, atol=1e-12)


def test_a_surface_that_slips_all_the_time_is_rubbed_as_by_han() -> None:
    velocity, spin = (0.3, 0.0), (0.0, 0.0, 300.0)
    han = bounced(velocity, spin, STRONGE._replace(cushion="han-2005"))
    np.testing.assert_allclose(bounced(velocity, spin, STRONGE), han, rtol=2e-3, atol=1e-9)


def test_a_compliant_nose_turns_the_slip_round() -> None:
    velocity, spin = (2.0, 0.0), (0.0, 0.0, 12.0)
    sine = HEIGHT / RADIUS - 1.0
    cosine = math.sqrt(1.0 - sine * sine)

    def slip_along(after: np.ndarray) -> float:
        return float(after[1] + RADIUS * (after[4] * cosine - after[2] * sine))

    before = RADIUS * 12.0 * cosine
    assert abs(slip_along(bounced(velocity, spin, STRONGE._replace(cushion="han-2005")))) < 1e-9
    assert slip_along(bounced(velocity, spin, STRONGE)) < -0.1 * before


@pytest.mark.parametrize("cushion", ["restitution", "han-2005", "mathavan-2010", "stronge-2000"])
def test_restitution_falls_with_the_closing_speed(cushion: str) -> None:
    falling = STRONGE._replace(cushion=cushion, cushion_restitution_fall=0.05, cushion_restitution=0.9)
    for speed in (0.5, 2.0, 4.0):
        same = falling._replace(cushion_restitution_fall=0.0, cushion_restitution=0.9 - 0.05 * speed)
        after = bounced((speed, 0.0), (0.0, 0.0, 0.0), falling)
        np.testing.assert_allclose(after, bounced((speed, 0.0), (0.0, 0.0, 0.0), same), atol=1e-12)
    at_most = bounced((4.0, 0.0), (0.0, 0.0, 0.0), falling._replace(cushion_restitution_fall=1.0))
    assert at_most[0] <= 1e-9


def test_a_mirror_does_not_fall() -> None:
    physics = STRONGE._replace(cushion="mirror", cushion_restitution_fall=0.1)
    assert bounced((3.0, 0.5), (0.0, 0.0, 0.0), physics)[0] == -3.0


def test_files_keep_the_numbers_that_may_be_left_out() -> None:
    physics = STRONGE._replace(cushion_restitution_fall=0.02, cushion_compliance=0.7)
    data = json.loads(json.dumps(shot_data(shot_at((1.0, 0.0), (0.0, 0.0, 0.0), physics))))
    assert data["restitution"]["cushion_fall"] == 0.02
    assert parse_shot(data).physics == physics
    plain = shot_data(shot_at((1.0, 0.0), (0.0, 0.0, 0.0), Physics()))
    assert "compliance" not in plain
    assert "cushion_fall" not in plain["restitution"]
    assert parse_shot(plain).physics == Physics()
    data["compliance"]["cushion"] = "soft"
    with pytest.raises(ShotError, match=r"compliance\.cushion: must be a number"):
        parse_shot(data)


def test_absurd_numbers_are_refused() -> None:
    for change, place in (
        ({"cushion_restitution_fall": -0.1}, r"restitution\.cushion_fall"),
        ({"cushion_restitution_fall": math.nan}, r"restitution\.cushion_fall"),
        ({"cushion_compliance": 0.0}, r"compliance\.cushion"),
    ):
        with pytest.raises(ShotError, match=place):
            shot_at((1.0, 0.0), (0.0, 0.0, 0.0), STRONGE._replace(**change))


def test_words_of_a_table_say_what_is_not_the_default() -> None:
    assert "compliance" not in repr(Physics())
    assert "cushion_restitution_fall=0.02" in repr(Physics(cushion_restitution_fall=0.02))
    assert repr(Physics()).startswith("Physics(ball_ball='alciatore-2006', cushion='han-2005', gravity=9.81,")
