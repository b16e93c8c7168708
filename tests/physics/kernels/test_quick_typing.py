"""numba's answers, remembered: the same types, flags and variables as without."""

from __future__ import annotations

import operator
import subprocess
import sys
from typing import Any

import llvmlite.binding as llvm
import numba
import numpy as np
import pytest
from numba import types
from numba.core import event, ir, postproc, utils
from numba.core.compiler import Flags, run_frontend
from numba.core.errors import TypingError
from numba.core.imputils import builtin_registry
from numba.core.registry import cpu_target

import game.physics.kernels.jit  # noqa: F401  (takes the short cuts)
from game.physics.kernels import quick_typing

PLAIN = (types.int32, types.int64, types.uint8, types.float32, types.float64, types.boolean, types.literal(3))
OPERATORS = (operator.add, operator.mul, operator.truediv, operator.floordiv, operator.lt, operator.and_)


def answers() -> list[str]:
    """What numba says that each operator gives on each two kinds of plain numbers."""
    context = cpu_target.typing_context
    context.refresh()
    said = []
    for asked in OPERATORS:
        for left in PLAIN:
            for right in PLAIN:
                try:
                    said.append(str(context.resolve_function_type(asked, (left, right), {})))
                except Exception as why:  # no such rule: that is an answer as well
                    said.append(type(why).__name__)
    return said


def test_an_answer_is_the_one_that_numba_gives_without_the_memory() -> None:
    lines = (
        "import runpy",
        "from game.physics.kernels import quick_typing",
        "quick_typing.answer_at_once = lambda: None",
        "from tests.physics.kernels.test_quick_typing import answers",
        "print(*answers(), sep='\\n')",
    )
    plain = subprocess.run(
        [sys.executable, "-c", "; ".join(lines)], capture_output=True, text=True, check=True
    )
    first, again = answers(), answers()
    assert first == again == plain.stdout.splitlines()
    assert len(set(first)) > 10


def test_flags_are_equal_where_all_their_options_are() -> None:
    one, other = Flags(), Flags()
    assert one == other
    assert hash(one) == hash(other)
    other.error_model = "python"
    said = Flags()
    said.error_model = other.error_model
    assert said == other
    assert hash(said) == hash(other)
    other.nrt = True
    assert said != other
    other.nrt = Flags().nrt  # said, and what it is anyway
    assert said == other
    assert said != "flags"


def test_taking_the_short_cuts_twice_changes_nothing() -> None:
    before = types.Function.get_call_type, Flags.__eq__
    quick_typing.answer_at_once()
    assert (types.Function.get_call_type, Flags.__eq__) == before


def test_an_operator_on_plain_numbers_is_asked_once(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []
    order = utils.order_by_target_specificity
    monkeypatch.setattr(
        utils, "order_by_target_specificity", lambda *given, **more: asked.append(1) or order(*given, **more)
    )
    context = cpu_target.typing_context
    context.refresh()
    for _ in range(3):
        given = context.resolve_function_type(operator.xor, (types.int16, types.int64), {})
        assert given.return_type == types.int64
    assert len(asked) == 1


@pytest.mark.parametrize(
    ("asked", "given", "answer"),
    [
        (operator.getitem, (types.float32[:, ::1], types.UniTuple(types.int64, 2)), types.float32),
        (operator.getitem, (types.float32[:, ::1], types.int64), types.float32[::1]),
        (operator.getitem, (types.int8[::1, :], types.int64), types.int8[:]),
        (operator.setitem, (types.int16[:], types.int64, types.float64), types.none),
    ],
)
def test_an_element_is_asked_for_once(monkeypatch: pytest.MonkeyPatch, asked, given, answer) -> None:
    told = []
    order = utils.order_by_target_specificity
    monkeypatch.setattr(
        utils, "order_by_target_specificity", lambda *given, **more: told.append(1) or order(*given, **more)
    )
    monkeypatch.setattr(quick_typing, "_answers", {})
    context = cpu_target.typing_context
    context.refresh()
    for _ in range(3):
        assert context.resolve_function_type(asked, given, {}).return_type == answer
    assert len(told) == 1
    for _ in range(2):
        with pytest.raises(TypingError):
            context.resolve_function_type(asked, (types.float64, *given[1:]), {})


def some_function(a, b):
    total = 0.0
    for k in range(len(a)):
        x, y = a[k], (b, total, k)
        a[k] = max(x, y[0]) + y[1]
        if a[k] > 3:
            total += a[k]
    return {"total": total}, [total, b]


def walked(value: Any) -> list[ir.Var]:
    """Variables in a value, by walking through all that hangs on it."""
    if isinstance(value, ir.Var):
        return [value]
    if isinstance(value, ir.Inst):
        return list(value.list_vars())
    if isinstance(value, dict):
        value = list(value.values())
    return [found for part in value for found in walked(part)] if isinstance(value, list | tuple) else []


def test_the_variables_of_a_statement_are_all_that_hang_on_it() -> None:
    statements = [one for block in run_frontend(some_function).blocks.values() for one in block.body]
    for one in statements:
        assert [id(var) for var in one.list_vars()] == [id(var) for var in walked(one.__dict__)]
    assert sum(len(one.list_vars()) for one in statements) > 50


def some_generator(n):
    for i in range(n):
        yield i + n


def test_lifetimes_are_those_that_are_found_at_once() -> None:
    """Found when they are asked for, and when statements that end them are put in; a generator's at once."""
    late, early = run_frontend(some_function), run_frontend(some_function)
    processor = postproc.PostProcessor(late)
    processor.run()
    assert "usedefs" not in vars(late.variable_lifetime)
    life = postproc.VariableLifetime(early.blocks)
    assert late.variable_lifetime.livemap == life.livemap
    assert late.variable_lifetime.deadmaps.combined == life.deadmaps.combined
    processor.run(emit_dels=True)
    gone = [one.value for block in late.blocks.values() for one in block.body if isinstance(one, ir.Del)]
    assert set(gone) == {name for names in life.deadmaps.combined.values() for name in names}
    assert run_frontend(some_generator).generator_info.state_vars


def test_nobody_hears_of_locks() -> None:
    heard = []

    class Hears(event.Listener):
        def on_start(self, event: Any) -> None:
            heard.append(event)

        on_end = on_start

    with event.install_listener("numba:llvm_lock", Hears()):
        llvm.parse_assembly("")
    assert not heard


def test_rules_are_looked_for_when_there_are_more(monkeypatch: pytest.MonkeyPatch) -> None:
    target = cpu_target.target_context
    target.refresh()
    looked: list[int] = []
    monkeypatch.setattr(type(target), "load_additional_registries", lambda _self: looked.append(1))
    target.refresh()
    assert not looked
    builtin_registry.lower(lambda x: x, types.float64)(lambda *_arguments: None)
    target.refresh()
    target.refresh()
    assert looked == [1]


def test_what_does_not_fit_into_a_slice_is_refused_in_few_words():
    @numba.njit
    def put(target, values):
        target[1:] = values

    target = np.zeros(3)
    put(target, np.array([1.0, 2.0]))
    assert target.tolist() == [0.0, 1.0, 2.0]
    with pytest.raises(ValueError, match="cannot assign slice from input of different size"):
        put(target, np.ones(3))
