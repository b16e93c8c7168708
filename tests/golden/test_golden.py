"""The kept digests: one for every level. `game selftest --golden FILE` compares them."""

import json
from pathlib import Path

from game.levels import level_files
from game.scenes import CATALOGUE


def test_every_level_has_a_digest():
    kept = json.loads(Path(__file__).with_name("scenes.json").read_text(encoding="utf-8"))
    levels = {f"{entry.name}/{file.stem}" for entry in CATALOGUE for file in level_files(entry.name)}
    assert set(kept) == levels
    assert all(len(digest) == 32 and int(digest, 16) >= 0 for digest in kept.values())
