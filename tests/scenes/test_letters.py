"""Nothing that is to be read is smaller than it can be: every scene in a window with its panel open."""

from __future__ import annotations

import pytest

from game.app.commands.window_picture import picture_of_window
from game.app.stagehand.opening import Opening
from game.scenes import CATALOGUE
from game.ui.look.fonts import FontBook

LEAST_PX = 11
SIZE = (1280, 720)


@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
def test_no_letters_are_below_eleven_pixels(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: set[tuple[int, str]] = set()
    plain = FontBook.font

    def font(self: FontBook, size: float, weight: str = "medium"):
        asked.add((max(self.least, round(size * self.k)), weight))
        return plain(self, size, weight)

    monkeypatch.setattr(FontBook, "font", font)
    stage = Opening().make_stage(CATALOGUE[name].load())
    stage.run(2)
    picture_of_window(stage, CATALOGUE, SIZE, "dark")
    words = {(px, weight) for px, weight in asked if not weight.startswith("formula")}  # indices are smaller
    assert words, "something was written"
    assert min(words)[0] >= LEAST_PX
