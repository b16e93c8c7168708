"""The help page of a scene, made from its declarations: what you see, equations, controls, what to try."""

from __future__ import annotations

import inspect
from collections.abc import Sequence

from game.stage import Scene
from game.ui.look.look import Look
from game.ui.widgets import keycap
from game.ui.widgets.column import Column
from game.ui.widgets.sheetpage import Link, Section, SheetPage

KeyRow = tuple[Sequence[str], str]


def paragraphs_of(scene_type: type[Scene]) -> list[str]:
    """The paragraphs of a scene's docstring, each in one line."""
    text = inspect.cleandoc(scene_type.__doc__ or "")
    return [" ".join(part.split()) for part in text.split("\n\n") if part.strip()]


class HelpPage(SheetPage):
    """The page as an overlay.

    ``controls``: rows of keys and words that every scene has. ``level``: title and words of the level in
    play, which come first. ``links``: buttons in the head.
    """

    def __init__(
        self,
        look: Look,
        scene_type: type[Scene],
        controls: Sequence[KeyRow] = (),
        level: tuple[str, str] = ("", ""),
        links: Sequence[Link] = (),
    ) -> None:
        super().__init__(look, links)
        self.scene_type = scene_type
        self.chip, self.title = scene_type.task, scene_type.title
        self.level = level
        self.controls = tuple(controls)

    def sections(self) -> tuple[Section, Section, Section]:
        return self._write_seen, self._write_equations, self._write_controls

    def _write_seen(self, column: Column) -> None:
        title, about = self.level
        if title and about:
            column.head(title)
            column.paragraph(about, color="text1")
            column.space(8)
        column.head("What you see")
        for i, words in enumerate(paragraphs_of(self.scene_type)):
            column.paragraph(words)
            if i == 0 and self.scene_type.figure is not None:
                column.figure(self.scene_type.figure)
        effects = tuple(self.scene_type.effects)
        if effects:
            column.space(8)
            column.head("Effects")
            for effect in effects:
                column.named(effect.label, effect.help)

    def _write_equations(self, column: Column) -> None:
        if self.scene_type.equations:
            column.head("Equations")
            for equation in self.scene_type.equations:
                column.equation(equation)

    def _write_controls(self, column: Column) -> None:
        if self.scene_type.try_this:
            column.head("Try this")
            for i, words in enumerate(self.scene_type.try_this):
                column.numbered(i + 1, words)
            column.space(8)
        column.head("Controls")
        for hint in self.scene_type.hints:
            column.control(hint.keys, hint.text)
        hinted = {keys for hint in self.scene_type.hints for keys in hint.keys}
        for action in self.scene_type.actions:
            if keycap.key_name(action.key) in hinted:
                continue
            column.control((keycap.key_name(action.key),), action.label)
        for keys, words in self.controls:
            column.control(keys, words)
