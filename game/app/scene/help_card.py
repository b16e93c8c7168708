"""The help page of a scene, with the keys that every scene has."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from game.app.screens.page_screen import PageScreen
from game.stage import Scene
from game.ui.widgets.helppage import HelpPage

if TYPE_CHECKING:
    from game.app.application import App

SHOWN = (
    ("pause", "pause and go on"),
    ("step", "one step"),
    ("step-back", "one step back"),
    ("reset", "begin anew"),
    ("accuracy", "what accuracy costs"),
    ("levels", "levels and hard cases"),
    ("save", "save level and recording"),
    ("open", "open what was saved"),
    ("pause-menu", "all else"),
)


class HelpCard(PageScreen):
    """Made from the scene's declarations; F1 closes it as well."""

    called: ClassVar[str] = "Help"

    def __init__(self, app: App, scene_type: type[Scene]):
        rows = [
            ((app.keys.label(name),), words)
            for name, words in SHOWN
            if name != "accuracy" or scene_type.study
        ]
        if "wheel" not in scene_type.takes:
            rows.append((("Wheel",), "zoom"))
        super().__init__(app, HelpPage(app.look, scene_type, rows))

    def command(self, name: str) -> bool:
        if name == "help":
            self.close()
            return True
        return super().command(name)
