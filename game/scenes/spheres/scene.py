"""Spheres that collide: impulses at contacts, piles, Newton's cradle."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

from game.lab.studies.impulses import impact_study
from game.levels import Level
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
from game.scenes.spheres.state import SphereState, restore, state_of
from game.scenes.spheres.view import CollisionView
from game.stage import (
    Equation,
    Frame,
    Hearing,
    Hint,
    Pointer,
    Readout,
    Scene,
    SceneAction,
    Stamped,
    Strip,
    Table,
    WarmUp,
)
from game.stage.states.state import copy_state
from game.worlds.expectations import captions_now, captions_of, draw_captions, with_headroom


class SphereCollisions(Scene):
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

    def build(self, level: Level | None) -> None:
        given = self.content_of(level)
        self.model = CollisionModel(given, self.parameters, self.active, self.seed)
        self.hand = Hand(self.model)
        self.view = CollisionView(self.model, self.hand)
        self.repeat = Repeat(given.repeat)
        self._beginning = copy_state(self.state()) if given.repeat else None
        captions_of(given.expected, self.readouts())  # refuses an unknown readout

    def parameter_changed(self, name: str) -> None:
        if name == "tool":
            self.hand.forget()
        else:
            self.model.parameter_changed(name)

    def effects_changed(self) -> None:
        self.model.change_effects(self.active)

    def state(self) -> SphereState:
        return state_of(self.model)

    def restore(self, state: SphereState) -> None:
        restore(self.model, state)

    def save_content(self) -> CollisionContent:
        return content_of(self.model)

    # -- a step, and what comes in ------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        if self._beginning is not None and self.repeat.advance(dt):
            self.restore(self._beginning)
            self.previous = None
        self.model.advance(dt)

    def pointer(self, event: Pointer) -> None:
        if event.kind == "down":
            self.repeat.end()
        self.hand.take_pointer(event)

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

    def messages(self) -> Sequence[str]:
        return self.model.messages.take()

    # -- what there is to see -----------------------------------------------------------------------

    def readouts(self) -> list[Readout]:
        return readouts_of(self.model)

    def hearing(self) -> Hearing:
        return hearing_of(self.model)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return self.view.legend()

    def panel_table(self) -> Table | None:
        return ledger_table(self.model)

    def point_at(self, key: int | None) -> None:
        self.view.lit = key

    def frame(self) -> Frame:
        content = self.model.content
        return with_headroom(self.model.frame(), len(content.expected) + bool(content.repeat))

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(self.previous, canvas, alpha)
        content, view = self.model.content, self.model.content.view
        if content.zoom is not None:
            frame = Frame(view.left, view.bottom, view.right, view.top)
            draw_inset(canvas, frame, content.zoom, lambda: self.view.draw(self.previous, canvas, alpha))
        top = (0.5 * (view.left + view.right), self.frame().top)
        captions = captions_now(self, content.expected)
        draw_captions(canvas, top, captions, self.repeat.left)

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
