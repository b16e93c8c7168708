"""One cubic Bezier curve, several of them joined smoothly, and Catmull-Rom curves.

Bernstein weights; splitting by de Casteljau 1959. Catmull-Rom curves after Catmull and Rom 1974, with knots
as in Yuksel, Schaefer and Keyser 2011, "Parameterization and applications of Catmull-Rom curves": a knot
lies |P(i+1) - P(i)|^a after the one before, with a = 0 (uniform), 1/2 (centripetal) or 1 (chordal).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.animation.piecewise import PiecewiseCubic
from game.physics.animation.tangents import piece_slopes

KINDS = {"uniform": "catmull-rom", "centripetal": "centripetal", "chordal": "chordal"}


class CubicBezier(PiecewiseCubic):
    """One curve of four control points (4, d), parameter 0 to 1. ValueError for another number of points."""

    def __init__(self, points: ArrayLike) -> None:
        array = np.array(points, dtype=np.float64)
        if array.ndim != 2 or len(array) != 4:
            raise ValueError(f"a cubic Bezier curve has four control points, not {array.shape}")
        super().__init__(array[None])

    @property
    def points(self) -> Floats:
        """Its control points (4, d)."""
        return self.controls[0]

    def split(self, u: float) -> tuple[CubicBezier, CubicBezier]:
        """The curve up to u and from there on, as two; ValueError unless 0 <= u <= 1."""
        if not 0.0 <= u <= 1.0:
            raise ValueError(f"u = {u!r}: expected 0 to 1")
        rows = [self.points]
        while len(rows[-1]) > 1:
            rows.append((1.0 - u) * rows[-1][:-1] + u * rows[-1][1:])
        return CubicBezier([row[0] for row in rows]), CubicBezier([row[-1] for row in reversed(rows)])


class BezierPath(PiecewiseCubic):
    """Pieces through knots (n, d) with handles (n, 2, d): control points before and after, from the knot.

    A joint is C1 where the handles are opposite and equal; `smooth` makes them so. ValueError for fewer than
    two knots.
    """

    def __init__(self, knots: ArrayLike, handles: ArrayLike) -> None:
        places, offsets = np.array(knots, dtype=np.float64), np.array(handles, dtype=np.float64)
        if places.ndim != 2 or len(places) < 2:
            raise ValueError(f"knots: expected two points or more, not {places.shape}")
        if offsets.shape != (len(places), 2, places.shape[1]):
            raise ValueError(f"handles: expected two for each knot, not {offsets.shape}")
        inner = (places[:-1], places[:-1] + offsets[:-1, 1], places[1:] + offsets[1:, 0], places[1:])
        super().__init__(np.stack(inner, axis=1))
        self.knots, self.handles = places, offsets

    def smooth(self) -> BezierPath:
        """The same path with C1 joints: each pair of handles becomes half their difference, to both sides."""
        half = 0.5 * (self.handles[:, 1] - self.handles[:, 0])
        return BezierPath(self.knots, np.stack((-half, half), axis=1))


class CatmullRom(PiecewiseCubic):
    """A curve through points (n, d): "uniform", "centripetal" or "chordal"; closed: back to the first point.

    Each piece depends on four points only. The first and the last slope of an open curve are those of the
    parabola through three points. Points in the same place end a smooth run. ValueError for fewer than two
    points or another kind.
    """

    def __init__(self, points: ArrayLike, kind: str = "centripetal", closed: bool = False) -> None:
        places = np.array(points, dtype=np.float64)
        if places.ndim != 2 or len(places) < 2:
            raise ValueError(f"points: expected two or more, not {places.shape}")
        if kind not in KINDS:
            raise ValueError(f"kind: expected one of {', '.join(KINDS)}, not {kind!r}")
        if not np.isfinite(places).all():
            raise ValueError("points: expected finite numbers")
        if closed:
            places = np.concatenate((places, places[:1]))
        steps = np.diff(places, axis=0)
        begins, ends = piece_slopes(KINDS[kind], np.arange(float(len(places))), steps, closed)
        inner = (places[:-1], places[:-1] + begins / 3.0, places[1:] - ends / 3.0, places[1:])
        super().__init__(np.stack(inner, axis=1))
        self.kind, self.closed = kind, closed
