"""A constant argument does not make another machine code of what is called."""

import pytest

from game.compiler.decorator import kernel


@kernel
def add_scaled(total, factor, offset=2.0):
    """Something that is called with constants and with variables."""
    return total + factor * offset


@kernel
def call_in_all_ways(total, factor):
    """Calls with variables, with constants of both kinds, by name and by default."""
    total = add_scaled(total, factor)
    total = add_scaled(total, 3)
    total = add_scaled(total, 4, offset=0.5)
    return add_scaled(total, 5, 7.0)


@pytest.mark.compiled
def test_constants_and_variables_share_machine_code():
    assert call_in_all_ways(1.0, 2) == call_in_all_ways.py_func(1.0, 2) == 1.0 + 4.0 + 6.0 + 2.0 + 35.0
    # offset left out is a default, which is a signature of its own; offset given by name or place is another
    assert len(add_scaled.signatures) == 2


@pytest.mark.compiled
def test_an_integer_constant_is_no_float():
    @kernel
    def halve(n):
        return n // 2 if n > 0 else 0

    @kernel
    def call(x):
        return halve(7) + halve(int(x)) + halve(x)

    assert call(9.0) == 3 + 4 + 4.0
    assert len(halve.signatures) == 2
