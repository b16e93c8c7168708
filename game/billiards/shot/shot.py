"""A shot: table, balls and physics just after the cue has left the ball. Checked, packed, ready to play."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.billiards.laws.batch import Batch
from game.billiards.laws.contacts import (
    BALL_MODELS,
    CONSTANT_FRICTION,
    CUSHION_MODELS,
    NO_FRICTION,
    RESTITUTION,
)
from game.billiards.laws.layout import Layout, is_clear, layout_of
from game.billiards.laws.state import (
    FLIGHT_IN_COLUMNS,
    IN_COLUMNS,
    IN_Z,
    LANDING_SPEED,
    MOTIONS,
    PHYSICS_COLUMNS,
    POCKETED,
    ROLLING,
    SLIDING,
    SPINNING,
    STATIONARY,
)
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS
from game.billiards.table.table import Table
from game.physics.kernels import elementary

Array = NDArray[np.float64]

OVERLAP = 1e-6  # m; balls that overlap more than this are refused
LARGEST = {"position": 1e4, "velocity": 1e4, "spin": 1e6, "radius": 1e2, "mass": 1e6}  # SI
HIGHEST = 10.0  # m
SMALLEST = {"radius": 1e-5, "mass": 1e-9}  # SI


OPTIONAL = ("cushion_restitution_fall", "cushion_compliance", "slate_restitution", "cushion_hop")


class ShotError(ValueError):
    """A shot that cannot be played; the message names the field and the reason."""


class Physics(NamedTuple):
    """Cloth, balls and cushions of a table. Frictions and restitutions have no unit; gravity is in m/s^2.

    cushion_restitution_fall: by how much the restitution of cushions falls with the closing speed, s/m.
    cushion_compliance: tangential over normal, of `stronge-2000`; for rubber (2 - nu)/(2 - 2 nu) = 1.5.
    slate_restitution: of a ball that falls on the bed (Alciatore, physical properties of pool balls and
    tables: 0.5). cushion_hop: share of it that is left when a cushion presses a ball down, 0 to 1, see
    `flight.nose`. airborne: balls may leave the slate; else vertical speed is left out.
    Defaults are those of a pool table in play. A friction of 0 takes the effect away.
    """

    ball_ball: str = "alciatore-2006"
    cushion: str = "han-2005"
    gravity: float = 9.81
    sliding: float = 0.2
    rolling: float = 0.01
    spinning: float = 0.0127
    ball_friction: float = 0.05
    cushion_friction: float = 0.2
    ball_restitution: float = 0.95
    cushion_restitution: float = 0.85
    cushion_restitution_fall: float = 0.0
    cushion_compliance: float = 1.5
    slate_restitution: float = 0.5
    cushion_hop: float = 0.0
    airborne: bool = True

    def __repr__(self) -> str:
        """All numbers; those that not every table has only where they are not the default.

        Words that stand for a table stay what they were before it could have these numbers. Whether balls may
        leave the slate is not said: it changes nothing about the table.
        """
        said = [f"{name}={value!r}" for name, value in self._asdict().items() if name != "airborne"
                and (name not in OPTIONAL or value != self._field_defaults[name])]  # fmt: skip
        return f"Physics({', '.join(said)})"


FRICTIONLESS = Physics(
    "elastic", "mirror", sliding=0.0, rolling=0.0, spinning=0.0, ball_friction=0.0, cushion_friction=0.0,
    ball_restitution=1.0, cushion_restitution=1.0,
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class Shot:
    """One shot, checked. Build it with `make_shot`, `load_shot`, or from another with `struck`.

    balls (n, 11): see `state`, about the table's middle. ids, element names: as events name them. flies: a
    ball leaves the slate, or might; balls are then (n, 13).
    """

    table: Table
    physics: Physics
    balls: Array
    ids: tuple[str, ...]
    cushion_ids: tuple[str, ...]
    jaw_ids: tuple[str, ...]
    pocket_ids: tuple[str, ...]
    layout: Layout
    flies: bool = False

    @property
    def positions(self) -> Array:
        """Positions (n, 2) m in the table's frame."""
        return self.balls[:, :2] + self.layout.middle

    @cached_property
    def constants(self) -> Array:
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
        assert row.shape == (PHYSICS_COLUMNS,)
        return row

    @cached_property
    def batch(self) -> Batch:
        """The shot as a batch of one."""
        return batch_of([self])

    def struck(self, ball: int, velocity: ArrayLike, spin: ArrayLike = (0.0, 0.0, 0.0)) -> Shot:
        """The same shot with the ball in row `ball` sliding at velocity (2 or 3,) m/s, spin (3,) rad/s.

        A vertical velocity downwards presses the ball onto the slate, upwards lifts it; it is left out if the
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
        balls[ball, 9] = SLIDING
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

    def _with_balls(self, balls: Array, ball: int, height: float, vertical: float) -> Shot:
        """The shot with other balls, and columns for their heights if one leaves the slate."""
        physics = self.physics
        rise = vertical if vertical > 0.0 else -physics.slate_restitution * vertical
        lifted = physics.airborne and (height > 0.0 or rise > LANDING_SPEED)
        flies = lifted or self.flies or (physics.airborne and physics.cushion_hop > 0.0)
        if flies and balls.shape[1] == IN_COLUMNS:
            balls = with_heights(balls).copy()
        if flies:
            balls[ball, IN_Z:] = (height, vertical) if lifted else 0.0
        balls.setflags(write=False)
        return Shot(
            self.table, self.physics, balls, self.ids, self.cushion_ids, self.jaw_ids, self.pocket_ids,
            self.layout, flies,
        )  # fmt: skip


def with_heights(balls: Array) -> Array:
    """Balls (n, 11) with columns for height and vertical speed, all 0: (n, 13), frozen."""
    lifted = np.zeros((len(balls), FLIGHT_IN_COLUMNS))
    lifted[:, :IN_COLUMNS] = balls
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
    balls = np.zeros((n, IN_COLUMNS))
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


def _fill(name: str, value: ArrayLike, columns: Array) -> None:
    """Write numbers to columns (n, k) of the balls, one for all; ShotError if the shape does not fit."""
    array = np.asarray(value, dtype=np.float64)
    if array.ndim == 1 and columns.shape[1] == 1:
        array = array[:, None]
    try:
        columns[:] = array
    except ValueError:
        raise ShotError(f"{name}: shape {array.shape} does not fit {len(columns)} balls") from None


def _guess_motions(balls: Array) -> Array:
    moving = (balls[:, 2:6] != 0.0).any(axis=1)
    return np.where(moving, SLIDING, np.where(balls[:, 6] != 0.0, SPINNING, STATIONARY)).astype(np.float64)


def _motion_numbers(motions: ArrayLike, n: int) -> Array:
    numbers = np.array(
        [MOTIONS.index(m) if isinstance(m, str) else int(m) for m in np.asarray(motions).tolist()]
    )
    if numbers.shape != (n,) or numbers.min(initial=0) < 0 or numbers.max(initial=0) > POCKETED:
        raise ShotError(f"motions: need {n} of {', '.join(MOTIONS)}")
    return numbers.astype(np.float64)


def check_physics(physics: Physics) -> None:
    """ShotError if a model is unknown or a number absurd."""
    if physics.ball_ball not in BALL_MODELS:
        raise ShotError(f"models.ball_ball: {physics.ball_ball!r} is not one of {', '.join(BALL_MODELS)}")
    if physics.cushion not in CUSHION_MODELS:
        raise ShotError(f"models.cushion: {physics.cushion!r} is not one of {', '.join(CUSHION_MODELS)}")
    if not (math.isfinite(physics.gravity) and 0.0 < physics.gravity <= 1e4):
        raise ShotError(f"gravity: must be positive, at most 1e4 m/s^2, got {physics.gravity!r}")
    names = {
        "sliding": "friction.sliding",
        "rolling": "friction.rolling",
        "spinning": "friction.spinning",
        "ball_friction": "friction.ball_ball",
        "cushion_friction": "friction.cushion",
    }
    for field, name in names.items():
        value = getattr(physics, field)
        if not (math.isfinite(value) and (value == 0.0 or 1e-9 <= value <= 1e3)):
            raise ShotError(f"{name}: must be 0, or between 1e-9 and 1e3, got {value!r}")
    for field, name, least, most in (
        ("cushion_restitution_fall", "restitution.cushion_fall", 0.0, 10.0),
        ("cushion_compliance", "compliance.cushion", 0.01, 100.0),
        ("cushion_hop", "restitution.cushion_hop", 0.0, 1.0),
    ):
        if not least <= getattr(physics, field) <= most:
            raise ShotError(
                f"{name}: must be between {least:g} and {most:g}, got {getattr(physics, field)!r}"
            )
    for field in ("ball_restitution", "cushion_restitution", "slate_restitution"):
        value = getattr(physics, field)
        if not 0.0 <= value <= 1.0:
            raise ShotError(f"restitution.{field.split('_')[0]}: must be between 0 and 1, got {value!r}")


def check_balls(balls: Array, table: Table, physics: Physics) -> None:
    """ShotError if a ball's numbers are absurd, or contradict each other or the table.

    balls (n, 11): columns as in `Shot`, places from a corner of the table as in a file.
    """
    for i, row in enumerate(balls.tolist()):
        fields = {
            "position": row[0:2],
            "velocity": row[2:4],
            "spin": row[4:7],
            "radius": row[7:8],
            "mass": row[8:9],
        }
        for name, values in fields.items():
            for value in values:
                if not math.isfinite(value) or abs(value) > LARGEST[name]:
                    raise ShotError(
                        f"balls[{i}].{name}: must be finite and at most {LARGEST[name]:g}, got {value!r}"
                    )
                if name in SMALLEST and value < SMALLEST[name]:
                    raise ShotError(f"balls[{i}].{name}: must be at least {SMALLEST[name]:g}, got {value!r}")
        _check_motion(i, row)
        needs_height = CUSHION_MODELS[physics.cushion] != RESTITUTION and len(table.cushions) + len(
            table.jaws
        )
        if needs_height and not abs(table.cushion_height / row[7] - 1.0) < 1.0:
            raise ShotError(
                f"table.cushion_height: {physics.cushion} needs it between 0 and twice the radius of"
                f" balls[{i}], got {table.cushion_height!r}"
            )
    _check_overlap(balls)


def _check_motion(i: int, row: list[float]) -> None:
    """The stated motion must fit velocity and spin."""
    motion = int(row[9])
    vx, vy, wx, wy, wz, radius = row[2:8]
    if motion in (STATIONARY, SPINNING) and (vx, vy, wx, wy) != (0.0, 0.0, 0.0, 0.0):
        raise ShotError(f"balls[{i}].motion: {MOTIONS[motion]}, but it has velocity or spin about x or y")
    if motion == STATIONARY and wz != 0.0:
        raise ShotError(f"balls[{i}].motion: stationary, but it spins about z")
    if motion == ROLLING:
        slip = elementary.hypot(vx - radius * wy, vy + radius * wx)
        if slip > 1e-6 * (1.0 + elementary.hypot(vx, vy)):
            raise ShotError(
                f"balls[{i}].spin: a rolling ball has spin (-vy/R, vx/R), this one slips at {slip:.3g} m/s"
            )


def _check_overlap(balls: Array) -> None:
    present = [i for i in range(len(balls)) if int(balls[i, 9]) != POCKETED]
    for place, i in enumerate(present):
        for j in present[:place]:
            reach = 2.0 * math.sqrt(balls[i, 7] * balls[j, 7])
            gap = elementary.hypot(balls[i, 0] - balls[j, 0], balls[i, 1] - balls[j, 1]) - reach
            if gap < -OVERLAP:
                raise ShotError(f"balls[{j}] and balls[{i}] overlap by {-gap:.3g} m")
