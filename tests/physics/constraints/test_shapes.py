"""Shapes: what they are made of, and what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.constraints import shapes


def test_a_rope_hangs_between_its_pins():
    rope = shapes.rope((0.0, 1.0), (2.0, 1.0), 4, 0.5, "both")
    assert rope.positions.tolist() == [[0.0, 1.0], [0.5, 1.0], [1.0, 1.0], [1.5, 1.0], [2.0, 1.0]]
    assert rope.inverse_masses.tolist() == [0.0, 2.0, 2.0, 2.0, 0.0]
    assert len(shapes.rope((0.0, 0.0), (1.0, 0.0), 1).links) == 1


def test_a_bridge_weighs_what_it_is_said_to():
    bridge = shapes.bridge((0.0, 0.0), (4.0, 0.0), 4, 1.0, mass=2.0, lamps=1, lamp_mass=8.0)
    deck, rope, lamp = np.split(bridge.inverse_masses, [5, 10])
    assert deck[1:-1].tolist() == [0.5] * 3 and rope[1:-1].tolist() == [1.0] * 3
    assert lamp.tolist() == [0.5, 0.5, 0.125]
    assert np.all(np.diff(bridge.positions[10:, 1]) < 0.0) and np.all(bridge.positions[10:, 0] == 2.0)


def test_a_ring_goes_round():
    ring = shapes.ring((1.0, 2.0), 0.5, 3)
    assert np.allclose(np.linalg.norm(ring.positions - (1.0, 2.0), axis=1), 0.5)
    assert sorted(map(sorted, ring.links.tolist())) == [[0, 1], [0, 2], [1, 2]]


@pytest.mark.parametrize(
    ("make", "what"),
    [
        (lambda: shapes.rope((0, 0), (1, 0), 0), "links = 0"),
        (lambda: shapes.rope((0, 0), (1, 0), 400), "links = 400"),
        (lambda: shapes.rope((0, 0), (1, 0), 4, pins="last"), "pins = 'last'"),
        (lambda: shapes.rope((0, 0), (1, 0), 4, mass=0.0), "mass = 0.0"),
        (lambda: shapes.cloth((0, 0), 1, 5, 0.1), "columns = 1"),
        (lambda: shapes.cloth((0, 0), 5, 5, 0.1, pins="all"), "pins = 'all'"),
        (lambda: shapes.cloth((0, 0), 5, 5, 0.1, mass=math.nan), "mass = nan"),
        (lambda: shapes.bridge((0, 0), (1, 0), 4, 1.0, mass=-1.0), "mass = -1.0"),
        (lambda: shapes.bridge((0, 0), (1, 0), 4, 1.0, lamps=-1), "lamps = -1"),
        (lambda: shapes.bridge((0, 0), (1, 0), 4, 1.0, lamps=1, lamp_mass=0.0), "lamp_mass = 0.0"),
        (lambda: shapes.ring((0, 0), 1.0, 2), "corners = 2"),
        (lambda: shapes.ring((0, 0), 1.0, 8, mass=math.inf), "mass = inf"),
        (lambda: shapes.joined([]), "shapes"),
    ],
)
def test_what_makes_no_sense_is_refused(make, what: str):
    with pytest.raises(ValueError, match=what):
        make()
