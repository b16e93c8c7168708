"""Array expressions are rewritten as numba does it; kernels without any go without; no statement is kept."""

from __future__ import annotations

import gc
import weakref
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numba import config
from numba.core import ir

from game.compiler.decorator import inner_kernel, kernel, lean_kernel
from game.compiler.target import short_rewrites
from game.compiler.target.kept import dumps
from game.compiler.target.linking import kept_form

pytestmark = pytest.mark.skipif(bool(config.DISABLE_JIT), reason="nothing is compiled")


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """The answers of `may_be_rewritten`, in order."""
    answers: list[bool] = []
    plain = short_rewrites.may_be_rewritten

    def ask(code: Any, kinds: Any) -> bool:
        answers.append(plain(code, kinds))
        return answers[-1]

    monkeypatch.setattr(short_rewrites, "may_be_rewritten", ask)
    return answers


def _by_elements(a: Any, b: Any) -> None:
    for i in range(a.size):
        a[i] += 2.0 * b[i]


def _sum_of_arrays(a: Any, b: Any) -> Any:
    return a + 2.0 * b


def _opposite(a: Any, _b: Any) -> Any:
    return -a


def _root(a: Any, b: Any) -> Any:
    return np.sqrt(a * a + b * b)


def _constants(a: Any, b: Any) -> Any:
    return np.array([1.0, 2.0, 3.0])[0] * a[0] + b[0]


@pytest.mark.parametrize("function", [_sum_of_arrays, _opposite, _root, _constants])
def test_an_expression_of_arrays_is_looked_for(function: Callable[..., Any], asked: list[bool]) -> None:
    a, b = np.arange(3.0) + 0.5, np.full(3, 0.25)
    assert np.array_equal(kernel(function)(a, b), function(a, b))
    assert asked == [True]


def test_a_sum_of_arrays_is_one_loop(monkeypatch: pytest.MonkeyPatch) -> None:
    """numba's own rule makes one expression of two operators, and so no array between them."""
    found: list[bool] = []
    plain = short_rewrites.NopythonRewrites.run_pass

    def run(step: Any, state: Any) -> bool:
        done = plain(step, state)
        ops = [one.op for block in state.func_ir.blocks.values() for one in block.find_exprs()]
        found.append("arrayexpr" in ops and "binop" not in ops)
        return bool(done)

    monkeypatch.setattr(short_rewrites.NopythonRewrites, "run_pass", run)
    kernel(_sum_of_arrays)(np.ones(3), np.ones(3))
    assert found[0]  # what comes after it is the loop's own code, of numbers


def test_a_kernel_by_elements_goes_without(asked: list[bool]) -> None:
    a, b = np.arange(3.0), np.ones(3)
    lean_kernel(_by_elements)(a, b)
    assert a.tolist() == [2.0, 3.0, 4.0]
    assert asked == [False]


def test_a_rule_of_another_package_is_heeded(asked: list[bool], monkeypatch: pytest.MonkeyPatch) -> None:
    rules = short_rewrites.rewrite_registry.rewrites
    more = [*rules["after-inference"], type("Foreign", (rules["after-inference"][0],), {})]
    monkeypatch.setitem(rules, "after-inference", more)
    a = np.zeros(2)
    lean_kernel(_by_elements)(a, np.ones(2))
    assert a.tolist() == [2.0, 2.0]
    assert asked == [True]


def test_statements_of_compiled_kernels_are_let_go(monkeypatch: pytest.MonkeyPatch) -> None:
    """numba would keep them, with all their types, for as long as the kernel is there."""
    made: list[weakref.ref[Any]] = []
    begin = ir.FunctionIR.__init__

    def begun(code: Any, *args: Any, **kws: Any) -> None:
        begin(code, *args, **kws)
        made.append(weakref.ref(code))

    @inner_kernel
    def doubled(x):
        return 2.0 * x

    @kernel
    def outer(x):
        return doubled(x) + 1.0

    monkeypatch.setattr(ir.FunctionIR, "__init__", begun)
    assert outer(3.0) == 7.0
    gc.collect()
    assert len(made) >= 2
    assert [one for one in made if one() is not None] == []


def test_types_of_statements_are_not_written_down() -> None:
    @kernel
    def rather_plain(some_number):
        return some_number + 1.0

    rather_plain(1.0)
    (compiled,) = rather_plain.overloads.values()
    assert b"some_number = arg(" not in dumps(kept_form(compiled))
