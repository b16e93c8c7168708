"""Wave particles: fronts of waves carried by particles. Yuksel, House, Keyser 2007, "Wave Particles".

A particle is a hump of a height and a radius that goes straight on at the speed of its wave. Each stands for
a part of a front, an angle seen from where the front began (section 4). As the front grows, neighbours come
apart. A particle that is farther than a share of its radius from the next becomes three of a third of its
height and angle. All are computed back from the origin, so that no error grows. A bank mirrors a particle
and its origin with it.

Heights of particles of one radius add up on a grid (section 6): each is laid on its four nearest points,
then the grid is drawn out by the hump's shape along rows and columns. What lies beyond a bank is folded back.

Where we differ: radii have speeds of their own, by Airy's law (1845). Keeping the sum of heights, a ring
sinks as 1/d. As a choice a front keeps its energy, and sinks as 1/sqrt(d), as it does on water.
"""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.compiler.decorator import kernel
from game.physics.kernels import elementary
from game.physics.waves.airy import wave_rate
from game.settings import Number, Option

FIELDS = 8
X, Y, COS, SIN, HEIGHT, ANGLE, AWAY, KIND = range(FIELDS)
BOOKS = 4
MADE, SPLIT, FADED, REFUSED = range(BOOKS)  # particles put, divided, left as too low, without a place
KEEPS = ("height", "energy")
LENGTHS = 2.0  # radii in a wave length: a hump is as wide as a crest and its foot
AT_LEAST = 16  # particles of a ring


class WaveSettings(NamedTuple):
    """How wave particles go on."""

    depth: Annotated[float, Number(0.05, 1000.0, help="of the still water", unit="m")] = 2.0
    gravity: Annotated[float, Number(0.0, 30.0, help="downwards", unit="m/s²")] = 9.81
    keeps: Annotated[int, Option(KEEPS, help="what a front keeps as it grows")] = 1
    spacing: Annotated[
        float, Number(0.05, 2.0, help="radii between neighbours, at which one becomes three")
    ] = 0.5
    fading: Annotated[float, Number(0.0, 10.0, unit="1/s", help="rate at which all heights sink")] = 0.05
    lowest: Annotated[float, Number(0.0, 0.1, unit="m", help="lower particles are left out")] = 5e-4


class WaveParticleState(NamedTuple):
    """fields: (FIELDS, n) of particles; books: (BOOKS,) particles; lost: (1,) m³ of those left out."""

    fields: Floats
    books: Longs
    lost: Floats


def speed_of(radius: float, depth: float, gravity: float) -> float:
    """m/s of a wave of ``LENGTHS`` radii on water of a depth, m (Airy 1845)."""
    number = 2.0 * math.pi / (LENGTHS * radius)
    return wave_rate(number, depth, gravity) / number


@kernel
def _bounce(fields, i, width, height):
    """Mirror a particle at the banks of a pond from (0, 0) to (width, height) until it is inside."""
    for axis, end in ((X, width), (Y, height)):
        place = fields[axis, i]
        if place < 0.0 or place > end:
            turns = math.floor(place / end)
            rest = place - turns * end
            if turns % 2.0 == 0.0:
                fields[axis, i] = rest
            else:
                fields[axis, i] = end - rest
                fields[axis + COS, i] = -fields[axis + COS, i]


@kernel
def _divide(fields, i, at, turn):
    """Put at ``at`` a copy of particle i, turned about its origin by an angle with (cos, sin) ``turn``."""
    for field in range(FIELDS):
        fields[field, at] = fields[field, i]
    c, s, away = fields[COS, i], fields[SIN, i], fields[AWAY, i]
    fields[COS, at] = c * turn[0] - s * turn[1]
    fields[SIN, at] = s * turn[0] + c * turn[1]
    fields[X, at] = fields[X, i] + away * (fields[COS, at] - c)
    fields[Y, at] = fields[Y, i] + away * (fields[SIN, at] - s)


