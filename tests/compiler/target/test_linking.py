"""Inner kernels are linked into who calls them, from whatever depth, new or kept."""

from __future__ import annotations

import gc
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest
from numba import config, njit, types
from numba.core.errors import TypingError

from game.compiler.decorator import inner_kernel, kernel, lean_kernel
from game.compiler.progress import compiling
from game.compiler.target.linking import InnerLibrary, KernelLibrary, environments_of, kept_form
from game.physics.kernels.elementary import linking
from tests.compiler.test_decorator import Copy

pytestmark = pytest.mark.skipif(bool(config.DISABLE_JIT), reason="nothing is compiled")
DOUBLE = (types.float64,)


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


@inner_kernel
def speaks(x):
    if x > 1.0:
        print(x)
    return 2.0 * x


@lean_kernel
def listens(x):
    return speaks(x) + 1.0


@inner_kernel
def refuses(x):
    if x < 0.0:
        raise ValueError("a negative one")
    return x


@lean_kernel
def asks(x):
    return refuses(x) + 1.0


@inner_kernel
def count_down(n):
    return 0 if n == 0 else 1 + count_down(n - 1)


@lean_kernel
def counts(n):
    return count_down(n)


@inner_kernel
def even(n):
    return True if n == 0 else odd(n - 1)


@inner_kernel
def odd(n):
    return False if n == 0 else even(n - 1)


@lean_kernel
def is_even(n):
    return even(n)


@kernel
def is_even_too(n):
    return True if n == 0 else is_odd_too(n - 1)


@kernel
def is_odd_too(n):
    return False if n == 0 else is_even_too(n - 1)


@lean_kernel
def lean_count_down(n):
    return 0 if n == 0 else 1 + lean_count_down(n - 1)


@lean_kernel
def counts_twice(n):
    return 2 * lean_count_down(n)


@lean_kernel
def only_called(x):
    return deep(x) - 0.5


@lean_kernel
def calls(x):
    return only_called(x) * 2.0


@kernel
def makes_an_array(n):
    return np.ones(n)


@kernel
def sums(n):
    return makes_an_array(n).sum()


class TestCalledByKernelsOnly:
    """A kernel that Python may call has machine code of its own once Python does"""

    def test_it_has_none_until_then(self) -> None:
        assert calls(2.0) == 13.0
        assert not only_called.overloads
        result = only_called.called.overloads[DOUBLE]
        assert isinstance(result.library, InnerLibrary)
        assert result.library.get_pointer_to_function(result.fndesc.llvm_func_name) == 0
        assert only_called(2.0) == 6.5
        assert not isinstance(only_called.overloads[DOUBLE].library, InnerLibrary)
        assert only_called.called.overloads[DOUBLE] is result

    def test_it_calls_itself(self) -> None:
        assert counts_twice(5) == 10
        assert lean_count_down(5) == 5

    def test_two_of_another_kind_call_each_other(self) -> None:
        """Those that count references, as the message to inner ones says."""
        assert is_even_too(4)
        assert not is_odd_too(4)

    def test_one_that_makes_arrays_is_called_as_it_is(self) -> None:
        assert sums(3) == 3.0
        assert makes_an_array.called is makes_an_array


