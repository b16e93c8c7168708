"""Products of matrices, linear systems, eigenvectors and draws by plain sums in a fixed order.

numpy hands these to a BLAS that picks other code for each processor, with fused multiply-adds and sums in
another order. So two machines come to other bits. Meant for the few and small matrices of Python code;
kernels write their sums out.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.compiler.decorator import kernel

SWEEPS = 60  # of Jacobi's method, which needs some ten


@kernel
def multiply(a: np.ndarray, b: np.ndarray, product: np.ndarray) -> None:
    """product (n, k) = a (n, m) times b (m, k)."""
    for i in range(a.shape[0]):
        for j in range(b.shape[1]):
            product[i, j] = 0.0
        for k in range(a.shape[1]):
            for j in range(b.shape[1]):
                product[i, j] += a[i, k] * b[k, j]


@kernel
def eliminate(a: np.ndarray, b: np.ndarray) -> float:
    """Turn b (n, m) into the solution of a x = b (a (n, n) is used up); the determinant, 0 if there is none.

    Gauss's elimination, each time with the largest element of the column.
    """
    n = a.shape[0]
    determinant = 1.0
    for column in range(n):
        best = column
        for row in range(column + 1, n):
            if abs(a[row, column]) > abs(a[best, column]):
                best = row
        if best != column:
            determinant = -determinant
            for j in range(n):
                a[column, j], a[best, j] = a[best, j], a[column, j]
            for j in range(b.shape[1]):
                b[column, j], b[best, j] = b[best, j], b[column, j]
        pivot = a[column, column]
        determinant *= pivot
        if pivot == 0.0:
            return 0.0
        for row in range(column + 1, n):
            share = a[row, column] / pivot
            for j in range(column + 1, n):
                a[row, j] -= share * a[column, j]
            for j in range(b.shape[1]):
                b[row, j] -= share * b[column, j]
    for column in range(n - 1, -1, -1):
        for j in range(b.shape[1]):
            b[column, j] /= a[column, column]
            for row in range(column):
                b[row, j] -= a[row, column] * b[column, j]
    return determinant


@kernel
def rotate_away(a: np.ndarray, axes: np.ndarray) -> None:
    """Make a symmetric (n, n) diagonal by C. G. J. Jacobi's rotations (1846); axes (n, n) turn with it."""
    n = a.shape[0]
    for _ in range(SWEEPS):
        left = 0.0
        for p in range(n):
            for q in range(p + 1, n):
                left += abs(a[p, q])
        if left == 0.0:
            return
        for p in range(n):
            for q in range(p + 1, n):
                if abs(a[p, q]) <= 1e-18 * np.sqrt(abs(a[p, p] * a[q, q])):
                    a[p, q] = 0.0
                    continue
                slope = 0.5 * (a[q, q] - a[p, p]) / a[p, q]
                t = 1.0 / (abs(slope) + np.sqrt(slope * slope + 1.0))
                t = t if slope >= 0.0 else -t
                c = 1.0 / np.sqrt(t * t + 1.0)
                s = t * c
                a[p, p] -= t * a[p, q]
                a[q, q] += t * a[p, q]
                a[p, q] = 0.0
                for k in range(n):
                    if k not in (p, q):
                        i, j = min(k, p), max(k, p)
                        u, v = min(k, q), max(k, q)
                        one, other = a[i, j], a[u, v]
                        a[i, j], a[u, v] = c * one - s * other, s * one + c * other
                    one, other = axes[k, p], axes[k, q]
                    axes[k, p], axes[k, q] = c * one - s * other, s * one + c * other


def product(a: ArrayLike, b: ArrayLike) -> Any:
    """a @ b of one or two dimensions each, of a stack (..., n, m) with one matrix or vector, or of two stacks
    (k, n, m) and (k, m, l), matrix by matrix.

    A numpy float for two vectors. ValueError if the shapes do not fit.
    """
    left, right = np.asarray(a, dtype=np.float64), np.asarray(b, dtype=np.float64)
    if left.ndim == right.ndim == 3 and len(left) == len(right) and left.shape[2] == right.shape[1]:
        found = np.empty((len(left), left.shape[1], right.shape[2]))
        left, right = np.ascontiguousarray(left), np.ascontiguousarray(right)
        for one, other, made in zip(left, right, found, strict=True):
            multiply(one, other, made)
        return found
    if right.ndim > 2 or left.shape[-1] != right.shape[0]:
        raise ValueError(f"product: shapes {left.shape} and {right.shape} do not fit")
    rows = np.ascontiguousarray(left.reshape(math.prod(left.shape[:-1]), left.shape[-1]))
    columns = np.ascontiguousarray(right.reshape(len(right), math.prod(right.shape[1:])))
    found = np.empty((rows.shape[0], columns.shape[1]))
    multiply(rows, columns, found)
    return found.reshape(left.shape[:-1] + right.shape[1:])[()]


def solve(a: ArrayLike, b: ArrayLike) -> NDArray[np.float64]:
    """x of a x = b, a (n, n), b (n,) or (n, m). LinAlgError if a is singular."""
    matrix, given = np.array(a, dtype=np.float64, order="C"), np.asarray(b, dtype=np.float64)
    found = np.array(given.reshape(len(given), math.prod(given.shape[1:])), order="C")
    if eliminate(matrix, found) == 0.0 and len(matrix):
        raise np.linalg.LinAlgError("the matrix is singular")
    return found.reshape(given.shape)


def inverse(a: ArrayLike) -> NDArray[np.float64]:
    """The inverse of a (n, n). LinAlgError if it is singular."""
    matrix = np.asarray(a, dtype=np.float64)
    return solve(matrix, np.eye(len(matrix)))


def determinant(a: ArrayLike) -> float:
    """The determinant of a (n, n)."""
    matrix = np.array(a, dtype=np.float64, order="C")
    return float(eliminate(matrix, np.zeros((len(matrix), 0))))


def eigenvectors(a: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Eigenvalues (n,), rising, and eigenvectors (n, n) in columns, of a symmetric matrix."""
    matrix = np.array(a, dtype=np.float64, order="C")
    axes = np.eye(len(matrix))
    rotate_away(matrix, axes)
    values = np.diagonal(matrix).copy()
    order = np.argsort(values, kind="stable")
    return values[order], np.ascontiguousarray(axes[:, order])


def interpolated(x: ArrayLike, places: ArrayLike, values: ArrayLike) -> NDArray[np.float64]:
    """Values at x on the lines between the points (places, values), the outermost beyond them."""
    at, y = np.asarray(places, dtype=np.float64), np.asarray(values, dtype=np.float64)
    given = np.clip(np.asarray(x, dtype=np.float64), at[0], at[-1])
    i = np.clip(np.searchsorted(at, given, side="right") - 1, 0, max(len(at) - 2, 0))
    after = np.minimum(i + 1, len(at) - 1)
    width = at[after] - at[i]
    share = np.where(width > 0.0, (given - at[i]) / np.where(width > 0.0, width, 1.0), 0.0)
    return np.asarray(y[i] + (y[after] - y[i]) * share)


def uniform(random: np.random.Generator, low: Any = 0.0, high: Any = 1.0, size: Any = None) -> Any:
    """`random.uniform`, whose sum a compiler may fuse."""
    if size is None and (np.ndim(low) or np.ndim(high)):
        size = np.broadcast_shapes(np.shape(low), np.shape(high))
        low, high = np.asarray(low, dtype=np.float64), np.asarray(high, dtype=np.float64)
    return low + (high - low) * random.random(size)
