"""The model of the sphere collisions: the world, what its parameters say, and the exact run beside it."""

from __future__ import annotations

import math
from typing import Any

import msgspec
import numpy as np

from game.physics.broadphase import BroadPhase, HierarchicalGrid, SweepAndPrune, UniformGrid
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.kernels import elementary
from game.physics.rigid import PUSHES
from game.physics.spheres.collisions import CollidingSpheres, CollisionState
from game.physics.spheres.composition import Composition
from game.physics.spheres.settings import Surroundings, Tables
from game.physics.spheres.smooth_spheres import SmoothSpheres
from game.physics.spheres.spheres import MotionState, SphereBodies
from game.scenes.spheres import pushes
from game.scenes.spheres.editing import joined, without
from game.scenes.spheres.layout import bodies_of, layout_of, tables_of
from game.scenes.spheres.level import MOST_SPHERES, CollisionContent
from game.scenes.spheres.parameters import NOT_SETTINGS, TABLE_PARAMETERS, CollisionParameters
from game.scenes.spheres.state import SphereState
from game.stage import Frame, ParameterError, Part
from game.stage.messages import Messages

NOTHING = np.zeros((0, 3))
MOST_EXACT = 2_000  # impacts in a step of the event-driven run
CELL = 1.15  # times the largest diameter: edge of the grid's cells


