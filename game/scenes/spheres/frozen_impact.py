"""A collision at which time stands still: its normal, speeds, impulse and friction cone in the picture."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.physics.spheres import ledger
from game.scenes.spheres.ledger import entry_of
from game.scenes.spheres.model import CollisionModel
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_si

LENGTH = 0.13  # of the height in view: the normal, and the impulse


class Impact(NamedTuple):
    """A collision in the plane. point: m; normal: unit vector from the first sphere to the other or the wall;
    impulse: N s on the other; before, after: separating speed, m/s; friction: μ of the pair."""

    point: np.ndarray
    normal: np.ndarray
    impulse: np.ndarray
    before: float
    after: float
    friction: float

    @property
    def along(self) -> float:
        """Impulse along the normal, N s."""
        return float(self.impulse @ self.normal)

    @property
    def across(self) -> float:
        """Impulse of friction, N s."""
        return math.sqrt(max(float(self.impulse @ self.impulse) - self.along**2, 0.0))


def impact_of(model: CollisionModel) -> Impact | None:
    """The collision at which a model stands still; None while it goes on."""
    entry = entry_of(model, model.frozen) if model.frozen else None
    if entry is None:
        return None
    world = model.world
    composition, since = world.bodies.composition, world.time - float(entry[ledger.TIME])
    places = world.bodies.places()[:, :2] - since * world.bodies.velocities[composition.owners, :2]
    one, other = int(entry[ledger.ONE]), int(entry[ledger.OTHER])
    point = entry[[ledger.X, ledger.Y]]
    normal = (places[other] if other >= 0 else point) - places[one]
    length = math.sqrt(float(normal @ normal))
    normal = normal / length if length > 0.0 else np.array((0.0, 1.0))
    kinds = composition.kinds
    wall = world.tables.friction.shape[0] - 1
    friction = float(world.tables.friction[kinds[one], kinds[other] if other >= 0 else wall])
    impulse = entry[[ledger.JX, ledger.JY]]
    return Impact(point, normal, impulse, float(entry[ledger.BEFORE]), float(entry[ledger.AFTER]), friction)


def draw_impact_frozen(model: CollisionModel, canvas: Canvas) -> None:
    """Normal, impulse and friction cone at the contact, their numbers beside it; nothing while it goes on."""
    impact = impact_of(model)
    if impact is None:
        return
    view = model.content.view
    length = LENGTH * (view.top - view.bottom)
    point, normal = impact.point, impact.normal
    half = math.atan(impact.friction)
    sides = [point + 1.2 * length * _turned(normal, angle) for angle in (-half, half)]
    canvas.polygon(np.array((point, *sides)), fill="green", fill_alpha=0.18, outline="green", width=1.2)
    across = _turned(normal, 0.5 * math.pi)
    canvas.line(point - length * across, point + length * across, "text3", 1.2, dash=(5.0, 4.0))
    canvas.arrow(point, tuple(1.5 * length * normal), "text1", "n", width=1.8)
    size = math.sqrt(float(impact.impulse @ impact.impulse))
    if size > 0.0:
        canvas.arrow(point, tuple(impact.impulse), "amber", "j", 0.75 * length / size)
    canvas.contact(tuple(point), chosen=True)
    if canvas.words:
        _write(canvas, impact)


def _write(canvas: Canvas, impact: Impact) -> None:
    most = format_si(impact.friction * impact.along, "N s")
    lines = (
        f"v_n  {format_si(impact.before, 'm/s')}, then {format_si(impact.after, 'm/s')}",
        f"j  {format_si(impact.along, 'N s')} along n",
        f"j_t  {format_si(impact.across, 'N s')}, at most μ j = {most}",
        "G goes on",
    )
    dx, dy = canvas.room_for(tuple(impact.point), (240.0, 76.0), (150.0, 116.0))
    for i, words in enumerate(lines):
        color = "amber" if i == 1 else "accent" if i == len(lines) - 1 else "text1"
        offset = (dx - 116.0, dy - 30.0 + 19.0 * i)
        canvas.label(tuple(impact.point), words, color, 12, "semibold", anchor="left", offset=offset)


def _turned(vector: np.ndarray, angle: float) -> np.ndarray:
    """A vector (2,) turned by an angle (rad)."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array((c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]))
