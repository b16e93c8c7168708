"""A world of solids as a level makes it: stepped, driven, measured by its gauges."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.physics.effects import EffectSet
from game.physics.kernels import elementary
from game.physics.solids import Material, SolidState, box
from game.scenes.solids import bodies, measures
from game.scenes.solids.bodies import COLOUR_BITS, COLOURS, HIDDEN, OWN_FRICTION, OWN_RESTITUTION
from game.scenes.solids.gauges import Gauges
from game.scenes.solids.level import BodyEntry, JointEntry, Point, SolidContent
from game.scenes.solids.measures import sounds_now
from game.scenes.solids.parameters import SolidParameters
from game.scenes.solids.structures import make
from game.worlds.hearing import Heard
from game.worlds.members.solids import Solids
from game.worlds.world import Member, World

ANCHOR = 0  # the body that joints to the ground hang on
GROUND_DEPTH, WALL_WIDTH, ENDLESS = 20.0, 4.0, 4000.0  # m
SOUNDS = np.array(
    [
        {"stone": measures.STONE, "steel": measures.STEEL, "brass": measures.STEEL}.get(name, measures.WOOD)
        for name in COLOURS
    ],
    dtype=np.int64,
)


class ModelState(NamedTuple):
    """world; tints: colour and own materials of each body; gauges: what they show; marks: see `Gauges`;
    heard: (k, HEARD_WIDTH).
    """

    world: SolidState
    tints: Longs
    gauges: Floats
    marks: Floats
    heard: Floats


class Tints(Member):
    """``rows`` (n,): colour of each body, and which of its materials are its own."""

    kept = ("rows",)

    def __init__(self) -> None:
        self.rows: Longs = np.zeros(0, dtype=np.int64)

    def set(self, body: int, tint: int) -> None:
        """Of one body."""
        if body >= len(self.rows):
            self.rows = np.concatenate([self.rows, np.zeros(body + 1 - len(self.rows), dtype=np.int64)])
        self.rows[body] = tint


class Shake(NamedTuple):
    """A key-framed body's swing about a place: m, amplitude m, rate rad/s, phase rad."""

    body: int
    place: Point
    amplitude: Point
    rate: float
    phase: float


