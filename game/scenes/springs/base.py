"""What the two mass-spring scenes share: a network of particles and links that is built, moved and torn."""

from __future__ import annotations

import dataclasses
from collections import deque
from collections.abc import Sequence
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.levels import Level
from game.physics.constraints import PositionBasedDynamics
from game.physics.constraints.editing import Topology, assemble, topology_of
from game.physics.kernels.limits import LimitError
from game.scenes.springs import hand
from game.scenes.springs.level import (
    LinkEntry,
    ParticleEntry,
    SpringContent,
    build_network,
)
from game.scenes.springs.parameters import CHOSEN_PARAMETERS, MassSpringParameters
from game.scenes.springs.saving import content_of
from game.scenes.springs.view import SpringView
from game.stage import (
    Frame,
    Hint,
    ParameterError,
    Pointer,
    Readout,
    SceneAction,
    Strip,
)

Array = NDArray[np.float64]
MOST_PROJECTIONS = 50_000_000  # of links and areas in a step: a second
ROUNDING = 1e-12  # strains and lengths (m) up to this are shown as none


class SpringState(NamedTuple):
    """What moves (see `PositionState`), and how it is linked if that is not as in the level any more."""

    fields: Array
    torn: NDArray[np.int64]
    intact: Array
    hand: Array
    own: Array  # (m,) stiffness of a link's own; empty as the following while nothing was edited
    pairs: NDArray[np.int64]
    rest: Array
    stiffness: Array
    compliance: Array
    corners: NDArray[np.int64]
    starts: NDArray[np.int64]
    areas: Array
    contacts: NDArray[np.int64]
    distances: Array


