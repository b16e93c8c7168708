"""A ball that falls along an arc is not held in the air by continuous collision."""

from __future__ import annotations

import math

from game.physics.solids import Chain, Disc, SolidWorld


def test_a_ball_comes_down_a_quarter_of_a_circle() -> None:
    """Chords of 3 degrees: the ball is often as near to the next one as continuous collision brings it."""
    world = SolidWorld()
    angles = [math.radians(3.0 * k) for k in range(31)]
    arc = [(3.0 * math.sin(a), 3.0 - 3.0 * math.cos(a)) for a in angles]
    world.add_body(Chain([(-40.0, 0.0), *arc, (3.0, 8.0)]), kind="fixed")
    for k in range(40):
        ball = world.add_body(Disc(0.45), (1.5 + 0.02 * k, 6.0), velocity=(2.4, 0.0))
        for _ in range(180):
            world.step(1.0 / 60.0)
        x, y = world.bodies.positions[ball].tolist()
        assert x < 1.0 and y < 0.5, f"ball {k} hangs at {x:.2f}, {y:.2f} m"
        world.remove_body(ball)
