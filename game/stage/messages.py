"""What a scene has to tell, until the window shows it as fading messages."""

from __future__ import annotations

from collections import deque

from game.stage.part import Part

MOST_UNREAD = 8  # of more, the oldest are forgotten


class Messages(Part):
    """Messages that are not read yet; ``Scene.messages`` is to give ``take()``."""

    def __init__(self) -> None:
        self.unread: deque[str] = deque(maxlen=MOST_UNREAD)

    def say(self, words: str) -> None:
        """Tell something; nothing for no words."""
        if words:
            self.unread.append(words)

    def take(self) -> tuple[str, ...]:
        """What is new since the last call, oldest first."""
        new = tuple(self.unread)
        self.unread.clear()
        return new
