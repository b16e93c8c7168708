"""Spheres that collide: impulses at contacts, piles, Newton's cradle."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

from game.lab.studies.impulses import impact_study
from game.physics.fields import DRAG, GRAVITY
from game.physics.rigid import PUSHES, ROTATION, WINDOW
from game.physics.spheres.collisions import CollidingSpheres
from game.physics.spheres.effects import COLLISIONS, FRICTION, IMPACT_TIMES, LEDGES, STRINGS
from game.physics.spheres.spheres import SphereBodies
from game.scenes.shared.insets import draw_inset
from game.scenes.shared.repeats import Repeat
from game.scenes.spheres import C13
from game.scenes.spheres.figure import draw_friction_cone
from game.scenes.spheres.hand import Hand
from game.scenes.spheres.ledger import ledger_table
from game.scenes.spheres.level import CollisionContent, SphereEntry
from game.scenes.spheres.model import CollisionModel
from game.scenes.spheres.parameters import CollisionParameters
from game.scenes.spheres.readouts import readouts_of
from game.scenes.spheres.saving import content_of
from game.scenes.spheres.sounds import hearing_of
from game.scenes.spheres.view import CollisionView
from game.stage import (
    Equation,
    Frame,
    Hint,
    Pointer,
    SceneAction,
    Stamped,
    Strip,
    Table,
    WarmUp,
)
from game.stage.states.state import copy_state
from game.worlds.expectations import draw_captions, with_headroom
from game.worlds.scene import ModelScene, Told


class SphereCollisions(ModelScene):
    """Spheres fly, hit each other and the walls of the window, slide, roll and pile up. Each is a rigid body
    in space, with position, orientation, momentum and angular momentum. The picture shows the plane, and the
    line of a radius shows how each has turned.

    Where two are in contact and approach, an impulse along their line of centres turns the approach around:
    by the restitution e. Friction acts across it, at the contact point, and so makes them turn. The impulses
    of resting contacts are found for all of them together, in a few sweeps.

    Every collision is entered into a ledger: momentum and angular momentum must not change, and energy only
    by what restitution and friction take. For 200 spheres and more in one plane there is a quicker solver. It
    enters the energy of each collision and the momentum that all of one moment have lost together.

    In the equations: x position, v velocity, P momentum, q orientation as a quaternion, ω spin, h time step,
    m mass, I moment of inertia, r radius (a vector: from a centre to the contact), n normal from a to b, d
    from centre to centre, t time, e restitution, μ friction, j impulse, j_t that of friction, v_n approach,
    u_t sliding speed, m_n and m_t the masses that those feel, λ impulse so far, g gravity; ′ after.
    """

    name, task, title = C13.names
    study = impact_study
    parameters_type = CollisionParameters
    parameters: CollisionParameters
    effects = (
        GRAVITY | DRAG | ROTATION | WINDOW | PUSHES | COLLISIONS | FRICTION | IMPACT_TIMES | STRINGS | LEDGES
    )
    may_be_infinite = frozenset(("masses",))
    content_type = CollisionContent
    told = Told(readouts_of, content_of, hearing=hearing_of)
    model: CollisionModel
    legend_in_panel = True
    takes: ClassVar[frozenset[str]] = frozenset(("right",))

    hints = (
        Hint(("Drag",), "push a sphere"),
        Hint(("1", "2", "3"), "tools"),
        Hint(("Right click",), "remove a sphere"),
    )
    actions = (
        SceneAction("push", "push", "1"),
        SceneAction("sphere", "new sphere", "2"),
        SceneAction("remove", "remove a sphere", "3"),
        SceneAction("go-on", "go on after an impact", "g"),
        SceneAction("turn", "turn over: gravity points the other way", "t"),
    )
    strips = (
        Strip("Energy", "J", ("translational energy", "rotational energy", "total energy")),
        Strip("Momentum", "kg m/s", ("P x", "P y")),
        Strip("Penetration", "m", ("maximum penetration",)),
    )
    figure = staticmethod(draw_friction_cone)
    equations = (
        Equation(
            "Motion", r"\v{x}' = \v{x} + h\v{P}/m,  q' = q + \frac{h}{2} \v{\omega} q", "explicit Euler"
        ),
        Equation(
            "Contact speed",
            r"v_n = (\v{v}_b + \v{\omega}_b\times\v{r}_b - \v{v}_a - \v{\omega}_a\times\v{r}_a)\cdot\v{n}",
        ),
        Equation("Impulse", r"j = -(1+e) v_n m_n,  1/m_n = 1/m_a + 1/m_b", "for spheres; Hahn 1988"),
        Equation(
            "Friction", r"j_t = \min(\mu j, u_t m_t),  1/m_t = 1/m_n + r_a^2/I_a + r_b^2/I_b", "Coulomb"
        ),
        Equation("Energy", r"\Delta E = -\frac{1}{2}(1-e^2) m_n v_n^2", "smooth spheres"),
        Equation("Resting contact", r"\Delta\lambda = \max(\lambda - m_n v_n, 0) - \lambda", "Catto 2005"),
        Equation(
            "Rest", r"e = 0  \text{ below }  v_n = 4 g h / (1 - e^2)", "penetration must not make energy"
        ),
        Equation("Impact time", r"\abs{\v{d} + \v{v} t} = r_a + r_b", "Ericson 2005, 5.5"),
    )
    try_this = (
        "Press on a sphere off its centre, draw, let go: it moves and turns.",
        "Freeze on impact: normal, speeds, impulse and friction cone stand in the picture; G goes on.",
        "Open the cradle, lift two balls; choose the law Simultaneous: all move, energy and momentum fit.",
        "Switch impact times off in the fast-and-small level: the bullet passes through.",
        "Open the pile: no correction, then Baumgarte, then split impulses; compare penetration and energy.",
    )
    default_content: ClassVar[CollisionContent] = CollisionContent(
        spheres=(
            SphereEntry(position=(-2.0, 2.0), velocity=(2.0, 0.0)),
            SphereEntry(position=(1.0, 2.2)),
        )
    )

    demo = (  # the first sphere is pushed back into the others
        Stamped(420, Pointer("down", -0.55, 2.88, button=1)),
        Stamped(435, Pointer("move", 0.6, 2.6, button=1)),
        Stamped(450, Pointer("up", 1.9, 2.2, button=1)),
    )

    def make(self, content: CollisionContent) -> None:
        self.model = CollisionModel(content, self.parameters, self.active, self.seed)
        self.said = self.model.messages
        self.hand = Hand(self.model)
        self.view = CollisionView(self.model, self.hand)
        self.repeat = Repeat(content.repeat)
        self._beginning = copy_state(self.state()) if content.repeat else None

    def parameter_changed(self, name: str) -> None:
        if name == "tool":
            self.hand.forget()
        else:
            super().parameter_changed(name)

    # -- a step, and what comes in ------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        if self._beginning is not None and self.repeat.advance(dt):
            self.restore(self._beginning)
            self.previous = None
        self.model.advance(dt)

    def pointer(self, event: Pointer) -> None:
        if event.kind == "down":
            self.repeat.end()
        super().pointer(event)

    def why_idle(self, name: str) -> str:
        return "No cradle hangs here." if name == "lifted" and not self.model.content.cradles else ""

    def action(self, name: str) -> None:
        if name == "go-on":
            self.model.go_on()
            return
        if name == "turn":
            self.model.turn_over()
            return
        self.parameters.tool = name
        self.hand.forget()

    # -- what there is to see -----------------------------------------------------------------------

    def panel_table(self) -> Table | None:
        return ledger_table(self.model)

    def point_at(self, key: int | None) -> None:
        self.view.lit = key

    def frame(self) -> Frame:
        content = self.model.content
        return with_headroom(self.model.frame(), len(content.expected) + bool(content.repeat))

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(canvas, self.previous, alpha)
        zoom = self.model.content.zoom
        if zoom is not None:
            shown = self.shown()
            draw_inset(canvas, shown, zoom, lambda: self.view.draw(canvas, self.previous, alpha))
        self.draw_expected(canvas)

    def draw_expected(self, canvas: Any) -> None:
        shown = self.shown()
        top = (0.5 * (shown.left + shown.right), self.frame().top)
        draw_captions(canvas, top, self.captions(), self.repeat.left)

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        """Kernels part by part."""

        def world(**settings: Any) -> CollidingSpheres:
            bodies = SphereBodies([(0.0, 0.0), (0.9, 0.0)], [0.5, 0.5], [(1.0, 0.0), (0.0, 0.0)])
            return CollidingSpheres(bodies, **settings)

        return (
            WarmUp("contacts", lambda: world().overlap()),
            WarmUp("ledger", lambda: world().totals()),
            WarmUp("impulses", lambda: world().step(cls.dt)),
            WarmUp("impact times", lambda: world(effects=cls.effects).step(cls.dt)),
            WarmUp("impulses in the plane", lambda: world(path="planar").step(cls.dt)),
        )
