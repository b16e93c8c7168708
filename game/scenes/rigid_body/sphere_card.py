"""What one sphere adds to the body: volume, mass, and its part of the moment of inertia."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.physics.rigid import quaternion_to_matrix
from game.physics.rigid.motion import P, Q
from game.scenes.rigid_body.level import RADIUS, SHARE
from game.scenes.rigid_body.model import RigidModel
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_number, format_si

LINE = 18.0  # design px


class SphereCard(NamedTuple):
    """volume m³, mass kg; distance m of its centre from the axis; own, offset: 2/5 m r² and m d², kg m²."""

    volume: float
    mass: float
    distance: float
    own: float
    offset: float
    spins: bool  # the axis is that of the spin; else the vertical one


def card_of(model: RigidModel, pane: int, sphere: int) -> SphereCard:
    """Of a sphere of the body in a pane, about the axis through the centre of mass along the spin."""
    bodies, body = model.bodies, model.bodies.all[pane]
    radius, share = (float(bodies.design[sphere, column]) for column in (RADIUS, SHARE))
    volume = 4.0 / 3.0 * math.pi * radius**3
    mass = bodies.density * share * volume
    spin = np.array(body.angular_velocity)
    size = math.sqrt(float(spin @ spin))
    axis = spin / size if size > 0.0 else np.array((0.0, 1.0, 0.0))
    out = quaternion_to_matrix(bodies.rows[pane, Q:P]) @ body.offsets[sphere]
    away = out - (out @ axis) * axis
    distance = math.sqrt(float(away @ away))
    return SphereCard(volume, mass, distance, 0.4 * mass * radius**2, mass * distance**2, size > 0.0)


def draw_sphere_card(canvas: Canvas, model: RigidModel, pane: int, sphere: int, place: np.ndarray) -> None:
    """The numbers beside a place (2,) m of the picture."""
    card = card_of(model, pane, sphere)
    axis = "of the spin" if card.spins else "upright"
    lines = (
        f"V {format_number(card.volume)} m³,  m {format_si(card.mass, 'kg')}",
        f"d {format_si(card.distance, 'm')} from the axis {axis}",
        f"2/5 m r²  {format_number(card.own)} kg m²",
        f"m d²  {format_number(card.offset)} kg m²",
        f"together  {format_number(card.own + card.offset)} kg m²",
    )
    dx, dy = canvas.room_for(tuple(place), (230.0, LINE * len(lines)), (170.0, 70.0))
    for i, words in enumerate(lines):
        offset = (dx - 110.0, dy + LINE * (i - 0.5 * (len(lines) - 1)))
        canvas.label(tuple(place), canvas.figure(("card", i), words), "text1", 12, "semibold", "left", offset)
