"""A world of solids as a level makes it: stepped, driven, measured by its gauges."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.effects import EffectSet
from game.physics.solids import Disc, Material, SolidSettings, SolidState, SolidWorld, box
from game.physics.solids.state import ASLEEP, DYNAMIC
from game.scenes.shared.stopwatch import Stopwatch
from game.scenes.solids.bodies import (
    HIDDEN,
    OWN_FRICTION,
    OWN_RESTITUTION,
    joint_options,
    shapes_of,
    tint_of,
)
from game.scenes.solids.level import BodyEntry, GaugeEntry, JointEntry, Point, SolidContent
from game.scenes.solids.parameters import SolidParameters
from game.scenes.solids.structures import make
from game.stage import ParameterError, Part

Floats = NDArray[np.float64]
ANCHOR = 0  # the body that joints to the ground hang on
GROUND_DEPTH, WALL_WIDTH, ENDLESS = 20.0, 4.0, 4000.0  # m


class ModelState(NamedTuple):
    """world; tints: colour and own materials of each body; gauges: what they show; starts: (g, 3) poses."""

    world: SolidState
    tints: NDArray[np.int64]
    gauges: Floats


class Shake(NamedTuple):
    """A key-framed body's swing: place m, amplitude m, rate rad/s."""

    body: int
    place: Point
    amplitude: Point
    rate: float


class SolidModel(Part):
    """Bodies and joints of a level in a world.

    ids: of the level's bodies. time: s. snapped, bumps: of the last step.
    """

    def __init__(self, content: SolidContent, parameters: SolidParameters, active: EffectSet, seed: int):
        self.content, self.parameters, self.active = content, parameters, active
        self.watch = Stopwatch()
        self.world = SolidWorld(self._settings())
        self.tints: NDArray[np.int64] = np.zeros(0, dtype=np.int64)
        self.floors: list[int] = []
        self._lay_ground()
        made = make(content, seed)
        ids = [self.add(entry) for entry in made.bodies]
        self.shakes = [
            Shake(ids[k], entry.position, entry.swing.amplitude, entry.swing.rate)
            for k, entry in enumerate(made.bodies) if entry.swing is not None
        ]  # fmt: skip
        self.leaving = [(entry.gone_at, ids[k]) for k, entry in enumerate(made.bodies) if entry.gone_at > 0.0]
        joints = [self.join(entry, ids) for entry in made.joints]
        self.time = 0.0
        self.gauges: Floats = np.zeros(len(content.gauges))
        self._of = [self._gauged(gauge, ids, joints) for gauge in content.gauges]
        self._starts = [self._pose(body) for body in self._of]
        for k, gauge in enumerate(content.gauges):
            self.gauges[k] = self._measure(k, gauge, self._of[k])

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

    def _gauged(self, gauge: GaugeEntry, ids: list[int], joints: list[int]) -> int:
        things = joints if gauge.measure == "force" else ids
        if gauge.of >= len(things) and gauge.measure not in ("passed", "fallen", "highest"):
            raise ValueError(f"gauges: {gauge.name!r} is of {gauge.of}; there are {len(things)}")
        return things[gauge.of] if gauge.of < len(things) else ANCHOR

    def _pose(self, body: int) -> tuple[float, float, float]:
        rows = self.world.bodies
        if body >= len(rows.angles):
            return 0.0, 0.0, 0.0
        x, y = rows.positions[body].tolist()
        return x, y, float(rows.angles[body])

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
        self._of = [ANCHOR if of == body and gauge.measure != "force" else of
                    for of, gauge in zip(self._of, self.content.gauges, strict=True)]  # fmt: skip

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> int:
        """One step; how many joints have broken in it."""
        for leaves_at, body in list(self.leaving):
            if self.time + 0.5 * dt >= leaves_at:
                self.remove(body)
        for shake in self.shakes:
            self._drive(shake, dt)
        whole = int(np.count_nonzero(self.world.joints.flags & 8))
        with self.watch.time("step"):
            self.world.step(dt)
        self.time += dt
        for k, gauge in enumerate(self.content.gauges):
            if gauge.until == 0.0 or self.time <= gauge.until + 0.25 * dt:
                self.gauges[k] = self._measure(k, gauge, self._of[k])
        return int(np.count_nonzero(self.world.joints.flags & 8)) - whole

    def _drive(self, shake: Shake, dt: float) -> None:
        """Give a key-framed body the velocity that takes it to where it is to be."""
        height = math.sin(shake.rate * (self.time + dt))
        x, y = self.world.bodies.positions[shake.body].tolist()
        speed = (
            (shake.place[0] + shake.amplitude[0] * height - x) / dt,
            (shake.place[1] + shake.amplitude[1] * height - y) / dt,
        )
        self.world.set_velocity(shake.body, speed)

    def _measure(self, k: int, gauge: GaugeEntry, of: int) -> float:
        rows, measure = self.world.bodies, gauge.measure
        dynamic = rows.flags & DYNAMIC != 0
        if measure == "passed":
            return int(np.count_nonzero(rows.positions[dynamic, 0] > gauge.level))
        if measure == "fallen":
            return int(np.count_nonzero(rows.positions[dynamic, 1] < gauge.level))
        if measure == "highest":
            return float(rows.positions[dynamic, 1].max(initial=-math.inf)) if dynamic.any() else 0.0
        if measure == "force":
            return self.world.joint_load(of)[0] if self._holds(of) else 0.0
        if of == ANCHOR:
            return float(self.gauges[k])
        x, y, angle = (now - then for now, then in zip(self._pose(of), self._starts[k], strict=True))
        if measure == "when":
            return self.time if self.gauges[k] == 0.0 and math.hypot(x, y) >= gauge.level else self.gauges[k]
        return float({
            "right": x, "up": y, "sink": -y, "way": math.hypot(x, y), "turn": math.degrees(angle),
            "speed": math.hypot(*rows.velocities[of].tolist()), "spin": float(rows.spins[of]),
        }[measure])  # fmt: skip

    def _holds(self, joint: int) -> bool:
        rows = self.world.joints
        return joint < len(rows.kinds) and rows.kinds[joint] >= 0 and not rows.flags[joint] & 8

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
        return ModelState(self.world.state(), self.tints, self.gauges)

    def restore(self, state: Any) -> None:
        """Take over a copy of a state."""
        self.world.restore(state.world)
        self.tints = state.tints.copy()
        np.copyto(self.gauges, state.gauges)
