"""Which tests go to one process of pytest-xdist together: those of a folder, and all of a scene.

Tests of one folder use the same kernels. Those of a scene stand in its folder and, scene by scene, in some
files that go through the whole catalogue. Where one process runs all of them, no other compiles, loads and
keeps these kernels. Dealt out by files they were compiled by both of two processes, or waited for.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from functools import cache
from typing import Any

# Files whose tests are named by the scene that they run, each for a good while.
OF_EVERY_SCENE = {
    "tests/benchmarks/test_frame.py",
    "tests/golden/test_accounts.py",
    "tests/hard_cases/test_determinism.py",
    "tests/lab/test_points_of_studies.py",
    "tests/scenes/test_every_story.py",
    "tests/scenes/test_letters.py",
    "tests/scenes/test_saved_at_any_moment.py",
}
# Folders of tests that have little in common: each of their files goes alone.
BY_FILES = {"tests", "tests/benchmarks", "tests/hard_cases", "tests/lab", "tests/scenes"}
SCENES = "tests/scenes/"
EARLY = 10_000  # tests that a scene counts for: its own take longest, and the last shares should be short


@cache
def folders_of_scenes() -> dict[str, str]:
    """Folder of the tests of each scene, by the scene's name."""
    from game.scenes import CATALOGUE  # not before the session has its folders

    return {entry.name: SCENES + entry.module.split(".")[2] for entry in CATALOGUE}


@cache
def _beginning() -> re.Pattern[str]:
    """A case that is named by a scene: the longest name that fits, then its end, or what else it says."""
    names = sorted(folders_of_scenes(), key=len, reverse=True)
    return re.compile(rf"({'|'.join(map(re.escape, names))})(?=$|[-/])")


def share_of(test: str) -> str:
    """The share that a test belongs to, by its id: a folder or a file, as ``tests/scenes/boxes``."""
    path, _, name = test.partition("::")
    if path in OF_EVERY_SCENE and name.endswith("]"):
        scene = _beginning().match(name[name.index("[") + 1 : -1])
        return folders_of_scenes()[scene[1]] if scene else path
    folder = path.rpartition("/")[0]
    return path if folder in BY_FILES else folder


def in_order(tests: Iterable[str]) -> dict[str, int]:
    """Places of all shares in the queue: those of scenes first, then the others, each by its number."""
    sizes = Counter(map(share_of, tests))
    scenes = set(folders_of_scenes().values())
    weights = {share: size + EARLY * (share in scenes) for share, size in sizes.items()}
    return {share: k for k, share in enumerate(sorted(weights, key=lambda share: (-weights[share], share)))}


def scheduler(config: Any, log: Any) -> Any:
    """What hands these shares out, in the order of the tests: pytest-xdist must be there."""
    from xdist.scheduler import LoadScopeScheduling

    class ByShares(LoadScopeScheduling):
        """One share after the other to whoever has done the one before."""

        def _split_scope(self, nodeid: str) -> str:
            share = shares.get(nodeid)
            if share is None:
                share = shares[nodeid] = share_of(nodeid)
            return share

        def _assign_work_unit(self, node: Any) -> None:
            # what is done would be counted again at the end of each test
            assigned = self.assigned_work[node]
            for share in [share for share, tests in assigned.items() if all(tests.values())]:
                del assigned[share]
            super()._assign_work_unit(node)

    shares: dict[str, str] = {}
    config.option.loadscopereorder = False  # they come in order
    return ByShares(config, log)
