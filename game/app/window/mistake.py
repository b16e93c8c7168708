"""A user's mistake: one line that says what is wrong with the input, never a traceback."""

from __future__ import annotations

from game.app.window.words import printable


class MistakeError(Exception):
    """Something the user gave or asked for does not work; the message is the whole answer.

    ``status`` is the exit status: 2 for wrong input, 1 for a run that failed.
    """

    def __init__(self, message: str, status: int = 2):
        super().__init__(printable(" ".join(message.split())))
        self.status = status