@kernel
def advance_particles(fields, count, radii, speeds, dt, size, settings, books, lost):
    """Move, bounce, leave out and divide ``count`` particles; how many there are then.

    radii, speeds: (kinds,) m, m/s; size: of the pond, m; lost: (1,) m³, what goes with those left out.
    """
    capacity, kept, born = fields.shape[1], 0, count
    fade = elementary.exp(-settings.fading * dt)
    energy = settings.keeps == 1
    for i in range(count):
        kind = int(fields[KIND, i])
        radius, way = radii[kind], speeds[kind] * dt
        before = fields[AWAY, i]
        tall = fields[HEIGHT, i] * fade
        if energy:
            tall *= math.sqrt((before + way) / before)
        if abs(tall) < settings.lowest:
            books[FADED] += 1
            lost[0] += tall * radius * radius
            continue
        if kept < i:
            for field in range(FIELDS):
                fields[field, kept] = fields[field, i]
        fields[HEIGHT, kept] = tall
        fields[AWAY, kept] = before + way
        fields[X, kept] += fields[COS, kept] * way
        fields[Y, kept] += fields[SIN, kept] * way
        angle = fields[ANGLE, kept]
        if angle * (before + way) > settings.spacing * radius:
            if born + 2 <= capacity:
                third = tall / 3.0
                fields[ANGLE, kept] = angle / 3.0
                fields[HEIGHT, kept] = third
                c, s = elementary.cos(angle / 3.0), elementary.sin(angle / 3.0)
                _divide(fields, kept, born, (c, s))
                _divide(fields, kept, born + 1, (c, -s))
                fields[HEIGHT, kept] = tall - third - third
                _bounce(fields, born, size[0], size[1])
                _bounce(fields, born + 1, size[0], size[1])
                born += 2
                books[SPLIT] += 1
            else:
                books[REFUSED] += 1
        _bounce(fields, kept, size[0], size[1])
        kept += 1
    if kept < count:
        for i in range(count, born):
            for field in range(FIELDS):
                fields[field, kept + i - count] = fields[field, i]
    return kept + born - count


@kernel
def lay_heights(fields, count, kind, grid, cell, margin):
    """Add the heights of the particles of a kind to their four nearest points of a grid with a margin.

    Point (j, i) of the grid is at ((i - margin + 1/2) cell, (j - margin + 1/2) cell).
    """
    for p in range(count):
        if int(fields[KIND, p]) != kind:
            continue
        x = fields[X, p] / cell + margin - 0.5
        y = fields[Y, p] / cell + margin - 0.5
        i, j = int(x), int(y)
        right, up, tall = x - i, y - j, fields[HEIGHT, p]
        grid[j, i] += tall * (1.0 - right) * (1.0 - up)
        grid[j, i + 1] += tall * right * (1.0 - up)
        grid[j + 1, i] += tall * (1.0 - right) * up
        grid[j + 1, i + 1] += tall * right * up


@kernel
def draw_out(grid, work, weights, margin, heights):
    """Add to heights (ny, nx) a grid drawn out by weights (2 m + 1,) along rows, then along columns.

    grid: (ny + 2 margin, nx + 2 margin), 2 m + 1 <= margin; what comes to lie beyond a bank is folded back.
    """
    half = weights.shape[0] // 2
    rows, columns = grid.shape
    ny, nx = heights.shape
    for j in range(rows):
        for i in range(columns):
            work[j, i] = 0.0
        for k in range(-half, half + 1):
            weight = weights[k + half]
            for i in range(half, columns - half):
                work[j, i] += weight * grid[j, i + k]
    for j in range(rows):
        for i in range(columns):
            grid[j, i] = 0.0
    for j in range(half, rows - half):
        for k in range(-half, half + 1):
            weight = weights[k + half]
            for i in range(columns):
                grid[j, i] += weight * work[j + k, i]
    for k in range(margin):  # what is beyond a bank comes back
        for j in range(rows):
            grid[j, margin + k] += grid[j, margin - 1 - k]
            grid[j, margin + nx - 1 - k] += grid[j, margin + nx + k]
    for k in range(margin):
        for i in range(margin, margin + nx):
            grid[margin + k, i] += grid[margin - 1 - k, i]
            grid[margin + ny - 1 - k, i] += grid[margin + ny + k, i]
    for j in range(ny):
        for i in range(nx):
            heights[j, i] += grid[margin + j, margin + i]


