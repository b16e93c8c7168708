"""How tests are shared out among processes: all of a scene to one, none left out, the longest first."""

from __future__ import annotations

import pytest

from game.scenes import CATALOGUE
from tests.paths import ROOT
from tests.shares import BY_FILES, OF_EVERY_SCENE, folders_of_scenes, in_order, share_of


@pytest.mark.parametrize(
    ("test", "share"),
    [
        ("tests/scenes/boxes/test_c05.py::test_one[x]", "tests/scenes/boxes"),
        ("tests/golden/test_accounts.py::test_a_scene[c05]", "tests/scenes/boxes"),
        ("tests/scenes/test_every_story.py::test_its_end[a26/evening]", "tests/scenes/fireplace"),
        ("tests/lab/test_points_of_studies.py::a[wind-tunnel-channel-drag]", "tests/scenes/wind_tunnel"),
        ("tests/lab/test_points_of_studies.py::test_a[c01-c01-uneven]", "tests/scenes/key_frames"),
        ("tests/hard_cases/test_determinism.py::TestAll::test_two[solver-race]", "tests/scenes/solids"),
        ("tests/lab/test_points_of_studies.py::test_a[c0]", "tests/lab/test_points_of_studies.py"),
        ("tests/golden/test_accounts.py::test_every_hand_is_undone", "tests/golden"),
        ("tests/ui/test_figures.py::test_a_figure[c05]", "tests/ui"),
        ("tests/lab/test_timing.py::test_least", "tests/lab/test_timing.py"),
        ("tests/physics/solids/test_hand.py::TestHand::test_it[c05]", "tests/physics/solids"),
    ],
)  # fmt: skip
def test_a_test_goes_with_its_folder_and_that_of_a_scene_with_the_scenes(test: str, share: str) -> None:
    assert share_of(test) == share


def test_what_is_said_of_folders_and_files_is_there() -> None:
    assert set(folders_of_scenes()) == {entry.name for entry in CATALOGUE}
    assert all((ROOT / folder).is_dir() for folder in [*folders_of_scenes().values(), *BY_FILES])
    for path in OF_EVERY_SCENE:
        assert "CATALOGUE" in (ROOT / path).read_text(encoding="utf-8"), path


def test_scenes_come_first_and_of_the_others_the_large_ones() -> None:
    tests = ["tests/ui/test_a.py::test_it", "tests/physics/solids/test_b.py::test_it"]
    tests += ["tests/scenes/boxes/test_c.py::test_it", "tests/physics/solids/test_b.py::test_that"]
    tests += [f"tests/golden/test_accounts.py::test_a[{name}]" for name in ("c04", "c01", "c02", "c03")]
    found = in_order(tests)
    shares = sorted(found, key=found.__getitem__)
    assert sorted(found.values()) == list(range(len(found)))
    assert set(map(share_of, tests)) == set(found)
    first = {folders_of_scenes()[name] for name in ("c01", "c02", "c03", "c04", "c05")}
    assert set(shares[: len(first)]) == first
    assert shares[-2:] == ["tests/physics/solids", "tests/ui"]
