"""What a level of a cavity may say."""

from __future__ import annotations

from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations


class CavityContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level: what its readouts are expected to become."""

    expected: Expectations = ()


DEFAULT = CavityContent()
