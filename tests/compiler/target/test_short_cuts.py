"""numba's answers, remembered: the same types, flags and variables as without."""

from __future__ import annotations

import operator
from typing import Any

import llvmlite.binding as llvm
import numba
import numpy as np
import pytest
from numba import config, types
from numba.core import base, event, ir, postproc, utils
from numba.core.compiler import Flags, run_frontend
from numba.core.errors import TypingError
from numba.core.imputils import builtin_registry
from numba.core.registry import cpu_target

from game.compiler.decorator import kernel
from game.compiler.target.contexts import target
from game.compiler.target.short_cuts import Answers, QuickFlags, short_cuts

PLAIN = (types.int32, types.int64, types.uint8, types.float32, types.float64, types.boolean, types.literal(3))
OPERATORS = (operator.add, operator.mul, operator.truediv, operator.floordiv, operator.lt, operator.and_)


def answers(context: Any) -> list[str]:
    """What each operator gives on each two kinds of plain numbers."""
    context.refresh()
    said = []
    for asked in OPERATORS:
        for left in PLAIN:
            for right in PLAIN:
                function = context.resolve_value_type(asked)
                try:
                    said.append(str(context.resolve_function_type(function, (left, right), {})))
                except Exception as why:  # no such rule: that is an answer as well
                    said.append(type(why).__name__)
    return said


def test_an_answer_is_the_one_that_numba_gives() -> None:
    first, again = answers(target.typing_context), answers(target.typing_context)
    assert first == again == answers(cpu_target.typing_context)
    assert len(set(first)) > 10


def test_flags_are_equal_where_all_their_options_are() -> None:
    one, other = QuickFlags(), QuickFlags()
    assert one == other
    assert hash(one) == hash(other)
    other.error_model = "python"
    said = QuickFlags()
    said.error_model = other.error_model
    assert said == other
    assert hash(said) == hash(other)
    assert said.values() == Flags(said).values()
    other.nrt = True
    assert said != other
    other.nrt = QuickFlags().nrt  # said, and what it is anyway
    assert said == other
    assert said == Flags(said)
    assert said != "flags"


def test_an_operator_on_plain_numbers_is_asked_once(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []
    order = utils.order_by_target_specificity
    monkeypatch.setattr(
        utils, "order_by_target_specificity", lambda *given, **more: asked.append(1) or order(*given, **more)
    )
    context = target.typing_context
    context.refresh()
    monkeypatch.setattr(context, "_answers", Answers())
    function = context.resolve_value_type(operator.xor)
    for _ in range(3):
        given = context.resolve_function_type(function, (types.int16, types.int64), {})
        assert given.return_type == types.int64
        assert context.call_type(function, (types.int16, types.int64)) == given
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
    context = target.typing_context
    context.refresh()
    monkeypatch.setattr(context, "_answers", Answers())
    function = context.resolve_value_type(asked)
    for _ in range(3):
        assert context.resolve_function_type(function, given, {}).return_type == answer
    if asked is operator.setitem:
        assert context.resolve_setitem(*given).return_type == answer
    assert len(told) == 1
    for _ in range(2):
        with pytest.raises(TypingError):
            context.resolve_function_type(function, (types.float64, *given[1:]), {})


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
    with short_cuts:
        listed = [[id(var) for var in one.list_vars()] for one in statements]
    assert listed == [[id(var) for var in walked(one.__dict__)] for one in statements]
    assert sum(len(one.list_vars()) for one in statements) > 50


def some_generator(n):
    for i in range(n):
        yield i + n


def test_lifetimes_are_those_that_are_found_at_once() -> None:
    """Found when they are asked for, and when statements that end them are put in; a generator's at once."""
    late, early = run_frontend(some_function), run_frontend(some_function)
    processor = postproc.PostProcessor(late)
    with short_cuts:
        processor.run()
        assert run_frontend(some_generator).generator_info.state_vars
    assert "usedefs" not in vars(late.variable_lifetime)
    life = postproc.VariableLifetime(early.blocks)
    assert late.variable_lifetime.livemap == life.livemap
    assert late.variable_lifetime.deadmaps.combined == life.deadmaps.combined
    processor.run(emit_dels=True)
    gone = [one.value for block in late.blocks.values() for one in block.body if isinstance(one, ir.Del)]
    assert set(gone) == {name for names in life.deadmaps.combined.values() for name in names}


def heard_of_locks() -> int:
    """How many times numba tells that LLVM is locked and unlocked, for one call of it."""
    heard = []

    class Hears(event.Listener):
        def on_start(self, event: Any) -> None:
            heard.append(event)

        on_end = on_start

    with event.install_listener("numba:llvm_lock", Hears()):
        llvm.parse_assembly("").close()
    return len(heard)


def exchanged() -> tuple[Any, ...]:
    """What of numba the short cuts exchange."""
    return ir.Inst._rec_list_vars, postproc.PostProcessor.run, base._has_loc


def test_numba_is_as_it_was_when_no_kernel_compiles() -> None:
    before = exchanged()
    assert heard_of_locks() > 0
    with pytest.raises(KeyError), short_cuts:
        with short_cuts:
            inside = exchanged()
        assert exchanged() == inside
        assert not set(inside) & set(before)
        assert heard_of_locks() == 0
        raise KeyError
    assert exchanged() == before
    assert heard_of_locks() > 0
    assert {each.__module__ for each in before} == {"numba.core.ir", "numba.core.postproc", "numba.core.base"}


@pytest.mark.skipif(bool(config.DISABLE_JIT), reason="nothing is compiled")
def test_numba_is_as_it_was_when_a_kernel_failed() -> None:
    @kernel
    def fails(x):
        return x.nothing_of_this_name

    before = exchanged()
    with pytest.raises(TypingError):
        fails(1.0)
    assert exchanged() == before


def test_rules_are_looked_for_when_there_are_more(monkeypatch: pytest.MonkeyPatch) -> None:
    context = target.target_context
    context.refresh()
    looked: list[int] = []
    monkeypatch.setattr(type(context), "load_additional_registries", lambda _self: looked.append(1))
    context.refresh()
    assert not looked
    builtin_registry.lower(lambda x: x, types.float64)(lambda *_arguments: None)
    context.refresh()
    context.refresh()
    assert looked == [1]


def put(target, values):
    target[1:] = values


@pytest.mark.skipif(bool(config.DISABLE_JIT), reason="nothing is compiled")
def test_what_does_not_fit_into_a_slice_is_refused_in_few_words() -> None:
    ours, theirs = kernel(put), numba.njit(put)
    target = np.zeros(3)
    ours(target, np.array([1.0, 2.0]))
    assert target.tolist() == [0.0, 1.0, 2.0]
    with pytest.raises(ValueError, match="cannot assign slice from input of different size"):
        ours(target, np.ones(3))
    with pytest.raises(ValueError, match=r"\(3,\).*\(2,\)|\(2,\).*\(3,\)"):
        theirs(target, np.ones(3))
