"""One body twice: in a tank by hydrostatics, and in a tank of liquid beside it."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs, Point
from game.physics.effects import EffectSet
from game.physics.grid.layout import Grid
from game.physics.hydrostatics import (
    Curve,
    Floater,
    FloatingBody,
    FloatingSettings,
    FloatingState,
    Pose,
    curve_of,
    make_floater,
    pose_at,
)
from game.physics.hydrostatics.bodies import Ballast
from game.physics.hydrostatics.cut import cut
from game.physics.hydrostatics.motion import LEVEL, SPIN, VX, Tank, X, Y
from game.physics.kernels import elementary
from game.physics.liquid import LiquidState
from game.physics.solids import Disc, Material, Polygon, SolidState, box
from game.physics.solids.mass import polygon_mass
from game.scenes.floating.by_law import ByLaw
from game.scenes.floating.level import FloatingContent
from game.scenes.floating.parameters import FloatingParameters
from game.scenes.floating.shapes import SHAPES, outline_of
from game.scenes.floating.swings import Swings
from game.settings import taken
from game.worlds.hands.hand import NOBODY
from game.worlds.members.solids import Solids
from game.worlds.members.water import DENSITY, Water
from game.worlds.world import Kept, World

LEAD = 0.022  # m: radius of ballast
OF_BODY = ("shape", "weight", "ballast", "tilt", "hinge")


class FloatingWorldState(NamedTuple):
    """law: the body by hydrostatics; solids, liquid: the other tank; outline (n, 2) m; built (4,): density
    kg/m³, ballast's place m and mass kg; drawn (n, 2) m: what was drawn; lead_at (3,): whether ballast was
    put, and where, m; periods: as `Swings` keeps them.
    """

    law: FloatingState
    solids: SolidState
    liquid: LiquidState
    outline: Floats
    built: Floats
    drawn: Floats
    lead_at: Floats
    periods: Floats


class FloatingWorld(World):
    """law: by hydrostatics, in the left tank; water, solids: the liquid's tank, ``apart`` m to the right.

    floater, curve: the body as it is made; body: its number among the solids; anchor: what joints hang on.
    """

    state_type = FloatingWorldState

    def __init__(
        self, content: FloatingContent, parameters: FloatingParameters, active: EffectSet, seed: int
    ):
        self.content, self.parameters = content, parameters
        width, height = content.tank
        if not 0.02 <= content.depth < height:
            raise ValueError(
                f"depth = {content.depth!r}: expected from 0.02 m to less than the tank's height"
            )
        cell = width / int(parameters.cells)
        grid = Grid(int(parameters.cells), max(4, round(height / cell)), cell, (content.apart, 0.0))
        self.solids = Solids(parameters, active)
        self.anchor = self.solids.anchor()
        self.walls = self._build_walls(grid)
        self.others: Longs = np.array([self._add_other(one) for one in content.others], dtype=np.int64)
        self.body, self.joint = NOBODY, NOBODY
        self.drawn: Floats = outline_of(content.outline or SHAPES["hull"])
        self.outline, self.built = np.zeros((0, 2)), np.zeros(4)
        self.lead_at: Floats = np.array((content.ballast_at is not None, *(content.ballast_at or (0.0, 0.0))))
        self.shape, self.set_at = str(parameters.shape), math.radians(float(parameters.tilt))
        self.floater, self.curve = self._make(parameters)
        tank = Tank(width, width * content.depth, DENSITY)
        pose = self.rest_pose()
        self.law = ByLaw(
            FloatingBody(
                self.floater, tank, self._start(pose), pose.angle, settings=self._settings(),
                hinge=self._hinge(),
            )
        )  # fmt: skip
        self._put_in_liquid(pose.angle)
        self.water = Water(grid, parameters, active, self.solids, most=6 * grid.nx * grid.ny)
        self._fill()
        self.water.begin()
        self.swings = Swings(self.watched)
        super().__init__(
            content, parameters, active, self.law, self.solids, self.water,
            Kept(self, "outline", "built", "drawn", "lead_at"),
            self.swings,
        )  # fmt: skip

    # -- the body -------------------------------------------------------------------------------------------

    def _settings(self) -> FloatingSettings:
        return taken(FloatingSettings, self.parameters.values)

    def _make(self, chosen: FloatingParameters) -> tuple[Floater, Curve]:
        """Outline and weights by the parameters; what follows of them."""
        self.outline = self.drawn.copy() if self.shape == "drawn" else outline_of(SHAPES[self.shape])
        density = DENSITY * float(chosen.weight)
        middle = polygon_mass(self.outline, density)
        if self.lead_at[0] == 0.0:
            place = middle.centre[0], float(self.outline[:, 1].min()) + 1.5 * LEAD
        else:
            place = tuple((np.array(middle.centre) + self.lead_at[1:]).tolist())
        self.built = np.array((density, *place, float(chosen.ballast) * middle.mass))
        return self._known()

    def _known(self) -> tuple[Floater, Curve]:
        """Floater and curve of the body that is kept."""
        density, x, y, lead = self.built.tolist()
        floater = make_floater(self.outline, density, [Ballast(x, y, LEAD, lead)])
        return floater, curve_of(floater, DENSITY)

    def rest_pose(self) -> Pose:
        """As it is set down."""
        return pose_at(self.floater, self.set_at, DENSITY)

    def pinned(self) -> bool:
        """Whether it hangs on a hinge."""
        return self.shape == "plank"

    def still_level(self) -> float:
        """m, of the tank's water with the body afloat in it."""
        below = min(self.floater.mass / DENSITY, self.floater.area)
        return self.content.depth + (0.0 if self.pinned() else below / self.content.tank[0])

    def _start(self, pose: Pose) -> Point:
        """Where its centre is, as it is set down (in the left tank, m)."""
        middle = 0.5 * self.content.tank[0]
        if not self.pinned():
            return middle, self.still_level() - pose.depth + self.content.lift
        c, s = elementary.cos(pose.angle), elementary.sin(pose.angle)
        x, y = self.floater.centre
        return middle + c * x - s * y, self.content.depth - float(self.parameters.hinge) + s * x + c * y

    def _hinge(self) -> Point | None:
        return (0.0, 0.0) if self.pinned() else None

    def _shapes(self) -> list[Any]:
        """Of the body among the solids, in the frame of its centre of mass."""
        density, x, y, lead = self.built.tolist()
        cx, cy = self.floater.centre
        wood = Material(density=density, friction=0.3, restitution=0.05)
        shapes: list[Any] = [Polygon(self.outline - np.array((cx, cy)), material=wood)]
        if lead > 0.0:
            heavy = Material(density=lead / (math.pi * LEAD * LEAD), friction=0.3)
            shapes.append(Disc(LEAD, (x - cx, y - cy), heavy))
        return shapes

    def _put_in_liquid(self, angle: float) -> None:
        """A body of the solids as the one by hydrostatics is now, in the place of the one before."""
        world, pose = self.solids.world, self.law.body.pose
        if self.joint != NOBODY:
            world.remove_joint(self.joint)
            self.joint = NOBODY
        if self.body != NOBODY:
            world.remove_body(self.body)
        place = float(pose[X]) + self.content.apart, float(pose[Y])
        self.body = world.add_body(self._shapes(), place, angle, restless=True)
        if self.pinned():
            hinge = float(self.law.body.hinge[3]) + self.content.apart, float(self.law.body.hinge[4])
            self.joint = world.add_joint("pin", self.anchor, self.body, hinge)

    def _fill(self) -> None:
        """Calm water, as much as at the beginning, about what stands in it."""
        liquid, (width, _) = self.water.liquid, self.content.tank
        liquid.keep_only(np.zeros(liquid.count, dtype=np.bool_))
        liquid.account[:] = 0.0
        self.water.meet(without=(self.anchor, *self.walls))
        left, pitch = self.content.apart, liquid.grid.cell / liquid.spread
        owed = round(width * self.content.depth / liquid.area)
        low = 0.0
        while owed > 0 and low < self.content.tank[1]:
            row = liquid.lattice((left, low), (left + width, low + pitch))
            row = row[liquid.solid_distance(row) > 0.0]
            if len(row) > owed:  # the last one, with gaps
                share = owed / len(row)
                row = row[np.diff(np.floor(share * np.arange(len(row) + 1))) > 0.0]
            owed -= liquid.add(row)
            low += pitch

    def set_down(self, angle: float) -> None:
        """Both bodies at rest at an angle (rad), where they would float at it."""
        self.set_at = angle
        self.renew()

    def renew(self) -> None:
        """Make the body anew by the parameters, and set it down in both tanks."""
        self.floater, self.curve = self._make(self.parameters)
        pose, law = self.rest_pose(), self.law.body
        self.law.held = None
        self.law.body = FloatingBody(
            self.floater, law.tank, self._start(pose), pose.angle, settings=law.settings, hinge=self._hinge()
        )
        self._put_in_liquid(pose.angle)
        self._fill()
        self.swings.begin()

    def take_outline(self, points: Floats) -> str:
        """Draw another body; why not."""
        try:
            corners = outline_of(points)
        except ValueError as error:
            return f"No body: {error}."
        width, height = np.ptp(corners, axis=0).tolist()
        if max(width, height) > 0.8 * self.content.tank[0]:
            return "It is too large for the tank."
        self.drawn = corners - corners.mean(axis=0)
        self.lead_at[0] = 0.0
        self.shape = self.parameters.shape = "drawn"
        self.renew()
        return ""

    # -- a step ---------------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        """By hydrostatics, and in the liquid if that is computed."""
        self.law.step(dt)
        if self.parameters.both:
            self.water.step(dt)
            self.solids.step(dt)
        self.swings.step(dt)
        self.time += dt
        return ""

    def change_parameter(self, name: str) -> None:
        super().change_parameter(name)
        self.law.body.settings = self._settings()
        self.law.watch.clear()
        if name == "shape":
            self.shape = str(self.parameters.shape)
        if name == "tilt":
            self.set_at = math.radians(float(self.parameters.tilt))
        if name in OF_BODY:
            self.renew()

    def restore(self, state: Any) -> None:
        self.outline, self.built = state.outline.copy(), state.built.copy()
        self.floater, self.curve = self._known()
        self.law.body.floater = self.floater
        super().restore(state)

    # -- what there is --------------------------------------------------------------------------------------

    def watched(self) -> Floats:
        """Spin (rad/s) and speed upwards (m/s) of both bodies, by which their swings are timed."""
        pose, rows = self.law.body.pose, self.solids.world.bodies
        return np.array((pose[SPIN], pose[VX + 1], rows.spins[self.body], rows.velocities[self.body, 1]))

    def lead_place(self) -> Point | None:
        """Of the ballast in the frame of the centre of mass, m; None where there is none."""
        _, x, y, lead = self.built.tolist()
        cx, cy = self.floater.centre
        return (x - cx, y - cy) if lead > 0.0 else None

    def liquid_level(self) -> float:
        """m: how high the liquid stands where no solid is, in the mean of its columns."""
        liquid = self.water.liquid
        free = (liquid.obstacles.faces.volume > 0.999).all(axis=0)
        inside = np.clip(0.5 - liquid.cells.phi[:, free], 0.0, 1.0)
        return float(inside.sum()) * liquid.grid.cell / max(int(free.sum()), 1) if free.any() else math.nan

    def liquid_pose(self) -> tuple[Point, float]:
        """Centre m and angle rad of the body in the liquid."""
        rows = self.solids.world.bodies
        x, y = rows.positions[self.body].tolist()
        return (x, y), float(rows.angles[self.body])

    def under(self, centre: Point, angle: float, level: float) -> tuple[float, float]:
        """m² of the body below a level, and its draft m."""
        c, s = elementary.cos(angle), elementary.sin(angle)
        found = cut(self.floater.corners, c, s, level - centre[1])
        return float(found[0]), -float(found[8])

    def law_level(self) -> float:
        """m."""
        return float(self.law.body.pose[LEVEL])

    def hinge_depth(self) -> float:
        """m, of the hinge below the level by hydrostatics."""
        return self.law_level() - float(self.law.body.hinge[4])

    def fastest(self) -> float:
        """m/s, of the liquid."""
        speeds = self.water.liquid.speeds
        return float(np.sqrt((speeds * speeds).sum(axis=1).max())) if len(speeds) else 0.0

    def loose(self) -> Longs:
        """Bodies that a hand may take out of the liquid's tank."""
        return np.concatenate([self.others, [self.body]]).astype(np.int64)

    # -- the tank -------------------------------------------------------------------------------------------

    def _build_walls(self, grid: Grid) -> list[int]:
        (left, low), (right, high), thick = grid.lower, grid.upper, 0.5
        wide, tall = right - left, high - low
        world = self.solids.world
        return [
            world.add_body(box(thick, 3.0 * tall), (left - 0.5 * thick, low + tall), kind="fixed"),
            world.add_body(box(thick, 3.0 * tall), (right + 0.5 * thick, low + tall), kind="fixed"),
            world.add_body(
                box(wide + 2.0 * thick, thick), (left + 0.5 * wide, low - 0.5 * thick), kind="fixed"
            ),
        ]

    def _add_other(self, one: Any) -> int:
        wood = Material(density=one.density * DENSITY, friction=0.3, restitution=0.05)
        shape: Any = (
            Disc(one.radius, material=wood)
            if one.radius > 0.0
            else box(one.size[0], one.size[1], material=wood)
        )
        place = one.at[0] + self.content.apart, one.at[1]
        return self.solids.world.add_body(shape, place, restless=True)

    # -- what a hand points at ------------------------------------------------------------------------------

    def own_place(self, at: Point) -> Point | None:
        """A point (m) of either tank in the body's frame, about its centre; None if it is beside the body."""
        (x, y), angle = self._pose_near(at)
        c, s = elementary.cos(angle), elementary.sin(angle)
        dx, dy = at[0] - x, at[1] - y
        own = float(c * dx + s * dy), float(c * dy - s * dx)
        a = self.floater.corners - np.array(own)
        b = np.roll(a, -1, axis=0)
        crossed = (a[:, 1] > 0.0) != (b[:, 1] > 0.0)
        rise = np.where(crossed, b[:, 1] - a[:, 1], 1.0)
        right = a[:, 0] - a[:, 1] * (b[:, 0] - a[:, 0]) / rise > 0.0
        return own if np.count_nonzero(crossed & right) % 2 else None

    def centre_near(self, at: Point) -> Point:
        """m, of the body in the tank in which a point lies."""
        return self._pose_near(at)[0]

    def _pose_near(self, at: Point) -> tuple[Point, float]:
        if at[0] > self.content.apart:
            return self.liquid_pose()
        x, y, angle = self.law.body.pose[:3].tolist()
        return (x, y), angle

    def put_ballast(self, own: Point) -> None:
        """Lead at a point about the centre of mass, m."""
        x, y = self.floater.centre
        middle = polygon_mass(self.outline, 1.0).centre
        self.lead_at[:] = 1.0, own[0] + x - middle[0], own[1] + y - middle[1]
        self.set_at = self._pose_near((0.0, 0.0))[1]
        self.renew()
