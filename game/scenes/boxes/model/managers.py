"""Which pair manager keeps the pairs of so many boxes."""

from __future__ import annotations

from game.physics.broadphase import HashedPairs, MatrixPairs, PairManager

MOST_IN_MATRIX = 4_096  # boxes; the matrix takes 32 MB there, and four times as much at twice as many


def matrix_for(rows: int) -> MatrixPairs | None:
    """An empty full matrix for so many ids and some more; None where it would be too large."""
    if rows > MOST_IN_MATRIX:
        return None
    return MatrixPairs(max(1 << max(rows - 1, 1).bit_length(), 256))


def manager_for(rows: int, kind: str) -> PairManager:
    """An empty pair manager for so many ids: of the kind "matrix" or "hash", if a matrix is possible."""
    matrix = matrix_for(rows) if kind == "matrix" else None
    return HashedPairs() if matrix is None else matrix
