"""One rigid body of spheres in space, by ten methods to integrate its rotation."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from game.lab.studies.rotation import rotation_study
from game.physics.fields import DRAG, GRAVITY
from game.physics.rigid import PUSHES, ROTATION, WINDOW
from game.physics.rigid.free_top import turn_freely
from game.scenes.rigid_body import C12
from game.scenes.rigid_body.equations import EQUATIONS
from game.scenes.rigid_body.figure import draw_momentum_sphere
from game.scenes.rigid_body.hand import Hand
from game.scenes.rigid_body.level import RigidContent, SphereEntry
from game.scenes.rigid_body.model import RigidModel
from game.scenes.rigid_body.parameters import RigidBodyParameters
from game.scenes.rigid_body.readouts import readouts_of
from game.scenes.rigid_body.saving import content_of
from game.scenes.rigid_body.view import RigidView
from game.stage import Frame, Hint, Pointer, SceneAction, Stamped, Strip, WarmUp
from game.ui.painters.spheres import WARM_UPS
from game.worlds.expectations import draw_captions, with_headroom
from game.worlds.scene import ModelScene, Told


class RigidBodyScene(ModelScene):
    """Spheres are joined to one body. Its mass, centre and inertia tensor follow from theirs by the offset
    theorem. Its state is position, quaternion, momentum and angular momentum. Velocity and spin follow from
    those.

    No force turns the two hammers that the scene begins with, and yet they turn over: a spin about the middle
    axis of inertia is not stable. B, by the splitting, turns over again and again, as often as the exact
    solution by Jacobi's elliptic functions, which goes along as an outline.

    A, by explicit Euler, does so no more after five seconds. It keeps L to the bit, but not the energy: that
    rises until the body turns about its axis of least inertia, and can rise no more.

    The small sphere shows L as the body sees it. A free body's L stays on a curve of its own energy; a method
    that makes energy spirals outwards to an end of axis 1.

    In the equations: m mass, r radius of a sphere, d from the body's centre of mass to the sphere's, x
    position, P momentum, f force, L angular momentum, τ torque, a and α accelerations, q orientation as a
    quaternion, ω spin, I inertia in the body's frame with I1 to I3 its principal moments, J inertia in the
    world's frame, R the body's turn (with a number: one about that principal axis), h time step, k slopes,
    E energy, but in the offset theorem the unit matrix.
    """

    name, task, title = C12.names
    parameters_type = RigidBodyParameters
    parameters: RigidBodyParameters
    effects = GRAVITY | DRAG | ROTATION | WINDOW | PUSHES
    content_type = RigidContent
    told = Told(readouts_of, content_of)
    model: RigidModel
    study = rotation_study
    takes = frozenset(("right",))

    hints = (
        Hint(("Drag",), "a force on the body; beside it: turn the view"),
        Hint(("1", "2", "3"), "push, new sphere, remove"),
        Hint(("Right drag",), "turn the view"),
    )
    actions = (
        SceneAction("push", "push", "1"),
        SceneAction("sphere", "new sphere", "2"),
        SceneAction("remove", "remove a sphere", "3"),
        SceneAction("undo", "undo", "ctrl+z"),
        SceneAction("redo", "redo", "ctrl+y"),
        SceneAction("still", "stop the body", "0"),
        SceneAction("meet", "begin again from A", "m"),
    )
    strips = (
        Strip(
            "Energy of rotation",
            "J",
            ("A: energy", "B: energy", "exact: energy", "greatest energy"),
            exact=("exact: energy", "greatest energy"),
            sometimes=("B: energy",),
        ),
        Strip("Error of L", "", ("A: L error", "B: L error"), sometimes=("B: L error",)),
        Strip("Error of |q|", "", ("A: |q| error", "B: |q| error"), sometimes=("B: |q| error",)),
    )
    figure = staticmethod(draw_momentum_sphere)
    equations = EQUATIONS
    try_this = (
        "Count the flips of A and B beside the exact ones; then give A another integrator, and begin again.",
        "Set a time step of 1/10 s: explicit Euler is lost at once, the splitting only jitters.",
        "Choose Implicit gyroscopic, which most engines use: it loses energy and angular momentum.",
        "Point at a sphere: its volume and mass, and what it adds to the moment of inertia about the spin.",
        "Push the head, then the handle, with the same force. Double the density and do it again.",
        "Switch normalizing off and look at |q| with explicit Euler, and with the exponential map.",
    )
    default_content = RigidContent(
        spheres=(
            SphereEntry(position=(0.0, 0.0, 0.0), radius=0.3),
            SphereEntry(position=(0.7, 0.3, 0.0), radius=0.25),
        ),
        spin=(0.3, 2.0, 0.5),
    )

    demo = (  # the head of A is pulled up, and B is pulled alike
        Stamped(150, Pointer("down", -2.39, 0.62, button=1)),
        Stamped(160, Pointer("move", -2.6, 1.0, button=1)),
        Stamped(170, Pointer("up", -2.9, 1.25, button=1)),
    )

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        """The exact body first, which is half of all; then a step, and what draws the spheres."""
        unit, one = (1.0, 0.0, 0.0, 0.0), (1.0, 1.0, 1.0)
        return (
            WarmUp("exact body", lambda: turn_freely(unit, one, (1.0, 2.0, 3.0), 0.01)),
            WarmUp("step", lambda: cls().advance(cls.dt)),
            *(WarmUp(*row) for row in WARM_UPS),
        )

    # -- building -----------------------------------------------------------------------------------

    def make(self, content: RigidContent) -> None:
        self.model = RigidModel(content, self.parameters, self.active)
        self.said = self.model.messages
        self.hand = Hand(self.model)
        self.view = RigidView(self.model, self.hand)

    # -- a step, and what comes in ------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        self.model.advance(dt, self.hand.held())

    def action(self, name: str) -> None:
        if name == "undo":
            self.hand.edits.undo()
        elif name == "redo":
            self.hand.edits.redo()
        elif name == "still":
            self.model.stop()
        elif name == "meet":
            self.model.bodies.meet()
        else:
            self.parameters.tool = name

    # -- what there is to see -----------------------------------------------------------------------

    def shown(self) -> Frame:
        return self.model.panes.frame()

    def frame(self) -> Frame:
        return with_headroom(self.shown(), len(self.model.content.expected))

    def draw_expected(self, canvas: Any) -> None:
        draw_captions(canvas, (0.0, self.frame().top), self.captions())
