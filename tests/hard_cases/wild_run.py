"""Builds and steps wild levels, each within bounds of time and memory; run as a program of its own.

    wild_run.py STEPS TAME SCENE:NUMBER …

For each level a line {"level": …} before, and one with what came of it after. Who takes too much CPU time is
ended by the system in the midst of it, with a traceback; what is being compiled does not count. Memory is
what the process may have beyond what it had before: MemoryError.
"""

from __future__ import annotations

import faulthandler
import json
import resource
import signal
import sys
import time
from pathlib import Path
from typing import Any

from numba.core import event

from game.levels import LevelError, parse_level
from game.physics.kernels.limits import LimitError
from game.scenes import CATALOGUE
from game.stage import ParameterError, Stage
from tests.hard_cases.wild_levels import wild_level

MEMORY = 2 << 30  # bytes, of a level
BUILD_S, STEP_S, ALL_S = 20.0, 5.0, 60.0  # s of CPU time; several times what was measured of any
ENOUGH_S = 10.0  # s of CPU time after which no more steps are made


class Stopwatch(event.Listener):
    """CPU time but for what the compiler takes; ends the process at a limit."""

    def __init__(self) -> None:
        self._depth, self._began, self._compiled = 0, 0.0, 0.0
        event.register("numba:compile", self)
        faulthandler.register(signal.SIGPROF, chain=True)  # and then as without a handler: the end

    def now(self) -> float:
        return time.process_time() - self._compiled

    def limit(self, seconds: float) -> None:
        signal.setitimer(signal.ITIMER_PROF, seconds)

    def on_start(self, event: Any) -> None:
        if self._depth == 0:
            self._began = time.process_time()
            self._left = signal.setitimer(signal.ITIMER_PROF, 0.0)[0]
        self._depth += 1

    def on_end(self, event: Any) -> None:
        self._depth -= 1
        if self._depth == 0:
            self._compiled += time.process_time() - self._began
            self.limit(self._left)


def say(**said: Any) -> None:
    print(json.dumps(said), flush=True)


def bound_memory() -> None:
    """Let the process take MEMORY more than it has."""
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
    hard = resource.getrlimit(resource.RLIMIT_AS)[1]
    resource.setrlimit(resource.RLIMIT_AS, (pages * resource.getpagesize() + MEMORY, hard))


def try_level(name: str, text: str, steps: int, watch: Stopwatch) -> dict[str, Any]:
    """What came of a level: refused, or how long it took to build and to step; trouble if there was any."""
    scene_type = CATALOGUE[name].load()
    began = watch.now()
    try:
        level = parse_level(text, name, scene_type.content_type)
        stage = Stage(scene_type, level=level)
    except (LevelError, ParameterError, LimitError) as error:
        return {"refused": str(error), "build_s": watch.now() - began}
    except ValueError as error:
        return {"refused": str(error), "plain": True, "build_s": watch.now() - began}
    built, longest, done = watch.now(), 0.0, 0
    for _ in range(steps):
        before = watch.now()
        if not stage.run(1):
            break
        done += 1
        longest = max(longest, watch.now() - before)
        if watch.now() - built > ENOUGH_S:
            break
    told: dict[str, Any] = {
        "build_s": built - began,
        "step_s": longest,
        "steps": done,
        "all_s": watch.now() - built,
    }
    if stage.fault is not None:
        told["fault"] = stage.fault.message
        if stage.fault.error is not None and not isinstance(stage.fault.error, LimitError):
            told["trouble"] = f"{stage.fault.quantity}: {stage.fault.message}"
    return told


def main(steps: int, tame: bool, levels: list[str]) -> None:
    watch = Stopwatch()
    for level in levels:
        name, number = level.rsplit(":", 1)
        if not hasattr(main, name):
            CATALOGUE[name].load()().advance(1e-3)  # so that what all levels take is not counted as one's
            setattr(main, name, True)
        say(level=level)
        bound_memory()
        watch.limit(ALL_S)
        try:
            told = try_level(name, wild_level(CATALOGUE[name].load(), int(number), tame), steps, watch)
        except MemoryError:
            told = {"trouble": f"more than {MEMORY >> 20} MB"}
        except Exception as error:
            told = {"trouble": f"{type(error).__name__}: {error}"}
        watch.limit(0.0)
        for name, most in (("build_s", BUILD_S), ("step_s", STEP_S)):
            if told.get(name, 0.0) > most:
                told["trouble"] = f"{name} = {told[name]:.1f} s"
        say(**told, memory_mb=resource.getrusage(resource.RUSAGE_SELF).ru_maxrss >> 10)


if __name__ == "__main__":
    main(int(sys.argv[1]), sys.argv[2] == "tame", sys.argv[3:])
