"""Particles, links and outlines, and one step of all of it by position based dynamics."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats, Longs
from game.physics.constraints import motion as m
from game.physics.constraints.areas import AREA, INTACT, measure_areas
from game.physics.constraints.attachments import nearest_pins
from game.physics.constraints.effects import ATTACHMENTS, LINKED, TEARING
from game.physics.constraints.graph import Links, Outlines, arms_of, checked, checked_pairs
from game.physics.constraints.grip import (
    empty_hand,
    give_mass,
    hand_on,
    let_go,
    own_masses,
    patch_of,
    take_hold,
)
from game.physics.constraints.links import MODELS, REST, prepare_links
from game.physics.constraints.measures import measure_energy, measure_links, measure_momentum
from game.physics.constraints.motion import Motion, advance
from game.physics.constraints.network import NOBODY, PADDING, network_of
from game.physics.constraints.schemes import SCHEMES
from game.physics.constraints.settings import LARGEST, Settings, effects_for
from game.physics.constraints.tearing import break_link, tear


class PositionState(NamedTuple):
    """What moves. The arrays are the system's own, not copies."""

    fields: Floats  # (12, n + padding): see motion
    torn: Longs  # (m,)
    intact: Floats  # (k,) outlines
    hand: Floats  # (6 + 3 k,): who is held and who is led along, see grip


class LinkMeasures(NamedTuple):
    """How far links are off."""

    worst_strain: float
    mean_excess: float  # m, root of the mean square
    energy: float  # J, by the compliances
    length_ratio: float  # of all links together, to what they are at rest


