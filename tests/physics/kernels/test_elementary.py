"""Our own elementary functions: within an ulp, exact where they can be, the same bits compiled and not."""

from __future__ import annotations

import math
import os
import random
import struct
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.compiler.decorator import kernel
from game.physics.kernels import elementary, elementwise
from game.physics.kernels.elementary import linking
from tests.reference import elementary as exact

INF, NAN = math.inf, math.nan
COUNT = 60  # arguments of each kind
# What each module says of its functions, in ulp.
BOUNDS = {
    "sin": 0.8, "cos": 0.8, "tan": 0.9, "exp": 0.55, "expm1": 0.8, "log": 0.55, "log2": 0.55, "log10": 0.55,
    "log1p": 0.55, "pow": 0.6, "atan": 0.55, "atan2": 0.55, "asin": 0.55, "acos": 0.55, "hypot": 0.9,
    "cbrt": 0.55, "tanh": 0.8, "asinh": 0.55, "erf": 0.7,
}  # fmt: skip


def any_floats(chance: random.Random) -> Iterator[float]:
    """Floats of every size and sign, each exponent as likely."""
    for _ in range(COUNT):
        value = struct.unpack("<d", struct.pack("<Q", chance.getrandbits(64)))[0]
        if math.isfinite(value):
            yield value


def spread(chance: random.Random, low: float, high: float) -> list[float]:
    return [chance.uniform(low, high) for _ in range(COUNT)]


def sizes(chance: random.Random, low: float, high: float) -> list[float]:
    """Sizes from low to high, each ratio as likely, of either sign."""
    found = [math.exp(chance.uniform(math.log(low), math.log(high))) for _ in range(COUNT)]
    return [chance.choice((-1.0, 1.0)) * value for value in found]


def arguments(name: str) -> list[tuple[float, ...]]:
    """Where a function is measured: everywhere, where it is used, and where it is hard."""
    chance = random.Random(name)
    every = list(any_floats(chance))
    positive = [abs(value) for value in every if value != 0.0]
    tiny = sizes(chance, 1e-310, 1.0)
    near_one = [1.0 + value for value in sizes(chance, 1e-16, 0.2)]
    if name in ("sin", "cos", "tan"):
        turns = [chance.randrange(1, 2**19) * math.pi / 2.0 for _ in range(COUNT)]
        hard = [6381956970095103.0 * 2.0**797, 45.553093477052, 1647098.9, 1647099.1, -1e22, 5e-324]
        found = every + spread(chance, -2.0, 2.0) + spread(chance, -1e3, 1e3) + tiny + turns + hard
    elif name == "exp":
        found = spread(chance, -745.1, 709.78) + spread(chance, -2.0, 2.0) + tiny
    elif name == "expm1":
        found = spread(chance, -60.0, 709.0) + spread(chance, -0.5, 0.5) + tiny
    elif name in ("log", "log2", "log10"):
        found = positive + near_one + spread(chance, 0.5, 4.0) + [5e-324, 2.2e-308]
    elif name == "log1p":
        found = positive + tiny + spread(chance, -0.999, 3.0)
    elif name in ("atan", "asinh", "cbrt"):
        found = every + spread(chance, -3.0, 3.0) + tiny
    elif name in ("asin", "acos"):
        found = spread(chance, -1.0, 1.0) + tiny + [1.0, -1.0, 0.0, 1.0 - 2.0**-53, 2.0**-53 - 1.0]
    elif name == "tanh":
        found = spread(chance, -22.0, 22.0) + spread(chance, -0.6, 0.6) + tiny
    elif name == "erf":
        found = spread(chance, -6.0, 6.0) + tiny
    else:
        return pairs(name, chance)
    return [(value,) for value in found]


def pairs(name: str, chance: random.Random) -> list[tuple[float, float]]:
    """The same for functions of two numbers."""
    if name == "pow":
        found = list(zip(spread(chance, 0.0, 9.0), spread(chance, -300.0, 300.0), strict=True))
        near = [1.0 + value for value in sizes(chance, 1e-12, 0.1)]
        found += zip(near, [chance.uniform(-1.0, 1.0) / (value - 1.0) for value in near], strict=True)
        found += [(-a, float(k)) for k, a in enumerate(spread(chance, 0.5, 2.0))]
        found += [
            (a, b)
            for a, b in zip(sizes(chance, 1e-300, 1e300), spread(chance, -1.0, 1.0), strict=True)
            if a > 0
        ]
        return found
    found = list(zip(spread(chance, -1.0, 1.0), spread(chance, -1.0, 1.0), strict=True))
    for low, high in ((1e-18, 1e18), (1e-320, 1e-290), (1e290, 1e308)):
        found += zip(sizes(chance, low, high), sizes(chance, low, high), strict=True)
    return found


@pytest.mark.parametrize("name", BOUNDS)
def test_within_its_bound_of_the_exact_value(name: str) -> None:
    function, reference = getattr(elementary, name), getattr(exact, name)
    worst = max((exact.ulps(function(*x), reference(*x)), x) for x in arguments(name))
    assert worst[0] < BOUNDS[name], worst


