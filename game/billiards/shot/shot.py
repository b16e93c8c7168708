"""A shot: table, balls and physics just after the cue has left the ball. Checked, packed, ready to play."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.billiards.laws import state as s
from game.billiards.laws.batch import Batch
from game.billiards.laws.contacts import (
    BALL_MODELS,
    CONSTANT_FRICTION,
    CUSHION_MODELS,
    NO_FRICTION,
)
from game.billiards.laws.layout import Layout, is_clear, layout_of
from game.billiards.laws.state import MOTIONS
from game.billiards.shot.balls import LARGEST, check_balls
from game.billiards.shot.physics import Physics, ShotError, check_physics
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS
from game.billiards.table.table import Table

HIGHEST = 10.0  # m


@dataclass(frozen=True, eq=False)
class Shot:
    """One shot, checked. Build it with `make_shot`, `load_shot`, or from another with `struck`.

    balls (n, 11): see `state`, about the table's middle. ids, element names: as events name them. flies: a
    ball leaves the slate, or might; balls are then (n, 13).
    """

    table: Table
    physics: Physics
    balls: Floats
    ids: tuple[str, ...]
    cushion_ids: tuple[str, ...]
    jaw_ids: tuple[str, ...]
    pocket_ids: tuple[str, ...]
    layout: Layout
    flies: bool = False

    @property
    def positions(self) -> Floats:
        """Positions (n, 2) m in the table's frame."""
        return self.balls[:, :2] + self.layout.middle

    @cached_property
    def constants(self) -> Floats:
        """physics (22,) as the kernels read it: the columns of `state` that are named after GRAVITY."""
        p = self.physics
        model = BALL_MODELS[p.ball_ball]
        restitution = 1.0 if model.elastic else p.ball_restitution
        # a constant friction of 0 is none: the kernels then do without the whole law
        smooth = model.friction == CONSTANT_FRICTION and p.ball_friction == 0.0
        law = NO_FRICTION if smooth else model.friction
        row = np.array(
            [
                p.gravity, p.sliding, p.rolling, p.spinning,
                restitution, law, p.ball_friction, model.limit(restitution),
                CUSHION_MODELS[p.cushion], 1.0 if p.cushion == "mirror" else p.cushion_restitution,
                p.cushion_friction, self.table.cushion_height, *self.layout.free,
                *self.layout.middle,
                0.0 if p.cushion == "mirror" else p.cushion_restitution_fall, p.cushion_compliance,
                p.slate_restitution, p.cushion_hop,
            ]
        )  # fmt: skip
        assert row.shape == (s.PHYSICS_COLUMNS,)
        return row

    @cached_property
    def batch(self) -> Batch:
        """The shot as a batch of one."""
        return batch_of([self])

    def struck(self, ball: int, velocity: ArrayLike, spin: ArrayLike = (0.0, 0.0, 0.0)) -> Shot:
        """The same shot with the ball in row `ball` sliding at velocity (2 or 3,) m/s, spin (3,) rad/s.

        A vertical velocity downwards presses the ball onto the slate, upwards lifts it. It is left out if the
        physics has no airborne balls, or if the ball would rise at no more than `state.LANDING_SPEED`.
        ShotError for a row that there is not, or other shapes.
        """
        if not 0 <= ball < len(self.balls):
            raise ShotError(f"struck: there are balls 0 to {len(self.balls) - 1}, not {ball!r}")
        motion, turn = np.asarray(velocity, dtype=np.float64), np.asarray(spin, dtype=np.float64)
        if motion.shape not in ((2,), (3,)) or turn.shape != (3,):
            raise ShotError(f"struck: velocity 2 or 3, spin 3 numbers, not {motion.shape} and {turn.shape}")
        columns = np.concatenate([motion[:2], turn])
        vertical = float(motion[2]) if len(motion) == 3 else 0.0
        if not (np.isfinite(columns).all() and math.isfinite(vertical)):
            raise ShotError("struck: velocity and spin must be finite")
        balls = self.balls.copy()
        balls[ball, 2:7] = columns
        balls[ball, 9] = s.SLIDING
        return self._with_balls(balls, ball, 0.0, vertical)

    def in_air(
        self, ball: int, velocity: ArrayLike, height: float, spin: ArrayLike = (0.0, 0.0, 0.0)
    ) -> Shot:
        """The same shot with a ball in the air, `height` m above where it would lie, at velocity (3,) m/s.

        ShotError for a height that is not positive, and as `struck` and `lifted`.
        """
        level = self.struck(ball, np.asarray(velocity)[:2], spin)
        if not height > 0.0:
            raise ShotError(f"in_air: height must be above 0, got {height!r}")
        return level.lifted(ball, height, float(np.asarray(velocity)[2]))

    def lifted(self, ball: int, height: float, rise: float) -> Shot:
        """The same shot with a ball `height` m above where it would lie, rising at `rise` m/s.

        At height 0 it is pressed onto the slate, or jumps. ShotError for absurd numbers, or on a table
        without airborne balls.
        """
        if not (0.0 <= height <= HIGHEST and abs(rise) <= LARGEST["velocity"]):
            raise ShotError(
                f"balls[{ball}].height: must be 0 to {HIGHEST:g} m, rise finite; got {height!r}, {rise!r}"
            )
        if not self.physics.airborne:
            raise ShotError(
                f"balls[{ball}].height: on this table all balls stay down, it has no airborne ones"
            )
        return self._with_balls(self.balls.copy(), ball, height, rise)

    def _with_balls(self, balls: Floats, ball: int, height: float, vertical: float) -> Shot:
        """The shot with other balls, and columns for their heights if one leaves the slate."""
        physics = self.physics
        rise = vertical if vertical > 0.0 else -physics.slate_restitution * vertical
        lifted = physics.airborne and (height > 0.0 or rise > s.LANDING_SPEED)
        flies = lifted or self.flies or (physics.airborne and physics.cushion_hop > 0.0)
        if flies and balls.shape[1] == s.IN_COLUMNS:
            balls = with_heights(balls).copy()
        if flies:
            balls[ball, s.IN_Z :] = (height, vertical) if lifted else 0.0
        balls.setflags(write=False)
        return Shot(
            self.table, self.physics, balls, self.ids, self.cushion_ids, self.jaw_ids, self.pocket_ids,
            self.layout, flies,
        )  # fmt: skip


