"""Large tuples handed over by address, arrays by their parts, and elements of arrays."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest
from numba import config, njit, types
from numba.core.errors import LoweringError
from numba.core.runtime import _nrt_python, rtsys
from numba.extending import intrinsic, overload

from game.compiler.decorator import inner_kernel, kernel, lean_kernel
from game.compiler.entrances import Entrances
from game.compiler.target.bundles import MOST_BY_VALUE, is_by_address

pytestmark = pytest.mark.skipif(bool(config.DISABLE_JIT), reason="nothing is compiled")


class Inside(NamedTuple):
    """Nested."""

    low: np.ndarray
    high: np.ndarray
    turned: np.ndarray


class Bundle(NamedTuple):
    """Members of all sorts."""

    grid: np.ndarray
    marks: np.ndarray
    scale: float
    inside: Inside
    small: np.ndarray
    on: bool
    number: int


class Pair(NamedTuple):
    """Too small to go by address."""

    x: float
    y: float


def bundle(scale=2.0, count=3):
    return Bundle(
        np.arange(12.0).reshape(3, 4),
        np.arange(5, dtype=np.int32),
        scale,
        Inside(np.arange(3.0), np.arange(4.0) + 10.0, np.zeros((2, 2)).T),
        np.array([1, 2, 250], dtype=np.uint8),
        True,
        count,
    )


DEEP = (2.0 + 100.0 * 13.0) + (11.0 + 12.0 + 13.0) + 2.0 * 0.5 + 2.0  # what `deep` gives for `bundle()`
TOTAL = DEEP + 7.0 + 4.0 + 3.0 + 1000.0 + 250.0  # and `whole`


@inner_kernel
def lowest(inside, k):
    return inside.low[k] + 100.0 * inside.high[-1]


@inner_kernel
def add_up(numbers, first):
    total = 0.0
    for k in range(first, numbers.shape[0]):
        total += numbers[k]
    return total


@inner_kernel
def deep(given, pair):
    marks = given.marks
    marks[1] += 1
    return lowest(given.inside, 2) + add_up(given.inside.high, 1) + given.scale * pair.x + marks[1]


@lean_kernel
def whole(given, pair):
    given.grid[0, -1] = 7
    total = deep(given, pair) + given.grid[0, 3] + given.grid.shape[1] + given.number
    return total + (1000.0 if given.on else 0.0) + given.small[2]


@lean_kernel
def makes_one(given, times):
    last, total = given, 0.0
    for k in range(times):
        new = Bundle(
            given.grid, given.marks, last.scale + k, given.inside, given.small, given.on, given.number
        )
        total += lowest(new.inside, 0) + scale_of(last) * 1000.0 + scale_of(new)
        last = new
    return total


@inner_kernel
def scale_of(given):
    return given.scale


@lean_kernel
def takes_another(given, other, swap):
    if swap:
        given = other
    return scale_of(given)


@kernel
def gives_back(given):
    high = given.inside.high
    return high, given


@lean_kernel
def goes_through(given, n):
    for k in range(n):
        yield given.scale * given.inside.low[k]


@lean_kernel
def of_two(both, k):
    return scale_of(both[0]) - scale_of(both[1]) + both[1].grid[k, 0]


class TestTuples:
    def test_members_at_any_depth_are_read_and_written(self) -> None:
        ours, theirs = bundle(), bundle()
        assert whole(ours, Pair(0.5, 0.0)) == TOTAL
        theirs.marks[1], theirs.grid[0, 3] = 2, 7.0
        for k in (0, 1, 4):
            np.testing.assert_array_equal(ours[k], theirs[k])

    def test_a_call_takes_one_address_for_a_large_one(self) -> None:
        whole(bundle(), Pair(0.5, 0.0))
        [result] = deep.overloads.values()
        function = result.library.own().get_function(result.fndesc.llvm_func_name)
        assert len(list(function.arguments)) == 2 + 1 + 2  # returned, error; bundle; both of the pair
        assert "noalias" in str(function).split("{")[0].rpartition("ptr")[2]

    def test_where_the_border_is(self) -> None:
        manager = whole.targetdescr.target_context.data_model_manager
        of = [types.NamedUniTuple(types.float64, n, Pair) for n in (MOST_BY_VALUE, MOST_BY_VALUE + 1)]
        assert [is_by_address(manager.lookup(kind)) for kind in of] == [False, True]

    def test_one_that_is_made_in_a_kernel(self) -> None:
        scales = [2.0, 2.0, 3.0, 5.0, 8.0]  # each is the one before, and 0, 1, 2, 3
        expected = 4 * 1300.0 + 1000.0 * sum(scales[:4]) + sum(scales[1:])
        assert makes_one(bundle(), 4) == expected

    def test_an_argument_that_becomes_another(self) -> None:
        assert takes_another(bundle(3.0), bundle(5.0), True) == 5.0
        assert takes_another(bundle(3.0), bundle(5.0), False) == 3.0

    def test_one_that_is_given_back_is_counted_right(self) -> None:
        given = bundle()
        gives_back(given)
        _nrt_python.memsys_enable_stats()
        before = rtsys.get_allocation_stats()
        for _ in range(3):
            high, same = gives_back(given)
            assert high.tolist() == [10.0, 11.0, 12.0, 13.0]
            assert same.inside.low.tolist() == [0.0, 1.0, 2.0]
            assert same.number == 3
        del high, same
        after = rtsys.get_allocation_stats()
        assert after.mi_alloc - before.mi_alloc == after.mi_free - before.mi_free

    def test_a_generator_keeps_it(self) -> None:
        assert list(goes_through(bundle(3.0), 3)) == [0.0, 3.0, 6.0]

    def test_in_a_tuple_of_another_kind(self) -> None:
        assert of_two((bundle(5.0), bundle(3.0)), 2) == 2.0 + 8.0

    def test_code_that_is_not_ours_calls_with_it(self) -> None:
        @njit
        def outside(given, pair):
            return deep(given, pair)

        assert outside(bundle(), Pair(0.5, 0.0)) == DEEP

    def test_only_kernels_of_numbers_have_an_entry_for_c(self) -> None:
        cubes(1.0)
        takes_another(bundle(), bundle(), False)
        entries = []
        for one in (cubes, takes_another):
            [result] = one.overloads.values()
            held = {function.name for function in result.library.get_defined_functions()}
            entries.append(result.fndesc.llvm_cfunc_wrapper_name in held)
        assert entries == [True, False]

    def test_numbers_change_from_call_to_call(self) -> None:
        assert [takes_another(bundle(x), bundle(), False) for x in (1.0, 2.0, 4.0)] == [1.0, 2.0, 4.0]


class TestEntry:
    """What comes past numba's own look at types, as through `Entrances`."""

    def entered(self):
        entrances = Entrances()
        entrances.call(whole, bundle(), Pair(0.5, 0.0))
        return lambda given: entrances.call(whole, given, Pair(0.5, 0.0))

    def test_an_array_of_other_elements_is_refused(self) -> None:
        call = self.entered()
        for wrong in (np.zeros(5, dtype=np.int64), [1.0] * 5, None):
            with pytest.raises(TypeError, match="can't unbox array"):
                call(bundle()._replace(marks=wrong))
        inside = bundle().inside._replace(low=np.arange(3, dtype=np.float32))
        with pytest.raises(TypeError, match="can't unbox array"):
            call(bundle()._replace(inside=inside))

    def test_a_number_that_is_none_is_refused(self) -> None:
        with pytest.raises(TypeError):
            self.entered()(bundle()._replace(scale="much"))

    def test_afterwards_all_is_well(self) -> None:
        call = self.entered()
        with pytest.raises(TypeError):
            call(bundle()._replace(marks=None))
        assert call(bundle()) == TOTAL

    def test_a_tuple_of_another_length_is_refused(self) -> None:
        for wrong in (tuple(bundle())[:4], (*bundle(), 1.0), bundle()._replace(inside=(np.arange(3.0),))):
            with pytest.raises(ValueError, match="size mismatch for tuple, expected"):
                self.entered()(wrong)


