"""Open parts of faces and cells from signed distances of a solid.

Each face is sampled at both corners and in its middle; on either half the distance runs linearly. So walls
and gaps of one cell are kept, wherever they lie on the grid. Two corners alone would not see a wall between
them.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel, kernel

NOTHING = 1e-9  # of a cell: a distance that counts as 0


@inner_kernel
def _half(a, b):
    """Open part of a half face between distances a and b; 0 counts as open beside what is open."""
    if a <= 0.0 and b <= 0.0:
        return 0.0
    if a >= 0.0 and b >= 0.0:
        return 1.0
    return max(a, b) / (max(a, b) - min(a, b))


@inner_kernel
def _face(a, middle, b, one, other):
    """Open part of a face: corners a, b, middle, and the centres at both sides of it.

    A face that lies in the surface is closed if one of its cells is solid. Open, closed, open: a wall crosses
    the face, and nothing passes between its two sides.
    """
    if a == 0.0 and middle == 0.0 and b == 0.0:
        return 0.0 if min(one, other) < 0.0 else 1.0
    if a > 0.0 and b > 0.0 and middle < 0.0:
        return 0.0
    return 0.5 * (_half(a, middle) + _half(middle, b))


@inner_kernel
def _tidy(d, h):
    return 0.0 if abs(d) < NOTHING * h else d


@kernel
def open_faces(nodes, mid_x, mid_y, centres, h, ax, ay):
    """Write ax (ny, nx + 1) and ay (ny + 1, nx) from distances, m. They are given at nodes (ny + 1, nx + 1),
    in the middle of faces (as ax, ay) and at centres (ny, nx).
    """
    ny, nx = centres.shape
    for j in range(ny):
        for i in range(nx + 1):
            one, other = centres[j, max(i - 1, 0)], centres[j, min(i, nx - 1)]
            ax[j, i] = _face(
                _tidy(nodes[j, i], h), _tidy(mid_x[j, i], h), _tidy(nodes[j + 1, i], h), _tidy(one, h),
                _tidy(other, h),
            )  # fmt: skip
    for j in range(ny + 1):
        for i in range(nx):
            one, other = centres[max(j - 1, 0), i], centres[min(j, ny - 1), i]
            ay[j, i] = _face(
                _tidy(nodes[j, i], h), _tidy(mid_y[j, i], h), _tidy(nodes[j, i + 1], h), _tidy(one, h),
                _tidy(other, h),
            )  # fmt: skip


@kernel
def close_thin_cells(nodes, centres, ax, ay):
    """A wall that leaves two opposite corners of a cell open keeps them apart: such cells are closed."""
    ny, nx = centres.shape
    for j in range(ny):
        for i in range(nx):
            a, b = nodes[j, i] > 0.0, nodes[j, i + 1] > 0.0
            c, d = nodes[j + 1, i] > 0.0, nodes[j + 1, i + 1] > 0.0
            if centres[j, i] < 0.0 and ((a and d and not b and not c) or (b and c and not a and not d)):
                ax[j, i], ax[j, i + 1], ay[j, i], ay[j + 1, i] = 0.0, 0.0, 0.0, 0.0


@kernel
def open_cells(nodes, centres, volume):
    """Open part of each cell (ny, nx): the mean of its four quarters' halves, by corners and centre."""
    ny, nx = centres.shape
    for j in range(ny):
        for i in range(nx):
            c, total = centres[j, i], 0.0
            for k in range(4):
                d = nodes[j + k // 2, i + k % 2]
                total += _half(d, c)
            volume[j, i] = 0.25 * total


@kernel
def clearance(ax, ay, clear):
    """clear (ny, nx): how many cells to the nearest that is not all open, counted as a king moves."""
    ny, nx = clear.shape
    far = float(ny + nx)
    for j in range(ny):
        for i in range(nx):
            whole = min(min(ax[j, i], ax[j, i + 1]), min(ay[j, i], ay[j + 1, i])) >= 1.0
            clear[j, i] = far if whole else 0.0
    for j in range(ny):
        for i in range(nx):
            least = clear[j, i]
            if i > 0:
                least = min(least, clear[j, i - 1] + 1.0)
            if j > 0:
                least = min(least, clear[j - 1, i] + 1.0)
                if i > 0:
                    least = min(least, clear[j - 1, i - 1] + 1.0)
                if i < nx - 1:
                    least = min(least, clear[j - 1, i + 1] + 1.0)
            clear[j, i] = least
    for j in range(ny - 1, -1, -1):
        for i in range(nx - 1, -1, -1):
            least = clear[j, i]
            if i < nx - 1:
                least = min(least, clear[j, i + 1] + 1.0)
            if j < ny - 1:
                least = min(least, clear[j + 1, i] + 1.0)
                if i > 0:
                    least = min(least, clear[j + 1, i - 1] + 1.0)
                if i < nx - 1:
                    least = min(least, clear[j + 1, i + 1] + 1.0)
            clear[j, i] = least


@kernel
def layers(part, most, layer):
    """layer (as part): 0 for open faces, then 1, 2 ... most by how far a closed one is from them."""
    rows, columns = part.shape
    for j in range(rows):
        for i in range(columns):
            layer[j, i] = 0 if part[j, i] > 0.0 else most + 1
    for depth in range(1, most + 1):
        for j in range(rows):
            for i in range(columns):
                if layer[j, i] <= depth:
                    continue
                near = i > 0 and layer[j, i - 1] == depth - 1
                near = near or (i < columns - 1 and layer[j, i + 1] == depth - 1)
                near = near or (j > 0 and layer[j - 1, i] == depth - 1)
                near = near or (j < rows - 1 and layer[j + 1, i] == depth - 1)
                if near:
                    layer[j, i] = depth