def with_heights(balls: Floats) -> Floats:
    """Balls (n, 11) with columns for height and vertical speed, all 0: (n, 13), frozen."""
    lifted = np.zeros((len(balls), s.FLIGHT_IN_COLUMNS))
    lifted[:, : s.IN_COLUMNS] = balls
    lifted.setflags(write=False)
    return lifted


def batch_of(shots: list[Shot]) -> Batch:
    """Pack shots of equally many balls for the kernel."""
    tables: dict[int, int] = {}
    layouts: list[Layout] = []
    rows = []
    for shot in shots:
        if id(shot.layout) not in tables:
            tables[id(shot.layout)] = len(layouts)
            layouts.append(shot.layout)
        rows.append(tables[id(shot.layout)])
    starts = np.cumsum([0] + [len(layout.elements) for layout in layouts])
    ranges = np.array([[0, *np.cumsum(layout.counts)] for layout in layouts]) + starts[:-1, None]
    return Batch(
        np.stack([shot.balls for shot in shots]),
        np.stack([shot.constants for shot in shots]),
        np.concatenate([layout.elements for layout in layouts]),
        ranges[rows],
    )


def make_shot(
    table: Table,
    positions: ArrayLike,
    velocities: ArrayLike = 0.0,
    spins: ArrayLike = 0.0,
    *,
    radii: ArrayLike = BALL_RADIUS,
    masses: ArrayLike = BALL_MASS,
    motions: ArrayLike | None = None,
    physics: Physics = Physics(),  # noqa: B008  (immutable)
    ids: tuple[str, ...] | None = None,
) -> Shot:
    """A checked shot. positions, velocities (n, 2) SI; spins (n, 3) rad/s; radii (n,) m, masses (n,) kg.

    Numbers stand for all balls. motions (n,): names or numbers of `state.MOTIONS`; left out, a ball slides if
    it moves, spins in place if only w z is not 0, else rests. ids: of the balls; left out they are
    the row numbers, as those of cushions, jaws and pockets are. ShotError names what is wrong.
    """
    xy = np.array(positions, dtype=np.float64).reshape(-1, 2)
    n = len(xy)
    layout = layout_of(table)
    balls = np.zeros((n, s.IN_COLUMNS))
    balls[:, 0:2] = xy
    _fill("velocities", velocities, balls[:, 2:4])
    _fill("spins", spins, balls[:, 4:7])
    _fill("radii", radii, balls[:, 7:8])
    _fill("masses", masses, balls[:, 8:9])
    balls[:, 9] = _guess_motions(balls) if motions is None else _motion_numbers(motions, n)
    names = tuple(str(i) for i in range(n)) if ids is None else tuple(ids)
    if len(names) != n or len(set(names)) != n:
        raise ShotError(f"balls: {n} balls need {n} different ids")
    check_physics(physics)
    check_balls(balls, table, physics)
    balls[:, 10] = [float(is_clear(table, radius)) for radius in balls[:, 7].tolist()]
    balls[:, 0:2] -= layout.middle
    balls.setflags(write=False)
    cushion_ids, jaw_ids, pocket_ids = (
        tuple(str(k) for k in range(len(rows))) for rows in (table.cushions, table.jaws, table.pockets)
    )
    flies = physics.airborne and physics.cushion_hop > 0.0
    if flies:
        balls = with_heights(balls)
    balls.setflags(write=False)
    return Shot(table, physics, balls, names, cushion_ids, jaw_ids, pocket_ids, layout, flies)


def _fill(name: str, value: ArrayLike, columns: Floats) -> None:
    """Write numbers to columns (n, k) of the balls, one for all; ShotError if the shape does not fit."""
    array = np.asarray(value, dtype=np.float64)
    if array.ndim == 1 and columns.shape[1] == 1:
        array = array[:, None]
    try:
        columns[:] = array
    except ValueError:
        raise ShotError(f"{name}: shape {array.shape} does not fit {len(columns)} balls") from None


def _guess_motions(balls: Floats) -> Floats:
    moving = (balls[:, 2:6] != 0.0).any(axis=1)
    return np.where(moving, s.SLIDING, np.where(balls[:, 6] != 0.0, s.SPINNING, s.STATIONARY)).astype(
        np.float64
    )


def _motion_numbers(motions: ArrayLike, n: int) -> Floats:
    numbers = np.array(
        [MOTIONS.index(m) if isinstance(m, str) else int(m) for m in np.asarray(motions).tolist()]
    )
    if numbers.shape != (n,) or numbers.min(initial=0) < 0 or numbers.max(initial=0) > s.POCKETED:
        raise ShotError(f"motions: need {n} of {', '.join(MOTIONS)}")
    return numbers.astype(np.float64)
