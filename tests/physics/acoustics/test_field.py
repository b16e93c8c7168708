"""The sound field against scipy, differences and the closed form of a plane standing wave."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import j1

from game.physics.acoustics import Grain, Levitator, LevitatorSettings, PhasedArray, facing_rows
from game.physics.acoustics.field import STRENGTH, transfer
from game.physics.acoustics.levitator import AIR, FREQUENCY, PISTON, POLYSTYRENE

K = 2.0 * math.pi * FREQUENCY / AIR.sound
WAVE = AIR.sound / FREQUENCY


def levitator(rows: int = 4, **settings) -> Levitator:
    return Levitator(
        facing_rows(rows, 9, 0.01, 0.16, 5.0), [], figure="heart", settings=LevitatorSettings(**settings)
    )


def test_one_transducer_is_a_piston():
    alone = Levitator(PhasedArray([(0.0, 0.0)], [(0.0, 1.0)], [0], 2.0), [])
    alone.array.sources[:, 5] = 0.4
    for x, y in ((0.0, 0.05), (0.03, 0.05), (-0.07, 0.02), (0.06, -0.01)):
        d, sine = math.hypot(x, y), abs(x) / math.hypot(x, y)
        s = K * PISTON * sine
        shape = 2.0 * j1(s) / s if s else 1.0
        want = 2.0 / d * shape * np.exp(1j * (K * d + 0.4)) if y > 0.0 else 0.0
        found = complex(*alone.sample([(x, y)])[0, :2])
        assert found == pytest.approx(want, rel=1e-9, abs=1e-12)


def test_slopes_are_those_of_pressure_and_potential():
    field = levitator()
    places = np.random.default_rng(1).uniform(-0.05, 0.05, (100, 2))
    h = 2e-6
    found = field.sample(places)
    steep = np.zeros(100)
    force = np.zeros((100, 2))
    for axis in range(2):
        step = np.eye(2)[axis] * h
        after, before = field.sample(places + step), field.sample(places - step)
        rise = (after[:, :2] - before[:, :2]) / (2.0 * h)
        steep += np.sum(rise * rise, axis=1)
        force[:, axis] = -(after[:, 3] - before[:, 3]) / (2.0 * h)
    assert np.max(np.abs(np.sqrt(steep) - found[:, 2])) < 1e-5 * np.max(found[:, 2])
    assert np.max(np.abs(force - found[:, 4:])) < 1e-5 * np.max(np.abs(force))


def test_a_plane_standing_wave_pushes_as_its_closed_form_says():
    """F = 4 pi a³ k E (f1/3 + f2/2) sin 2kz (Bruus 2012, eq. 47), by two transducers far away."""
    far, strength = 4.0, 8_000.0
    places, axes = [(0.0, -far), (0.0, far)], [(0.0, 1.0), (0.0, -1.0)]
    wave = Levitator(
        PhasedArray(places, axes, [0, 1], strength), [], settings=LevitatorSettings(pattern="plane")
    )
    wave.array.level(K, (0.0, 0.0), wave.offsets)
    grain = POLYSTYRENE
    f1, f2 = grain.contrast(AIR)
    density = (2.0 * strength / far) ** 2 / (4.0 * AIR.density * AIR.sound**2)
    z = np.linspace(-0.4, 0.4, 41) * WAVE
    most = 4.0 * math.pi * grain.radius**3 * K * density * (f1 / 3.0 + f2 / 2.0)
    found = wave.sample(np.stack([np.zeros_like(z), z], axis=1))
    # the pressure has its node at 0, so the force draws back to it
    assert np.max(np.abs(found[:, 5] + most * np.sin(2.0 * K * z))) < 2e-3 * most
    assert np.allclose(found[:, 4], 0.0, atol=1e-9 * most)


def test_traps_lie_half_a_wave_apart():
    """In plane waves exactly; in a focus a little more, as its waves do not all run along the axis."""
    places, axes = [(0.0, -4.0), (0.0, 4.0)], [(0.0, 1.0), (0.0, -1.0)]
    plane = Levitator(PhasedArray(places, axes, [0, 1], 1e4), [])
    plane.array.level(K, (0.0, 0.0), plane.offsets)
    focus = Levitator(facing_rows(2, 17, 0.01, 0.2, 10.0), [])
    for field, low, high in ((plane, 0.4999, 0.5001), (focus, 0.5, 0.56)):
        x, y = field.place if field is focus else (0.0, 0.0)
        z = np.linspace(-1.3, 1.3, 5201) * WAVE
        depth = field.sample(np.stack([np.full_like(z, x), y + z], axis=1))[:, 3]
        lowest = np.flatnonzero((depth[1:-1] < depth[:-2]) & (depth[1:-1] < depth[2:])) + 1
        gaps = np.diff(z[lowest]) / WAVE
        assert len(lowest) >= 5 and np.all((gaps > low) & (gaps < high))


def test_the_picture_of_the_field_is_the_field():
    field = levitator()
    places = np.random.default_rng(2).uniform(-0.06, 0.06, (50, 2))
    heard = transfer(field.array.sources, field.wave, places)
    p = heard @ np.exp(1j * field.array.sources[:, 5])
    want = field.sample(places)
    assert np.max(np.abs(p - (want[:, 0] + 1j * want[:, 1]))) < 1e-4 * np.max(np.abs(p))
    assert field.array.sources[0, STRENGTH] == 5.0


def test_the_focus_is_a_node_of_the_pressure_and_a_trap():
    for rows in (2, 4):
        field = levitator(rows)
        field.array.focus(K, (0.0, 0.0), field.offsets)
        p_re, p_im, steep, *_ = field.sample([(0.0, 0.0)])[0]
        assert math.hypot(p_re, p_im) < 1e-9 * steep / K
        h = 0.05 * WAVE
        pull = field.sample([(h, 0.0), (-h, 0.0), (0.0, h), (0.0, -h)])[:, 4:]
        assert pull[0, 0] < 0.0 < pull[1, 0] and pull[2, 1] < 0.0 < pull[3, 1]


def test_grain_with_the_air_s_own_contrast_feels_nothing():
    field = levitator()
    field.set_grain(Grain(0.5e-3, AIR.density, AIR.sound))
    assert np.allclose(field.sample([(0.01, 0.02)])[0, 3:], 0.0, atol=1e-20)


@pytest.mark.parametrize(
    "arguments",
    [(3, 5, 0.01, 0.2, 1.0), (2, 0, 0.01, 0.2, 1.0), (2, 5, 0.0, 0.2, 1.0), (2, 5, 0.01, 0.2, -1.0)],
)
def test_nonsense_is_refused(arguments):
    with pytest.raises(ValueError, match=r"expected|out of range"):
        facing_rows(*arguments)
    with pytest.raises(ValueError, match="length 1"):
        PhasedArray([(0.0, 0.0)], [(0.0, 2.0)], [0], 1.0)
    with pytest.raises(ValueError, match="quarter wave"):
        levitator().set_grain(POLYSTYRENE._replace(radius=3e-3))
    with pytest.raises(ValueError, match="density"):
        levitator().set_grain(POLYSTYRENE._replace(density=math.nan))
    with pytest.raises(ValueError, match="substeps"):
        LevitatorSettings(substeps=0)
    with pytest.raises(ValueError, match="figure"):
        levitator().set_figure("square", 0.1)
    with pytest.raises(ValueError, match="dt"):
        levitator().step(math.inf)
