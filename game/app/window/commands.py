"""All commands of the program: one table that names them, words them and gives each its key.

What is printed anywhere about a command is read from here: the card of keys, the row of hints, the help page,
the card of a pause and the menu's foot. What a command does stands in one table as well, by the same names:
`Screen.actions` of the screen that is on top, and `App.actions` for the whole program.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

Actions = Mapping[str, Callable[[], object]]  # what each command does, by its name


class Command(NamedTuple):
    """Something that a key does: its name, its words, and its key unless the settings say otherwise.

    The card of keys shows all of them. ``hint``: words in a scene's row of hints, ``foot``: in the menu's
    foot. ``helps``: it stands on a scene's help page, ``choice``: in the card of a pause. ``repeats``: a key
    that is held gives the command again and again.
    """

    name: str
    label: str
    key: str
    hint: str = ""
    foot: str = ""
    helps: bool = False
    choice: bool = False
    repeats: bool = False

    @property
    def heading(self) -> str:
        """The label as a line of its own."""
        return self.label[0].upper() + self.label[1:]


COMMANDS = (
    Command("pause", "pause and go on", "space", "pause", helps=True),
    Command("step", "one step", "period", "step", helps=True, repeats=True),
    Command("step-back", "one step back", "comma", "step back", helps=True, repeats=True),
    Command("undo", "undo the last thing done by hand", "ctrl+z", helps=True),
    Command("reset", "begin again", "backspace", helps=True, choice=True),
    Command("pause-menu", "what can be done", "p", helps=True),
    Command("slower", "slower", "minus", repeats=True),
    Command("faster", "faster", "equals", repeats=True),
    Command("view", "whole view", "home"),
    Command("story", "take over a story, or go on with it", "f6"),
    Command("marks", "teaching marks of a story", "f7"),
    Command("film", "film this, or the last ten seconds", "f9", helps=True, choice=True),
    Command("tools", "ruler, protractor, stop-watch, charts", "f8", helps=True, choice=True),
    Command("charts", "a chart of any readout", "f5", helps=True, choice=True),
    Command("accuracy", "what accuracy costs", "a", "accuracy", helps=True),
    Command("levels", "levels and hard cases", "l", "levels", helps=True, choice=True),
    Command("panel", "panel on and off", "tab"),
    Command("next", "next scene", "pagedown", choice=True),
    Command("previous", "previous scene", "pageup"),
    Command("save", "save level and recording", "ctrl+s", helps=True, choice=True),
    Command("teach", "save as a teaching level", "ctrl+t", choice=True),
    Command("open", "open what was saved", "ctrl+o", helps=True, choice=True),
    Command("copy", "copy the stroke or the run as text", "ctrl+shift+c", helps=True, choice=True),
    Command("give", "copy the stroke for the other player", "ctrl+shift+x", helps=True, choice=True),
    Command("paste", "open a run, or play a stroke, from the clipboard", "ctrl+v", helps=True, choice=True),
    Command("favourite", "favourite or not, in the menu", "ctrl+f", foot="favourite"),
    Command("help", "help", "f1", "help", "keys", choice=True),
    Command("tour", "tour of the window", "f3", choice=True),
    Command("papers", "papers of the course", "f4"),
    Command("career", "career: ladder, matches, cups", "ctrl+k"),
    Command("challenge", "challenge of the day", "ctrl+d"),
    Command("theme", "dark or light", "f2", foot="theme"),
    Command("settings", "settings", "f10", foot="settings", choice=True),
    Command("full-screen", "full screen", "f11", foot="full screen"),
    Command("screenshot", "picture", "f12", foot="picture"),
    Command("back", "back to the menu", "escape", choice=True),
    Command("quit", "leave Carom", "ctrl+q", choice=True),
)
BY_NAME: Mapping[str, Command] = {command.name: command for command in COMMANDS}


def perform(name: str, actions: Actions) -> bool:
    """Do what a table says a command does; False if it does not name it."""
    action = actions.get(name)
    if action is None:
        return False
    action()
    return True