class TestNew:
    def test_what_is_called_from_several_depths(self) -> None:
        assert top(2.0) == 7.0 - 10.0
        assert above(2.0) == 3.0

    def test_an_inner_kernel_has_no_machine_code(self) -> None:
        top(1.0)
        result = deep.overloads[DOUBLE]
        assert isinstance(result.library, InnerLibrary)
        assert result.library.get_pointer_to_function(result.fndesc.llvm_func_name) == 0

    def test_its_code_is_not_optimised_by_itself(self) -> None:
        top(1.0)
        module = deep.overloads[DOUBLE].library.own()
        held = [function for function in module.functions if not function.is_declaration]
        assert [function.name for function in held] == [deep.overloads[DOUBLE].fndesc.llvm_func_name]
        assert f"call i32 @{deepest.overloads[DOUBLE].fndesc.llvm_func_name}" in str(held[0]).replace('"', "")
        assert not deep.overloads[DOUBLE].library.has_dynamic_globals

    def test_code_that_is_not_ours_calls_kernels_of_both_kinds(self) -> None:
        @njit
        def outside(x):
            return top(x) + deep(x) + beside(x)

        assert outside(2.0) == -3.0 + 7.0 - 1.0

    def test_it_prints(self, capfd: pytest.CaptureFixture[str]) -> None:
        """What it needs of Python is there where it was linked in."""
        assert listens(1.5) == 4.0
        sys.stdout.flush()
        assert capfd.readouterr().out == "1.5\n"
        assert environments_of(speaks.overloads[DOUBLE].library.own())

    def test_what_it_raises_is_raised(self) -> None:
        assert asks(1.0) == 2.0
        with pytest.raises(ValueError, match="a negative one"):
            asks(-1.0)

    def test_it_calls_itself(self) -> None:
        assert counts(5) == 5

    def test_two_that_call_each_other_are_refused(self) -> None:
        with pytest.raises((NotImplementedError, TypingError), match="in a circle"):
            is_even(4)


class TestFinished:
    """Of a finished kernel no module of LLVM's stays in memory."""

    def test_it_is_linked_in_and_looked_at_all_the_same(self) -> None:
        @kernel
        def grown(n):
            return 2.0 * np.ones(n)

        @kernel
        def over(n):
            return grown(n).sum()

        assert over(3) == 6.0
        assert over(4) == 8.0
        for result in (*grown.overloads.values(), *over.overloads.values()):
            library = result.library
            assert not [*library._final_module.functions]
            assert library._shared_module is None
            held = {function.name for function in library.get_defined_functions()}
            assert result.fndesc.llvm_func_name in held
            assert result.fndesc.llvm_func_name in library.get_llvm_str()
            assert result.fndesc.llvm_func_name in library.get_asm_str()

    def test_its_machine_code_is_handed_over_once(self) -> None:
        @kernel
        def told(x):
            return x + 1.0

        assert told(1.0) == 2.0
        [result] = told.overloads.values()
        _, parts = kept_form(result)
        code, bitcode = parts[0][2]
        assert code and bitcode
        again = KernelLibrary.from_object(result.library.codegen, "again", code, bitcode)
        assert [one.name for one in again.get_defined_functions()] == [
            one.name for one in result.library.get_defined_functions()
        ]
        assert kept_form(result)[1][0][2][0] == b""


