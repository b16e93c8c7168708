"""One rigid body of spheres in space, by ten ways to integrate its turning."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.lab.studies.rotation import rotation_study
from game.levels import Level
from game.physics.rigid import METHODS
from game.physics.rigid.free_top import turn_freely
from game.physics.rigid.motion import INVERSES, MOMENTS, P
from game.physics.rigid.turning import measure
from game.scenes.rigid_body import C12, hand
from game.scenes.rigid_body.bodies import EXACT, FLIPS, A, B, Bodies, is_about_middle_axis
from game.scenes.rigid_body.camera import box_edges, camera_matrix
from game.scenes.rigid_body.figure import draw_momentum_sphere
from game.scenes.rigid_body.level import RigidContent, SphereEntry, design_of
from game.scenes.rigid_body.parameters import HOME, LABELS, SHOWN_ONLY, RigidBodyParameters
from game.scenes.rigid_body.readouts import readouts_of
from game.scenes.rigid_body.state import TRAIL, RigidState, content_of, restore, state_of
from game.scenes.rigid_body.view import RigidView
from game.stage import (
    Equation,
    Frame,
    Hint,
    Pointer,
    Readout,
    SceneAction,
    Stamped,
    Strip,
    WarmUp,
)
from game.ui.painters.spheres import WARM_UPS

Array = NDArray[np.float64]
TITLE_ROOM = 0.25  # m
GAP = 0.12  # m, between the panes of the twin view


class RigidBodyScene(RigidBodyParameters):
    """Spheres are joined to one body. Its mass, centre and inertia tensor follow from theirs by the offset
    theorem; its state is place, quaternion, momentum and angular momentum, and velocity and spin follow from
    those.

    No force turns the two hammers that the scene begins with, and yet they turn over: a spin about the middle
    axis of inertia is not stable. B, by the splitting, turns over again and again, as often as the exact
    solution by Jacobi's elliptic functions, which goes along as an outline.

    A, by explicit Euler, does so no more after five seconds. It keeps L to the bit, but not the energy: that
    rises until the body turns about its axis of least inertia, and can rise no more.

    The small sphere shows L as the body sees it. A free body's L stays on a curve of its own energy; a method
    that makes energy spirals outwards to an end of axis 1.
    """

    name, task, title = C12.names
    dt = 1.0 / 60.0
    content_type = RigidContent
    study = rotation_study
    takes = frozenset(("right",))

    hints = (
        Hint(("Drag",), "a force on the body; beside it: turn the view"),
        Hint(("1", "2", "3"), "push, new sphere, take off"),
        Hint(("Right drag",), "turn the view"),
    )
    actions = (
        SceneAction("push", "push", "1"),
        SceneAction("sphere", "new sphere", "2"),
        SceneAction("remove", "take off", "3"),
        SceneAction("undo", "take back", "ctrl+z"),
        SceneAction("redo", "do again", "ctrl+y"),
        SceneAction("still", "stop the body", "0"),
        SceneAction("meet", "all as A is", "m"),
    )
    strips = (
        Strip("Energy of rotation", "J", ("A", "B", "exact", "bound"), ("exact", "bound"), sometimes=("B",)),
        Strip("Angular momentum made", "", ("L of A", "L of B"), sometimes=("L of B",)),
        Strip("Length of q, off 1", "", ("q of A", "q of B"), sometimes=("q of B",)),
    )
    figure = staticmethod(draw_momentum_sphere)
    equations = (
        Equation(
            "Motion",
            r"\dot{\v{x}} = \v{P} / m,  \dot{\v{P}} = \v{f},  \dot{\v{L}} = \v{\tau}",
            "Newton, Euler",
        ),
        Equation("Quaternion", r"\dot{q} = \frac{1}{2} (0, \v{\omega}) q", "Hamilton"),
        Equation("Spin", r"\v{\omega} = J^{-1} \v{L},  J = R I R^T", "Baraff 1997"),
        Equation(
            "Offset theorem", r"I = \sum \frac{2}{5} m r^2 E + m (d^2 E - \v{d} \v{d}^T)", "Huygens, Steiner"
        ),
        Equation(
            "Accelerations",
            r"\v{a} = \v{f} / m,  \v{\alpha} = J^{-1} (\v{\tau} - \v{\omega} \times \v{L})",
            "",
        ),
        Equation(
            "Energy of rotation",
            r"E = \frac{1}{2} \v{\omega} \cdot \v{L} \le \frac{L^2}{2 I_1}",
            "at equal L",
        ),
        Equation(
            "Wobble about the middle axis",
            r"\omega_2 \sqrt{\frac{(I_2 - I_1)(I_3 - I_2)}{I_1 I_3}}",
            "growth, 1/s",
        ),
    )
    try_this = (
        "Count the flips of A and B beside the exact ones; then give A another integrator, and begin again.",
        "Set a time step of 1/10 s: explicit Euler is lost at once, the splitting only jitters.",
        "Take Implicit gyroscopic: what most engines use. It loses energy and angular momentum.",
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

    def build(self, level: Level | None) -> None:
        self.content: RigidContent = (
            level.content if level is not None and level.content is not None else self.default_content
        )
        self.grip, self.pane = "", A
        self.arm = self.start = self.target = (0.0, 0.0, 0.0)
        self.last = (0.0, 0.0)
        self.push: tuple[float, ...] | None = None  # force N, arm m, seconds left
        self.done: list[hand.Edit] = []
        self.undone: list[hand.Edit] = []
        self.told: deque[str] = deque(maxlen=8)
        self.steps = 0
        self.trail = np.zeros((2, TRAIL, 3))
        content = self.content
        x, y = (np.abs(camera_matrix(*HOME)) @ np.array(content.window)).tolist()[:2]
        self.room = (x, y + TITLE_ROOM if self.twin else y)  # half the sides of the picture, m
        self.box = box_edges(self.half_sides())
        self.bodies = Bodies(design_of(content), self.density)
        self.bodies.start(content.place, content.orientation, content.velocity, content.spin)
        self.bodies.meet()
        self.view = RigidView()
        self.configure()
        self._note()

    def half_sides(self) -> Array:
        """Half the sides (3,) m of the box of each body."""
        half = np.array(self.content.window, dtype=np.float64)
        if self.twin:  # two boxes side by side in the picture of one
            right, _, near = np.abs(camera_matrix(*HOME))[0].tolist()
            half[0] = max(0.5 * (self.room[0] - GAP) - near * half[2], 0.25 * half[0]) / right
        return half

    def pane_shift(self, pane: int) -> float:
        """Where (m) the middle of a body's box is in the picture."""
        if not self.twin:
            return 0.0
        shift = 0.5 * self.room[0]
        return shift if pane == B else -shift

    def method_label(self, pane: int) -> str:
        """Words for the method of a body."""
        return LABELS[METHODS.index(self.second if pane == B else self.method)]

    def configure(self) -> None:
        """Hand the parameters to the bodies."""
        half = self.half_sides()
        for index, body in enumerate(self.bodies.all):
            body.change(
                method=(self.method, self.second, "exact")[index],
                effects=self.active,
                gravity=self.gravity,
                damping=self.damping,
                normalizing=self.normalizing or index == EXACT,
                wall=self.wall,
                restitution=self.restitution,
                lower=-half,
                upper=half,
            )

    def parameter_changed(self, name: str) -> None:
        if name == "density":
            self.bodies.change_density(self.density, self.keep)
        if name not in SHOWN_ONLY:
            self.configure()

    def effects_changed(self) -> None:
        self.configure()

    # -- remembering --------------------------------------------------------------------------------

    def state(self) -> RigidState:
        return state_of(self)

    def restore(self, state: RigidState) -> None:
        restore(self, state)

    def save_content(self) -> RigidContent:
        return content_of(self)

    # -- a step -------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        body, flips = self.bodies.all[A], self.bodies.accounts[A, FLIPS]
        bounces = body.bounces
        self.bodies.step(dt, self.twin, self._push_now(dt))
        self.steps += 1
        self._note()
        first = flips == 0.0 < self.bodies.accounts[A, FLIPS] and body.bounces == bounces
        if first and body.is_free and is_about_middle_axis(body):
            self.told.append("The body has turned over, with no torque on it.")

    def _push_now(self, dt: float) -> tuple[float, ...] | None:
        """Force and arm of this step; of a push that ends within it, the share that is left."""
        held = hand.held_force(self)
        if held is not None:
            return *held, *self.arm
        if self.push is None:
            return None
        left = self.push[6]
        share = min(1.0, left / dt)
        force = tuple(share * f for f in self.push[:3])
        arm = self.push[3:6]
        self.push = (*self.push[:6], left - dt) if left > dt * (1.0 + 1e-9) else None
        return *force, *arm

    def _note(self) -> None:
        """Write where L is, seen from the bodies, into the trail."""
        for index in (A, B):
            body = self.bodies.all[index]
            _, _, momentum, _, *spin = measure(body.state, body.constants[0])
            place = self.trail[index, self.steps % TRAIL]
            place[:] = spin
            if momentum > 0.0:
                place *= body.constants[0, MOMENTS:INVERSES] / momentum

    def pointer(self, event: Pointer) -> None:
        hand.take_pointer(self, event)
        self.configure()

    def action(self, name: str) -> None:
        if name == "undo":
            hand.undo(self)
        elif name == "redo":
            hand.redo(self)
        elif name == "still":
            for body in self.bodies.all:
                body.states[0, P:] = 0.0
            self.push = None
            self.bodies.meet()
        elif name == "meet":
            self.bodies.meet()
        else:
            self.values["tool"] = name
        self.configure()

    def messages(self) -> Sequence[str]:
        new = tuple(self.told)
        self.told.clear()
        return new

    # -- what there is to see -----------------------------------------------------------------------

    def readouts(self) -> list[Readout]:
        return readouts_of(self)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return self.view.legend(self)

    def frame(self) -> Frame:
        x, y = self.room
        return Frame(-x, -y, x, y)

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(self, canvas, alpha)
