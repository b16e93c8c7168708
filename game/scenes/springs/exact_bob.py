"""Where the bob of a pendulum should be now, exactly."""

from __future__ import annotations

import math

from game.physics.constraints import DAMPING
from game.physics.fields import GRAVITY
from game.physics.oscillators import pendulum_angle
from game.scenes.springs.level import Point
from game.scenes.springs.model import SpringModel
from game.ui.canvas.canvas import EXACT_DASH, Canvas


def exact_bob(model: SpringModel) -> Point | None:
    """Place (m) of the second particle, let go at rest on a link to the first, by elliptic functions; None
    where it is not known: without gravity, damped, or once somebody took part."""
    parameters, particles = model.parameters, model.content.particles
    damped = DAMPING in model.active and parameters.damping > 0.0
    known = model.undisturbed and not damped and GRAVITY in model.active and parameters.gravity > 0.0
    if not known or len(particles) < 2:
        return None
    (px, py), (bx, by) = particles[0].position, particles[1].position
    length = math.dist((px, py), (bx, by))
    if not length > 0.0:
        return None
    angle = pendulum_angle(math.atan2(bx - px, py - by), parameters.gravity / length, model.time)
    return px + length * math.sin(angle), py - length * math.cos(angle)


def draw_exact_bob(canvas: Canvas, model: SpringModel) -> None:
    """Its link dashed and a ring, named."""
    place = exact_bob(model)
    if place is None:
        return
    canvas.line(model.content.particles[0].position, place, "text1", 1.4, dash=EXACT_DASH, alpha=0.75)
    canvas.ring(place, 7.0, "text1", 1.4)
    canvas.label(place, "exact", "text2", 12, anchor="left", offset=(14.0, 12.0))
