"""The help page of a scene, with the keys that every scene has."""

from __future__ import annotations

from typing import ClassVar

from game.app.screens.host import Host
from game.app.screens.page_screen import PageScreen
from game.app.window.commands import COMMANDS, Actions
from game.scenes.papers import papers_of
from game.stage import Scene
from game.ui.widgets.helppage import HelpPage
from game.ui.widgets.wishes import Wish


class HelpCard(PageScreen):
    """Made from the scene's declarations; F1 closes it as well."""

    called: ClassVar[str] = "Help"

    def __init__(self, host: Host, scene_type: type[Scene], level: tuple[str, str] = ("", "")):
        """``level``: title and words of the level in play."""
        rows = [
            ((host.keys.label(command.name),), command.label)
            for command in COMMANDS
            if command.helps and (command.name != "accuracy" or scene_type.study is not None)
        ]
        if "wheel" not in scene_type.takes:
            rows.append((("Wheel",), "zoom"))
        papers = {row.number: row for row in papers_of(scene_type.name)}
        links = [(number, f"Paper {number}") for number in reversed(papers)]
        super().__init__(host, HelpPage(host.look, scene_type, rows, level, links))
        self._papers = papers

    def fulfil(self, wish: Wish) -> None:
        self.host.cards.open_paper(self._papers[wish.name])

    @property
    def actions(self) -> Actions:
        return {**super().actions, "help": self.close}
