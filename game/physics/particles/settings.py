"""How particles are to be moved: effects, method, forces, solids, each checked where it comes in."""

from __future__ import annotations

import math

import numpy as np

from game.physics.effects import Effect, EffectSet
from game.physics.fields import DRAG, GRAVITY, QUADRATIC_DRAG, WHIRL, WIND
from game.physics.particles.contacts import CONTACTS
from game.physics.particles.effects import PARTICLES
from game.physics.particles.flight import EXPONENTIAL, METHODS, STABILITY_LIMITS
from game.physics.particles.forces import AIR_BITS, Forces
from game.physics.particles.solids import LARGEST, Discs

CALM = Forces(9.81, 0.1, 0.02, 0.0, 0.0, 0.0, 2.0, 0.0, 0.5, 0.0, 0.0, 0.0)
SMOOTH = 0.25  # drag times substep at which every method is within 1 % of the exact decay
MAX_SUBSTEPS = 64


class Settings:
    """What a step does with particles. Every setter raises ValueError, naming the field, for nonsense.

    effects: of `PARTICLES`. method: of METHODS. contact: of CONTACTS. life: s. forces: `Forces`. floor: m.
    floor_restitution: 0 to 1. substeps: of a step; 0 for as many as drag needs to be stable and smooth.
    """

    def __init__(
        self,
        solids: Discs,
        effects: EffectSet | Effect,
        method: str,
        contact: str,
        life: float,
        forces: Forces,
        floor: float,
        floor_restitution: float,
        substeps: int,
    ):
        self.solids = solids
        self.effects = effects
        self.method = method
        self.contact = contact
        self.life = life
        self.forces = forces
        self.substeps = substeps
        self.set_ground(floor, floor_restitution)

    @property
    def effects(self) -> EffectSet:
        """What a step computes."""
        return self._effects

    @effects.setter
    def effects(self, effects: EffectSet | Effect) -> None:
        self._effects = PARTICLES.checked(effects)
        self.mask = PARTICLES.mask(self._effects)

    @property
    def method(self) -> str:
        """The integrator, of METHODS."""
        return METHODS[self._method]

    @method.setter
    def method(self, name: str) -> None:
        if name not in METHODS:
            raise ValueError(f"method = {name!r}: expected one of {', '.join(METHODS)}")
        self._method = METHODS.index(name)

    @property
    def contact(self) -> str:
        """How impacts are found, of CONTACTS."""
        return CONTACTS[self._contact]

    @contact.setter
    def contact(self, name: str) -> None:
        if name not in CONTACTS:
            raise ValueError(f"contact = {name!r}: expected one of {', '.join(CONTACTS)}")
        self._contact = CONTACTS.index(name)

    @property
    def life(self) -> float:
        """How long each particle lives, s; a change holds for those alive too."""
        return self._life

    @life.setter
    def life(self, value: float) -> None:
        if not 0.0 < value < math.inf:
            raise ValueError(f"life = {value!r}: expected a finite number above 0 s")
        self._life = float(value)

    @property
    def forces(self) -> Forces:
        """The numbers of the force law; change them by `forces._replace(...)`."""
        return self._forces

    @forces.setter
    def forces(self, forces: Forces) -> None:
        for name, value in forces._asdict().items():
            least = 0.0 if name in ("drag", "quadratic_drag", "pull") else -LARGEST
            if not least <= value <= LARGEST:
                raise ValueError(f"{name} = {value!r}: expected {least:g} to {LARGEST:g}")
        if forces.whirl_core <= 0.0:
            raise ValueError(f"whirl_core = {forces.whirl_core!r}: expected more than 0 m")
        self._forces = Forces(*map(float, forces))
        self._law = np.array(self._forces)

    @property
    def substeps(self) -> int:
        """Substeps of a step; 0: as many as drag needs."""
        return self._substeps

    @substeps.setter
    def substeps(self, value: int) -> None:
        if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= MAX_SUBSTEPS:
            raise ValueError(f"substeps = {value!r}: expected a whole number, 0 to {MAX_SUBSTEPS}")
        self._substeps = value

    @property
    def floor(self) -> float:
        """Height of the floor, m."""
        return self._floor

    @property
    def floor_restitution(self) -> float:
        """Speed after over speed before an impact on the floor."""
        return self._floor_restitution

    def set_ground(self, floor: float, restitution: float) -> None:
        """Height of the floor (m) and its restitution, 0 to 1. ValueError for what is out of range."""
        if not abs(floor) <= LARGEST:
            raise ValueError(f"floor = {floor!r}: expected a finite number up to {LARGEST:g}")
        if not 0.0 <= restitution <= 1.0:
            raise ValueError(f"floor_restitution = {restitution!r}: expected 0 to 1")
        self._floor, self._floor_restitution = float(floor), float(restitution)

    # -- what follows from them ---------------------------------------------------------------------

    def fastest_birth(self) -> float:
        """The greatest speed (m/s) at which a particle starts; 0 without emitters."""
        return 0.0

    def air_speed(self) -> float:
        """The greatest speed (m/s) of the air anywhere."""
        forces, speed = self._forces, 0.0
        if WIND in self._effects:
            speed = math.sqrt(forces.wind_x * forces.wind_x + forces.wind_y * forces.wind_y)
        if WHIRL in self._effects:
            speed += abs(forces.whirl_strength) / (2.0 * forces.whirl_core)
        return speed

    def may_run_away(self, h: float) -> bool:
        """Whether a substep of h (s) is too long for drag on somebody: it may speed up and not slow down."""
        limit = STABILITY_LIMITS[self._method]
        if not self.mask & AIR_BITS or math.isinf(limit):
            return False
        fall = abs(self._forces.gravity) * self._life if GRAVITY in self._effects else 0.0
        pushed = 2.0 * float(np.abs(self.solids.rows[:, 3:5]).sum(axis=1).max(initial=0.0))
        fastest = max(self.fastest_birth(), self.fastest_added()) + self.air_speed() + fall + pushed
        rate = self._forces.drag if DRAG in self._effects else 0.0
        if QUADRATIC_DRAG in self._effects:
            rate += 2.0 * self._forces.quadratic_drag * fastest
        return rate * h > limit

    def fastest_added(self) -> float:
        """The greatest speed (m/s) of a particle that was put in by itself; 0 if none was."""
        return 0.0

    def stiffness(self) -> float:
        """The fastest rate (1/s) at which drag slows anything that is sent out."""
        rate = self._forces.drag if DRAG in self._effects else 0.0
        if QUADRATIC_DRAG in self._effects:
            rate += 2.0 * self._forces.quadratic_drag * (self.fastest_birth() + self.air_speed())
        return rate

    def substeps_for(self, dt: float) -> int:
        """Substeps that a step of dt (s) is divided into."""
        if self._substeps:
            return self._substeps
        if not self.mask & AIR_BITS:
            return 1
        if self._method == EXPONENTIAL:
            return 1
        return min(max(math.ceil(self.stiffness() * dt / SMOOTH), 1), MAX_SUBSTEPS)

    def slack(self, h: float) -> float:
        """How much farther than h |v| (m) a particle near a solid may get in h (s)."""
        forces, solids = self._forces, self.solids
        push = abs(forces.gravity) if GRAVITY in self._effects else 0.0
        if forces.pull:
            arms = np.abs(solids.centres - (forces.pull_x, forces.pull_y)).sum(axis=1) + solids.radii
            arm = max(float(np.max(arms, initial=0.0)), abs(self.floor - forces.pull_y))
            push += forces.pull * (1.0 + arm)
        return h * (h * push + self.air_speed())