class MassSpringScene(MassSpringParameters):
    """Base of C14 and C15. A subclass says how stiff a link is."""

    dt = 1.0 / 60.0
    content_type = SpringContent
    takes: ClassVar[frozenset[str]] = frozenset(("right",))

    hints = (
        Hint(("Drag",), "move a particle"),
        Hint(("Right drag",), "cut"),
        Hint(("1", "…", "5"), "tools"),
    )
    actions = (
        SceneAction("hand", "move", "1"),
        SceneAction("particle", "new particle", "2"),
        SceneAction("link", "link two", "3"),
        SceneAction("pin", "pin or free", "4"),
        SceneAction("cut", "cut", "5"),
        SceneAction("delete", "delete what is chosen", "delete"),
    )
    strips = (
        Strip("Stretch", "", ("worst", "in all")),
        Strip("Energy", "J", ("kinetic", "potential", "sum")),
        Strip("Constraint error", "m", ("residual",)),
    )
    default_content: ClassVar[SpringContent] = SpringContent(
        particles=(ParticleEntry(position=(0.0, 3.0), inverse_mass=0.0), ParticleEntry(position=(1.5, 3.0))),
        links=(LinkEntry(ends=(0, 1)),),
    )

    # -- how stiff links are ------------------------------------------------------------------------

    def model_name(self) -> str:
        """The solver's model of a link."""
        raise NotImplementedError

    def link_numbers(self, own: Array) -> tuple[Array, Array]:
        """Stiffness (m,) and compliance (m,) m/N of links with these own stiffnesses (or NOT_OWN)."""
        raise NotImplementedError

    # -- building -----------------------------------------------------------------------------------

    def build(self, level: Level | None) -> None:
        self.content: SpringContent = (
            level.content if level is not None and level.content is not None else self.default_content
        )
        self.edited = False
        self.chosen = self.first = hand.NOBODY
        self.knife: tuple[float, float] | None = None
        self.told: deque[str] = deque(maxlen=8)
        self.projections = 0  # in a step, as far as there may be so many
        self.make_system()
        self._bound_work()
        self.view = SpringView()

    def make_system(self) -> None:
        """The level's network, at its beginning."""
        network = build_network(self.content)
        shape = network.shape
        self.own = network.own
        stiffness, compliance = self.link_numbers(self.own)
        self.system = PositionBasedDynamics(
            *shape[:3],
            stiffness,
            rest_lengths=network.rest,
            compliances=compliance,
            areas=shape.areas,
            velocities=network.velocities,
            contacts=shape.contacts,
            distances=shape.distances,
            order=self.order,
        )
        self.system.outlines.rows[0] *= network.pressures
        self._configure()

    def _configure(self) -> None:
        """Hand the parameters to the system; ParameterError if it refuses one."""
        try:
            self.system.change(
                effects=self.active,
                model=self.model_name(),
                scheme=self.scheme,
                solver=self.solver,
                substeps=int(self.substeps),
                iterations=int(self.iterations),
                gravity=self.gravity,
                damping=self.damping,
                floor=self.content.floor,
                relaxation=self.relaxation,
                speed_limit=self.speed_limit,
                stretch_limit=self.strength,
            )
        except ValueError as error:
            raise ParameterError(str(error)) from None

    def _bound_work(self) -> None:
        """LimitError if the parameters ask for more work in a step than before and than there may be."""
        system, settings = self.system, self.system.settings
        each = len(system.torn) + len(system.outlines.starts) - 1 + len(system.contacts.pairs)
        projections = each * settings.iterations * settings.substeps
        if projections > max(MOST_PROJECTIONS, self.projections):
            raise LimitError(
                f"iterations, substeps: {settings.iterations} x {settings.substeps} sweeps over {each} "
                f"links, areas and contacts are too many, {MOST_PROJECTIONS // each} at most are wanted"
            )
        self.projections = projections

    def renew_links(self) -> None:
        """Give all links the stiffness that they have now."""
        stiffness, compliance = self.link_numbers(self.own)
        self.system.links = dataclasses.replace(self.system.links, stiffness=stiffness, compliance=compliance)
        self.system.masses_changed()

    def take_system(self, system: PositionBasedDynamics, own: Array) -> None:
        """Go on with an edited system."""
        self.system, self.own, self.edited = system, own, True
        self._configure()

    def parameter_changed(self, name: str) -> None:
        if name in CHOSEN_PARAMETERS:
            hand.apply_parameter(self, name)
        elif name == "tool":
            hand.begin_anew(self)
        elif name not in ("strains", "points"):
            self._configure()
            self.renew_links()
            if name in ("iterations", "substeps"):
                self._bound_work()

    def effects_changed(self) -> None:
        self._configure()

    # -- remembering --------------------------------------------------------------------------------

    def state(self) -> SpringState:
        moving = self.system.state()
        if not self.edited:
            return SpringState(*moving, *_UNEDITED)
        topology = topology_of(self.system)
        return SpringState(
            *moving, self.own, *(part for name, part in topology._asdict().items() if name != "torn")
        )

    def restore(self, state: SpringState) -> None:
        self.edited = len(state.starts) > 0
        if not self.edited:
            if len(state.torn) != len(self.system.torn) or state.fields.shape != self.system.fields.shape:
                self.make_system()
        else:
            topology = Topology(
                state.pairs, state.rest, state.stiffness, state.compliance, state.torn, state.corners,
                state.starts, state.areas, state.contacts, state.distances,
            )  # fmt: skip
            count = state.fields.shape[1] - (self.system.fields.shape[1] - self.system.count)
            self.own = state.own.copy()
            self.system = assemble(self.system, state.fields[:, :count], topology)
        self._configure()
        if not self.edited:
            self.own = build_network(self.content).own if len(self.own) != len(state.torn) else self.own
        self.renew_links()
        self.system.restore(type(self.system.state())(*state[:4]))

    def save_content(self) -> SpringContent:
        return content_of(self)

    # -- a step -------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        before = self.system.tears
        self.system.step(dt)
        if self.system.tears > before and before == 0:
            self.told.append("A link is torn.")

    def pointer(self, event: Pointer) -> None:
        hand.take_pointer(self, event)

    def action(self, name: str) -> None:
        if name == "delete":
            hand.delete(self)
        else:
            self.values["tool"] = name
            hand.begin_anew(self)

    def messages(self) -> Sequence[str]:
        new = tuple(self.told)
        self.told.clear()
        return new

    # -- what there is to see -----------------------------------------------------------------------

    def readouts(self) -> list[Readout]:
        system = self.system
        kinetic, potential = system.energy()
        links = system.measure()
        elastic = links.energy if self.model_name() == "xpbd" else 0.0
        settings = system.settings
        projections = len(system.torn) * settings.iterations * settings.substeps
        return [
            Readout("particles", system.count),
            Readout("links", int(len(system.torn) - system.torn.sum())),
            Readout("worst", _above_rounding(links.worst_strain)),
            Readout("in all", _above_rounding(links.length_ratio - 1.0)),
            Readout("residual", _above_rounding(links.mean_excess), "m"),
            Readout("kinetic", kinetic, "J"),
            Readout("potential", potential, "J"),
            Readout("elastic", elastic, "J"),
            Readout("sum", kinetic + potential + elastic, "J"),
            Readout("torn", int(system.tears)),
            Readout("projections a step", int(projections)),
        ]

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return self.view.legend(self)

    def frame(self) -> Frame:
        view = self.content.view
        return Frame(view.left, view.bottom, view.right, view.top)

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(self, canvas, alpha)


def _above_rounding(value: float) -> float:
    """A measured error, 0 where it is rounding."""
    return value if abs(value) > ROUNDING else 0.0


_NONE, _NO_INDEX = np.zeros(0), np.zeros(0, dtype=np.int64)
_UNEDITED: tuple[Any, ...] = (
    _NONE, _NO_INDEX, _NONE, _NONE, _NONE, _NO_INDEX, _NO_INDEX, _NONE, _NO_INDEX, _NONE,
)  # fmt: skip
