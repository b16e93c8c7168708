"""A curve of cubic Bezier pieces: points, tangents, directions, length, lines to draw it by."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.animation.arc_length import ArcLength, polygon_length
from game.physics.animation.flattening import even_parameters, flatten_adaptively

LARGEST = 1e100  # of a control point: squares stay finite
VANISHING = 1e-12  # of the control polygon: a derivative up to this is rounding


@kernel(_nrt=False)
def write_directions(controls, pieces, parameters, out):
    """Write unit vectors out (k, d) along ``pieces`` (k,) of controls (n, 4, d) at u = ``parameters`` (k,).

    The first derivative that is more than rounding says where the curve goes.
    """
    for k in range(pieces.shape[0]):
        i, u = pieces[k], parameters[k]
        v = 1.0 - u
        back = -1.0 if v == 0.0 else 1.0  # at the end one looks back
        least = VANISHING * polygon_length(controls, i)
        size = 0.0
        for order in range(3):
            square = 0.0
            for j in range(controls.shape[2]):
                a = controls[i, 1, j] - controls[i, 0, j]
                b = controls[i, 2, j] - controls[i, 1, j]
                c = controls[i, 3, j] - controls[i, 2, j]
                if order == 0:
                    way = v * v * a + 2.0 * u * v * b + u * u * c
                elif order == 1:
                    way = back * (v * (b - a) + u * (c - b))
                else:
                    way = a - 2.0 * b + c
                out[k, j] = way
                square += way * way
            size = math.sqrt(square)
            if size > least:
                break
        for j in range(controls.shape[2]):
            out[k, j] = out[k, j] / size if size > least else 0.0


class PiecewiseCubic:
    """Pieces with control points (n, 4, d), one after the other; piece i has the parameters i to i + 1.

    Parameters may be given as one number or as an array; below 0 and above n they mean the ends. At the end
    of a piece the point is exactly its control point. ValueError for what is no such array of finite numbers
    up to 1e100, and for parameters that are not finite.
    """

    def __init__(self, controls: ArrayLike) -> None:
        array = np.array(controls, dtype=np.float64)
        if array.ndim != 3 or array.shape[1] != 4 or 0 in array.shape:
            raise ValueError(f"control points: expected shape (pieces, 4, d), not {array.shape}")
        if not np.all(np.abs(array) <= LARGEST):
            raise ValueError(f"control points: expected finite numbers up to {LARGEST:g}")
        self.controls = array + 0.0

    @property
    def pieces(self) -> int:
        """How many there are."""
        return len(self.controls)

    def point(self, parameters: ArrayLike) -> Floats:
        """Points (..., d) at parameters (...,)."""
        piece, u, v = self._places(parameters)
        p = self.controls[piece]
        u, v = u[..., None], v[..., None]
        weights = (v * v * v, 3.0 * u * v * v, 3.0 * u * u * v, u * u * u)
        return sum((w * p[..., k, :] for k, w in enumerate(weights)), np.zeros(()))

    def tangent(self, parameters: ArrayLike) -> Floats:
        """Derivatives (..., d) by the parameter; at a joint those of the piece that begins there."""
        piece, u, v = self._places(parameters)
        q = 3.0 * np.diff(self.controls, axis=1)[piece]
        u, v = u[..., None], v[..., None]
        return v * v * q[..., 0, :] + 2.0 * u * v * q[..., 1, :] + u * u * q[..., 2, :]

    def direction(self, parameters: ArrayLike) -> Floats:
        """Unit vectors (..., d) the way the curve goes on, also where its derivative vanishes.

        Where control points coincide or the curve has a cusp, the next derivative that is not zero says where
        it goes. At the very end of a piece it says where the curve came from. A piece that is a point has
        none: zeros.
        """
        piece, u, _ = self._places(parameters)
        out = np.empty((piece.size, self.controls.shape[2]))
        write_directions(self.controls, piece.reshape(-1), u.reshape(-1), out)
        return out.reshape(*piece.shape, -1)

    # -- length -------------------------------------------------------------------------------------

    @cached_property
    def arc(self) -> ArcLength:
        """Lengths along the curve."""
        return ArcLength(self.controls)

    @property
    def length(self) -> float:
        """Length of the whole curve."""
        return self.arc.total

    def length_to(self, parameters: ArrayLike) -> Floats:
        """Length (...,) from the beginning to parameters (...,), in the unit of the controls."""
        return self.arc.to(parameters)

    def parameter_at(self, lengths: ArrayLike) -> Floats:
        """Parameters (...,) at lengths (...,) from the beginning."""
        return self.arc.parameter(lengths)

    # -- lines --------------------------------------------------------------------------------------

    def flatten(self, tolerance: float, how: Literal["adaptive", "even"] = "adaptive") -> Floats:
        """Points (k, d) of a chain of lines that is nowhere farther than ``tolerance`` from the curve.

        Adaptively halved, or in Wang's number of even parts; never more than 65 536 lines a piece. Between
        pieces that do not meet there is a line as well. ValueError unless tolerance > 0.
        """
        if not (np.isfinite(tolerance) and tolerance > 0.0):
            raise ValueError(f"tolerance = {tolerance!r}: expected a positive number")
        if how == "even":
            return self.point(even_parameters(self.controls, tolerance))
        return flatten_adaptively(self.controls, tolerance)[0]

    def joint_gaps(self) -> Floats:
        """How far (n - 1, 2) the inner joints are from C0 and C1: gaps of points and of derivatives."""
        left, right = self.controls[:-1], self.controls[1:]
        gap = right[:, 0] - left[:, 3]
        bend = 3.0 * ((right[:, 1] - right[:, 0]) - (left[:, 3] - left[:, 2]))
        return np.sqrt(np.stack(((gap * gap).sum(axis=1), (bend * bend).sum(axis=1)), axis=1))

    def check(self) -> None:
        """ValueError if the length does not lie between chords and control polygons."""
        way = np.diff(self.controls, axis=1)
        polygon = float(np.sqrt((way * way).sum(axis=2)).sum())
        chord = self.controls[:, 3] - self.controls[:, 0]
        least = float(np.sqrt((chord * chord).sum(axis=1)).sum())
        if not least - 1e-12 * polygon <= self.length <= polygon * (1.0 + 1e-12):
            raise ValueError(f"length {self.length!r} is not between {least!r} and {polygon!r}")

    def _places(self, parameters: ArrayLike) -> tuple[NDArray[np.int64], Floats, Floats]:
        """Piece, u and 1 - u of each parameter; the end of the curve is that of its last piece."""
        at = np.asarray(parameters, dtype=np.float64)
        if not np.isfinite(at).all():
            raise ValueError("parameters: expected finite numbers")
        at = np.clip(at, 0.0, float(self.pieces))
        piece = np.minimum(at.astype(np.int64), self.pieces - 1)
        u = at - piece
        return piece, u, 1.0 - u