@settings(max_examples=60, deadline=None)
@given(st.floats(allow_nan=False, allow_infinity=False), st.floats(-700.0, 700.0), st.floats(1e-300, 1e300))
def test_within_an_ulp_wherever_it_is_looked_for(x: float, small: float, positive: float) -> None:
    for name, given_ in (("sin", x), ("cos", x), ("atan", x), ("cbrt", x), ("exp", small), ("log", positive)):
        if given_ != 0.0:
            value = getattr(elementary, name)(given_)
            assert exact.ulps(value, getattr(exact, name)(given_)) < 1.0, (name, given_)


SPECIAL = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -0.5,
    2.0,
    -2.0,
    3.0,
    -3.0,
    1e300,
    -1e300,
    5e-324,
    -5e-324,
    2.0**53,
    1e-300,
]
SPECIAL += [INF, -INF, NAN, 1.5, -1.5, 2.0**53 + 2.0, -(2.0**53) - 2.0, 1.0 - 2.0**-53, 1.0 + 2.0**-52]
POLES = {("log", 0.0): -INF, ("log2", 0.0): -INF, ("log10", 0.0): -INF, ("log1p", -1.0): -INF}


def by_math(name: str, *x: float) -> float:
    """What the C library says, without the errors that Python makes of it."""
    try:
        return float(np.cbrt(*x)) if name == "cbrt" else float(getattr(math, name)(*x))
    except OverflowError:
        return math.copysign(INF, x[0]) if name == "pow" and x[0] < 0.0 and x[1] % 2.0 else INF
    except ValueError:
        if name == "pow" and x[0] == 0.0:
            odd = x[1] % 2.0 == 1.0
            return math.copysign(INF, x[0]) if odd else INF
        return POLES.get((name, x[0]), NAN)


def alike(a: float, b: float) -> bool:
    """Equal with the sign of zero, both nan, or the same to the last digits where neither is special."""
    if math.isnan(a) or math.isnan(b):
        return math.isnan(a) and math.isnan(b)
    same_sign = math.copysign(1.0, a) == math.copysign(1.0, b)
    return same_sign and (a == b or math.isclose(a, b, rel_tol=4e-16, abs_tol=5e-324))


@pytest.mark.parametrize("name", BOUNDS)
def test_zeros_infinities_and_nans_as_in_c(name: str) -> None:
    function = getattr(elementary, name)
    if name in ("pow", "atan2", "hypot"):
        cases: list[tuple[float, ...]] = [(a, b) for a in SPECIAL for b in SPECIAL]
    else:
        cases = [(a,) for a in SPECIAL]
    wrong = [
        (x, function(*x), by_math(name, *x)) for x in cases if not alike(function(*x), by_math(name, *x))
    ]
    assert not wrong


def test_exact_where_the_value_is_a_float() -> None:
    for n in range(-1074, 1024):
        assert elementary.log2(math.ldexp(1.0, n)) == n
        assert elementary.pow(2.0, n) == math.ldexp(1.0, n)
    for n in range(23):
        assert elementary.log10(10.0**n) == n
        assert elementary.pow(10.0, n) == float(10**n)
    for n in range(1, 200):
        assert elementary.cbrt(float(n**3)) == n
        assert elementary.hypot(3.0 * n, -4.0 * n) == 5.0 * n
        assert elementary.pow(float(n * n), 0.5) == n
    assert elementary.exp(0.0) == elementary.cos(0.0) == 1.0
    assert elementary.atan2(1.0, 1.0) == math.pi / 4.0


@pytest.mark.parametrize(
    ("name", "edges", "rises"),
    [
        ("sin", [math.pi / 4.0, 0.25], True), ("cos", [math.pi / 4.0, 0.3], False),
        ("tan", [0.67434, math.pi / 4.0], True),
        ("exp", [(k + 0.5) * math.log(2.0) / 128.0 for k in (0, 63, 64, 127)] + [709.0, -708.4], True),
        ("expm1", [0.25, -0.25, 60.0, -60.0], True),
        ("log", [1.0, 1.0 + 2.0**-8, 1.0 - 2.0**-9, 2.0**-1022, 1.498], True),
        ("log1p", [2.0**-54, 1.0], True),
        ("atan", [1.0, 2.0**-28, 2.0**60, *((i + 0.5) / 64.0 for i in (0, 1, 31, 63))], True),
        ("asin", [2.0**-28, 0.7071, 0.99999], True), ("acos", [0.7071, 0.99999, 0.0], False),
        ("tanh", [0.25, 2.0**-28, 20.0], True), ("erf", [2.0**-30, 5.99], True), ("asinh", [2.0**30], True),
        ("cbrt", [2.0**-900, 1.0], True),
    ],
)  # fmt: skip
def test_monotone_where_one_way_of_reckoning_ends(name: str, edges: list[float], rises: bool) -> None:
    function = getattr(elementary, name)
    for edge in edges:
        x = edge
        for _ in range(40):
            x = math.nextafter(x, -INF)
        last = function(x)
        for _ in range(80):
            x = math.nextafter(x, INF)
            now = function(x)
            assert now >= last if rises else now <= last, x
            last = now


