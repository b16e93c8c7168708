"""Inner kernels are linked into who calls them; numba's answers about numbers are remembered, and right."""

from __future__ import annotations

import os
import subprocess
import sys

import numpy as np
import pytest
from numba import config, njit, types
from numba.core.types.functions import BaseFunction

from game.physics.kernels.lean import inner_kernel, lean_kernel
from game.physics.kernels.linking import InnerLibrary

pytestmark = pytest.mark.skipif(bool(config.DISABLE_JIT), reason="nothing is compiled")


@inner_kernel
def deepest(x):
    return x * 3.0


@inner_kernel
def deep(x):
    return deepest(x) + 1.0


@inner_kernel
def beside(x):
    return deepest(x) - deep(x)


@lean_kernel
def top(x):
    return deep(x) + 10.0 * beside(x)


@lean_kernel
def above(x):
    return top(x) + deepest(x)


def test_what_is_called_from_several_depths_is_linked_once():
    assert top(2.0) == 7.0 - 10.0
    assert above(2.0) == 3.0


def test_an_inner_kernel_has_no_machine_code():
    top(1.0)
    library = deep.overloads[(types.float64,)].library
    assert isinstance(library, InnerLibrary)
    assert library.get_pointer_to_function(deep.overloads[(types.float64,)].fndesc.llvm_func_name) == 0


def test_code_that_is_not_ours_calls_a_kernel():
    @njit
    def outside(x):
        return top(x) + 1.0

    assert outside(2.0) == -2.0


@njit
def mixed(a, b, m):
    return a + b, a * m, m + m, a // b, a / b, a > m, -m, a**b, max(a, b), max(m, m)


def test_numbers_of_all_kinds_have_the_types_that_numba_gives_them():
    cases = [(np.int32(7), np.int64(2), 1.5), (7, 2, np.float32(1.5)), (np.uint8(7), True, 2), (7.0, 2, True)]
    for _ in range(2):
        for case in cases:
            assert mixed(*case) == mixed.py_func(*case)


def test_what_is_written_in_python_is_asked_for_anew(monkeypatch):
    """numba compiles such a function with the options of who calls it: no answer of another caller's."""
    from game.physics.kernels import operators

    told = []

    class Written:
        typing_key = "written"
        _impl_keys = {(): "code"}

    class Found:
        args = ()

    monkeypatch.setattr(operators, "_ask", lambda *_: told.append(1) or Found)
    for _ in range(2):
        assert BaseFunction.get_call_type(Written(), "context", (types.float64,), {}) is Found
    assert len(told) == 2


USER = """
import sys
from game.physics.kernels.jit import compiling
from game.physics.solids import SolidWorld, box
world = SolidWorld()
world.add_body(box(1.0, 1.0), (0.0, 0.0), velocity=(1.0, 0.0))
world.add_body(box(1.0, 1.0), (3.0, 0.0))
for _ in range(60):
    world.step(1.0 / 60.0)
print(world.bodies.positions.tobytes().hex(), compiling().done)
"""


def test_kept_inner_code_is_as_good_as_new():
    """A second process compiles nothing, and computes the same."""

    def run() -> list[str]:
        done = subprocess.run(
            [sys.executable, "-c", USER], env=dict(os.environ), capture_output=True, text=True
        )
        assert done.returncode == 0, done.stderr
        return done.stdout.split()

    first, second = run(), run()
    assert first[0] == second[0]
    assert second[1] == "0"
