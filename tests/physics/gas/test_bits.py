"""What is computed in vector instructions has the bits of the plain functions beside it."""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from game.physics.gas import Gas, GasSettings
from game.physics.grid import Border, Borders, Grid
from tests.paths import ROOT
from tests.physics.grid.shapes import Disc

CASES = [
    (1, "time-centred"),
    (4, "cubic"),
    (5, "time-centred"),
    (7, "cubic"),
    (8, "time-centred"),
    (9, "cubic"),
]


def ends(fields: int, advection: str) -> str:
    """A digest of short and long steps with so many fields, in a box, a torus, a tunnel with a disc."""
    found = hashlib.sha256()
    tunnel = Borders(Border("inflow", (1.0, 0.0)), Border("open"))
    for borders, solid in ((Borders(), False), (Borders.all("periodic"), False), (tunnel, True)):
        names = (*(f"f{k}" for k in range(fields - 1)), "smoke")
        settings = replace(GasSettings(), advection=advection, smoke_weight=0.5, turns=2)
        gas = Gas(Grid(9, 6, 1.0 / 6), borders, settings, names)
        rng = np.random.default_rng(fields)
        gas.u[:], gas.v[:] = rng.normal(0.0, 1.0, gas.u.shape), rng.normal(0.0, 1.0, gas.v.shape)
        gas.scalars[:] = rng.random(gas.scalars.shape)
        if solid:
            gas.set_solids(Disc((0.7, 0.5), 0.22))
        for dt in (0.03, 0.03, 0.4):
            gas.step(dt)
        gas.u[2, 3] = 1e9  # a way that is none
        gas.step(0.03)
        for array in (gas.u, gas.v, gas.pressure, gas.scalars):
            found.update(np.ascontiguousarray(array + 0.0).tobytes())
    return found.hexdigest()


def test_the_bits_are_those_of_plain_functions():
    code = "from tests.physics.gas.test_bits import *\nprint(*(ends(*case) for case in CASES))"
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1", "PYTHONPATH": str(ROOT)}
    run = subprocess.run(
        [sys.executable, "-c", code], env=environment, cwd=ROOT, capture_output=True, text=True, check=True
    )
    plain = run.stdout.split()
    assert len(set(plain)) == len(CASES)
    assert [ends(*case) for case in CASES] == plain


@pytest.mark.parametrize(("fields", "other"), [(5, 4), (8, 3), (9, 1)])
def test_a_field_is_carried_alike_whatever_goes_with_it(fields, other):
    """Eight at once, four at once or one by one."""
    found = []
    for count in (fields, other):
        gas = Gas(Grid(12, 10, 0.1), fields=tuple(f"f{k}" for k in range(count)))
        rng = np.random.default_rng(1)
        gas.u[:, 1:-1], gas.v[1:-1] = rng.normal(0.0, 1.0, (10, 11)), rng.normal(0.0, 1.0, (9, 12))
        lumps = rng.random((10, 12))
        for k in range(count):
            gas.scalars[..., k] = lumps * (1.0 if k == 0 else k + 1.5)
        for _ in range(4):
            gas.step(0.05)
        found.append(gas.scalars[..., 0].copy())
        for k in range(1, count):
            assert np.allclose(gas.scalars[..., k], (k + 1.5) * found[-1], rtol=1e-12, atol=0.0)
    assert np.array_equal(*found)
