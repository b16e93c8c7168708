"""A world of solids as a level makes it: stepped, driven, measured by its gauges."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.effects import EffectSet
from game.physics.kernels import elementary
from game.physics.solids import Disc, Material, SolidSettings, SolidState, SolidWorld, box
from game.physics.solids.state import ASLEEP, DYNAMIC
from game.scenes.solids.bodies import (
    COLOURS,
    HIDDEN,
    OWN_FRICTION,
    OWN_RESTITUTION,
    joint_options,
    shapes_of,
    tint_of,
)
from game.scenes.solids.gauges import Gauges
from game.scenes.solids.level import BodyEntry, JointEntry, Point, SolidContent
from game.scenes.solids.measures import HEARD_WIDTH, STEEL, STONE, THUD, WOOD, heard_now
from game.scenes.solids.parameters import SolidParameters
from game.scenes.solids.structures import make
from game.stage import ParameterError, Part
from game.worlds.stopwatch import Stopwatch

Floats = NDArray[np.float64]
ANCHOR = 0  # the body that joints to the ground hang on
GROUND_DEPTH, WALL_WIDTH, ENDLESS = 20.0, 4.0, 4000.0  # m
SOUNDS = np.array(
    [{"stone": STONE, "steel": STEEL, "brass": STEEL}.get(name, WOOD) for name in COLOURS], dtype=np.int64
)


class ModelState(NamedTuple):
    """world; tints: colour and own materials of each body; gauges: what they show; marks: see `Gauges`;
    heard: see `heard_now`.
    """

    world: SolidState
    tints: NDArray[np.int64]
    gauges: Floats
    marks: Floats
    heard: Floats


class Shake(NamedTuple):
    """A key-framed body's swing about a place: m, amplitude m, rate rad/s, phase rad."""

    body: int
    place: Point
    amplitude: Point
    rate: float
    phase: float