class TestCollecting:
    """Python looks for circles of objects before a compilation and after it, and not meanwhile."""

    def test_not_meanwhile(self, monkeypatch: pytest.MonkeyPatch) -> None:
        seen = []
        disable = gc.disable

        def see() -> None:
            disable()
            seen.append(gc.isenabled())

        monkeypatch.setattr(gc, "disable", see)
        assert gc.isenabled()
        done = compiling().done

        @kernel
        def inner(x):
            return x + 1.0

        @kernel
        def outer(x):
            return inner(x)

        outer(1.0)
        assert gc.isenabled()
        assert seen == [False]  # once for both
        assert compiling().done == done + 2

    def test_again_after_a_failure(self) -> None:
        @kernel
        def fails(x):
            return x.nothing_of_this_name

        with pytest.raises(TypingError):
            fails(1.0)
        assert gc.isenabled()

    def test_who_had_switched_it_off_finds_it_so(self) -> None:
        @kernel
        def some(x):
            return x - 1.0

        gc.disable()
        try:
            some(1.0)
            assert not gc.isenabled()
        finally:
            gc.enable()

    def test_two_threads(self) -> None:
        def run() -> None:
            @kernel
            def some(x):
                return x - 1.0

            some(1.0)

        threads = [threading.Thread(target=run) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert gc.isenabled()


INNER = """
from game.compiler.decorator import inner_kernel
@inner_kernel
def low(x):
    if x < 0.0:
        raise ValueError("a negative one")
    return x * 3.0
@inner_kernel
def middle(x):
    return low(x) + 1.0
@inner_kernel
def speaks(x):
    print(x)
    return low(x)
@inner_kernel
def tells(x):
    return speaks(x) + 0.5
def make(bits):
    @inner_kernel
    def twin(x):
        for i in range(50):
            x = x * 0.5 + i
        return 1000.0 if bits & 1 else -5.0
    return twin
a, b = make(0), make(1)
"""
HEAD = """
from game.compiler.decorator import lean_kernel
from game.physics.inner import a, b, low, middle, speaks, tells
@lean_kernel
def call(x):
"""
CALLS = {  # what a process of its own calls: its value, and how many kernels it has to compile
    "low(x) + a(x)": (1.0, 3),
    "middle(x) + b(x)": (1007.0, 3),
    "middle(x) + low(x) + a(x) + 10.0 * b(x)": (10008.0, 1),
    "tells(x)": (6.5, 3),
    "tells(x) - 1.5": (5.0, 1),
}
CALL = """
from game.physics.{name} import call
from game.compiler.progress import compiling
print(call(2.0), compiling().done)
try:
    call(-1.0)
except ValueError as error:
    print(error)
"""


class TestKept:
    """Of kept inner code, each piece of a process of its own, a later process makes what it needs."""

    def call(self, copy: Copy, name: str) -> list[str]:
        out, err = copy.start(CALL.format(name=name)).communicate(timeout=900)
        assert err == ""
        return out.split("\n")[:-1]

    def test_outer_kernels_are_made_of_it(self, tmp_path: Path) -> None:
        copy = Copy(tmp_path)
        copy.write("physics/inner.py", INNER)
        for i, (text, (value, done)) in enumerate(CALLS.items()):
            copy.write(f"physics/outer_{i}.py", f"{HEAD}    return {text}\n")
            once, twice = (["2.0"], ["-1.0"]) if "tells" in text else ([], [])
            assert self.call(copy, f"outer_{i}") == [*once, f"{value} {done}", *twice, "a negative one"]
        assert self.call(copy, f"outer_{i}") == ["2.0", f"{value} 0", "-1.0", "a negative one"]


USED = """
from game.physics.kernels import elementary
from game.physics.kernels.elementary import linking
assert not linking.known()
print(elementary.cos(1.0))
assert linking.known() == {"cos"}, linking.known()
"""


class TestSymbols:
    """Functions that machine code calls by name are made when they are called for, new or kept."""

    def test_only_those_that_are_called(self) -> None:
        for _ in range(2):
            done = subprocess.run([sys.executable, "-c", USED], capture_output=True, text=True)
            assert done.returncode == 0, done.stderr
            assert float(done.stdout) == pytest.approx(0.5403023058681398, rel=1e-15)

    def test_one_that_could_not_be_made_is_tried_again(self, monkeypatch: pytest.MonkeyPatch) -> None:
        tried = []

        class Fails:
            def compile(self, _types: object) -> None:
                tried.append(1)
                raise MemoryError

        monkeypatch.setitem(linking._functions, "failing", (Fails(), 1))
        for _ in range(2):
            with pytest.raises(MemoryError):
                linking.make_symbol_known("carom_failing")
        assert len(tried) == 2
        assert "failing" not in linking.known()

    def test_others_are_let_be(self) -> None:
        before = linking.known()
        linking.make_symbol_known("memcpy")
        linking.make_symbol_known("carom_no_such_function")
        assert linking.known() == before

    def test_what_is_called_and_not_held(self) -> None:
        from game.physics.kernels.elementary import cos

        @inner_kernel
        def turned(x):
            return cos(x)

        @lean_kernel
        def outer(x):
            return turned(x) + deepest(x)

        outer(1.0)
        assert "carom_cos" in kept_form(outer.overloads[DOUBLE])[0]
        assert kept_form(turned.overloads[DOUBLE])[0] == ["carom_cos"]