@lean_kernel
def element(array, i, j):
    return array[i, j]


@lean_kernel
def set_element(array, i, j, value):
    array[i, j] = value


@lean_kernel
def third(array, i, j, k):
    array[i, j, k] += 0.5
    return array[i, j, k]


@lean_kernel
def flat(array, i):
    array[0] = array[i]
    return array[-1]


@lean_kernel
def row_sum(array, i):
    row = array[i]
    return row[0] + row[row.shape[0] - 1]


@lean_kernel
def same_index(array, i, j):
    at = i, j
    array[at] = array[at] + at[0]
    return array[at]


@lean_kernel
def powers(x, k):
    return x**2, x**-3, x**k, 2**k


@lean_kernel
def cubes(x):
    return x**3, x * (x * x)


@lean_kernel
def compares(x, k):
    return x < k, x == k, x / k, k // 2, k % 3, -x + True


class TestElements:
    @pytest.mark.parametrize("layout", ["C", "A", "F"])
    @pytest.mark.parametrize("kind", [np.float64, np.float32, np.int32, np.uint8, np.bool_])
    def test_of_two_dimensions(self, layout, kind) -> None:
        array = (np.arange(12).reshape(3, 4) % 5).astype(kind)
        array = {"C": array, "A": np.repeat(array, 2, axis=1)[:, ::2], "F": np.asfortranarray(array)}[layout]
        for i in (0, 2, -1, -3):
            for j in (0, 3, -1, -4):
                assert element(array, i, j) == array[i, j]
                assert element(array, np.int32(i), np.int16(j)) == array[i, j]
                changed = array.copy(order="K") if layout == "F" else np.repeat(array, 2, axis=1)[:, ::2]
                set_element(changed, i, j, 1)
                expected = array.copy()
                expected[i, j] = 1
                np.testing.assert_array_equal(changed, expected)

    def test_unsigned_indices(self) -> None:
        array = np.arange(12.0).reshape(3, 4)
        assert element(array, np.uint8(2), np.uint64(3)) == 11.0

    def test_of_three_dimensions(self) -> None:
        array = np.arange(24.0).reshape(2, 3, 4)
        assert third(array, 1, -2, 3) == 19.5
        assert array[1, 1, 3] == 19.5
        assert third(array[:, ::2], 1, 1, -1) == 23.5

    def test_a_number_of_another_type_is_converted(self) -> None:
        array = np.zeros((2, 2), dtype=np.int32)
        set_element(array, 1, 0, 3.7)
        assert array[1, 0] == 3

    def test_rows_and_indices_kept(self) -> None:
        array = np.arange(12.0).reshape(3, 4)
        assert row_sum(array, 1) == 11.0
        assert same_index(array, 2, 1) == 11.0
        assert flat(np.array([1.0, 2.0, 3.0]), 1) == 3.0

    def test_operators_of_numbers(self) -> None:
        assert powers(3.0, 2) == powers.py_func(3.0, 2)
        assert powers(1.1, 5)[0] == 1.1 * 1.1
        both = [cubes(1.0 + k / 7.0) for k in range(200)]  # products, not what the power of two numbers gives
        assert all(cube == product for cube, product in both)
        assert compares(0.5, 7) == compares.py_func(0.5, 7)


def test_an_error_while_lowering_names_the_statement() -> None:
    @intrinsic
    def cannot(_context, _x):
        def write(*_arguments):
            raise LoweringError("not to be written")

        return types.float64(types.float64), write

    @kernel
    def fails(x):
        return cannot(x)

    with pytest.raises(LoweringError, match=r"not to be written[\s\S]*lowering"):
        fails(1.0)


def test_a_rule_that_comes_later_is_known() -> None:
    def later(x):
        return x + 1.0

    element(np.zeros((1, 1)), 0, 0)  # what is compiled before knows nothing of it

    @overload(later)
    def _of_later(x):
        return lambda x: x + 2.0

    @kernel
    def asks(x):
        return later(x)

    assert asks(1.0) == 3.0
