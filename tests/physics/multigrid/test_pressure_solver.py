"""The pressure equation against scipy's direct solution, and how fast each turn of the solvers is."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import spsolve

from game.physics.grid.borders import INFLOW, NO_SLIP, OPEN, PERIODIC, WALL
from game.physics.multigrid import SOLVERS, PressureSolver

BOX, TUNNEL, TORUS = (WALL, NO_SLIP, WALL, WALL), (INFLOW, OPEN, WALL, OPEN), (PERIODIC,) * 4


def parts(nx, ny, seed=None):
    """Open parts of faces: all open, or with some solids."""
    ax, ay = np.ones((ny, nx + 1)), np.ones((ny + 1, nx))
    if seed is not None:
        rng = np.random.default_rng(seed)
        for _ in range(max(2, nx * ny // 900)):
            i, j = rng.integers(1, nx - 3), rng.integers(1, ny - 3)
            w, h = rng.integers(1, max(2, nx // 6)), rng.integers(1, max(2, ny // 6))
            ax[j : j + h, i : i + w + 1] = 0.0
            ay[j : j + h + 1, i : i + w] = 0.0
        ax *= np.where(rng.random(ax.shape) < 0.1, rng.random(ax.shape), 1.0)
    return ax, ay


def matrix(solver):
    """The sparse matrix of the solver's equation, row by row of cells."""
    e = solver.equation
    ny, nx = e.b.shape
    rows, columns, values = [], [], []
    for j in range(ny):
        for i in range(nx):
            for c, m, n in (
                (e.cx[j, i], j, i - 1), (e.cx[j, i + 1], j, i + 1),
                (e.cy[j, i], j - 1, i), (e.cy[j + 1, i], j + 1, i),
            ):  # fmt: skip
                rows.append(j * nx + i)
                columns.append(j * nx + i)
                values.append(c)
                if e.joined[0]:
                    n %= nx
                if e.joined[1]:
                    m %= ny
                if 0 <= m < ny and 0 <= n < nx:
                    rows.append(j * nx + i)
                    columns.append(m * nx + n)
                    values.append(-c)
    return coo_matrix((values, (rows, columns)), shape=(nx * ny, nx * ny)).tocsr()


def exact(solver, b):
    """scipy's solution: in each closed region the mean of b taken out, that of p made 0."""
    e = solver.equation
    a, right = matrix(solver).tolil(), b.ravel().copy()
    labels = e.labels.ravel()
    for k in range(solver.regions):
        cells = np.flatnonzero(labels == k)
        if not e.fixed[k]:
            right[cells] -= right[cells].mean()
            a[cells[0]] = 0.0
            a[cells[0], cells[0]] = 1.0
            right[cells[0]] = 0.0
    for cell in np.flatnonzero(labels < 0):
        a[cell, cell] = 1.0
        right[cell] = 0.0
    p = spsolve(a.tocsc(), right)
    for k in range(solver.regions):
        if not e.fixed[k]:
            p[labels == k] -= p[labels == k].mean()
    return p.reshape(b.shape)


def solved(solver, b, method="multigrid", turns=1, goal=0.0):
    solver.equation.p[:] = 0.0
    solver.equation.b[:] = b
    return solver.solve(method, turns, goal)


@pytest.mark.parametrize("kinds", [BOX, TUNNEL, TORUS])
@pytest.mark.parametrize(
    ("nx", "ny", "seed"), [(16, 16, None), (13, 17, 1), (32, 7, 2), (4, 4, None), (5, 23, None)]
)
def test_every_solver_finds_what_scipy_finds(kinds, nx, ny, seed):
    solver = PressureSolver(nx, ny, np.array(kinds))
    solver.set_faces(*parts(nx, ny, seed))
    b = np.random.default_rng(7).standard_normal((ny, nx))
    want = exact(solver, b)
    for method in SOLVERS:
        turns = {"multigrid": 40, "v-cycles": 60, "conjugate-gradients": 400}.get(method, 20_000)
        found = solved(solver, b, method, turns, 1e-11)
        assert found.after <= 1e-11, method
        assert np.max(np.abs(solver.pressure - want)) < 1e-8 * np.max(np.abs(want)), method


@pytest.mark.parametrize("kinds", [BOX, TUNNEL, TORUS])
@pytest.mark.parametrize(("nx", "ny", "least"), [(128, 64, 20.0), (127, 61, 12.0), (64, 64, 20.0)])
def test_a_turn_of_multigrid_cuts_the_residual_in_boxes(kinds, nx, ny, least):
    solver = PressureSolver(nx, ny, np.array(kinds))
    b = np.random.default_rng(3).standard_normal((ny, nx))
    one, six = solved(solver, b, turns=1), solved(solver, b, turns=6)
    assert six.turns == 6 and (one.before / six.after) ** (1.0 / 6.0) > least