class CollisionModel(Part):
    """The spheres of a content, stepped as the parameters say.

    world: the colliding spheres. exact: the event-driven run that goes beside, or None. pushes: forces by
    hand that act now. frozen: number of the collision at which it stands still, or 0. messages: for the
    person, oldest first. ValueError and ParameterError for a content or parameters that the world refuses.
    """

    def __init__(
        self, content: CollisionContent, parameters: CollisionParameters, active: EffectSet, seed: int
    ):
        self.content, self.parameters, self.active = content, parameters, active
        self.messages = Messages()
        self.pushes: list[pushes.Push] = []
        self.frozen = 0
        self.exact: SmoothSpheres | None = None
        layout = layout_of(_with_lifted(content, int(parameters.lifted)), seed)
        bodies = bodies_of(layout, parameters.real, parameters.density)
        self.world = self._world_of(bodies, layout.surroundings)
        self._configure()
        if content.exact:
            self.begin_exact()

    # -- the world and its parameters ---------------------------------------------------------------

    def _world_of(self, bodies: SphereBodies, surroundings: Surroundings) -> CollidingSpheres:
        return CollidingSpheres(bodies, surroundings, self._tables(), self._broad_phase(bodies))

    def take_bodies(self, bodies: SphereBodies, surroundings: Surroundings) -> None:
        """Go on with these bodies and surroundings; what the world remembers of contacts is lost."""
        before = self.world
        self.world = self._world_of(bodies, surroundings)
        self.end_exact("there are other spheres")
        np.copyto(self.world.ring, before.ring)
        np.copyto(self.world.counters, before.counters)
        self._configure()

    def _tables(self) -> Tables:
        p = self.parameters
        return tables_of(self.content, p.restitution, p.friction, p.wall_restitution, p.wall_friction)

    def _broad_phase(self, bodies: SphereBodies) -> BroadPhase | None:
        name = self.parameters.broad_phase
        if name == "grid":
            view = self.content.view
            cell = CELL * 2.0 * float(bodies.composition.radii.max())
            cell = max(cell, (view.right - view.left) / 2_000.0, (view.top - view.bottom) / 2_000.0)
            return UniformGrid((view.left, view.bottom), (view.right, view.top), cell)
        if name == "hierarchical":
            return HierarchicalGrid()
        return SweepAndPrune() if name == "sweep-and-prune" else None

    def _configure(self) -> None:
        """Hand the parameters to the world; ParameterError if it refuses one."""
        p = self.parameters
        try:
            self.world.change(
                effects=self.active,
                scheme=p.scheme,
                law=p.law,
                correction=p.correction,
                iterations=int(p.iterations),
                passes=int(p.passes),
                substeps=int(p.substeps),
                gravity=p.gravity,
                drag=p.drag,
                slop=p.slop,
                rest=p.rest,
                warm=p.warm,
            )
        except ValueError as error:
            raise ParameterError(str(error)) from None
        if self.exact is not None and self.exact.gravity != self._acting_gravity():
            self.end_exact("gravity is another")

    def change_parameter(self, name: str) -> None:
        """Take over the new value of a parameter; ParameterError if the world refuses it."""
        if name == "freeze":
            self.frozen = 0
        if name in TABLE_PARAMETERS:
            self.world.tables = self._tables()
            self.end_exact("the spheres are others")
        elif name not in NOT_SETTINGS:
            self._configure()

    def change_effects(self, active: EffectSet) -> None:
        """Go on with these effects."""
        self.active = active
        self._configure()

    def _acting_gravity(self) -> float:
        """m/s²; 0 where it is switched off."""
        return self.parameters.gravity if GRAVITY in self.active else 0.0

    # -- the exact run ------------------------------------------------------------------------------

    def begin_exact(self) -> SmoothSpheres:
        """The event-driven run of the spheres as they are, without friction or drag."""
        bodies = self.world.bodies
        self.exact = SmoothSpheres(
            bodies.state.positions,
            bodies.velocities,
            bodies.composition.radii,
            bodies.composition.masses,
            restitution=self.parameters.restitution,
            wall_restitution=self.parameters.wall_restitution,
            gravity=self._acting_gravity(),
            window=self.world.surroundings.window,
        )
        return self.exact

    def end_exact(self, why: str) -> None:
        """The exact run is no run of these spheres any more."""
        if self.exact is not None:
            self.exact = None
            self.messages.say(f"The exact run ends here: {why}.")

    # -- a step, and what comes from outside --------------------------------------------------------

    def advance(self, dt: float) -> None:
        """Go on by dt s, unless it stands still at a collision."""
        if self.frozen:
            return
        collisions = self.world.collisions
        if PUSHES in self.active:
            pushes.apply_pushes(self.pushes, self.world, dt)
        self.pushes = pushes.after_step(self.pushes, dt)
        self.world.step(dt)
        if self.exact is not None:
            try:
                self.exact.fly(dt, MOST_EXACT)
            except ValueError:
                self.end_exact("it has impacts without end")

        if self.parameters.freeze and self.world.collisions > collisions:
            self.frozen = collisions + 1

    def go_on(self) -> None:
        """To the next collision of this moment, else on in time."""
        self.frozen = self.frozen + 1 if 0 < self.frozen < self.world.collisions else 0

    def turn_over(self) -> None:
        """Turn the window over: what was below is above, as gravity now points the other way."""
        self.parameters.gravity = -self.parameters.gravity
        self.change_parameter("gravity")
        self.messages.say(f"Turned over: gravity points {'up' if self.parameters.gravity < 0.0 else 'down'}.")

    def push(self, body: int, place: pushes.Place, force: tuple[float, float, float]) -> None:
        """A force (N) begins to act on a body, at a point of its own frame (m from its centre)."""
        self.end_exact("a force acts")
        self.pushes.append(pushes.Push(body, place, force, float(self.parameters.push_time)))

    def add_sphere(self, x: float, y: float) -> None:
        """A new sphere, as a body of its own; no nearer to the walls than its radius (m)."""
        bodies, view, radius = self.world.bodies, self.content.view, self.parameters.radius
        if len(bodies.composition.radii) >= MOST_SPHERES:
            self.messages.say(f"There can be {MOST_SPHERES} spheres at most.")
            return
        if 2.0 * radius > min(view.right - view.left, view.top - view.bottom):
            self.messages.say("The window is too small for such a sphere.")
            return
        x = min(max(x, view.left + radius), view.right - radius)
        y = min(max(y, view.bottom + radius), view.top - radius)
        real, density = self.parameters.real, self.parameters.density
        new = SphereBodies(
            [(x, y)], [radius],
            masses=density * 4.0 / 3.0 * math.pi * elementary.cube(radius) if real else 1.0,
            inertias="solid" if real else "unit",
        )  # fmt: skip
        self.take_bodies(joined(bodies, new), self.world.surroundings)

    def remove_body_of(self, sphere: int) -> bool:
        """Remove a sphere and those joined to it; False if it is of the last body, which stays."""
        bodies = self.world.bodies
        if bodies.count == 1:
            self.messages.say("The last body stays.")
            return False
        gone = int(bodies.composition.owners[sphere])
        self.pushes = pushes.without_body(self.pushes, gone)
        self.take_bodies(*without(bodies, self.world.surroundings, gone))
        return True

    # -- what it shows ------------------------------------------------------------------------------

    def frame(self) -> Frame:
        """The window, and a little around it."""
        view = self.content.view
        margin = 0.015 * (view.top - view.bottom)
        return Frame(view.left - margin, view.bottom - margin, view.right + margin, view.top + margin)

    def state(self) -> SphereState:
        """The arrays themselves."""
        world, exact = self.world, self.exact
        around = world.surroundings
        beside = (exact.positions, exact.velocities) if exact is not None else (NOTHING, NOTHING)
        return SphereState(*world.state(), *world.bodies.composition, around.hung, around.strings, *beside)

    def restore(self, state: SphereState) -> None:
        """Take over a copy of a state, with other spheres if need be."""
        composition = Composition(
            state.masses.copy(), state.inverse_inertias.copy(), state.round_bodies.copy(), state.radii.copy(),
            state.owners.copy(), state.offsets.copy(), state.kinds.copy(),
        )  # fmt: skip
        around = self.world.surroundings
        mine: tuple[Any, ...] = (*self.world.bodies.composition, around.hung, around.strings)
        theirs: tuple[Any, ...] = (*composition, state.hung, state.strings)
        if not all(np.array_equal(a, b) for a, b in zip(mine, theirs, strict=True)):
            motion = MotionState(*(part.copy() for part in state[:4]))
            around = around._replace(hung=state.hung.copy(), strings=state.strings.copy())
            self.take_bodies(SphereBodies.of_parts(composition, motion), around)
        self.world.restore(CollisionState(**{name: getattr(state, name) for name in CollisionState._fields}))
        self.exact = None
        if len(state.exact_places):
            exact = self.begin_exact()
            np.copyto(exact.positions, state.exact_places)
            np.copyto(exact.velocities, state.exact_speeds)


def _with_lifted(content: CollisionContent, lifted: int) -> CollisionContent:
    """A content in whose cradles so many balls are drawn aside; 0: as it is."""
    if not lifted:
        return content
    cradles = tuple(msgspec.structs.replace(one, drawn=min(lifted, one.balls)) for one in content.cradles)
    return msgspec.structs.replace(content, cradles=cradles)
