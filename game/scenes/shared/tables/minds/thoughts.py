"""What a computer player thought, told in two short sentences if a person asks for it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

from game.billiards.players.ladder import BY_NAME
from game.billiards.players.taste import SAFETY

if TYPE_CHECKING:
    from game.billiards.players.opponents import Decision


class Told(NamedTuple):
    """The stroke that was chosen with its chance, and what there was instead. tried: it was to score."""

    chosen: str = ""
    instead: str = ""
    tried: bool = True

    def beside(self, line: Any) -> Any:
        """A line below the table (a tuple with ``lead`` and ``more``) that tells this, too."""
        if not self.chosen:
            return line
        if not line.lead:
            return line._replace(lead=self.chosen, more=self.instead)
        return line._replace(more=" ".join((self.chosen, self.instead)))


def called(grade: str, name: str) -> str:
    """What a computer player is called: one of the ladder by its own name, else by the name in the game."""
    return BY_NAME[grade].title if grade in BY_NAME else name


def share(chance: float) -> str:
    """A chance in words."""
    return f"{round(100.0 * chance)} of 100"


def told_of(player: str, made: Decision, pot: str, in_points: bool = False) -> Told:
    """What a player thought. pot: what it wanted to pot, in words; in_points: worths are points."""
    if made.stroke is None or not made.kind:
        return Told()
    ways = {"bank": " by a bank", "kick": " by a kick", "combination": " by a combination"}
    if made.kind == SAFETY:
        chosen = f"{player} played safe: no foul in {share(made.chance)}."
    else:
        chosen = f"{player} meant {pot}{ways.get(made.kind, '')}: {share(made.chance)}."
    if math.isnan(made.safe):
        return Told(chosen, "Sure enough not to look for a safety.", made.kind != SAFETY)
    if made.kind == SAFETY:
        best = max((shot.chance for shot in made.considered), default=0.0)
        surest = f"The surest pot: {share(best)}." if best > 0.0 else "No pot was to be seen."
        return Told(chosen, surest, False)
    if in_points:
        return Told(chosen, f"Worth {made.worth:+.1f} points; the best safety {made.safe:+.1f}.")
    return Told(chosen, f"It then wins {share(made.worth)}; after the best safety {share(made.safe)}.")
