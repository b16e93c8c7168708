"""With a numba that was not tried kernels are plain: no inner part of it is touched, and the numbers stay."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest
from numba import config

from game.compiler.tried import fits
from tests.paths import ROOT

PROBE = """
import json, sys
import numba
import numpy as np
{before}
from game.compiler.decorator import inner_kernel, kernel, lean_kernel
from game.compiler.entrances import Entrances
from game.compiler.progress import compiling
from game.physics.kernels import elementary, elementwise, linear
from game.physics.solids import SolidWorld

@inner_kernel
def low(x, k):
    return x[k] * elementary.cos(x[k]) + elementary.pow(x[k], 0.3)

@lean_kernel
def high(x):
    total = 0.0
    for k in range(len(x)):
        total += low(x, k) / 3.0
    return total

x = np.linspace(0.1, 7.0, 50)
values = [high(x), Entrances().call(high, x), float(elementwise.sin(x).sum()), elementary.atan2(0.3, -2.0)]
inside = sorted(name for name in sys.modules if name.startswith("game.compiler.target"))
print(json.dumps([[value.hex() for value in values], inside, type(high).__name__, compiling().done > 0]))
"""


@pytest.mark.parametrize(
    ("version", "answer"),
    [
        *(("0.68.0", True), ("0.68.1", True), ("0.67.0", False), ("0.69.0", False), ("1.68.0", False)),
        *(("0.68.0rc1", False), ("0.68.0.dev1", False), ("0.680.1", False), ("0", False), ("", False)),
    ],
)
def test_versions(version: str, answer: bool) -> None:
    assert fits(version) is answer


def probe(before: str = "", **environment: str) -> list[object]:
    done = subprocess.run(
        [sys.executable, "-c", PROBE.format(before=before)],
        cwd=ROOT,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    return list(json.loads(done.stdout))


@pytest.mark.skipif(bool(config.DISABLE_JIT), reason="nothing is compiled")
def test_plain_kernels_give_the_same_bits_and_reach_into_nothing() -> None:
    own = probe(CAROM_PLAIN_NUMBA="0")
    assert own[1] and own[2:] == ["KernelDispatcher", True]
    asked_for = probe(CAROM_PLAIN_NUMBA="1")
    untried = probe(before="numba.__version__ = '0.69.0'", CAROM_PLAIN_NUMBA="")
    assert asked_for == untried == [own[0], [], "CPUDispatcher", True]
