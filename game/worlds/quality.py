"""How finely a scene is computed, by one choice: play, teach, film, or as many parts as one says."""

from __future__ import annotations

from typing import NamedTuple

from game.stage import Choice

OWN = "own"


class Quality(NamedTuple):
    """How many parts each quality has, and in words of what."""

    play: int
    teach: int
    film: int
    of: str

    def choose(self, default: str, group: str, more: str = "", rebuild: bool = True) -> Choice:
        """``tier``. more: what else its help says; rebuild: the scene begins anew with another one."""
        return Choice(
            default, ("play", "teach", "film", OWN), labels=("Play", "Teach", "Film", "Own"), group=group,
            label="Quality", rebuild=rebuild,
            help=f"{self.of}: {self.play}, {self.teach}, {self.film}, or as many as you say{more}",
        )  # fmt: skip

    def parts(self, tier: str, own: float) -> int:
        """How many there are with a choice; ``own``: with one's own."""
        return int(own) if tier == OWN else int(getattr(self, tier))
