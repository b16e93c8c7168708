"""Plates in air: what they are, what comes in, and one step of all of them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.constraints.effects import CONTACTS
from game.physics.effects import Effect, EffectSet
from game.physics.fields import GRAVITY, GROUND, QUADRATIC_DRAG
from game.physics.fields import WIND as WINDS
from game.physics.kernels import elementary, elementwise
from game.physics.plates import contacts as touching
from game.physics.plates import impulses, law
from game.physics.plates.checks import (
    LARGEST,
    PlateSettings,
    checked_settings,
    checked_walls,
    slopes_of,
)
from game.physics.plates.effects import BENDING, CIRCULATION, GUST_INERTIA, PLATES
from game.physics.plates.flight import (
    LANES,
    METHODS,
    ROWS,
    WIND,
    fly,
)
from game.physics.plates.law import Plate, checked_plate, law_of
from game.physics.plates.wind import GustyWind
from game.physics.surfaces.sample_fields import Field

MOST_PLATES = 4_096
MOST_CONTACTS = 16  # for each plate
FASTEST_SPIN = 1e5  # rad/s
EVERYTHING = PLATES.known


class Feels(Protocol):
    """A wind that knows its gradient and rate."""

    def feel(self, places: Floats, time: float, air: Floats) -> None:
        """Write velocity, gradient and rate (WIND, n) at places (rows x and y of (k, n) m)."""


class PlateState(NamedTuple):
    """All that later steps depend on: state and laws of `law`, time (s), the wind that was felt last (2, n),
    contacts of the last step (k, WARM).
    """

    rows: Floats
    laws: Floats
    time: Floats
    felt: Floats
    warm: Floats


class Plates:
    """Plates, each with a law of its own, in a wind.

    wind: a `GustyWind`, any `Field` of two columns (whose slopes are taken by differences), or None: still
    air. walls: (m, 4) m, segments that nothing passes, or (m, 6) with radius (m) and friction. effects: of
    `PLATES`. method: one of METHODS.     ValueError, naming the argument, for what makes no sense.
    """

    def __init__(
        self,
        plates: Sequence[Plate] = (),
        places: ArrayLike = (),
        *,
        effects: EffectSet | Effect = EVERYTHING,
        wind: Feels | Field | None = None,
        walls: ArrayLike = (),
        method: str = "rk4",
        settings: PlateSettings = PlateSettings(),  # noqa: B008 - a tuple of numbers
    ):
        self.effects = PLATES.checked(effects)
        self.wind = wind
        self.set_method(method)
        self.settings = checked_settings(settings)
        self.walls = checked_walls(walls)
        self.rows: Floats = np.zeros((law.STATE, 0))
        self.laws: Floats = np.zeros((law.COLUMNS, 0))
        self.felt: Floats = np.zeros((2, 0))
        self.time = 0.0
        self._buffer, self._counts = np.zeros(ROWS * LANES), np.zeros(LANES, dtype=np.int64)
        self._make_room()
        where = np.asarray(places, dtype=np.float64).reshape(-1, 3) if len(plates) else np.zeros((0, 3))
        if len(where) != len(plates):
            raise ValueError(f"places: expected (x, y, angle) for each of {len(plates)} plates")
        self.add_all(plates, where)

    # -- what there is ------------------------------------------------------------------------------

    def __len__(self) -> int:
        return int(self.rows.shape[1])

    def add(
        self, plate: Plate, place: tuple[float, float], angle: float = 0.0,
        velocity: tuple[float, float] = (0.0, 0.0), spin: float = 0.0,
    ) -> int:  # fmt: skip
        """One more plate, bent as it is at rest; its number. ValueError for nonsense, or too many."""
        self.add_all([plate], np.array([[*place, angle]]))
        last = len(self) - 1
        self.set_motion(last, velocity, spin)
        return last

    def add_all(self, plates: Sequence[Plate], places: Floats) -> None:
        """More plates at rest at (x m, y m, angle rad), (n, 3)."""
        if len(self) + len(plates) > MOST_PLATES:
            raise ValueError(f"plates: expected at most {MOST_PLATES}")
        if not np.isfinite(places).all() or (len(places) and np.max(np.abs(places)) > LARGEST):
            raise ValueError(f"places: expected finite numbers within {LARGEST:g}")
        rows, laws = np.zeros((law.STATE, len(plates))), np.zeros((law.COLUMNS, len(plates)))
        for k, plate in enumerate(plates):
            laws[:, k] = law_of(checked_plate(plate))
        rows[law.X], rows[law.Y], rows[law.THETA] = places.T
        rows[law.BEND] = laws[law.CURL]
        self.rows = np.ascontiguousarray(np.concatenate([self.rows, rows], axis=1))
        self.laws = np.ascontiguousarray(np.concatenate([self.laws, laws], axis=1))
        self._make_room()
        self.felt = self._wind_now()

    def set_motion(self, number: int, velocity: tuple[float, float], spin: float) -> None:
        """Give a plate a velocity (m/s) and a spin (rad/s)."""
        if not all(map(math.isfinite, (*velocity, spin))):
            raise ValueError(f"velocity = {velocity!r}, spin = {spin!r}: expected finite numbers")
        if elementary.length(*velocity) > LARGEST or abs(spin) > FASTEST_SPIN:
            raise ValueError(
                f"velocity = {velocity!r}, spin = {spin!r}: faster than {LARGEST:g}, {FASTEST_SPIN:g}"
            )
        self.rows[law.VX, number], self.rows[law.VY, number] = velocity
        self.rows[law.SPIN, number] = spin

    def set_method(self, method: str) -> None:
        """Another of METHODS from now on; ValueError for none of them."""
        if method not in METHODS:
            raise ValueError(f"method = {method!r}: expected one of {', '.join(METHODS)}")
        self._method = float(METHODS.index(method))

    def change(self, number: int, plate: Plate) -> None:
        """Another law for a plate from now on."""
        self.laws[:, number] = law_of(checked_plate(plate))

    def remove(self, number: int) -> None:
        """Take a plate away; those after it move up."""
        self.rows = np.ascontiguousarray(np.delete(self.rows, number, axis=1))
        self.laws = np.ascontiguousarray(np.delete(self.laws, number, axis=1))
        self.felt = np.ascontiguousarray(np.delete(self.felt, number, axis=1))
        self._make_room()

    def _make_room(self) -> None:
        n = len(self)
        self.air: Floats = np.zeros((WIND, n))
        self.touched: Floats = np.zeros(n)
        self._before, self._points = (
            np.zeros((law.STATE, n)),
            np.zeros((n, touching.POINTS, touching.PER_POINT)),
        )
        self._order = np.arange(n)
        most = MOST_CONTACTS * n
        self._rows, self._ids = np.zeros((most, touching.ROW)), np.zeros((most, 2), dtype=np.int64)
        self._keys = np.zeros(most)
        self._table = np.zeros(1 << max(2 * most, 1).bit_length(), dtype=np.int64)
        self.warm: Floats = np.zeros((0, impulses.WARM))
        self.contacts = 0

    # -- a step -------------------------------------------------------------------------------------

    def step(self, dt: float) -> None:
        """Go on by dt (s). ValueError unless it is finite and above 0."""
        if not 0.0 < dt < math.inf:
            raise ValueError(f"dt = {dt!r}: expected a finite number above 0 s")
        n = len(self)
        if not n:
            self.time += dt
            return
        effects, settings = self.effects, self.settings
        windy = self.wind is not None and WINDS in effects
        gravity = settings.gravity if GRAVITY in effects else 0.0
        bends = 1.0 if BENDING in effects else 0.0
        inertia = 1.0 if GUST_INERTIA in effects else 0.0
        self._feel()
        if inertia:
            self._jump()
        touches = GROUND in effects or CONTACTS in effects or len(self.walls)
        world = (self.rows, self.laws, self._points)
        found = (self._rows, self._ids, self._keys, bends)
        if touches:
            impulses.copy_state(self.rows, self._before)
            self.contacts = touching.find_contacts(
                world, found, self.walls, self._order,
                (gravity, float(GROUND in effects), settings.floor, float(CONTACTS in effects),
                 settings.friction),
                dt,
            )  # fmt: skip
        fly(
            self.rows, self._laws_now(), self.air, self._buffer, self._counts,
            (gravity, inertia, bends, 0.0 if windy else 1.0, self._method), dt,
        )  # fmt: skip
        if touches:
            count = self.contacts
            order = np.argsort(self._rows[:count, touching.HEIGHT], kind="stable")
            impulses.solve_contacts(
                world, found, order, self._before, self.warm, self._table, self.touched, dt
            )
            pushes = self._rows[:count, touching.PUSH : touching.RUB + 1]
            self.warm = np.concatenate([self._keys[:count, None], pushes], axis=1)
        self.time += dt
        self.felt = self._wind_now()

    def _laws_now(self) -> Floats:
        """The laws by the effects that are computed."""
        if CIRCULATION in self.effects and QUADRATIC_DRAG in self.effects:
            return self.laws
        laws = self.laws.copy()
        if CIRCULATION not in self.effects:
            laws[[law.TURN, law.GLIDE]] = 0.0
        if QUADRATIC_DRAG not in self.effects:
            laws[[law.DRAG, law.DRAG_TURN, law.TORQUE, law.TORQUE_2]] = 0.0
        return laws

    def _feel(self) -> None:
        """The wind at each plate, with its slopes."""
        if self.wind is None or WINDS not in self.effects:
            self.air[:] = 0.0
            return
        if isinstance(self.wind, GustyWind) or hasattr(self.wind, "feel"):
            self.wind.feel(self.rows, self.time, self.air)
        else:
            slopes_of(self.wind, self.rows[:2], self.time, self.air)
        if not np.isfinite(self.air).all():
            raise FloatingPointError(f"wind: not finite at plate {_first_bad(self.air)}")

    def _wind_now(self) -> Floats:
        """The wind (2, n) where plates are now; what the next step begins with unless the wind jumps."""
        self._feel()
        return self.air[:2].copy()

    def _jump(self) -> None:
        """The impulse of a wind that is another than it was at the end of the last step."""
        jump = self.air[:2] - self.felt
        if not np.any(jump):
            return
        c, s = elementwise.cos(self.rows[law.THETA]), elementwise.sin(self.rows[law.THETA])
        along, across = c * jump[0] + s * jump[1], c * jump[1] - s * jump[0]
        along *= 1.0 - self.laws[law.WEIGHT] / self.laws[law.MASS_X]
        across *= 1.0 - self.laws[law.WEIGHT] / self.laws[law.MASS_Y]
        self.rows[law.VX] += c * along - s * across
        self.rows[law.VY] += s * along + c * across

    # -- what is there ------------------------------------------------------------------------------

    @property
    def positions(self) -> Floats:
        """(n, 2) m, a copy."""
        return self.rows[:2].T.copy()

    @property
    def angles(self) -> Floats:
        """(n,) rad, turns counted."""
        return self.rows[law.THETA].copy()

    @property
    def velocities(self) -> Floats:
        """(n, 2) m/s, a copy."""
        return self.rows[law.VX : law.VY + 1].T.copy()

    @property
    def spins(self) -> Floats:
        """(n,) rad/s, a copy."""
        return self.rows[law.SPIN].copy()

    def energy(self) -> Floats:
        """(n,) J/m: of motion through still air with what it takes along, of height, and of bend."""
        rows, laws = self.rows, self.laws
        c, s = elementwise.cos(rows[law.THETA]), elementwise.sin(rows[law.THETA])
        ux, uy = c * rows[law.VX] + s * rows[law.VY], c * rows[law.VY] - s * rows[law.VX]
        gravity = self.settings.gravity if GRAVITY in self.effects else 0.0
        total = (
            laws[law.MASS_X] * (ux * ux)
            + laws[law.MASS_Y] * (uy * uy)
            + laws[law.INERTIA] * (rows[law.SPIN] * rows[law.SPIN])
        )
        if BENDING in self.effects:
            total = total + laws[law.BEND_INERTIA] * (rows[law.BEND_RATE] * rows[law.BEND_RATE])
        # a bend that is fixed keeps what it holds
        total = total + laws[law.STIFF] * elementary.square(rows[law.BEND] - laws[law.CURL])
        return np.asarray(laws[law.MASS] * (0.5 * total + laws[law.WEIGHT] * gravity * rows[law.Y]))

    def step_error(self, dt: float) -> float:
        """How far apart (m) one flight of dt (s) and two of half of it end, the worst plate; contacts left
        out."""
        if not len(self):
            return 0.0
        whole, halves = self.rows.copy(), self.rows.copy()
        windy = self.wind is not None and WINDS in self.effects
        rules = (
            self.settings.gravity if GRAVITY in self.effects else 0.0, float(GUST_INERTIA in self.effects),
            float(BENDING in self.effects), 0.0 if windy else 1.0, self._method,
        )  # fmt: skip
        laws = self._laws_now()
        fly(whole, laws, self.air, self._buffer, self._counts, rules, dt)
        for _ in range(2):
            fly(halves, laws, self.air, self._buffer, self._counts, rules, 0.5 * dt)
        return float(np.max(elementwise.hypot(*(whole - halves)[:2])))

    def check(self) -> None:
        """FloatingPointError, naming quantity and plate, for what is not finite or absurd."""
        names = ("x", "y", "angle", "velocity x", "velocity y", "spin", "bend", "bend rate")
        for name, row in zip(names, self.rows, strict=True):
            if not np.isfinite(row).all():
                raise FloatingPointError(f"{name} of plate {int(np.argmin(np.isfinite(row)))} is not finite")
        if len(self) and np.max(np.abs(self.rows[law.BEND])) > law.MOST_BEND + 1e-12:
            raise FloatingPointError("a plate is bent beyond its stop")

    def state(self) -> PlateState:
        """All that later steps depend on."""
        return PlateState(self.rows, self.laws, np.array([self.time]), self.felt, self.warm)

    def restore(self, state: PlateState) -> None:
        """Take over a copy of a state."""
        many = len(self)
        self.rows, self.laws = state.rows.copy(), state.laws.copy()
        self.time, self.felt = float(state.time[0]), state.felt.copy()
        if len(self) != many:
            self._make_room()
        self.warm = state.warm.copy()


def _first_bad(air: Floats) -> int:
    return int(np.argmin(np.isfinite(air).all(axis=0)))