def test_solids_leave_a_turn_a_factor_of_ten():
    nx, ny = 128, 64
    solver = PressureSolver(nx, ny, np.array(TUNNEL))
    x, y = np.meshgrid(np.arange(nx + 1), np.arange(ny + 1))
    d = np.hypot(x - 0.4 * nx, y - 0.5 * ny) - 0.17 * ny

    def part(a, b):
        return np.where(
            np.minimum(a, b) >= 0, 1.0, np.clip(np.maximum(a, b), 0, None) / (np.abs(a - b) + 1e-300)
        )

    ax = np.where(np.maximum(d[:-1], d[1:]) < 0, 0.0, part(d[:-1], d[1:]))
    ay = np.where(np.maximum(d[:, :-1], d[:, 1:]) < 0, 0.0, part(d[:, :-1], d[:, 1:]))
    b = np.random.default_rng(3).standard_normal((ny, nx))
    for faces in ((np.clip(ax, 0, 1), np.clip(ay, 0, 1)), parts(nx, ny, 5)):
        solver.set_faces(*faces)
        found = solved(solver, b, turns=6)
        assert (found.before / found.after) ** (1.0 / 6.0) > 10.0


@pytest.mark.parametrize(("nx", "ny"), [(4, 4096), (4096, 4), (64, 5), (7, 448), (97, 89), (6, 6)])
def test_any_size_converges(nx, ny):
    for kinds in (BOX, TUNNEL):
        solver = PressureSolver(nx, ny, np.array(kinds))
        b = np.random.default_rng(1).standard_normal((ny, nx))
        found = solved(solver, b, turns=8)
        assert found.after < 1e-6 * found.before


def test_each_closed_region_keeps_its_own_balance():
    """A sealed pocket beside a room, and one that an open side fixes."""
    ax, ay = parts(24, 16)
    ax[:, 8] = ax[:, 16] = 0.0
    solver = PressureSolver(24, 16, np.array((WALL, OPEN, WALL, WALL)))
    solver.set_faces(ax, ay)
    assert solver.regions == 3
    b = np.ones((16, 24))
    b[:, :8] = 3.0
    found = solved(solver, b, turns=30, goal=1e-12)
    assert sorted(solver.removed.tolist()) == [0.0, 1.0, 3.0]
    assert found.after <= 1e-12
    assert np.max(np.abs(solver.pressure[:, :16])) < 1e-12 and np.min(solver.pressure[:, 16:]) > 0.0


def test_a_corridor_of_one_cell_and_walls_without_thickness_converge():
    ax, ay = parts(64, 32)
    ax[:24, 33] = 0.0
    ax[8:, 34] = 0.0
    solver = PressureSolver(64, 32, np.array(BOX))
    solver.set_faces(ax, ay)
    found = solved(solver, np.random.default_rng(2).standard_normal((32, 64)), turns=40, goal=1e-9)
    assert solver.regions == 1 and found.after <= 1e-9


def test_all_closed_and_one_cell_left_are_no_trouble():
    solver = PressureSolver(8, 8, np.array(TUNNEL))
    for left in (0, 1):
        ax, ay = np.zeros((8, 9)), np.zeros((9, 8))
        ax[3, 3 : 3 + left] = 1.0
        solver.set_faces(ax, ay)
        for method in SOLVERS:
            found = solved(solver, np.ones((8, 8)), method, 5)
            assert np.isfinite(found.after) and np.all(np.isfinite(solver.pressure))
    assert solver.regions == 1


def test_gauss_seidel_leaves_of_the_smoothest_error_what_theory_says():
    """cos²(pi / n) a sweep, with pressure 0 around (Young 1954): 20 sweeps leave 95 % on 64 cells."""
    n = 64
    solver = PressureSolver(n, n, np.array((OPEN,) * 4))
    x = np.sin(np.pi * np.arange(1, n) / n)
    e = solver.equation
    solver.set_faces(*parts(n, n))
    # 63 unknowns between walls of value 0 lie at n cells' distance: the outermost row and column are closed
    ax, ay = np.zeros((n, n + 1)), np.zeros((n + 1, n))
    e.cx[:], e.cy[:] = ax, ay
    e.cx[: n - 1, :n], e.cy[:n, : n - 1] = 1.0, 1.0
    e.inverse[:] = 0.0
    e.inverse[: n - 1, : n - 1] = 0.25
    e.b[:] = 0.0
    e.p[:] = 0.0
    e.p[1:n, 1:n] = np.outer(x, x)
    from game.physics.multigrid.gauss_seidel import solve_sweeps

    solve_sweeps(e, 200, 0.0)  # the asymptotic shape first
    before = np.abs(e.p).max()
    solve_sweeps(e, 20, 0.0)
    assert np.abs(e.p).max() / before == pytest.approx(0.9529328937190433, rel=1e-3)


def test_nonsense_is_refused():
    solver = PressureSolver(8, 8, np.array(BOX))
    for arguments, named in (
        (("sor",), "method"),
        (("jacobi", -1), "turns"),
        (("jacobi", 1, np.nan), "goal"),
    ):
        with pytest.raises(ValueError, match=named):
            solver.solve(*arguments)
