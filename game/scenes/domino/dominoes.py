"""The dominoes of a level: where each stands, when it was struck, how fast the wave runs that they make."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs, Point
from game.physics.dominoes import domino_wave_speed
from game.physics.kernels import elementary, elementwise
from game.physics.solids import Material, SolidWorld, box
from game.scenes.domino.course import Standing, height_at, row_places
from game.scenes.domino.level import MOST_DOMINOES, DominoContent, PlankEntry, RowEntry, SingleEntry
from game.scenes.domino.parameters import DominoParameters
from game.worlds.tables import NO_FLOATS, NO_LONGS, extended
from game.worlds.world import Member

LEAST_FRICTION = 1e-6  # of a pair the geometric mean counts: what is rough enough makes up for the smooth
STRUCK_ANGLE = 0.03  # rad from where it stood: it has been struck
PUSH = 1.0  # of sqrt(g / h): spin of one that is pushed
SETTLED, MEASURED = 12, 12  # dominoes on the level before a wave is measured, and over which it is
GONE, NOT_YET = -1, -1.0


class Table(NamedTuple):
    """Of each domino: body (GONE: taken away), row, direction of its row, distance from the one before it (m,
    0: none), where its foot stood (m) and how it leant (rad), size (m). Time at which it was struck
    (NOT_YET), and whether it stands on the level at the height of the one before it.
    """

    body: Longs = NO_LONGS
    row: Longs = NO_LONGS
    to: Floats = NO_FLOATS
    pitch: Floats = NO_FLOATS
    x: Floats = NO_FLOATS
    y: Floats = NO_FLOATS
    lean: Floats = NO_FLOATS
    thick: Floats = NO_FLOATS
    tall: Floats = NO_FLOATS
    struck: Floats = NO_FLOATS
    level: Longs = NO_LONGS


class Wave(NamedTuple):
    """The latest that was measured: its speed (m/s; 0: none yet), gap, thickness and height (m) of its
    dominoes.
    """

    speed: float = 0.0
    gap: float = 0.0
    thick: float = 0.0
    tall: float = 0.0

    def theory(self, gravity: float, friction: float) -> float:
        """Speed (m/s) of a steady wave through such dominoes; NaN before."""
        if self.speed <= 0.0:
            return math.nan
        shares = self.gap / self.tall, self.thick / self.tall
        return math.sqrt(gravity * self.tall) * domino_wave_speed(*shares, friction)


class Dominoes(Member):
    """``table`` of all; last: number of the one that was struck last, -1 before. changed: by a hand, so that
    they are no longer as the level says. ValueError: too many.
    """

    kept = ("table",)

    def __init__(
        self, world: SolidWorld, content: DominoContent, floors: list[Floats], parameters: DominoParameters
    ):
        self.world, self.parameters = world, parameters
        self.last, self.changed, self.wave = -1, False, Wave()
        self.table = Table()
        for number, row in enumerate(content.rows):
            self.table = extended(self.table, self._row(content, number, row, floors[row.floor]))
        self.table = extended(self.table, self._singles(content))
        if len(self.table.body) > MOST_DOMINOES:
            raise ValueError(f"rows: {len(self.table.body)} dominoes; at most {MOST_DOMINOES}")

    # -- building -------------------------------------------------------------------------------------

    def _row(
        self, content: DominoContent, number: int, row: RowEntry, floor: Floats
    ) -> Iterator[tuple[float, ...]]:
        """Stand a row; what the table says of each."""
        gap = self.parameters.spacing if row.gap is None else row.gap
        planks = [plank for plank in content.planks if plank.floor == row.floor and not plank.seesaw]
        before: Standing | None = None
        for flat in row_places(row, floor, gap):
            y, slope = surface_at(floor, planks, flat.x)
            place = Standing(flat.x, y, slope, flat.larger)
            thick, tall = (part * place.larger for part in row.size)
            body = self._stand(place, (thick, tall), row.density)
            pitch = abs(place.x - before.x) if before is not None else 0.0
            level = before is not None and slope == 0.0 and before.lean == 0.0 and abs(y - before.y) < 1e-9
            yield (
                body, number, row.to, pitch, place.x, y, slope, thick, tall, NOT_YET,
                level and row.grows == 1.0,
            )  # fmt: skip
            before = place

    def _singles(self, content: DominoContent) -> Iterator[tuple[float, ...]]:
        """Stand those that a level names one by one; their row is the one after all others."""
        before: SingleEntry | None = None
        for one in content.singles:
            (x, y), lean = one.at, math.radians(one.lean)
            body = self._stand(Standing(x, y, lean, 1.0), one.size, 1.0)
            pitch, level = 0.0, False
            if before is not None and before.to == one.to and before.size == one.size:
                pitch = abs(x - before.at[0])
                level = lean == before.lean == 0.0 and abs(y - before.at[1]) < 1e-9
            yield body, len(content.rows), one.to, pitch, x, y, lean, *one.size, NOT_YET, level
            before = one

    def _stand(self, place: Standing, size: Point, density: float) -> int:
        """Stand a domino (thickness, height m) at a place; its body."""
        material = Material(density, max(self.parameters.friction, LEAST_FRICTION))
        return self.world.add_body(box(*size, material=material), centre_of(place, size[1]), place.lean)

    # -- what a hand does -----------------------------------------------------------------------------

    def push(self, number: int, back: bool = False) -> None:
        """Push a domino on in the direction of its row, about the edge of its foot; or back."""
        table, body = self.table, int(self.table.body[number])
        to = -float(table.to[number]) if back else float(table.to[number])
        tall, thick = float(table.tall[number]), float(table.thick[number])
        spin = -to * PUSH * math.sqrt(max(self.parameters.gravity, 1.0) / tall)
        c, s = self.world.bodies.rotations[body].tolist()
        x, y = -to * 0.5 * thick, 0.5 * tall  # centre from the edge it turns about
        rx, ry = c * x - s * y, s * x + c * y
        self.world.set_velocity(body, (-spin * ry, spin * rx), spin)

    def move(self, number: int, place: Standing) -> None:
        """Stand a domino elsewhere, upright and at rest."""
        self.changed = True
        table, body = self.table, int(self.table.body[number])
        self.world.set_pose(body, centre_of(place, float(table.tall[number])), place.lean)
        self.world.set_velocity(body, (0.0, 0.0), 0.0)
        table.x[number], table.y[number], table.lean[number] = place.x, place.y, place.lean
        table.struck[number], table.level[number] = NOT_YET, 0

    def add(self, place: Standing) -> bool:
        """Stand another domino there, like the nearest one; False if there is no more space for one."""
        table = self.table
        if len(table.body) >= MOST_DOMINOES:
            return False
        self.changed = True
        number, to, size = 0, 1.0, (0.16, 1.0)
        if len(table.body):
            near = int(np.argmin(elementwise.hypot(table.x - place.x, table.y - place.y)))
            number, to = int(table.row[near]), float(table.to[near])
            size = float(table.thick[near]), float(table.tall[near])
        body = self._stand(place, size, 1.0)
        row = (body, number, to, 0.0, place.x, place.y, place.lean, *size, NOT_YET, 0)
        self.table = extended(table, [row])
        return True

    def take_away(self, number: int) -> None:
        """Remove a domino; its neighbours are no longer measured."""
        self.changed = True
        self.world.remove_body(int(self.table.body[number]))
        self.table.body[number] = GONE
        self.table.level[number : number + 2] = 0

    # -- after a step ---------------------------------------------------------------------------------

    def note_struck(self, before: Floats, time: float, dt: float) -> None:
        """When dominoes left their places, in the step of dt (s) that has come to a time (s).

        before (n,): rad, angles of all bodies at its beginning.
        """
        table = self.table
        waiting = np.flatnonzero((table.struck < 0.0) & (table.body >= 0))
        bodies = table.body[waiting]
        now = np.abs(self.world.bodies.angles[bodies] - table.lean[waiting])
        hit = now > STRUCK_ANGLE
        if not hit.any():
            return
        struck, bodies, now = waiting[hit], bodies[hit], now[hit]
        then = np.abs(before[bodies] - table.lean[struck])
        share = np.clip((STRUCK_ANGLE - then) / np.maximum(now - then, 1e-12), 0.0, 1.0)
        table.struck[struck] = time - dt + share * dt
        self.last = int(struck[np.argmax(table.struck[struck])])
        self._measure_wave(self.last)

    def _measure_wave(self, end: int) -> None:
        """Speed over the last dominoes, if they stand on the level, one after the other, for long enough."""
        begin = end - SETTLED - MEASURED
        if begin < 0:
            return
        columns: Any = (column[begin : end + 1] for column in self.table)
        part = Table(*columns)
        pitches = part.pitch[1:]
        if not (part.level[1:] == 1).all() or (part.struck < 0.0).any():
            return
        if (part.row != part.row[0]).any() or np.ptp(pitches) > 1e-9:
            return
        took = float(part.struck[-1] - part.struck[SETTLED])
        if took > 0.0 and (np.diff(part.struck) > 0.0).all():
            thick = float(part.thick[-1])
            speed, gap = float(pitches[-MEASURED:].sum()) / took, float(pitches[-1]) - thick
            self.wave = Wave(speed, gap, thick, float(part.tall[-1]))

    # -- what there is --------------------------------------------------------------------------------

    def change(self, name: str) -> None:
        self.wave = self.wave._replace(speed=0.0)  # of other dominoes

    def there(self) -> Longs:
        """Numbers of those that have not been taken away."""
        return np.flatnonzero(self.table.body >= 0)

    def struck(self) -> int:
        """How many have been struck."""
        return int(np.count_nonzero(self.table.struck >= 0.0))

    def front(self, time: float) -> Point:
        """Where the wave is at a time (s), m: between the last that was struck and the next."""
        table, k = self.table, max(self.last, 0)
        if not len(table.body):
            return 0.0, 0.0
        pitch = max(float(table.pitch[k]), float(table.thick[k]))
        ahead = min(max(time - float(table.struck[k]), 0.0) * 4.0, pitch) if self.last >= 0 else 0.0
        return float(table.x[k]) + float(table.to[k]) * ahead, float(table.y[k]) + 0.6 * float(table.tall[k])


def surface_at(floor: Floats, planks: list[PlankEntry], x: float) -> Point:
    """Height (m) and slope (rad) of what a domino stands on at x: the floor, or a plank over a gap in it."""
    for plank in planks:
        if abs(x - plank.at[0]) <= 0.5 * plank.length:
            return plank.at[1], 0.0
    return height_at(floor, x)


def centre_of(place: Standing, tall: float) -> Point:
    """Centre of a domino that stands at a place, m."""
    half = 0.5 * tall
    return place.x - half * elementary.sin(place.lean), place.y + half * elementary.cos(place.lean)
