"""A fountain of particles over a stone, by seven methods and three ways to meet the stone."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from typing import Any

import numpy as np

from game.lab.studies.particles import bounce_study
from game.levels import Level
from game.physics.fields import DRAG, GRAVITY, WIND
from game.physics.kernels.limits import LimitError
from game.physics.particles import CALM, OBSTACLES, Discs, Emitter, Forces, ParticleSystem
from game.physics.particles.encounters import STEP
from game.scenes.fountain import C04, hand
from game.scenes.fountain import readouts as findings
from game.scenes.fountain.figure import draw_impact
from game.scenes.fountain.level import MOST_STONES, FountainContent, Stone
from game.scenes.fountain.parameters import FountainParameters
from game.scenes.fountain.view import FountainView
from game.stage import (
    Equation,
    Frame,
    Hint,
    Pointer,
    Readout,
    SceneAction,
    SetParameter,
    StageEvent,
    Strip,
)

HAND_SPEED = 25.0  # m/s, at which a stone follows the hand at most
MANY_PLACES = 200_000
MOST_MEETINGS = 32_000_000  # of a particle and a solid in a step, each substep again: a second or so at worst
TOUCH_TIME = 1.0 / 60.0  # s for which a particle counts as touching


class Fountain(FountainParameters):
    """Each particle is a point of 1 kg. It leaves the nozzle at its own instant within a step, in a random
    direction inside the spread, falls, is slowed by the air, and bounces off the stone and the ground by
    Newton's law of impact.

    The dashed curve is exact: no particle of this speed can pass it before it has touched something. A method
    of first order shows spray above it. Without fast drag and whirl all particles of one age lie on a
    circle that is known exactly; the error is how far the worst of them is off.

    Handling an impact at the end of a step makes every method one of first order. Interpolating along the
    chord restores the second, and solving for the instant of the impact the full order.
    """

    name, task, title = C04.names
    content_type = FountainContent
    study = bounce_study
    takes = frozenset(("right",))

    strips = (
        Strip("Energy", "J", ("potential", "kinetic")),
        Strip("Highest particle", "m", ("exact", "highest"), ("exact",)),
        Strip("Error", "m", ("error",)),
    )
    hints = (
        Hint(("Drag",), "move stone, nozzle, rim"),
        Hint(("Shift", "Click"), "new stone"),
        Hint(("Right click",), "remove stone"),
    )
    actions = (
        SceneAction("emit", "emitter on or off", "E"),
        SceneAction("clear", "clear all particles", "C"),
    )
    figure = staticmethod(draw_impact)
    equations = (
        Equation(
            "Motion, with drag and wind",
            r"\v{a} = \v{g} - (k + q\abs{\v{v}-\v{w}})(\v{v}-\v{w})",
            "Newton 1687",
        ),
        Equation(
            "Velocity Verlet",
            r"\v{x}_{n+1} = \v{x}_n + h\v{v}_n + \frac{1}{2}h^2\v{a}_n",
            "Swope and others 1982",
        ),
        Equation("", r"\v{v}_{n+1} = \v{v}_n + \frac{1}{2}h(\v{a}_n + \v{a}_{n+1})"),
        Equation("Impact", r"\v{v}^+ = \v{v}^- - (1+e)(\v{v}^- \cdot \v{n})\v{n}", "Newton 1687"),
        Equation("Envelope of all paths", r"y = \frac{v^2}{2g} - \frac{g x^2}{2 v^2}", "Torricelli 1644"),
        Equation(
            "Births", r"t_n = n / \text{rate},  N(T) = \floor{\text{rate} \, T}", "each at its own instant"
        ),
    )
    try_this = (
        "Choose explicit Euler and a long time step: the spray rises above the dashed curve.",
        "Set the restitution to 1 and watch the energy strip stay level; then choose step end as impact.",
        "Switch drag and wind on: the bars show what each costs; the dashed curve is still exact.",
        "Raise the places to 100 000 and the emit rate to 40 000: see what a step costs then.",
    )

    # -- building -----------------------------------------------------------------------------------

    def build(self, level: Level | None) -> None:
        content = level.content if level is not None and level.content is not None else FountainContent()
        self.content: FountainContent = content
        self.emitting = True
        self.own = [stone.restitution for stone in content.stones]
        self.hand: tuple[str, int] = hand.NOTHING
        self.target = (0.0, 0.0)
        self.grip = (0.0, 0.0)
        self.since = 0.0  # s: who was born later knows no other law and nozzle than the present ones
        self.told: deque[str] = deque(maxlen=8)
        self.full = False
        stones = Discs(capacity=MOST_STONES)
        for stone in content.stones:
            stones.add(stone.centre, stone.radius, self._restitution(stone.restitution))
        self.system = ParticleSystem(
            int(self.places),
            solids=stones,
            effects=self.active,
            seed=self.seed,
            floor=content.floor,
            emitters=[self._emitter(i) for i in range(len(content.nozzles))],
        )
        self.whirl_centre = content.whirl
        if content.particles:
            self.system.add(
                [particle.position for particle in content.particles],
                [particle.velocity for particle in content.particles],
            )
        self.configure()
        self.meetings = 0
        self._bound_work()
        self.view = FountainView()

    def _restitution(self, own: float | None) -> float:
        return self.restitution if own is None else own

    def _emitter(self, index: int, position: tuple[float, float] | None = None) -> Emitter:
        """A nozzle of the level with the panel's numbers."""
        nozzle = self.content.nozzles[index]
        shares = sum(other.share for other in self.content.nozzles)
        part = nozzle.share / shares if shares > 0.0 else 0.0
        return Emitter(
            nozzle.position if position is None else position,
            rate=self.rate * part if self.emitting else 0.0,
            speed=self.speed,
            spread=math.radians(self.spread),
            axis=math.radians(nozzle.tilt),
        )

    def configure(self) -> None:
        """Hand all parameters to the system."""
        system = self.system
        system.effects = self.active
        system.method = self.method
        system.contact = self.contact
        system.life = self.life
        system.substeps = 0 if self.smooth else 1
        system.set_ground(self.content.floor, self.ground_restitution)
        system.forces = CALM._replace(
            gravity=self.gravity,
            drag=self.drag,
            quadratic_drag=self.fast_drag,
            wind_x=self.wind,
            whirl_strength=self.whirl,
            whirl_x=self.whirl_centre[0],
            whirl_y=self.whirl_centre[1],
        )
        for j, own in enumerate(self.own):
            system.solids.rows[j, 5] = self._restitution(own)

    def _bound_work(self) -> None:
        """LimitError if the parameters ask for more work in a step than before and than there may be."""
        substeps = self.system.substeps_for(self.step_length)
        meetings = int(self.places) * substeps * (1 + len(self.own))
        if meetings > max(MOST_MEETINGS, self.meetings):
            most = MOST_MEETINGS // (substeps * (1 + len(self.own)))
            raise LimitError(
                f"places: {int(self.places)} are too many for {substeps} substeps among {1 + len(self.own)} "
                f"solids, {most} at most; less drag or a shorter time step takes fewer substeps"
            )
        self.meetings = meetings

    def _change_emitters(self) -> None:
        """Give the nozzles the panel's numbers, where they are."""
        for index in range(len(self.content.nozzles)):
            row = self.system.state().emitters[index]
            self.system.change_emitter(index, self._emitter(index, (float(row[0]), float(row[1]))))

    def takes_long(self, event: StageEvent | None) -> bool:
        """Very many places, which are all laid out anew."""
        return isinstance(event, SetParameter) and event.name == "places" and float(event.value) > MANY_PLACES

    def parameter_changed(self, name: str) -> None:
        if name in ("rate", "speed", "spread"):
            self._change_emitters()
        else:
            self.configure()
        if name in ("speed", "gravity", "drag", "wind", "fast_drag", "whirl"):
            self.since = self.system.time_s
        self._bound_work()

    def effects_changed(self) -> None:
        self.configure()
        self.since = self.system.time_s
        self._bound_work()

    def state(self) -> Any:
        return self.system.state()

    def restore(self, state: Any) -> None:
        self.system.restore(state)

    def save_content(self) -> FountainContent:
        """The level as it stands now; living particles are not kept."""
        emitters = self.system.state().emitters
        return FountainContent(
            nozzles=tuple(
                type(nozzle)(position=(float(row[0]), float(row[1])), tilt=nozzle.tilt, share=nozzle.share)
                for nozzle, row in zip(self.content.nozzles, emitters, strict=True)
            ),
            stones=tuple(
                Stone(centre=(float(row[0]), float(row[1])), radius=float(row[2]), restitution=own)
                for row, own in zip(self.system.solids.rows, self.own, strict=True)
            ),
            floor=self.content.floor,
            whirl=self.whirl_centre,
            view=self.content.view,
        )

    # -- a step -------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        system, (what, index) = self.system, self.hand
        if (system.forces.whirl_x, system.forces.whirl_y) != self.whirl_centre:
            self.configure()  # the whirl was put back by a step back
        if what == "stone":
            way = np.array(self.target) - system.solids.centres[index]
            pace = math.sqrt(float(way @ way)) / dt
            system.solids.carry(index, way / dt * min(1.0, HAND_SPEED / pace if pace > 0.0 else 1.0))
        dropped, moving = system.dropped, system.has_moving_emitters
        system.step(dt)
        if moving:  # who was born on the way did not leave the nozzle where it is now
            self.since = system.time_s
        if what == "stone":
            system.solids.carry(index, (0.0, 0.0))
        full = system.dropped > dropped
        if full and not self.full:
            self.told.append(
                f"The pool of {system.capacity} is full: further births are dropped and counted."
            )
        self.full = full

    def messages(self) -> Sequence[str]:
        new = tuple(self.told)
        self.told.clear()
        return new

    # -- the hand -----------------------------------------------------------------------------------

    def pointer(self, event: Pointer) -> None:
        hand.take_pointer(self, event)

    def action(self, name: str) -> None:
        if name == "emit":
            self.emitting = not self.emitting
            self._change_emitters()
        else:
            self.system.clear()

    # -- what there is to see -----------------------------------------------------------------------

    def law(self) -> Forces:
        """The force law with what is off taken out."""
        forces, on = self.system.forces, self.active
        windy = WIND in on and DRAG in on
        return forces._replace(
            gravity=forces.gravity if GRAVITY in on else 0.0,
            drag=forces.drag if DRAG in on else 0.0,
            wind_x=forces.wind_x if windy else 0.0,
        )

    def touching_since(self) -> int:
        """Number of the first step whose impacts still count as touching."""
        steps = max(1, round(TOUCH_TIME / self.step_length))
        return max(int(self.system.tallies[STEP]) + 1 - steps, 1)

    def readouts(self) -> list[Readout]:
        return findings.readouts(self)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        rows = [("scale:slow:fast", "Speed", f"0 {self.view.top_speed(self):.3g} m/s")]
        if OBSTACLES in self.active and len(self.own):
            rows.append(
                ("disc:amber", "touching the stone" if len(self.own) == 1 else "touching a stone", "")
            )
        if len(findings.exact_envelope(self)):
            older = 0.0 < self.since > self.system.time_s - self.life
            rows.append(("dash:text1", "exact for those born since" if older else "exact envelope", ""))
        return rows

    def frame(self) -> Frame:
        view = self.content.view
        return Frame(view.left, view.bottom, view.right, view.top)

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(self, canvas, alpha)
