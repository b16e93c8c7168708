"""Puts what a level says into a world of solids."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels import elementary
from game.physics.solids import Chain, Disc, Material, Polygon, SolidWorld, box
from game.scenes.domino.course import Standing, height_at, row_places
from game.scenes.domino.level import BallEntry, DominoContent, PlankEntry, RowEntry, SingleEntry, SliderEntry
from game.scenes.domino.parameters import DominoParameters
from game.scenes.domino.tables import DENSITIES, DOMINO_WIDTH, NOT_YET

Floats = NDArray[np.float64]
LEAST_FRICTION = 1e-6  # of a pair the geometric mean counts: what is rough enough makes up for the smooth
ALL = 2**62 - 1  # bits of all that a slider may meet


def floor_grip(wanted: float, friction: float) -> float:
    """Friction of a floor so that with dominoes of ``friction`` it comes to ``wanted``."""
    return min(wanted * wanted / max(friction, LEAST_FRICTION), 1e9)


def slider_grip(wanted: float, lane: float) -> float:
    """Friction of a block so that with a lane of friction ``lane`` it comes to ``wanted``."""
    return wanted * wanted / lane if lane > 0.0 else 0.0


def surface_at(floor: Floats, planks: list[PlankEntry], x: float) -> tuple[float, float]:
    """Height (m) and slope (rad) of what a domino stands on at x: the floor, or a plank over a gap in it."""
    for plank in planks:
        if abs(x - plank.at[0]) <= 0.5 * plank.length:
            return plank.at[1], 0.0
    return height_at(floor, x)


def domino_shape(thick: float, tall: float, density: float, friction: float) -> Polygon:
    """An upright one about its centre."""
    return box(thick, tall, material=Material(density, max(friction, LEAST_FRICTION)))


def centre_of(place: Standing, tall: float) -> tuple[float, float]:
    """Centre of a domino that stands at a place, m."""
    half = 0.5 * tall
    return place.x - half * elementary.sin(place.lean), place.y + half * elementary.cos(place.lean)


def add_domino(
    world: SolidWorld, place: Standing, size: tuple[float, float], density: float, friction: float
) -> int:
    """Stand a domino (thickness, height m) at a place; its body."""
    shape = domino_shape(*size, density, friction)
    return world.add_body(shape, centre_of(place, size[1]), place.lean)


def row_table(
    world: SolidWorld, content: DominoContent, number: int, floor: Floats, parameters: DominoParameters
) -> Floats:
    """Stand the dominoes of a row; a row of the table for each, see `tables`."""
    row: RowEntry = content.rows[number]
    gap = parameters.spacing if row.gap is None else row.gap
    planks = [plank for plank in content.planks if plank.floor == row.floor and not plank.seesaw]
    table = np.zeros((row.count, DOMINO_WIDTH))
    before: Standing | None = None
    for k, flat in enumerate(row_places(row, floor, gap)):
        y, slope = surface_at(floor, planks, flat.x)
        place = Standing(flat.x, y, slope, flat.larger)
        thick, tall = (part * place.larger for part in row.size)
        body = add_domino(world, place, (thick, tall), row.density, parameters.friction)
        pitch = abs(place.x - before.x) if before is not None else 0.0
        level = before is not None and slope == 0.0 and before.lean == 0.0 and abs(y - before.y) < 1e-9
        table[k] = (
            body, number, row.to, pitch, place.x, y, slope, thick, tall, NOT_YET,
            1.0 if level and row.grows == 1.0 else 0.0,
        )  # fmt: skip
        before = place
    return table


def single_table(world: SolidWorld, content: DominoContent, friction: float) -> Floats:
    """Stand the dominoes that a level names one by one; their row is the one after all others."""
    table = np.zeros((len(content.singles), DOMINO_WIDTH))
    before: SingleEntry | None = None
    for k, one in enumerate(content.singles):
        (x, y), lean = one.at, math.radians(one.lean)
        body = add_domino(world, Standing(x, y, lean, 1.0), one.size, 1.0, friction)
        alike = before is not None and before.to == one.to and before.size == one.size
        way = abs(x - before.at[0]) if before is not None and alike else 0.0
        level = alike and before is not None and lean == before.lean == 0.0 and abs(y - before.at[1]) < 1e-9
        row = (body, len(content.rows), one.to, way, x, y, lean, *one.size, NOT_YET, 1.0 if level else 0.0)
        table[k], before = row, one
    return table


def add_ball(world: SolidWorld, entry: BallEntry, floor: Floats, parameters: DominoParameters) -> int:
    """A ball on a floor; its body."""
    y, slope = height_at(floor, entry.x)
    material = Material(
        DENSITIES[entry.made_of], max(parameters.friction, LEAST_FRICTION), parameters.restitution
    )
    place = entry.x - entry.radius * elementary.sin(slope), y + entry.radius * elementary.cos(slope)
    speed = entry.velocity
    return world.add_body(
        Disc(entry.radius, material=material), place, 0.0,
        (speed * elementary.cos(slope), speed * elementary.sin(slope)), -speed / entry.radius,
    )  # fmt: skip


def add_plank(world: SolidWorld, anchor: int, entry: PlankEntry, grip: float) -> int:
    """A plank that lies there, or turns about a pin; its body."""
    material = Material(entry.density, grip)
    x, y = entry.at
    if not entry.seesaw:
        shape = box(entry.length, entry.thickness, material=material)
        return world.add_body(shape, (x, y - 0.5 * entry.thickness))
    half, thick = 0.5 * entry.length, 0.5 * entry.thickness
    shift = -0.02 * entry.length  # a little heavier on its left
    corners = [(shift - half, -thick), (shift + half, -thick), (shift + half, thick), (shift - half, thick)]
    body = world.add_body(Polygon(corners, material=material), (x, y), math.radians(entry.lean))
    world.add_joint("pin", anchor, body, (x, y))
    return body


def add_slider(world: SolidWorld, entry: SliderEntry, number: int, floor: Floats, lane: float) -> int:
    """A block in its lane; its body."""
    y, slope = height_at(floor, entry.x)
    others = sum(2 << k for k in range(12) if k != number)
    material = Material(entry.density, slider_grip(entry.friction, lane), 0.0, 2 << number, ALL & ~others)
    thick, tall = entry.size
    if entry.speed > 0.0:  # it lies flat
        lift = 0.5 * thick
        place = entry.x - lift * elementary.sin(slope), y + lift * elementary.cos(slope)
        velocity = entry.speed * elementary.cos(slope), entry.speed * elementary.sin(slope)
        return world.add_body(box(tall, thick, material=material), place, slope, velocity)
    standing = Standing(entry.x, y, slope, 1.0)
    return world.add_body(box(thick, tall, material=material), centre_of(standing, tall), slope)


def chain_of(points: Floats, grip: float) -> Chain:
    """A floor's shape."""
    return Chain(points, material=Material(1.0, grip))