class SolidModel(World):
    """Bodies and joints of a level in a world. floors: bodies of the ground and the walls."""

    state_type = ModelState
    content: SolidContent
    parameters: SolidParameters

    def __init__(self, content: SolidContent, parameters: SolidParameters, active: EffectSet, seed: int):
        super().__init__(content, parameters, active)
        self.solids, self.tints, self.heard = Solids(parameters, active), Tints(), Heard()
        self.world = self.solids.world
        self.floors: list[int] = []
        self._lay_ground()
        made = make(content, seed)
        ids = [self.add(entry) for entry in made.bodies]
        rows = list(zip(made.bodies, ids, strict=True))
        self.shakes = [self._shake(entry, body) for entry, body in rows if entry.swing is not None]
        self.leaving = [(entry.gone_at, body) for entry, body in rows if entry.gone_at > 0.0]
        self.freed = [(entry.free_at, body) for entry, body in rows if entry.free_at > 0.0]
        joints = [self.join(entry, ids) for entry in made.joints]
        blocks = ids[len(content.bodies) :]
        self.gauges = Gauges(self.world, content.gauges, ids, joints, blocks)
        self.members = (self.solids, self.tints, self.gauges, self.heard)

    # -- building -------------------------------------------------------------------------------------

    def _lay_ground(self) -> None:
        """What joints hang on, the floor and the walls."""
        self.tints.set(self.solids.anchor(), HIDDEN)
        content, base = self.content, self.content.floor
        own = content.floor_friction
        material = Material(1.0, self.parameters.friction if own is None else own)
        tint = 0 if own is None else OWN_FRICTION
        slabs = []
        if base is not None:
            slabs.append((box(ENDLESS, GROUND_DEPTH, material=material), (0.0, base - 0.5 * GROUND_DEPTH)))
        for side, x in zip((-1.0, 1.0), content.walls or (), strict=False):
            slab = box(WALL_WIDTH, 2000.0, material=material)
            slabs.append((slab, (x + side * 0.5 * WALL_WIDTH, (base or 0.0) + 900.0)))
        for shape, place in slabs:
            body = self.world.add_body(shape, place, kind="fixed")
            self.floors.append(body)
            self.tints.set(body, tint)

    def _shake(self, entry: BodyEntry, body: int) -> Shake:
        assert entry.swing is not None
        (ax, ay), phase = entry.swing.amplitude, math.radians(entry.swing.phase)
        x, y = self.world.bodies.positions[body].tolist()
        middle = x - ax * elementary.sin(phase), y - ay * elementary.sin(phase)
        return Shake(body, middle, entry.swing.amplitude, entry.swing.rate, phase)

    def add(self, entry: BodyEntry) -> int:
        """A body; its id. ValueError for nonsense."""
        body = self.world.add_body(
            bodies.shapes_of(entry, self.parameters.friction, self.parameters.restitution),
            entry.position,
            math.radians(entry.angle),
            entry.velocity,
            entry.spin,
            kind=entry.kind,
            gravity_scale=entry.gravity_scale,
        )
        self.tints.set(body, bodies.tint_of(entry))
        return body

    def join(self, entry: JointEntry, ids: list[int]) -> int:
        """A joint between bodies of these ids (-1: the ground); its id. ValueError."""
        if max(entry.bodies) >= len(ids):
            raise ValueError(f"joints: there is no body {max(entry.bodies)}")
        a, b = (ANCHOR if k < 0 else ids[k] for k in entry.bodies)
        return self.world.add_joint(entry.kind, a, b, entry.at, entry.other, **bodies.joint_options(entry))

    # -- changes --------------------------------------------------------------------------------------

    def change_parameter(self, name: str) -> None:
        super().change_parameter(name)
        shapes = self.world.shapes
        for field, bit, rows in (
            ("friction", OWN_FRICTION, shapes.frictions),
            ("restitution", OWN_RESTITUTION, shapes.restitutions),
        ):
            if name == field:
                rows[self.tints.rows[shapes.bodies] & bit == 0] = getattr(self.parameters, name)

    def give_own(self, body: int, name: str) -> str:
        """Give a body what the parameter of that name says is its own; why it cannot have it, or ""."""
        value, tint = self.parameters.values[name], int(self.tints.rows[body])
        field = name.removeprefix("own_")
        if field == "colour":
            self.tints.set(body, (tint & ~COLOUR_BITS) | COLOURS.index(value))
            return ""
        try:
            self.world.set_material(body, **{field: value})
        except ValueError as error:
            return f"{str(error)[:1].upper()}{str(error)[1:]}."
        self.tints.set(body, tint | {"friction": OWN_FRICTION, "restitution": OWN_RESTITUTION}.get(field, 0))
        return ""

    def show_own(self, body: int) -> None:
        """Let the parameters of the card say what a body has, as near as they can say it."""
        shapes, parameters = self.world.shapes, self.parameters
        first = self.world.shapes_of(body)[0]
        for name, rows in (
            ("own_density", shapes.densities),
            ("own_friction", shapes.frictions),
            ("own_restitution", shapes.restitutions),
        ):
            ends = getattr(type(parameters), name)
            setattr(parameters, name, min(max(float(rows[first]), ends.minimum), ends.maximum))
        parameters.own_colour = COLOURS[int(self.tints.rows[body]) & COLOUR_BITS]

    def remove(self, body: int) -> None:
        """Take a body away; its gauges stay as they are."""
        self.world.remove_body(body)
        self.shakes = [shake for shake in self.shakes if shake.body != body]
        self.leaving = [row for row in self.leaving if row[1] != body]
        self.freed = [row for row in self.freed if row[1] != body]
        self.gauges.forget(body)

    def restore(self, state: Any) -> None:
        super().restore(state)
        self.time = self.world.time

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        for leaves_at, body in list(self.leaving):
            if self.time + 0.5 * dt >= leaves_at:
                self.remove(body)
        for free_at, body in list(self.freed):
            if self.time + 0.5 * dt >= free_at:
                self._set_free(body)
        for shake in self.shakes:
            self._drive(shake, dt)
        super().advance(dt)
        self.time = self.world.time  # which goes back with its state
        kinds = SOUNDS[self.tints.rows & COLOUR_BITS]
        kinds[self.floors] = measures.THUD
        self.heard.remember(sounds_now(self.world, self.time - dt, kinds), self.time - dt)
        return "A joint is broken." if len(self.world.joints_broken()) else ""

    def _set_free(self, body: int) -> None:
        """A key-framed body goes on by itself, as it goes now."""
        self.world.set_kind(body, "dynamic")
        self.freed = [row for row in self.freed if row[1] != body]
        self.shakes = [shake for shake in self.shakes if shake.body != body]

    def _drive(self, shake: Shake, dt: float) -> None:
        """Give a key-framed body the velocity that takes it to where it is to be."""
        height = elementary.sin(shake.rate * (self.time + dt) + shake.phase)
        x, y = self.world.bodies.positions[shake.body].tolist()
        speed = (
            (shake.place[0] + shake.amplitude[0] * height - x) / dt,
            (shake.place[1] + shake.amplitude[1] * height - y) / dt,
        )
        self.world.set_velocity(shake.body, speed)

    # -- what is there --------------------------------------------------------------------------------

    def movable(self) -> Longs:
        """Ids of all bodies but the ground."""
        ids = self.world.ids()
        mine: Longs = ids[~np.isin(ids, [ANCHOR, *self.floors])]
        return mine
