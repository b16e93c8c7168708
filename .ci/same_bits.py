"""One digest, whoever made the code: for a generic processor, for this very one, or no compiler at all.

    python .ci/same_bits.py [--plain SCENE ...] [SCENE ...]

Each scene's levels are run as `game selftest --golden tests/golden/scenes.json` runs them, under generic and
under native code; those after ``--plain`` in plain Python as well, which takes a hundred times as long.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import time

SAMPLE = ("lecture-balls", "c10", "c12", "p22")
PLAIN = ("lecture-balls", "c01", "pendulum", "bouncing-ball", "spring-chain")
GENERIC = {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""}
GOLDEN = "tests/golden/scenes.json"


def selftest(name: str, scenes: list[str], more: dict[str, str]) -> bool:
    """Whether all digests are the kept ones."""
    plain = {key: value for key, value in os.environ.items() if not key.startswith("NUMBA_")}
    began = time.perf_counter()
    command = [sys.executable, "-m", "game", "selftest", *scenes, "--golden", GOLDEN]
    done = subprocess.run(command, env={**plain, **more}, stdout=subprocess.PIPE, text=True)
    lines = done.stdout.splitlines()
    if done.returncode:
        print(done.stdout)
    print(f"{name}: {lines[-1] if lines else 'nothing'} in {time.perf_counter() - began:.0f} s", flush=True)
    return done.returncode == 0


def main() -> int:
    """Status 1 if a digest is another."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("scenes", nargs="*", default=SAMPLE)
    parser.add_argument("--plain", nargs="*", default=PLAIN)
    options = parser.parse_args()
    scenes = list(options.scenes)
    well = [
        selftest("generic", scenes, {**GENERIC, "CAROM_PREBUILT": "0"}),
        selftest("native", scenes, {"CAROM_PREBUILT": "0"}),
        not options.plain or selftest("plain Python", list(options.plain), {"NUMBA_DISABLE_JIT": "1"}),
    ]
    return 0 if all(well) else 1


if __name__ == "__main__":
    sys.exit(main())