class SolidModel(Part):
    """Bodies and joints of a level in a world. floors: bodies of the ground and the walls; time: s."""

    def __init__(self, content: SolidContent, parameters: SolidParameters, active: EffectSet, seed: int):
        self.content, self.parameters, self.active = content, parameters, active
        self.watch = Stopwatch()
        self.world = SolidWorld(self._settings())
        self.tints: NDArray[np.int64] = np.zeros(0, dtype=np.int64)
        self.floors: list[int] = []
        self._lay_ground()
        made = make(content, seed)
        ids = [self.add(entry) for entry in made.bodies]
        bodies = list(zip(made.bodies, ids, strict=True))
        self.shakes = [self._shake(entry, body) for entry, body in bodies if entry.swing is not None]
        self.leaving = [(entry.gone_at, body) for entry, body in bodies if entry.gone_at > 0.0]
        self.freed = [(entry.free_at, body) for entry, body in bodies if entry.free_at > 0.0]
        joints = [self.join(entry, ids) for entry in made.joints]
        self.heard: Floats = np.zeros((0, HEARD_WIDTH))
        self.gauges = Gauges(self.world, content.gauges, ids, joints)

    @property
    def time(self) -> float:
        """s; the world's own, which goes back with its state."""
        return self.world.time

    # -- building -------------------------------------------------------------------------------------

    def _lay_ground(self) -> None:
        """What joints hang on, the floor and the walls."""
        nothing = Material(mask=0, category=0)
        self.world.add_body(Disc(0.01, material=nothing), kind="fixed")
        self._tint(ANCHOR, HIDDEN)
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
            self._tint(body, tint)

    def _tint(self, body: int, tint: int) -> None:
        if body >= len(self.tints):
            self.tints = np.concatenate([self.tints, np.zeros(body + 1 - len(self.tints), dtype=np.int64)])
        self.tints[body] = tint

    def _shake(self, entry: BodyEntry, body: int) -> Shake:
        assert entry.swing is not None
        (ax, ay), phase = entry.swing.amplitude, math.radians(entry.swing.phase)
        x, y = self.world.bodies.positions[body].tolist()
        middle = x - ax * elementary.sin(phase), y - ay * elementary.sin(phase)
        return Shake(body, middle, entry.swing.amplitude, entry.swing.rate, phase)

    def add(self, entry: BodyEntry) -> int:
        """A body; its id. ValueError for nonsense."""
        body = self.world.add_body(
            shapes_of(entry, self.parameters.friction, self.parameters.restitution),
            entry.position,
            math.radians(entry.angle),
            entry.velocity,
            entry.spin,
            kind=entry.kind,
            gravity_scale=entry.gravity_scale,
        )
        self._tint(body, tint_of(entry))
        return body

    def join(self, entry: JointEntry, ids: list[int]) -> int:
        """A joint between bodies of these ids (-1: the ground); its id. ValueError."""
        if max(entry.bodies) >= len(ids):
            raise ValueError(f"joints: there is no body {max(entry.bodies)}")
        a, b = (ANCHOR if k < 0 else ids[k] for k in entry.bodies)
        return self.world.add_joint(entry.kind, a, b, entry.at, entry.other, **joint_options(entry))

    # -- changes --------------------------------------------------------------------------------------

    def _settings(self) -> SolidSettings:
        parameters = self.parameters
        try:
            return SolidSettings(
                effects=self.active,
                solver=parameters.solver,
                substeps=parameters.substeps_now(),
                iterations=int(parameters.iterations),
                gravity=(0.0, -parameters.gravity),
                contact_hertz=parameters.stiffness,
            )
        except ValueError as error:
            raise ParameterError(str(error)) from None

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value."""
        self.world.settings = self._settings()
        self.watch.clear()
        shapes = self.world.shapes
        for field, bit, rows in (
            ("friction", OWN_FRICTION, shapes.frictions),
            ("restitution", OWN_RESTITUTION, shapes.restitutions),
        ):
            if name == field:
                rows[self.tints[shapes.bodies] & bit == 0] = getattr(self.parameters, name)

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        self.active = active
        self.world.settings = self._settings()
        self.watch.clear()

    def remove(self, body: int) -> None:
        """Take a body away; its gauges stay as they are."""
        self.world.remove_body(body)
        self.shakes = [shake for shake in self.shakes if shake.body != body]
        self.leaving = [row for row in self.leaving if row[1] != body]
        self.freed = [row for row in self.freed if row[1] != body]
        self.gauges.forget(body)

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> int:
        """One step; how many joints have broken in it."""
        for leaves_at, body in list(self.leaving):
            if self.time + 0.5 * dt >= leaves_at:
                self.remove(body)
        for free_at, body in list(self.freed):
            if self.time + 0.5 * dt >= free_at:
                self._set_free(body)
        for shake in self.shakes:
            self._drive(shake, dt)
        with self.watch.time("step"):
            self.world.step(dt)
        self.gauges.measure(self.world, self.time, dt)
        kinds = SOUNDS[self.tints & 255]
        kinds[self.floors] = THUD
        self.heard = heard_now(self.world, self.heard, self.time - dt, kinds)
        return len(self.world.joints_broken())

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

    def movable(self) -> NDArray[np.int64]:
        """Ids of all bodies but the ground."""
        ids = self.world.ids()
        mine: NDArray[np.int64] = ids[~np.isin(ids, [ANCHOR, *self.floors])]
        return mine

    def awake(self) -> int:
        """How many dynamic bodies are computed."""
        return int(np.count_nonzero(self.world.bodies.flags & (DYNAMIC | ASLEEP) == DYNAMIC))

    def state(self) -> ModelState:
        """All that later steps depend on."""
        return ModelState(self.world.state(), self.tints, self.gauges.values, self.gauges.marks, self.heard)

    def restore(self, state: Any) -> None:
        """Take over a copy of a state."""
        self.world.restore(state.world)
        self.tints = state.tints.copy()
        self.gauges.restore(state.gauges, state.marks)
        self.heard = state.heard.copy()
