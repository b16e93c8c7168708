"""numba's answers, remembered: the same types and the same flags as without."""

from __future__ import annotations

import operator
import subprocess
import sys

import pytest
from numba import types
from numba.core import utils
from numba.core.compiler import Flags
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
