"""Key-frames: values given at a few times, and everything between by a named interpolation.

    track = Keyframes([0.0, 0.4, 1.0], [(0, 0), (2, 1), (3, 0)], "spline")
    track.sample(0.25)                 # (2,)
    track.sample(times, out=buffer)    # (k, 2), nothing allocated

What the numbers mean is the caller's: a place, an angle, the stroke of a billiard cue.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats
from game.physics.animation import sampling
from game.physics.animation.angles import TURN, shortest_turn
from game.physics.animation.piecewise import PiecewiseCubic
from game.physics.animation.tangents import RULES, piece_slopes

INTERPOLATIONS = ("nearest", "linear", "bezier", *RULES)
LARGEST = 1e150  # of times and values: their differences and the coefficients stay finite


class Keyframes:
    """Keys at ``times`` (n,) s with ``values`` (n, m) or (n,), in any order, and how to go between them.

    interpolation: one of INTERPOLATIONS. handles: (n, 2, m), for "bezier" only: the control points before and
    after each key, relative to it. angles: columns that are angles and turn by the shortest way, half a turn
    going counterclockwise; turn: a whole turn in their unit. loop: the time from first to last key is
    repeated, and slopes go round if the last key is the first one again. geometry: columns whose distances
    space the knots of centripetal and chordal curves; all but angles if not given.

    Keys are sorted by time; of keys at the same time, which are a jump, the order given is kept: the limit
    from before is the first one's value, at the time itself and after it is the last one's. A sample at a
    key's time is exactly its value. "nearest" takes the later key halfway. Before the first key and after the
    last one their values hold. Angles are only good up to whole turns: from 350 to 10 degrees it goes to 370.

    ValueError for no keys, for what is not finite or beyond 1e150, and for shapes that do not fit.
    """

    def __init__(
        self,
        times: ArrayLike,
        values: ArrayLike,
        interpolation: str = "linear",
        *,
        handles: ArrayLike | None = None,
        angles: Sequence[int] = (),
        turn: float = TURN,
        loop: bool = False,
        geometry: Sequence[int] | None = None,
    ) -> None:
        instants, given = _checked("times", times, 1), np.asarray(values, dtype=np.float64)
        if len(instants) == 0:
            raise ValueError("times: expected at least one key")
        self.flat = given.ndim == 1  # one number a key: samples have no columns
        rows = _checked("values", given[:, None] if self.flat else given, 2)
        if len(rows) != len(instants) or rows.shape[1] == 0:
            raise ValueError(f"values: expected {len(instants)} rows of one number or more, not {rows.shape}")
        if interpolation not in INTERPOLATIONS:
            raise ValueError(
                f"interpolation: expected one of {', '.join(INTERPOLATIONS)}, not {interpolation!r}"
            )
        if not (np.isfinite(turn) and turn > 0.0):
            raise ValueError(f"turn = {turn!r}: expected a positive number")
        order = np.argsort(instants, kind="stable")
        self.interpolation = interpolation
        self.times, self.values = instants[order], rows[order]
        self.angles, self.turn, self.loop = _columns("angles", angles, rows.shape[1]), float(turn), bool(loop)
        others = tuple(j for j in range(rows.shape[1]) if j not in self.angles)
        self.geometry = _columns("geometry", geometry, rows.shape[1]) if geometry is not None else others
        self.handles = self._checked_handles(handles, order)
        self._build()

    def _checked_handles(self, handles: ArrayLike | None, order: NDArray[np.int64]) -> Floats | None:
        if (handles is None) == (self.interpolation == "bezier"):
            raise ValueError('handles: expected for "bezier", and for no other interpolation')
        if handles is None:
            return None
        offsets = _checked("handles", handles, 3)
        if offsets.shape != (len(self.times), 2, self.values.shape[1]):
            raise ValueError(f"handles: expected two for each key, not {offsets.shape}")
        return offsets[order]

    def _build(self) -> None:
        """Coefficients of all pieces."""
        steps = np.diff(self.values, axis=0)
        if self.angles:
            turning = list(self.angles)
            steps[:, turning] = shortest_turn(steps[:, turning], self.turn)
        n, m = self.values.shape
        self.coefficients = np.zeros((n, 4, m))
        self.coefficients[:, 0] = self.values
        if n > 1 and self.interpolation == "linear":
            self.coefficients[:-1, 1] = steps
        elif n > 1 and self.interpolation != "nearest":
            begins, ends = self._slopes(steps)
            self.coefficients[:-1, 1] = begins
            self.coefficients[:-1, 2] = 3.0 * steps - 2.0 * begins - ends
            self.coefficients[:-1, 3] = begins + ends - 2.0 * steps
        self._track = sampling.make_track(self.times, self.coefficients)
        self._degree = {"nearest": sampling.NEAREST, "linear": sampling.LINEAR}.get(
            self.interpolation, sampling.CUBIC
        )

    def _slopes(self, steps: Floats) -> tuple[Floats, Floats]:
        if self.handles is not None:
            return 3.0 * self.handles[:-1, 1], -3.0 * self.handles[1:, 0]
        seam = self.values[-1] - self.values[0]
        if self.angles:
            turning = list(self.angles)
            seam[turning] = shortest_turn(seam[turning], self.turn)
        scale = np.max(np.abs(self.values), initial=0.0)
        closed = self.loop and bool(np.all(np.abs(seam) <= 1e-12 * scale))
        geometry = self.geometry if self.geometry else None
        return piece_slopes(self.interpolation, self.times, steps, closed, geometry)

    # -- samples ------------------------------------------------------------------------------------

    def sample(self, times: ArrayLike, out: Floats | None = None) -> Floats:
        """Values at ``times``: (m,) at one time, (k, m) at (k,); without m if the keys are plain numbers.

        out: contiguous float64 of that shape, written and given back. ValueError for a time not finite.
        """
        return self._sample(self._degree, times, out)

    __call__ = sample

    def rate(self, times: ArrayLike, out: Floats | None = None) -> Floats:
        """Derivatives by time, 1/s; at a key those of what comes after it. Shapes as of `sample`.

        "nearest" and whatever holds a value has none (0); a jump is not seen. Within a piece that is shorter
        than 1e-150 s it is as steep as one of that length.
        """
        return self._sample(self._degree | sampling.RATE_BIT, times, out)

    def _sample(self, variant: int, times: ArrayLike, out: Floats | None) -> Floats:
        at = np.asarray(times, dtype=np.float64)
        if at.ndim > 1:
            raise ValueError(f"times: expected one time or a row of them, not {at.shape}")
        m = self.values.shape[1]
        shape = at.shape if self.flat else (*at.shape, m)
        if out is None:
            out = np.empty(shape)
        elif out.shape != shape or out.dtype != np.float64 or not out.flags.c_contiguous:
            raise ValueError(f"out: expected contiguous float64 of shape {shape}")
        kernel = sampling.sampler(variant, m if m <= sampling.UNROLLED else 0)
        row = np.ascontiguousarray(at.reshape(-1))
        if kernel(*self._track, m, int(self.loop), row, out.reshape(-1)):
            raise ValueError("times: expected finite times")
        return out

    # -- shape --------------------------------------------------------------------------------------

    @property
    def span(self) -> tuple[float, float]:
        """Times of the first and the last key, s."""
        return float(self.times[0]), float(self.times[-1])

    def path(self, columns: Sequence[int] | None = None) -> PiecewiseCubic:
        """The curve that some columns (all if not given) run through, a Bezier curve for each piece.

        Its parameter is i + u within piece i. A jump is a piece that is a point, the one jumped to. "nearest"
        runs through no curve: its keys are joined by lines.
        ValueError for fewer than two keys.
        """
        if len(self.times) < 2:
            raise ValueError("a path needs two keys")
        chosen = list(range(self.values.shape[1]) if columns is None else columns)
        c0, c1, c2, c3 = (self.coefficients[:-1, power][:, chosen] for power in range(4))
        if self.interpolation == "nearest":
            c1 = np.diff(self.values[:, chosen], axis=0)
        ends = self.values[1:, chosen].copy()
        turning = [j for j, column in enumerate(chosen) if column in self.angles]
        ends[:, turning] = (c0 + c1 + c2 + c3)[:, turning]
        jumps = np.diff(self.times) == 0.0  # pieces without a duration are points: no way is made in them
        c0[jumps], c1[jumps], c2[jumps], c3[jumps] = ends[jumps], 0.0, 0.0, 0.0
        return PiecewiseCubic(
            np.stack((c0, c0 + c1 / 3.0, ends - (c1 + 2.0 * c2 + 3.0 * c3) / 3.0, ends), axis=1)
        )

    def automatic_handles(self, rule: str = "parabolic") -> Floats:
        """Handles (n, 2, m) with which "bezier" would be the curve of another rule, for a first shape.

        ValueError for a rule that is none of RULES.
        """
        if rule not in RULES:
            raise ValueError(f"rule: expected one of {', '.join(RULES)}, not {rule!r}")
        known = {"angles": self.angles, "turn": self.turn, "loop": self.loop, "geometry": self.geometry}
        like = Keyframes(self.times, self.values, rule, **known)  # type: ignore[arg-type]
        handles = np.zeros((len(self.times), 2, self.values.shape[1]))
        if len(self.times) > 1:
            c1, c2, c3 = (like.coefficients[:-1, power] for power in (1, 2, 3))
            handles[:-1, 1] = c1 / 3.0
            handles[1:, 0] = -(c1 + 2.0 * c2 + 3.0 * c3) / 3.0
            handles[0, 0], handles[-1, 1] = -handles[0, 1], -handles[-1, 0]
        return handles

    def check(self) -> None:
        """ValueError if keys are not sorted, a coefficient is not finite, or a key is not met exactly."""
        if np.any(np.diff(self.times) < 0.0):
            raise ValueError("times are not sorted")
        if not np.isfinite(self.coefficients).all():
            raise ValueError("a coefficient is not finite")
        last = np.append(np.diff(self.times) > 0.0, True)
        if self.loop:
            last[-1] = False
        if not np.array_equal(self.sample(self.times[last]).reshape(-1), self.values[last].reshape(-1)):
            raise ValueError("a key is not met")

    def __len__(self) -> int:
        return len(self.times)


def _checked(name: str, numbers: ArrayLike, dimensions: int) -> Floats:
    """Numbers as a float64 array of their own; ValueError unless finite, in range and of that many axes."""
    array = np.array(numbers, dtype=np.float64)
    if array.ndim != dimensions:
        raise ValueError(f"{name}: expected an array of {dimensions} axes, not of shape {array.shape}")
    if not np.all(np.abs(array) <= LARGEST):  # also false for what is not a number
        raise ValueError(f"{name}: expected finite numbers up to {LARGEST:g}")
    return array + 0.0


def _columns(name: str, columns: Sequence[int], count: int) -> tuple[int, ...]:
    chosen = tuple(int(column) for column in columns)
    if any(not 0 <= column < count for column in chosen) or len(set(chosen)) != len(chosen):
        raise ValueError(f"{name}: expected different columns below {count}, not {chosen}")
    return chosen
