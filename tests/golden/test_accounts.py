"""Every scene tells of itself what it told when its accounts were kept.

What it measures, says, draws and comes to: in every level, under a hand, with its parameters. Whoever means
a change writes them anew with `python -m tests.golden SCENE` and reads the difference.
"""

from __future__ import annotations

import pytest

from game.app.stagehand.headless import prepare
from game.scenes import CATALOGUE
from tests.golden import kept
from tests.golden.accounts import account_of, levels_of, written_with

pytestmark = pytest.mark.compiled
SHOWN = 12  # differences in a message


@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
def test_a_scene_tells_what_it_told(name: str) -> None:
    prepare()
    account = kept.read(name)
    if account["with"] != written_with():
        pytest.skip(f"its accounts were kept with {account['with']}")
    found = list(kept.differences(account, account_of(name)))
    more = f"and {len(found) - SHOWN} more" if len(found) > SHOWN else ""
    meant = f"if that is meant: python -m tests.golden {name}"
    assert not found, "\n".join([name, *found[:SHOWN], more, meant])


def test_every_scene_and_level_is_told_of() -> None:
    assert sorted(file.stem for file in kept.FOLDER.iterdir()) == sorted(entry.name for entry in CATALOGUE)
    for entry in CATALOGUE:
        levels = [file.stem for file in levels_of(entry.name)]
        assert sorted(kept.read(entry.name)["levels"]) == sorted(levels)


def test_every_hand_is_undone() -> None:
    assert [entry.name for entry in CATALOGUE if kept.read(entry.name)["hand"]["undone"] != "yes"] == []
