"""The world of dominoes: floors, balls, planks, blocks and rows of a level."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Point
from game.physics.effects import EffectSet
from game.physics.kernels import elementary, elementwise
from game.physics.solids import Chain, Disc, Material, Polygon, SolidState, box
from game.physics.solids.arrays.state import DISC, SEGMENT
from game.physics.solids.effects import FRICTION
from game.scenes.domino.blocks import Blocks, block_grip
from game.scenes.domino.course import Standing, floor_points, height_at
from game.scenes.domino.dominoes import LEAST_FRICTION, Dominoes
from game.scenes.domino.level import BallEntry, DominoContent, PlankEntry, RowEntry, SliderEntry
from game.scenes.domino.parameters import DominoParameters
from game.worlds.hearing import Heard, impacts
from game.worlds.members.solids import Solids
from game.worlds.world import World

DENSITIES = {"steel": 7.8, "glass": 2.5, "wood": 0.7, "cork": 0.24}  # kg/m² of a slice, water being 1
CRAWL = 0.25  # m/s
WOOD, BALL, THUD = range(3)  # sounds
LEAST_HEARD = 0.25  # m/s of approach; what leans and slides is silent
HALF_A_DOMINO = 0.08  # kg: what strikes with more sounds faster than it is


class DominoState(NamedTuple):
    """Both tables as `Dominoes` and `Blocks` have them, heard (k, HEARD_WIDTH)."""

    world: SolidState
    dominoes: Floats
    sliders: Floats
    heard: Floats


class DominoWorld(World):
    """Dominoes, balls, planks and blocks of a level. pushed: whether the first push is over. floors: points
    (n, 2) m of each. ValueError for a floor that there is not.
    """

    state_type = DominoState
    content: DominoContent
    parameters: DominoParameters

    def __init__(self, content: DominoContent, parameters: DominoParameters, active: EffectSet, seed: int):
        super().__init__(content, parameters, active)
        self.pushed = False
        self.solids, self.heard = Solids(parameters, active), Heard()
        self.world = world = self.solids.world
        self.floors = [floor_points(floor) for floor in content.floors]
        anchor = self.solids.anchor()
        self.floor_ids = [
            world.add_body(Chain(points, material=Material(1.0, self._grip(k))), kind="fixed")
            for k, points in enumerate(self.floors)
        ]
        things: tuple[RowEntry | BallEntry | SliderEntry, ...] = (
            *content.rows, *content.balls, *content.sliders,
        )  # fmt: skip
        for one in things:
            if one.floor >= len(self.floors):
                raise ValueError(f"floor = {one.floor}: there are {len(self.floors)}")
        self.plank_ids = [self._add_plank(anchor, entry) for entry in content.planks]
        self.ball_ids = [self._add_ball(entry) for entry in content.balls]
        self.dominoes = Dominoes(world, content, self.floors, parameters)
        self.blocks = Blocks(world, content, self.floors, self._lane_grips())
        self.members = (self.solids, self.dominoes, self.blocks, self.heard)

    # -- building and changes -------------------------------------------------------------------------

    def _grip(self, floor: int | None) -> float:
        """Friction of a floor (None: of planks) so that dominoes meet it with what is wanted."""
        own = None if floor is None else self.content.floors[floor].friction
        wanted = self.parameters.floor_friction if own is None else own
        return min(wanted * wanted / max(self.parameters.friction, LEAST_FRICTION), 1e9)

    def _lane_grips(self) -> list[float]:
        return [self._grip(one.floor) for one in self.content.sliders]

    def _add_ball(self, entry: BallEntry) -> int:
        """A ball on a floor; its body."""
        y, slope = height_at(self.floors[entry.floor], entry.x)
        c, s, speed = elementary.cos(slope), elementary.sin(slope), entry.velocity
        material = Material(
            DENSITIES[entry.made_of],
            max(self.parameters.friction, LEAST_FRICTION),
            self.parameters.restitution,
        )
        return self.world.add_body(
            Disc(entry.radius, material=material), (entry.x - entry.radius * s, y + entry.radius * c), 0.0,
            (speed * c, speed * s), -speed / entry.radius,
        )  # fmt: skip

    def _add_plank(self, anchor: int, entry: PlankEntry) -> int:
        """A plank that lies there, or turns about a pin; its body."""
        material, (x, y) = Material(entry.density, self._grip(None)), entry.at
        if not entry.seesaw:
            shape = box(entry.length, entry.thickness, material=material)
            return self.world.add_body(shape, (x, y - 0.5 * entry.thickness))
        half, up = 0.5 * entry.length, 0.5 * entry.thickness
        shift = -0.02 * entry.length  # a little heavier on its left
        corners = [(shift - half, -up), (shift + half, -up), (shift + half, up), (shift - half, up)]
        body = self.world.add_body(Polygon(corners, material=material), (x, y), math.radians(entry.lean))
        self.world.add_joint("pin", anchor, body, (x, y))
        return body

    def change_parameter(self, name: str) -> None:
        super().change_parameter(name)
        if name in ("friction", "floor_friction"):
            self._change_friction()
        elif name == "restitution":
            rows = self.world.shapes.restitutions
            rows[np.isin(self.world.shapes.bodies, self.ball_ids)] = self.parameters.restitution

    def _change_friction(self) -> None:
        set_frictions = self.solids.set_frictions
        smooth = [*self.ball_ids, *self.dominoes.table.body.tolist()]
        set_frictions(smooth, max(self.parameters.friction, LEAST_FRICTION))
        for k, body in enumerate(self.floor_ids):
            set_frictions([body], self._grip(k))
        set_frictions(self.plank_ids, self._grip(None))
        rows = zip(self.content.sliders, self.blocks.table.body.tolist(), self._lane_grips(), strict=True)
        for entry, body, lane in rows:
            set_frictions([body], block_grip(entry.friction, lane))

    # -- a step ---------------------------------------------------------------------------------------

    def push_first(self) -> None:
        """Push the first domino that is there."""
        self.pushed, there = True, self.dominoes.there()
        if len(there):
            self.dominoes.push(int(there[0]))

    def advance(self, dt: float) -> str:
        at = self.content.pushed_at
        if (
            at is not None
            and not self.pushed
            and self.time >= at - 0.5 * dt
            and len(self.dominoes.table.body)
        ):
            self.push_first()
        before = self.world.bodies.angles.copy()
        said = super().advance(dt)
        self.dominoes.note_struck(before, self.time, dt)
        self._listen(self.time - dt)
        return said

    def _listen(self, began: float) -> None:
        """Contacts that began, as loud as they strike: on the floor, of two balls, else of wood."""
        found = impacts(self.world, LEAST_HEARD)
        if not len(found.rows):
            self.heard.forget(began)
            return
        of_balls = np.isin(found.bodies, self.ball_ids) & (found.shapes == DISC)
        kinds = np.where((found.shapes == SEGMENT).any(axis=1), THUD, WOOD)
        kinds = np.where(of_balls.all(axis=1), BALL, kinds)
        self.heard.remember(found.heard(began, kinds, found.by_impulse(HALF_A_DOMINO, 2.0)), began)

    # -- what is there --------------------------------------------------------------------------------

    def front(self) -> Point:
        """Where the wave is now, m."""
        return self.dominoes.front(self.time)

    def theory(self) -> float:
        """Speed (m/s) of a steady wave through the dominoes that were measured last; NaN before."""
        rough = self.parameters.friction if FRICTION in self.active else 0.0
        return self.dominoes.wave.theory(self.gravity(), rough)

    def ball_speeds(self) -> Floats:
        """(n,) m/s."""
        return elementwise.hypot(*self.world.bodies.velocities[np.array(self.ball_ids, dtype=np.int64)].T)

    def ball_at(self, point: Point) -> int:
        """Number of the ball at a point, or -1."""
        places = self.world.bodies.positions
        for k, (body, entry) in enumerate(zip(self.ball_ids, self.content.balls, strict=True)):
            if elementary.dist(places[body].tolist(), point) <= entry.radius:
                return k
        return -1

    def floor_below(self, point: Point) -> Standing | None:
        """Where something dropped at a point would stand; None where there is nothing below."""
        found = [(y, slope) for points in self.floors if points[0, 0] <= point[0] <= points[-1, 0]
                 for y, slope in (height_at(points, point[0]),)]  # fmt: skip
        found += [
            (entry.at[1], 0.0) for entry in self.content.planks
            if not entry.seesaw and abs(point[0] - entry.at[0]) <= 0.5 * entry.length
        ]  # fmt: skip
        below = [one for one in found if one[0] <= point[1] + 0.5]
        if not below:
            return None
        y, slope = max(below, key=lambda one: one[0])
        return Standing(point[0], y, slope, 1.0)