class PositionBasedDynamics:
    """Particles held together by links and outlines.

    positions: (n, 2) m. inverse_masses: (n,) 1/kg, 0 is fixed. links: (m, 2) particles. stiffness: (m,) or
    one number, 0 to 1. rest_lengths: (m,) m, else as given by the positions. compliances: (m,) m/N, for the
    model "xpbd". areas: closed outlines of particles. order: of ORDERS, in which links are solved.
    velocities: (n, 2) m/s. contacts: (c, 2) pairs that bounce off each other at their distances (c,) m.
    settings: fields of `Settings`; without effects, all that the arguments ask for. ValueError, naming what
    is wrong, for nonsense.
    """

    def __init__(
        self,
        positions: ArrayLike,
        inverse_masses: ArrayLike = 1.0,
        links: ArrayLike = (),
        stiffness: ArrayLike = 1.0,
        *,
        rest_lengths: ArrayLike | None = None,
        compliances: ArrayLike = 0.0,
        areas: Any = (),
        area_stiffness: ArrayLike = 1.0,
        area_compliance: ArrayLike = 0.0,
        velocities: ArrayLike | None = None,
        contacts: ArrayLike = (),
        distances: ArrayLike = 0.0,
        order: str = "coloured",
        **settings: Any,
    ):
        places = checked_pairs("positions", positions)
        n = len(places)
        if "effects" not in settings:
            settings["effects"] = effects_for(len(areas) > 0, np.size(contacts) > 0)
        self.settings = Settings(**settings)
        self.fields = np.zeros((m.FIELD_ROWS, n + PADDING))
        self.count = n
        self.order = order
        self.fields[m.X : m.Y + 1, :n] = places.T
        self.fields[m.INVERSE_MASS, :n] = checked("inverse_masses", inverse_masses, n, 0.0, 1e15)
        self.fields[m.FRESH] = 1.0
        if velocities is not None:
            self.fields[m.VX : m.VX + 2, :n] = checked_pairs("velocities", velocities, n).T
        self.links = Links.between(places, links, rest_lengths, stiffness, compliances)
        self.outlines = Outlines.around(places, areas, None, area_stiffness, area_compliance)
        self.torn = np.zeros(len(self.links.pairs), dtype=np.int64)
        self.hand = empty_hand()
        self.tears = 0
        self.contacts = Links.between(places, contacts, distances)
        self._arrange()

    # -- what it is made of -------------------------------------------------------------------------

    def change(self, **settings: Any) -> None:
        """Other settings from now on; ValueError, and nothing changed, if one of them makes no sense."""
        before = self.settings
        self.settings = dataclasses.replace(before, **settings)
        try:
            if self.settings.solver != before.solver:
                self._arrange()
        except ValueError:
            self.settings = before
            raise
        if self.settings.scheme != before.scheme:
            self.fields[m.FRESH] = 1.0
        self.hand[4] = 0.0

    def _arrange(self) -> None:
        """Bring links into the order of solving."""
        self._net = network_of(
            self.count, self.links, self.outlines, self.contacts, self.torn, self.order,
            self.settings.solver == "direct",
        )  # fmt: skip
        self._strains = np.zeros(len(self.torn))
        self.hand[4] = 0.0

    def _prepare(self, h: float, soft_step: float) -> None:
        """Bring the numbers of links up to date with masses, settings and the length of a substep (s)."""
        settings, net = self.settings, self._net
        prepare_links(
            self.inverse_masses, net, self.links.stiffness, self.links.compliance,
            MODELS.index(settings.model), settings.iterations, settings.relaxation, soft_step,
        )  # fmt: skip
        if ATTACHMENTS in settings.effects:
            arms = arms_of(net.links, self.count)
            nearest_pins(
                self.own_inverse_masses(),
                *arms,
                net.link_rows[REST],
                net.order,
                self.torn,
                net.pins,
                net.reaches,
            )
        self.hand[4:6] = h, soft_step

    # -- a step -------------------------------------------------------------------------------------

    def step(self, dt: float) -> None:
        """Go on by dt (s). ValueError unless it is finite and above 0."""
        if not 0.0 < dt < math.inf:
            raise ValueError(f"dt = {dt!r}: expected a finite number above 0 s")
        settings = self.settings
        h = dt / settings.substeps
        if h != self.hand[4] > 0.0:
            self.fields[m.FRESH] = 1.0  # the difference over two steps wants them to be equal
        if settings.scheme == "bdf2":
            ahead = settings.substeps
            if np.all(self.fields[m.FRESH, : self.count] > 0.0):
                # the first substep is one of Euler, also in what a compliance means
                ahead -= 1
                self._advance(h, h, 1, ahead)
            if ahead:
                self._advance(h, h * 2.0 / 3.0, ahead, 0)
        else:
            self._advance(h, h, settings.substeps, 0)
        if TEARING in settings.effects:
            torn = tear(self.fields[m.X], self.fields[m.Y], self._net, settings.stretch_limit)
            if torn:
                self.tears += torn
                if ATTACHMENTS in settings.effects:
                    self._prepare(*self.hand[4:6].tolist())

    def _advance(self, h: float, soft_step: float, substeps: int, ahead: int) -> None:
        """Some substeps of h (s), with compliance as α / soft_step²; ``ahead`` more of the step follow."""
        settings = self.settings
        if h != self.hand[4] or soft_step != self.hand[5]:
            self._prepare(h, soft_step)
        motion = Motion(
            LINKED.mask(settings.effects), MODELS.index(settings.model), SCHEMES.index(settings.scheme),
            int(settings.solver == "direct"), substeps, settings.iterations, ahead, h, soft_step,
            float(settings.gravity), float(settings.damping), float(settings.floor),
            float(settings.left), float(settings.right), float(settings.body_distance),
            float(settings.speed_limit), float(settings.restitution),
        )  # fmt: skip
        advance(self.fields, self.count, motion, self._net, self.held, self.hand[2:4], patch_of(self.hand))

    # -- the hand -----------------------------------------------------------------------------------

    @property
    def held(self) -> int:
        """The particle that the hand holds, or -1."""
        return int(self.hand[0])

    def grab(self, index: int, radius: float = 0.0) -> None:
        """Hold a particle: it is fixed, but follows `drag`; those within ``radius`` (m) are led along.

        ValueError for a number that no particle has, or a radius that is no number of at least 0.
        """
        if not 0.0 <= radius < math.inf:
            raise ValueError(f"radius = {radius!r}: expected a finite number of at least 0 m")
        if not 0 <= index < self.count:
            raise ValueError(f"particle {index}: there are 0 to {self.count - 1}")
        self.release()
        self.hand = hand_on(index, self.fields[m.X : m.Y + 1, : self.count].T, self.inverse_masses, radius)
        take_hold(self.hand, self.inverse_masses)

    def drag(self, target: ArrayLike) -> None:
        """Where the held particle is to be after the next step, (2,) m; no faster than the speed limit.

        ValueError for what is no place within the world.
        """
        self.hand[2:4] = checked_pairs("target", target, 1)[0]

    def release(self) -> None:
        """Let go: the particle has its mass again, and goes on as fast as it was led."""
        if self.held != NOBODY:
            let_go(self.hand, self.fields)
            self.hand = empty_hand(self.hand)

    def own_inverse_masses(self) -> Floats:
        """(n,) 1/kg, a copy: as they are when the hand lets go."""
        return own_masses(self.hand, self.inverse_masses)

    def give_inverse_mass(self, index: int, inverse_mass: float) -> None:
        """Give a particle another inverse mass, 1/kg, also in the hand; with 0 it stands still."""
        give_mass(self.hand, self.fields, index, inverse_mass)
        self.masses_changed()

    def cut(self, link: int) -> None:
        """Break a link (of the order given). ValueError for a number that no link has."""
        if not 0 <= link < len(self.torn):
            raise ValueError(f"link {link}: there are {len(self.torn)}")
        if not self.torn[link]:
            break_link(self._net, int(np.flatnonzero(self._net.order == link)[0]))
            self.tears += 1
            if ATTACHMENTS in self.settings.effects:
                self.hand[4] = 0.0

    # -- what there is ------------------------------------------------------------------------------

    @property
    def positions(self) -> Floats:
        """(n, 2) m, a copy."""
        return np.array(self.fields[m.X : m.Y + 1, : self.count].T, order="C")

    @property
    def velocities(self) -> Floats:
        """(n, 2) m/s, a copy."""
        return np.array(self.fields[m.VX : m.VX + 2, : self.count].T, order="C")

    @property
    def inverse_masses(self) -> Floats:
        """(n,) 1/kg: a view; call `masses_changed` after writing to it."""
        return self.fields[m.INVERSE_MASS, : self.count]

    def masses_changed(self) -> None:
        """Inverse masses or the links' own numbers were written to: use them from the next step on."""
        self.hand[4] = 0.0

    def energy(self) -> tuple[float, float]:
        """Kinetic and potential energy, J; height counts from the floor, or from 0 if that is far below."""
        floor = self.settings.floor if self.settings.floor > -LARGEST else 0.0
        return measure_energy(self.fields, self.count, float(self.settings.gravity), float(floor))

    def momentum(self) -> tuple[float, float, float]:
        """Momentum (kg m/s) and angular momentum about the origin (kg m²/s)."""
        return measure_momentum(self.fields, self.count)

    def measure(self) -> LinkMeasures:
        """How far links are off now."""
        net = self._net
        found = measure_links(
            self.fields, net.links, net.link_rows, net.order, self.torn, self.links.compliance, self._strains
        )
        return LinkMeasures(*found)

    @property
    def strains(self) -> Floats:
        """(m,) strain of each link in the order given, as of the last `measure`."""
        given = np.empty_like(self._strains)
        given[self._net.order] = self._strains
        return given

    @property
    def body_pairs(self) -> int:
        """Pairs of particles of different bodies."""
        sizes = np.diff(self._net.body_starts)
        return int((self.count * self.count - (sizes * sizes).sum()) // 2)

    def areas(self) -> tuple[Floats, Floats]:
        """Areas (k,) m² of the outlines, now and at rest."""
        outlines = self.outlines
        now = np.empty(len(outlines.starts) - 1)
        measure_areas(self.fields[m.X], self.fields[m.Y], outlines.corners, outlines.starts, now)
        return now, outlines.rows[AREA].copy()

    # -- remembering --------------------------------------------------------------------------------

    def state(self) -> PositionState:
        """The state as arrays that the system goes on using."""
        return PositionState(self.fields, self.torn, self.outlines.rows[INTACT], self.hand)

    def restore(self, state: PositionState) -> None:
        """Take over a copy of a state of a system of the same particles and links."""
        np.copyto(self.fields, state.fields)
        np.copyto(self.torn, state.torn)
        self.outlines.rows[INTACT] = state.intact
        self.hand = state.hand.copy()
        self.tears = int(np.count_nonzero(self.torn))
        if self.hand[4] > 0.0:
            self._prepare(*self.hand[4:6].tolist())

    def check(self) -> None:
        """Verify what must always hold; AssertionError names what does not."""
        assert np.all(np.isfinite(self.fields[: m.OLD_VX + 2])), "finite"
        held = self.held
        assert held == NOBODY or self.fields[m.INVERSE_MASS, held] == 0.0, "what is held is fixed"
        net = self._net
        assert sorted(net.order.tolist()) == list(range(len(self.torn))), "each link is solved once"
        assert np.all(net.links == self.links.pairs[net.order]), "links in the order of solving"
        for start, length, together in net.runs.tolist():
            run = net.links[start : start + length]
            assert not together or len(np.unique(run)) == 2 * length, "no particle twice in a run"