PROBE = """
import hashlib, math, random, struct
from game.physics.kernels import elementary
chance, hasher = random.Random(5), hashlib.blake2b()
def one():
    kind = chance.randrange(4)
    if kind == 0: return struct.unpack("<d", struct.pack("<Q", chance.getrandbits(64)))[0]
    return (chance.random() - 0.5) * (3.0, 30.0, 3e6)[kind - 1]
for name in NAMES:
    for _ in range(300):
        x = [one() for _ in range(2 if name in ("pow", "atan2", "hypot") else 1)]
        value = getattr(elementary, name)(*x)
        assert type(value) is float, (name, type(value))
        hasher.update(struct.pack("<d", math.nan if value != value else value))
print(hasher.hexdigest())
"""


def test_the_same_bits_compiled_and_not() -> None:
    found = set()
    for off in ("0", "1"):
        environment = {**os.environ, "NUMBA_DISABLE_JIT": off}
        root = Path(__file__).resolve().parents[3]
        code = PROBE.replace("NAMES", repr(list(BOUNDS)))
        run = subprocess.run(
            [sys.executable, "-W", "error", "-c", code],
            env=environment,
            cwd=root,
            capture_output=True,
            text=True,
        )
        assert run.returncode == 0, run.stderr
        found.add(run.stdout)
    assert len(found) == 1


@kernel
def _every(x: float) -> float:
    s = elementary.sin(x) + elementary.cos(x) * elementary.tan(x) + elementary.exp(x) * elementary.log(x)
    return s + elementary.pow(x, 0.3) * elementary.atan2(x, 2) + elementary.hypot(x, 1) * elementary.square(x)


def test_machine_code_calls_them_by_name_and_fuses_nothing() -> None:
    _every(0.5)
    text = next(iter(_every.inspect_llvm().values()))
    assert f"@{linking.PREFIX}sin(double" in text
    for refused in (
        "llvm.sin",
        "llvm.cos",
        "llvm.exp",
        "llvm.pow",
        "llvm.fma",
        "fmuladd",
        " contract ",
        " fast ",
    ):
        assert refused not in text
    assert "vfmadd" not in next(iter(_every.inspect_asm().values()))


def test_whole_arrays_hold_the_bits_of_single_numbers() -> None:
    x = np.linspace(-0.99, 0.99, 24).reshape(2, 3, 4)[:, ::-1]
    names = {
        "arcsin": "asin", "arccos": "acos", "arctan": "atan", "arcsinh": "asinh", "sin": "sin", "cos": "cos",
        "tan": "tan", "exp": "exp", "expm1": "expm1", "log1p": "log1p", "cbrt": "cbrt", "tanh": "tanh",
        "log": "log", "log2": "log2", "log10": "log10",
    }  # fmt: skip
    for name, own in names.items():
        given_ = np.abs(x) if name in ("log", "log2", "log10") else x
        found = getattr(elementwise, name)(given_)
        expected = [getattr(elementary, own)(v) for v in given_.reshape(-1).tolist()]
        assert found.shape == x.shape
        assert found.reshape(-1).tolist() == expected
        assert np.allclose(found, getattr(np, name)(given_), rtol=1e-14)
    assert elementwise.hypot(x, 2.0).tolist() == [
        [[elementary.hypot(v, 2.0) for v in r] for r in p] for p in x.tolist()
    ]
    assert elementwise.arctan2(x[0], x[:, :1]).shape == (2, 3, 4)
    assert elementwise.arctan2([1.0, -1.0], -1.0).tolist() == [
        elementary.atan2(1.0, -1.0),
        elementary.atan2(-1.0, -1.0),
    ]
    assert elementwise.power(2.0, np.arange(3)).tolist() == [1.0, 2.0, 4.0]
    assert isinstance(elementwise.sin(1), np.float64)
    assert abs(elementwise.turned(math.pi / 3.0) - (0.5 + 0.75**0.5 * 1j)) < 1e-15


def test_distances() -> None:
    assert elementary.dist((1.0, 2.0), (4.0, 6.0)) == 5.0
    assert elementary.dist((1.0, 2.0, 3.0), (3.0, 3.0, 5.0)) == 3.0
    assert elementary.length(2.0, -3.0, 6.0) == 7.0
    with pytest.raises(ValueError, match="shorter"):
        elementary.dist((1.0, 2.0), (1.0,))


def test_products() -> None:
    assert elementary.square(-3) == 9
    assert elementary.cube(-2.0) == -8.0
    assert elementary.square(np.array([1.0, 2.0])).tolist() == [1.0, 4.0]
