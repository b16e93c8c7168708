"""Kernels of another package are none of Carom's business: they are compiled, kept and run as without it.

Processes of their own use a small foreign library. numba keeps its machine code on disk, so what one process
compiled another runs: each may or may not have imported Carom.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from numba import config

from tests.paths import ROOT

pytestmark = pytest.mark.skipif(bool(config.DISABLE_JIT), reason="nothing is compiled")

LIBRARY = '''
"""Tides: nothing of Carom's."""
from typing import NamedTuple
import numba
import numpy as np

class Buoy(NamedTuple):
    height: np.ndarray
    speed: np.ndarray
    weight: np.ndarray

class Harbour(NamedTuple):
    buoys: Buoy
    depth: np.ndarray
    names: np.ndarray
    tide: float

@numba.njit(cache=True)
def load(buoy, k):
    return buoy.height[k] * buoy.weight[k] + buoy.speed[k]

@numba.njit(cache=True)
def level(harbour, k):
    return harbour.tide * harbour.depth[k] + load(harbour.buoys, k) + harbour.names[k]

@numba.njit(cache=True)
def shifted(harbour, by):
    return Harbour(harbour.buoys, harbour.depth + by, harbour.names, harbour.tide * 2.0)

@numba.njit(cache=True)
def copied(into, values):
    into[:] = values
    return into.sum()

def harbour():
    four = np.arange(4.0)
    return Harbour(Buoy(four, four + 10.0, 2.0 * four), four * four, np.arange(4), 0.5)
'''
# Some kernels come from numba's cache, others are compiled on top of them by this very process.
RUN = """
import json, sys
if "carom" in sys.argv:
    import numpy as np
    from game.physics.kernels import elementary
    from game.compiler.decorator import kernel
    from tides import load
    @kernel
    def ours(buoy, k):
        return load(buoy, k) + elementary.sin(0.0)
import numba
from tides import copied, harbour, level, load, shifted
here = harbour()

@numba.njit
def total(given, n):
    sum = 0.0
    for k in range(n):
        sum += level(given, k)
    return sum

@numba.njit
def twice(given, n):
    return total(shifted(given, 1.0), n)

try:
    copied(np.zeros(3), np.zeros(2)) if "carom" in sys.argv else copied(here.depth, here.depth[:2])
except ValueError as error:
    said = str(error)
moved = shifted(here, 1.0)
values = [total(here, 4), twice(here, 4), load(here.buoys, 3), level(moved, 2), moved.buoys.speed.sum()]
if "carom" in sys.argv:
    assert ours(here.buoys, 3) == values[2], ours(here.buoys, 3)
hits = sum(sum(one.stats.cache_hits.values()) for one in (load, level, shifted))
names = [result.fndesc.mangled_name for result in level.overloads.values()]
print(json.dumps({"values": values, "hits": hits, "said": said.count("shape"), "names": names}))
"""


def by_hand() -> list[float]:
    """What the library gives, reckoned in Python."""
    height = [0.0, 1.0, 2.0, 3.0]
    load = [h * 2.0 * h + h + 10.0 for h in height]
    level = [0.5 * h * h + load[k] + k for k, h in enumerate(height)]
    moved = [1.0 * (h * h + 1.0) + load[k] + k for k, h in enumerate(height)]
    return [sum(level), sum(moved), load[3], moved[2], sum(h + 10.0 for h in height)]


def run(folder: Path, *words: str) -> dict[str, object]:
    """What a process says that runs the library in a folder."""
    environment = {**os.environ, "PYTHONPATH": f"{ROOT}{os.pathsep}{folder}", "NUMBA_CACHE_DIR": ""}
    done = subprocess.run(
        [sys.executable, "-c", RUN, *words], cwd=folder, env=environment, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    return dict(json.loads(done.stdout))


@pytest.mark.parametrize("later", [(), ("carom",)], ids=["then without", "then with"])
@pytest.mark.parametrize("first", [(), ("carom",)], ids=["made without", "made with"])
def test_another_packages_kernels(tmp_path: Path, first: tuple[str, ...], later: tuple[str, ...]) -> None:
    (tmp_path / "tides.py").write_text(LIBRARY)
    made, found = run(tmp_path, *first), run(tmp_path, *later)
    assert made["values"] == found["values"] == by_hand()
    assert made["hits"] == 0
    assert found["hits"] == 3
    assert made["said"] == found["said"] == 2  # numba's own words of two shapes


# What numba is made of, before Carom is imported and after kernels of its were compiled.
LOOK = """
import json, sys, types
import numpy as np
import numba

def warm(x):
    return x[1:] * 2.0 + x.sum()

numba.njit(warm)(np.ones(3))  # that what numba itself loads late is there
from numba.core import bytecode, datamodel, pythonapi
from numba.core.target_extension import current_target

def look():
    found = {}
    for name, module in list(sys.modules.items()):
        if not name.startswith(("numba", "llvmlite")) or not isinstance(module, types.ModuleType):
            continue
        for word, value in list(vars(module).items()):
            if isinstance(value, types.FunctionType):
                found[f"{name}.{word}"] = value
            elif isinstance(value, type) and value.__module__ == name:
                for inner, part in list(vars(value).items()):
                    if isinstance(part, types.FunctionType | property | staticmethod | classmethod):
                        found[f"{name}.{word}.{inner}"] = part
    for kind, model in datamodel.default_manager._handlers.items():
        found[f"model of {kind.__name__}"] = model
    for kind, reader in pythonapi._unboxers.functions.items():
        found[f"reader of {kind.__name__}"] = reader
    for k, pair in enumerate(numba.core.base.ll.ffi.lib._lock._cblist):
        found[f"lock {k}"] = pair[0]
    return found

before = look()
from game.physics.kernels import elementary
from game.compiler.decorator import inner_kernel, kernel

@inner_kernel
def low(x, k):
    return x[k] * elementary.cos(0.0)

@kernel
def high(x):
    x[1:] = x[:-1] + low(x, 0)
    return x.sum()

assert high(np.ones(3)) == 5.0
after = look()
changed = [name for name, value in before.items() if after.get(name) is not value]
number = bytecode.FunctionIdentity.from_function(warm).unique_id
print(json.dumps([changed, len(before), number, current_target()]))
"""


def test_numba_is_left_as_it_is() -> None:
    done = subprocess.run([sys.executable, "-c", LOOK], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    changed, looked_at, number, target = json.loads(done.stdout)
    assert changed == []
    assert looked_at > 5000
    assert number < 100_000  # numba counts functions from 1 on
    assert target == "cpu"
