"""Spheres that collide: impulses at contacts, piles, Newton's cradle."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from game.lab.studies.impulses import impact_study
from game.levels import Level
from game.physics.broadphase import BroadPhase, HierarchicalGrid, SweepAndPrune, UniformGrid
from game.physics.fields import GRAVITY
from game.physics.spheres.collisions import CollidingSpheres
from game.physics.spheres.smooth_spheres import SmoothSpheres
from game.physics.spheres.spheres import SphereBodies
from game.scenes.spheres import C13, hand
from game.scenes.spheres import readouts as findings
from game.scenes.spheres import sounds as c13_sounds
from game.scenes.spheres.building import bodies_of, makings_of, tables_of
from game.scenes.spheres.figure import draw_friction_cone
from game.scenes.spheres.ledger import ledger_table
from game.scenes.spheres.level import CollisionContent, SphereEntry
from game.scenes.spheres.parameters import NOT_SETTINGS, TABLE_PARAMETERS, CollisionParameters
from game.scenes.spheres.saving import content_of
from game.scenes.spheres.state import SphereState, restore, state_of
from game.scenes.spheres.view import CollisionView
from game.stage import (
    Equation,
    Frame,
    Hearing,
    Hint,
    ParameterError,
    Pointer,
    Readout,
    SceneAction,
    Stamped,
    Strip,
    Table,
    WarmUp,
)

Array = NDArray[np.float64]
MOST_EXACT = 2_000  # impacts in a step of the event-driven run
CELL = 1.15  # times the largest diameter: edge of the grid's cells


class SphereCollisions(CollisionParameters):
    """Spheres fly, hit each other and the walls of the window, slide, roll and pile up. Each is a rigid body
    in space, with position, orientation, momentum and angular momentum; the picture shows the plane, and the
    line of a radius shows how each has turned.

    Where two touch and approach, an impulse along their line of centres turns the approach around: by the
    restitution e. Friction acts across it, at the contact point, and so makes them turn. What merely rests
    gets the impulses that bear it, found for all touches together in a few sweeps.

    Every collision is entered into a ledger: momentum and angular momentum must not change, and energy only
    by what restitution and friction take. For 200 spheres and more in one plane there is a quicker solver,
    which enters the energy of each collision and the momentum that all of one moment have lost together.
    """

    name, task, title = C13.names
    study = impact_study
    dt = 1.0 / 120.0
    may_be_infinite = frozenset(("masses",))
    content_type = CollisionContent
    legend_in_panel = True
    takes: ClassVar[frozenset[str]] = frozenset(("right",))

    hints = (
        Hint(("Drag",), "push a sphere"),
        Hint(("1", "2", "3"), "tools"),
        Hint(("Right click",), "take away"),
    )
    actions = (
        SceneAction("push", "push", "1"),
        SceneAction("sphere", "new sphere", "2"),
        SceneAction("remove", "take away", "3"),
    )
    strips = (
        Strip("Energy", "J", ("moving", "turning", "sum")),
        Strip("Momentum", "kg m/s", ("P x", "P y")),
        Strip("Overlap", "m", ("deepest",)),
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
        Equation("Bearing", r"\Delta\lambda = \max(\lambda - m_n v_n, 0) - \lambda", "Catto 2005"),
        Equation("Rest", r"e = 0  \text{ below }  v_n = 4 g h / (1 - e^2)", "overlap must not make energy"),
        Equation("Impact time", r"\abs{\v{d} + \v{v} t} = r_a + r_b", "Ericson 2005, 5.5"),
    )
    try_this = (
        "Press on a sphere off its centre, draw, let go: it moves and turns.",
        'Open Newton\'s cradle; choose the law "at once": all balls move, and energy and momentum still fit.',
        "Take impact times away in the fast-and-small level: the bullet passes through.",
        "Open the pile: choose no correction, then Baumgarte, then split impulses; see overlap and energy.",
    )
    default_content: ClassVar[CollisionContent] = CollisionContent(
        spheres=(
            SphereEntry(position=(-2.0, 2.0), velocity=(2.0, 0.0)),
            SphereEntry(position=(1.0, 2.2)),
        )
    )

    demo = (  # the white sphere is pushed back into the others
        Stamped(420, Pointer("down", -0.55, 2.88, button=1)),
        Stamped(435, Pointer("move", 0.6, 2.6, button=1)),
        Stamped(450, Pointer("up", 1.9, 2.2, button=1)),
    )

    # -- building -----------------------------------------------------------------------------------

    def build(self, level: Level | None) -> None:
        self.content: CollisionContent = (
            level.content if level is not None and level.content is not None else self.default_content
        )
        self.told: deque[str] = deque(maxlen=8)
        self.pressed: hand.Pressed | None = None
        self.pushes: list[hand.Push] = []
        makings = makings_of(self.content, self.seed)
        self.exact: SmoothSpheres | None = None
        self.take_bodies(bodies_of(makings, self.real, self.density), makings.surroundings)
        if self.content.exact:
            self.begin_exact()
        self.view = CollisionView()

    def take_bodies(self, bodies: SphereBodies, surroundings: Any) -> None:
        """Go on with these bodies and surroundings; what the world remembers of touches is lost."""
        before = getattr(self, "world", None)
        self.world = CollidingSpheres(bodies, surroundings, self._tables(), self._broad_phase(bodies))
        if before is not None:
            self.end_exact("there are other spheres")
            np.copyto(self.world.ring, before.ring)
            np.copyto(self.world.counters, before.counters)
        self._configure()

    def begin_exact(self) -> SmoothSpheres:
        """The event-driven run of the spheres as they are, without friction or drag."""
        bodies = self.world.bodies
        self.exact = SmoothSpheres(
            bodies.state.positions,
            bodies.velocities,
            bodies.makeup.radii,
            bodies.makeup.masses,
            restitution=self.restitution,
            wall_restitution=self.wall_restitution,
            gravity=self._pull(),
            window=self.world.surroundings.window,
        )
        return self.exact

    def _pull(self) -> float:
        """Gravity that acts, m/s²."""
        return self.gravity if GRAVITY in self.active else 0.0

    def end_exact(self, why: str) -> None:
        """The exact run is no run of these spheres any more."""
        if self.exact is not None:
            self.exact = None
            self.told.append(f"The exact run ends here: {why}.")

    def _tables(self) -> Any:
        return tables_of(
            self.content, self.restitution, self.friction, self.wall_restitution, self.wall_friction
        )

    def _broad_phase(self, bodies: SphereBodies) -> BroadPhase | None:
        if self.broad_phase == "grid":
            view = self.content.view
            cell = CELL * 2.0 * float(bodies.makeup.radii.max())
            cell = max(cell, (view.right - view.left) / 2_000.0, (view.top - view.bottom) / 2_000.0)
            return UniformGrid((view.left, view.bottom), (view.right, view.top), cell)
        if self.broad_phase == "hierarchical":
            return HierarchicalGrid()
        return SweepAndPrune() if self.broad_phase == "sweep-and-prune" else None

    def _configure(self) -> None:
        """Hand the parameters to the world; ParameterError if it refuses one."""
        try:
            self.world.change(
                effects=self.active,
                scheme=self.scheme,
                law=self.law,
                correction=self.correction,
                iterations=int(self.iterations),
                passes=int(self.passes),
                substeps=int(self.substeps),
                gravity=self.gravity,
                drag=self.drag,
                slop=self.slop,
                rest=self.rest,
                warm=self.warm,
            )
        except ValueError as error:
            raise ParameterError(str(error)) from None
        if self.exact is not None and self.exact.gravity != self._pull():
            self.end_exact("gravity is another")

    def parameter_changed(self, name: str) -> None:
        if name in TABLE_PARAMETERS:
            self.world.tables = self._tables()
            self.end_exact("the spheres are others")
        elif name == "tool":
            hand.begin_anew(self)
        elif name not in NOT_SETTINGS:
            self._configure()

    def effects_changed(self) -> None:
        self._configure()

    # -- a step -------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        hand.act(self, dt)
        self.world.step(dt)
        if self.exact is not None:
            try:
                self.exact.fly(dt, MOST_EXACT)
            except ValueError:
                self.end_exact("it has impacts without end")

    def pointer(self, event: Pointer) -> None:
        hand.take_pointer(self, event)

    def action(self, name: str) -> None:
        self.values["tool"] = name
        hand.begin_anew(self)

    def messages(self) -> Sequence[str]:
        new = tuple(self.told)
        self.told.clear()
        return new

    # -- remembering --------------------------------------------------------------------------------

    def state(self) -> SphereState:
        return state_of(self)

    def restore(self, state: SphereState) -> None:
        restore(self, state)

    def save_content(self) -> CollisionContent:
        return content_of(self)

    # -- what there is to see -----------------------------------------------------------------------

    def readouts(self) -> list[Readout]:
        return findings.readouts_of(self)

    def hearing(self) -> Hearing:
        return c13_sounds.hearing_of(self)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return self.view.legend(self)

    def panel_table(self) -> Table | None:
        return ledger_table(self)

    def point_at(self, key: int | None) -> None:
        self.view.lit = key

    def frame(self) -> Frame:
        view = self.content.view
        margin = 0.015 * (view.top - view.bottom)
        return Frame(view.left - margin, view.bottom - margin, view.right + margin, view.top + margin)

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(self, canvas, alpha)

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        """Kernels part by part."""

        def world(**settings: Any) -> CollidingSpheres:
            bodies = SphereBodies([(0.0, 0.0), (0.9, 0.0)], [0.5, 0.5], [(1.0, 0.0), (0.0, 0.0)])
            return CollidingSpheres(bodies, **settings)

        return (
            WarmUp("touches", lambda: world().overlap()),
            WarmUp("ledger", lambda: world().totals()),
            WarmUp("impulses", lambda: world().step(cls.dt)),
            WarmUp("impact times", lambda: world(effects=cls.effects).step(cls.dt)),
            WarmUp("impulses in the plane", lambda: world(path="planar").step(cls.dt)),
        )
