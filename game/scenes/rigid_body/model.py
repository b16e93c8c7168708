"""The model of the rigid body scene: the bodies, the push that acts on them, and where L has been."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.rigid import METHODS
from game.physics.rigid.motion import INVERSES, MOMENTS, P
from game.physics.rigid.turning import measure
from game.scenes.rigid_body import bodies
from game.scenes.rigid_body.bodies import Bodies, is_about_middle_axis
from game.scenes.rigid_body.level import RigidContent, design_of
from game.scenes.rigid_body.panes import Panes
from game.scenes.rigid_body.parameters import LABELS, SHOWN_ONLY, RigidBodyParameters
from game.stage import Part
from game.stage.messages import Messages

Vector = tuple[float, float, float]
TRAIL = 400  # steps that the trail of L on its sphere goes back


class Pull(NamedTuple):
    """A force (N) at a point of the bodies (m in their own axes, from the centre of mass)."""

    force: Vector
    arm: Vector


class Push(NamedTuple):
    """A pull that acts for so long."""

    pull: Pull
    left: float  # s


class RigidState(NamedTuple):
    """What moves, of what it is made, and what is remembered of it."""

    rows: Floats  # (3, 13)
    accounts: Floats  # (3, 4)
    design: Floats  # (n, 6)
    density: float  # kg/m³
    trail: Floats  # (2, TRAIL, 3): direction of L in the body's frame, by step number modulo TRAIL


class RigidModel(Part):
    """The bodies of a content, stepped as the parameters say.

    bodies: A, B and the exact one. panes: their boxes. push: the one that acts now, or None. trail
    (2, TRAIL, 3): directions of L in the frames of A and B, by step number modulo TRAIL. messages: for the
    person, oldest first. ValueError for a content that makes no sense.
    """

    def __init__(self, content: RigidContent, parameters: RigidBodyParameters, active: EffectSet):
        self.content, self.parameters, self.active = content, parameters, active
        self.messages = Messages()
        self.push: Push | None = None
        self.steps = 0
        self.trail = np.zeros((2, TRAIL, 3))
        self.panes = Panes(content.window, parameters.twin)
        self.bodies = Bodies(design_of(content), parameters.density)
        self.bodies.start(content.place, content.orientation, content.velocity, content.spin)
        self.bodies.meet()
        self.configure()
        self._note()

    def method_label(self, pane: int) -> str:
        """Words for the method of a body."""
        return LABELS[METHODS.index(self.parameters.second if pane == bodies.B else self.parameters.method)]

    def configure(self) -> None:
        """Hand the parameters to the bodies."""
        p, half = self.parameters, self.panes.half_sides
        for index, body in enumerate(self.bodies.all):
            body.change(
                method=(p.method, p.second, "exact")[index],
                effects=self.active,
                gravity=p.gravity,
                damping=p.damping,
                normalizing=p.normalizing or index == bodies.EXACT,
                wall=p.wall,
                restitution=p.restitution,
                lower=-half,
                upper=half,
            )

    def change_parameter(self, name: str) -> None:
        """Take over the new value of a parameter."""
        if name == "density":
            self.bodies.change_density(self.parameters.density, self.parameters.keep)
        if name not in SHOWN_ONLY:
            self.configure()

    def change_effects(self, active: EffectSet) -> None:
        """Go on with these effects."""
        self.active = active
        self.configure()

    # -- a step -------------------------------------------------------------------------------------

    def advance(self, dt: float, held: Pull | None) -> None:
        """Go on by dt s; held: what the hand pulls with, or None."""
        body, flips = self.bodies.all[bodies.A], self.bodies.accounts[bodies.A, bodies.FLIPS]
        bounces = body.bounces
        self.bodies.step(dt, self.parameters.twin, self._force_and_arm(dt, held))
        self.steps += 1
        self._note()
        first = flips == 0.0 < self.bodies.accounts[bodies.A, bodies.FLIPS] and body.bounces == bounces
        if first and body.is_free and is_about_middle_axis(body):
            self.messages.say("The body has turned over, with no torque on it.")

    def _force_and_arm(self, dt: float, held: Pull | None) -> Sequence[float] | None:
        """Force and arm (6) of this step; of a push that ends within it, the share that is left."""
        if held is not None:
            return *held.force, *held.arm
        if self.push is None:
            return None
        pull, left = self.push
        share = min(1.0, left / dt)
        self.push = Push(pull, left - dt) if left > dt * (1.0 + 1e-9) else None
        return *(share * f for f in pull.force), *pull.arm

    def _note(self) -> None:
        """Write where L is, seen from the bodies, into the trail."""
        for index in (bodies.A, bodies.B):
            body = self.bodies.all[index]
            _, _, momentum, _, *spin = measure(body.state, body.constants[0])
            place = self.trail[index, self.steps % TRAIL]
            place[:] = spin
            if momentum > 0.0:
                place *= body.constants[0, MOMENTS:INVERSES] / momentum

    def trail_of(self, index: int) -> Floats:
        """Directions (k, 3) of L that a body has had, from the oldest on."""
        trail = self.trail[index]
        count = min(self.steps + 1, TRAIL)
        return trail[np.arange(self.steps + 1 - count, self.steps + 1) % TRAIL]

    # -- what comes from outside --------------------------------------------------------------------

    def reshape(self, design: Floats) -> None:
        """Go on with other spheres (n, 6); a push ends."""
        self.bodies.reshape(design)
        self.push = None
        self.configure()

    def stop(self) -> None:
        """Take all motion from the bodies."""
        for body in self.bodies.all:
            body.states[0, P:] = 0.0
        self.push = None
        self.bodies.meet()

    def state(self) -> RigidState:
        """Its own arrays, not copies."""
        bodies = self.bodies
        return RigidState(bodies.rows, bodies.accounts, bodies.design, bodies.density, self.trail)

    def restore(self, state: RigidState) -> None:
        """Put a state back; bodies of another design are made again."""
        self.bodies.take(state.rows, state.design, float(state.density))
        np.copyto(self.bodies.accounts, state.accounts)
        np.copyto(self.trail, state.trail)
        self.configure()