class WaveParticles:
    """Wave particles on a pond from (0, 0) to ``size`` (m), of some radii (m), at most ``capacity`` of them.

    cell: m between points of the grid of heights.
    """

    def __init__(
        self,
        size: tuple[float, float],
        radii: tuple[float, ...],
        cell: float,
        settings: WaveSettings | None = None,
        capacity: int = 100_000,
    ):
        """ValueError, naming the argument, for nonsense."""
        if not all(0.0 < side < 1e4 for side in size):
            raise ValueError(f"size = {size!r}: expected two lengths above 0 m")
        if not 0.0 < cell <= 0.25 * min(size):
            raise ValueError(f"cell = {cell!r}: expected a length up to a quarter of the pond")
        if not radii or not all(cell <= radius <= 0.25 * min(size) for radius in radii):
            raise ValueError(f"radii = {radii!r}: expected lengths from a cell to a quarter of the pond")
        if not 1 <= capacity <= 2_000_000:
            raise ValueError(f"capacity = {capacity!r}: expected 1 to 2,000,000")
        self.size = float(size[0]), float(size[1])
        nx, ny = max(4, round(size[0] / cell)), max(4, round(size[1] / cell))
        self.cell = self.size[0] / nx
        self.radii: Floats = np.array(radii, dtype=np.float64)
        self.heights: Floats = np.zeros((ny, nx))
        self.count = 0
        self.books: Longs = np.zeros(BOOKS, np.int64)
        self.lost: Floats = np.zeros(1)
        self._fields: Floats = np.zeros((FIELDS, capacity))
        self._weights = [_weights(radius, self.cell) for radius in radii]
        self._margin = max(map(len, self._weights)) + 1  # a hump on a bank, drawn out, stays on the grid
        self._grid = np.zeros((ny + 2 * self._margin, nx + 2 * self._margin))
        self._work = np.zeros_like(self._grid)
        self.settings = settings or WaveSettings()

    @property
    def settings(self) -> WaveSettings:
        """How particles go on."""
        return self._settings

    @settings.setter
    def settings(self, settings: WaveSettings) -> None:
        self._settings = settings
        self.speeds: Floats = np.array(
            [speed_of(float(radius), settings.depth, settings.gravity) for radius in self.radii]
        )

    @property
    def fields(self) -> Floats:
        """(FIELDS, n) of the particles there are; a view."""
        return self._fields[:, : self.count]

    def add(
        self, place: tuple[float, float], toward: tuple[float, float], height: float, angle: float,
        away: float, kind: int = 0,
    ) -> bool:  # fmt: skip
        """One particle at a place (m), that goes ``toward`` (a unit vector).

        It stands for an angle of a front that began ``away`` (m, above 0) behind it. False without a place.
        """
        if self.count >= self._fields.shape[1]:
            self.books[REFUSED] += 1
            return False
        self._fields[:, self.count] = (*place, *toward, height, angle, away, kind)
        _bounce(self._fields, self.count, *self.size)
        self.count += 1
        self.books[MADE] += 1
        return True

    def add_ring(self, place: tuple[float, float], height: float, away: float, kind: int = 0) -> None:
        """A front all around a place (m), at a distance (m), whose crest is so high above still water (m)."""
        radius = float(self.radii[kind])
        count = max(AT_LEAST, math.ceil(math.tau * away / (self.settings.spacing * radius)))
        # humps side by side add up to their mean over the way between them
        each = height * math.tau * away / (count * radius)
        for k in range(count):
            turn = math.tau * k / count
            c, s = float(elementary.cos(turn)), float(elementary.sin(turn))
            at = place[0] + away * c, place[1] + away * s
            self.add(at, (c, s), each, math.tau / count, away, kind)

    def drop(self, place: tuple[float, float], height: float, kind: int = 0) -> None:
        """A stone falls in: a crest and, behind it, a trough with as much water."""
        radius = float(self.radii[kind])
        self.add_ring(place, height, 2.0 * radius, kind)
        self.add_ring(place, -2.0 * height, radius, kind)

    def step(self, dt: float) -> None:
        """Go on by dt (s)."""
        self.count = int(
            advance_particles(
                self._fields, self.count, self.radii, self.speeds, dt, self.size, self._settings,
                self.books, self.lost,
            )
        )  # fmt: skip

    def find_heights(self) -> Floats:
        """(ny, nx) m above the still water, in the middles of cells; the array is used again."""
        self.heights[...] = 0.0
        for kind, weights in enumerate(self._weights):
            self._grid[...] = 0.0
            lay_heights(self._fields, self.count, kind, self._grid, self.cell, self._margin)
            draw_out(self._grid, self._work, weights, self._margin, self.heights)
        return self.heights

    def volume(self) -> float:
        """m³ of water above the still level, less what is missing below it."""
        radii = self.radii[self.fields[KIND].astype(np.int64)]
        return float(np.sum(self.fields[HEIGHT] * radii * radii))

    def energy(self) -> float:
        """J at a density of 1 kg/m³: twice that of the heights, as waves that run have as much in motion."""
        cells = float(np.sum(self.heights * self.heights)) * self.cell * self.cell
        return self._settings.gravity * cells

    def state(self) -> WaveParticleState:
        """All that later steps depend on."""
        return WaveParticleState(self.fields, self.books, self.lost)

    def restore(self, state: WaveParticleState) -> None:
        """Take over a copy of a state of a pond with the same capacity."""
        self.count = state.fields.shape[1]
        self._fields[:, : self.count] = state.fields
        self.books[...] = state.books
        self.lost[...] = state.lost


def _weights(radius: float, cell: float) -> Floats:
    """(2 m + 1,) of a hump along a line: (1 + cos pi u / r) / 2, scaled so that their sum is r / cell."""
    half = max(1, math.ceil(radius / cell) - 1)
    places = np.arange(-half, half + 1) * (cell / radius)
    found = np.array([0.5 * (1.0 + float(elementary.cos(math.pi * u))) for u in places.tolist()])
    return np.asarray(found * (radius / cell / math.fsum(found.tolist())))
