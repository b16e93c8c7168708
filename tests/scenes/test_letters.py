"""What is to be read is large enough and whole: every scene in a window with its panel open."""

from __future__ import annotations

import pytest

from game.app.commands.window_picture import picture_of_window
from game.app.stagehand.opening import Opening
from game.scenes import CATALOGUE
from game.ui.look.fonts import FontBook

LEAST_PX = 11
SIZE = (1280, 720)
STEPS = 20


@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
def test_no_letters_are_below_eleven_pixels_and_no_words_are_cut(name: str, monkeypatch: pytest.MonkeyPatch):
    asked: set[tuple[int, str]] = set()
    cut: set[str] = set()
    plain, whole = FontBook.font, FontBook.fit

    def font(self: FontBook, size: float, weight: str = "medium"):
        asked.add((max(self.least, round(size * self.k)), weight))
        return plain(self, size, weight)

    def fit(self: FontBook, text: str, size: float, weight: str, width: int) -> str:
        written = whole(self, text, size, weight, width)
        if written != text:
            cut.add(text)
        return written

    monkeypatch.setattr(FontBook, "font", font)
    monkeypatch.setattr(FontBook, "fit", fit)
    stage = Opening().make_stage(CATALOGUE[name].load())
    stage.run(STEPS)
    picture_of_window(stage, CATALOGUE, SIZE, "dark")
    words = {(px, weight) for px, weight in asked if not weight.startswith("formula")}  # indices are smaller
    assert words, "something was written"
    assert min(words)[0] >= LEAST_PX
    assert not cut
