"""The world of dominoes: built from a level, stepped; who was struck when, and how far blocks have slid."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.dominoes import domino_wave_speed
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.kernels import elementary, elementwise
from game.physics.solids import Disc, Material, SolidSettings, SolidState, SolidWorld
from game.physics.solids.effects import FRICTION
from game.physics.solids.state import ASLEEP, DYNAMIC
from game.scenes.domino.course import Standing, floor_points
from game.scenes.domino.hearing import heard_now
from game.scenes.domino.level import MOST_DOMINOES, DominoContent
from game.scenes.domino.making import (
    LEAST_FRICTION,
    add_ball,
    add_domino,
    add_plank,
    add_slider,
    chain_of,
    floor_grip,
    row_table,
    single_table,
    slider_grip,
)
from game.scenes.domino.parameters import DominoParameters
from game.scenes.domino.tables import (
    BODY,
    DOMINO_WIDTH,
    FOOT_X,
    FOOT_Y,
    GONE,
    LEAN,
    LEVEL,
    NOT_YET,
    PITCH,
    ROW,
    SLIDER_BODY,
    SLIDER_SPEED,
    SLIDER_WAY,
    SLIDER_WIDTH,
    SLIDER_X,
    SLIDER_Y,
    STRUCK,
    TALL,
    THICK,
    TO,
    none_of,
)
from game.stage import ParameterError, Part
from game.worlds.hearing import HEARD_WIDTH
from game.worlds.stopwatch import Stopwatch

Floats = NDArray[np.float64]
STRUCK_ANGLE = 0.03  # rad from where it stood: it has been struck
PUSH = 1.0  # of sqrt(g / h): spin of one that is pushed
SETTLED, MEASURED = 12, 12  # dominoes on the level before a wave is measured, and over which it is
CRAWL = 0.25  # m/s
QUIET = 1e-3  # m/s, of a block that has come to rest


class ModelState(NamedTuple):
    """world; dominoes (n, DOMINO_WIDTH), sliders (m, SLIDER_WIDTH), heard (k, HEARD_WIDTH): see `tables`."""

    world: SolidState
    dominoes: Floats
    sliders: Floats
    heard: Floats


class DominoModel(Part):
    """Dominoes, balls, planks and blocks of a level.

    time: s. last: number of the domino that was struck last, -1 before. wave: m/s of the latest measured
    wave (0: none yet), gap, thick and tall (m) of its dominoes. pushed: whether the first push is over.
    changed: by a hand, so that it is no longer as the level says.
    """

    def __init__(self, content: DominoContent, parameters: DominoParameters, active: EffectSet):
        self.content, self.parameters, self.active = content, parameters, active
        self.watch = Stopwatch()
        self.time, self.last, self.pushed = 0.0, -1, False
        self.changed = False
        self.wave = self.wave_gap = self.wave_thick = self.wave_tall = 0.0
        self.world = SolidWorld(self._settings())
        self.floors = [floor_points(floor) for floor in content.floors]
        self.heard = none_of(HEARD_WIDTH)
        self._build()

    # -- building -------------------------------------------------------------------------------------

    def _build(self) -> None:
        content, parameters, world = self.content, self.parameters, self.world
        nothing = Material(mask=0, category=0)
        self.anchor = world.add_body(Disc(0.01, material=nothing), kind="fixed")
        self.floor_ids = [
            world.add_body(chain_of(points, self._grip(k)), kind="fixed")
            for k, points in enumerate(self.floors)
        ]
        asked = [row.floor for row in content.rows]
        asked += [ball.floor for ball in content.balls] + [slider.floor for slider in content.sliders]
        for floor in asked:
            if floor >= len(self.floors):
                raise ValueError(f"floor = {floor}: there are {len(self.floors)}")
        self.plank_ids = [add_plank(world, self.anchor, entry, self._grip(None)) for entry in content.planks]
        self.ball_ids = [
            add_ball(world, entry, self.floors[entry.floor], parameters) for entry in content.balls
        ]
        tables = [
            row_table(world, content, k, self.floors[row.floor], parameters)
            for k, row in enumerate(content.rows)
        ]
        tables.append(single_table(world, content, parameters.friction))
        self.dominoes = np.concatenate([none_of(DOMINO_WIDTH), *tables])
        if len(self.dominoes) > MOST_DOMINOES:
            raise ValueError(f"rows: {len(self.dominoes)} dominoes; at most {MOST_DOMINOES}")
        self.sliders = none_of(SLIDER_WIDTH)
        rows = []
        for k, one in enumerate(content.sliders):
            body = add_slider(world, one, k, self.floors[one.floor], self._grip(one.floor))
            rows.append((body, one.friction, NOT_YET, 0.0, 0.0, 0.0))
        if rows:
            self.sliders = np.array(rows)

    def _grip(self, floor: int | None) -> float:
        """Friction of a floor (None: of planks), so that dominoes meet it with what is wanted."""
        own = None if floor is None else self.content.floors[floor].friction
        wanted = self.parameters.floor_friction if own is None else own
        return floor_grip(wanted, self.parameters.friction)

    # -- changes --------------------------------------------------------------------------------------

    def _settings(self) -> SolidSettings:
        parameters = self.parameters
        try:
            return SolidSettings(
                effects=self.active,
                solver=parameters.solver,
                substeps=parameters.substeps_now(),
                iterations=int(parameters.iterations),
                gravity=(0.0, -parameters.gravity),
            )
        except ValueError as error:
            raise ParameterError(str(error)) from None

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value."""
        self.world.settings = self._settings()
        self.watch.clear()
        self.wave = 0.0  # of other dominoes
        if name in ("friction", "floor_friction"):
            self._change_friction()
        elif name == "restitution":
            rows = self.world.shapes.restitutions
            rows[np.isin(self.world.shapes.bodies, self.ball_ids)] = self.parameters.restitution

    def _change_friction(self) -> None:
        shapes = self.world.shapes
        own = max(self.parameters.friction, LEAST_FRICTION)
        smooth = [*self.ball_ids, *self.dominoes[:, BODY].astype(np.int64).tolist()]
        shapes.frictions[np.isin(shapes.bodies, smooth)] = own
        for k, body in enumerate(self.floor_ids):
            shapes.frictions[shapes.bodies == body] = self._grip(k)
        shapes.frictions[np.isin(shapes.bodies, self.plank_ids)] = self._grip(None)
        for entry, row in zip(self.content.sliders, self.sliders, strict=True):
            mine = shapes.bodies == int(row[SLIDER_BODY])
            shapes.frictions[mine] = slider_grip(entry.friction, self._grip(entry.floor))

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        self.active = active
        self.world.settings = self._settings()
        self.watch.clear()

    # -- what a hand does -----------------------------------------------------------------------------

    def push(self, number: int, back: bool = False) -> None:
        """Push a domino on in the direction of its row, about the edge of its foot; or back."""
        row = self.dominoes[number]
        body, to = int(row[BODY]), -float(row[TO]) if back else float(row[TO])
        tall, thick = float(row[TALL]), float(row[THICK])
        spin = -to * PUSH * math.sqrt(max(self.parameters.gravity, 1.0) / tall)
        c, s = self.world.bodies.rotations[body].tolist()
        x, y = -to * 0.5 * thick, 0.5 * tall  # centre from the edge it turns about
        rx, ry = c * x - s * y, s * x + c * y
        self.world.set_velocity(body, (-spin * ry, spin * rx), spin)

    def push_first(self) -> None:
        """Push the first domino that is there."""
        there = np.flatnonzero(self.dominoes[:, BODY] != GONE)
        self.pushed = True
        if len(there):
            self.push(int(there[0]))

    def stand(self, number: int, place: Standing) -> None:
        """Stand a domino elsewhere, upright and at rest."""
        self.changed = True
        row = self.dominoes[number]
        body, half = int(row[BODY]), 0.5 * float(row[TALL])
        centre = place.x - half * elementary.sin(place.lean), place.y + half * elementary.cos(place.lean)
        self.world.set_pose(body, centre, place.lean)
        self.world.set_velocity(body, (0.0, 0.0), 0.0)
        row[[FOOT_X, FOOT_Y, LEAN, STRUCK, LEVEL]] = place.x, place.y, place.lean, NOT_YET, 0.0

    def add(self, place: Standing) -> bool:
        """Stand another domino there; False if there is no more room for one."""
        if len(self.dominoes) >= MOST_DOMINOES:
            return False
        self.changed = True
        near = self._nearest_standing(place)
        to, thick, tall = (1.0, 0.16, 1.0) if near < 0 else self.dominoes[near, [TO, THICK, TALL]].tolist()
        number = float(self.dominoes[near, ROW]) if near >= 0 else 0.0
        body = add_domino(self.world, place, (thick, tall), 1.0, self.parameters.friction)
        row = np.zeros(DOMINO_WIDTH)
        row[[BODY, ROW, TO, FOOT_X, FOOT_Y, LEAN]] = body, number, to, place.x, place.y, place.lean
        row[[THICK, TALL, STRUCK]] = thick, tall, NOT_YET
        self.dominoes = np.concatenate([self.dominoes, row[None]])
        return True

    def _nearest_standing(self, place: Standing) -> int:
        if not len(self.dominoes):
            return -1
        rows = self.dominoes
        away = elementwise.hypot(rows[:, FOOT_X] - place.x, rows[:, FOOT_Y] - place.y)
        return int(np.argmin(away))

    def take_away(self, number: int) -> None:
        """Remove a domino; its neighbours are no longer measured."""
        self.changed = True
        self.world.remove_body(int(self.dominoes[number, BODY]))
        self.dominoes[number, BODY] = GONE
        self.dominoes[number : number + 2, LEVEL] = 0.0

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        """One step."""
        at = self.content.pushed_at
        if at is not None and not self.pushed and self.time >= at - 0.5 * dt and len(self.dominoes):
            self.push_first()
        before = self.world.bodies.angles.copy()
        with self.watch.time("step"):
            self.world.step(dt)
        self.time += dt
        self._note_struck(before, dt)
        self._note_sliding(dt)
        self.heard = heard_now(self.world, self.heard, self.time - dt, self.ball_ids)

    def _note_struck(self, before: Floats, dt: float) -> None:
        """When dominoes left their places, between this step and the last."""
        rows = self.dominoes
        waiting = np.flatnonzero((rows[:, STRUCK] < 0.0) & (rows[:, BODY] >= 0.0))
        bodies = rows[waiting, BODY].astype(np.int64)
        now = np.abs(self.world.bodies.angles[bodies] - rows[waiting, LEAN])
        hit = now > STRUCK_ANGLE
        if not hit.any():
            return
        struck, bodies, now = waiting[hit], bodies[hit], now[hit]
        then = np.abs(before[bodies] - rows[struck, LEAN])
        share = np.clip((STRUCK_ANGLE - then) / np.maximum(now - then, 1e-12), 0.0, 1.0)
        rows[struck, STRUCK] = self.time - dt + share * dt
        latest = struck[np.argmax(rows[struck, STRUCK])]
        self.last = int(latest)
        self._measure_wave(self.last)

    def _measure_wave(self, end: int) -> None:
        """Speed over the last dominoes, if they stand on the level, one after the other, for long enough."""
        begin = end - SETTLED - MEASURED
        if begin < 0:
            return
        rows = self.dominoes[begin : end + 1]
        pitches = rows[1:, PITCH]
        if not (rows[1:, LEVEL] == 1.0).all() or (rows[:, STRUCK] < 0.0).any():
            return
        if (rows[:, ROW] != rows[0, ROW]).any() or np.ptp(pitches) > 1e-9:
            return
        took = float(rows[-1, STRUCK] - rows[SETTLED, STRUCK])
        if took > 0.0 and (np.diff(rows[:, STRUCK]) > 0.0).all():
            self.wave = float(pitches[-MEASURED:].sum()) / took
            self.wave_thick, self.wave_tall = float(rows[-1, THICK]), float(rows[-1, TALL])
            self.wave_gap = float(pitches[-1]) - self.wave_thick

    def _note_sliding(self, dt: float) -> None:
        line = self.content.x_measured
        if line is None:
            return
        bodies = self.world.bodies
        for row in self.sliders:
            body = int(row[SLIDER_BODY])
            x, y = bodies.positions[body].tolist()
            speed = elementary.length(*bodies.velocities[body].tolist())
            if row[SLIDER_SPEED] < 0.0 and x >= line and self._lies(body):
                row[[SLIDER_SPEED, SLIDER_X, SLIDER_Y]] = speed, x, y
            elif row[SLIDER_SPEED] >= 0.0:
                row[SLIDER_WAY] = elementary.hypot(x - float(row[SLIDER_X]), y - float(row[SLIDER_Y]))

    def _lies(self, body: int) -> bool:
        """Whether a block lies on a long side and slides without turning."""
        c, _ = self.world.bodies.rotations[body].tolist()
        return abs(c) < 0.3 or self.content.pushed_at is None

    # -- what is there --------------------------------------------------------------------------------

    def awake(self) -> int:
        """How many bodies are computed."""
        return int(np.count_nonzero(self.world.bodies.flags & (DYNAMIC | ASLEEP) == DYNAMIC))

    def struck(self) -> int:
        """How many dominoes have been struck."""
        return int(np.count_nonzero(self.dominoes[:, STRUCK] >= 0.0))

    def gravity(self) -> float:
        """m/s², as it acts now."""
        return self.parameters.gravity if GRAVITY in self.active else 0.0

    def theory(self) -> float:
        """Speed (m/s) of a steady wave through the dominoes that were measured last; NaN before."""
        if self.wave <= 0.0:
            return math.nan
        tall = self.wave_tall
        scale = math.sqrt(self.gravity() * tall)
        rough = self.parameters.friction if FRICTION in self.active else 0.0
        return scale * domino_wave_speed(self.wave_gap / tall, self.wave_thick / tall, rough)

    def fastest_ball(self) -> float:
        """m/s; 0 without balls."""
        if not self.ball_ids:
            return 0.0
        return float(elementwise.hypot(*self.world.bodies.velocities[self.ball_ids].T).max())

    def moving_balls(self) -> int:
        """How many balls are faster than a crawl."""
        speeds = (
            elementwise.hypot(*self.world.bodies.velocities[self.ball_ids].T)
            if self.ball_ids
            else np.zeros(0)
        )
        return int(np.count_nonzero(speeds > CRAWL))

    def at_rest(self) -> int:
        """How many blocks have slid and come to rest."""
        bodies = self.sliders[self.sliders[:, SLIDER_SPEED] >= 0.0, SLIDER_BODY].astype(np.int64)
        return int(np.count_nonzero(elementwise.hypot(*self.world.bodies.velocities[bodies].T) < QUIET))

    def front(self) -> tuple[float, float]:
        """Where the wave is now, m: between the last that was struck and the next."""
        if not len(self.dominoes):
            return 0.0, 0.0
        row = self.dominoes[max(self.last, 0)]
        pitch, since = max(float(row[PITCH]), float(row[THICK])), self.time - float(row[STRUCK])
        ahead = min(max(since, 0.0) * 4.0, pitch) if self.last >= 0 else 0.0
        return float(row[FOOT_X]) + float(row[TO]) * ahead, float(row[FOOT_Y]) + 0.6 * float(row[TALL])

    def state(self) -> ModelState:
        """All that later steps depend on."""
        return ModelState(self.world.state(), self.dominoes, self.sliders, self.heard)

    def restore(self, state: Any) -> None:
        """Take over a copy of a state."""
        self.world.restore(state.world)
        self.dominoes = state.dominoes.copy()
        self.sliders = state.sliders.copy()
        self.heard = state.heard.copy()
