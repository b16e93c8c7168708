"""The ladder: eight players with names, each a style and a hand over the players that there are.

One table for all cue games. A row says which of them its player plays. `graded` makes of it a grade of pool,
snooker or carom, which decides as every other grade does. How strong each is was measured, not
typed: see `ladder_ratings`.
"""

from __future__ import annotations

from typing import NamedTuple

from game.billiards.players.taste import Hand, Taste

POOL, SNOOKER, CAROM = FAMILIES = ("billiards", "snooker", "carom")  # as of `game.register`
# A pot on twelve feet forgives less than one on nine: the same player's hand there, as the grades have it.
STEADIER = {POOL: 1.0, SNOOKER: 0.42, CAROM: 0.9}


class LadderPlayer(NamedTuple):
    """A player of the ladder.

    name: for settings and files; title: for people. style: in two words; about: a sentence. games: families
    that it plays. looks: the grade whose way of looking it has. unsteady: times the usual noise of a hand at
    pool, which `hand` divides among aim, speed and spin. taste: what it likes. schooled: the family that it
    has practised most, where its hand is a quarter steadier.
    """

    name: str
    title: str
    style: str
    about: str
    games: tuple[str, ...]
    looks: str
    unsteady: float
    hand: Hand
    taste: Taste
    schooled: str = ""

    def unsteady_at(self, family: str) -> float:
        """How many times the usual noise its hand has at the games of a family."""
        return self.unsteady * STEADIER[family] * (0.75 if family == self.schooled else 1.0)


LADDER = (
    LadderPlayer(
        "tom", "Tom Hale", "Beginner", "Plays what goes in most often, and never thinks of the next ball.",
        FAMILIES, "novice", 4.2, Hand(1.0, 1.0, 1.0), Taste(pot=1.0),
    ),
    LadderPlayer(
        "rocco", "Rocco Vale", "Gambler", "Loves banks and long chances, and trusts his hand too much.",
        FAMILIES, "expert", 3.0, Hand(1.0, 1.2, 1.0), Taste(bank=0.2, confidence=2.5),
    ),
    LadderPlayer(
        "greta", "Greta Lind", "Safety player", "Rather leaves you nothing than takes a chance herself.",
        FAMILIES, "club", 2.5, Hand(1.0, 0.8, 1.0), Taste(safety=0.15),
    ),
    LadderPlayer(
        "ines", "Ines Duarte", "Potter", "Takes every ball that can go in, with a steady aim.",
        FAMILIES, "expert", 2.1, Hand(0.75, 1.2, 1.3), Taste(pot=0.8),
    ),
    LadderPlayer(
        "kenji", "Kenji Mori", "Position player", "Plays for the next ball; speed and spin are his strength.",
        FAMILIES, "expert", 1.6, Hand(1.1, 0.7, 0.7), Taste(),
    ),
    LadderPlayer(
        "marie", "Marie Dufour", "Three-cushion artist", "Sees ways by the cushions where others see none.",
        (POOL, CAROM), "master", 1.3, Hand(1.0, 0.9, 0.7), Taste(bank=0.08), CAROM,
    ),
    LadderPlayer(
        "sean", "Sean Brady", "Break builder", "Once in, he stays in: every pot is played for the one after.",
        (POOL, SNOOKER), "master", 1.1, Hand(0.9, 0.8, 1.0), Taste(), SNOOKER,
    ),
    LadderPlayer(
        "vera", "Vera Novak", "Champion", "Has no weakness, and waits for yours.",
        FAMILIES, "master", 0.7, Hand(), Taste(),
    ),
)  # fmt: skip
BY_NAME = {player.name: player for player in LADDER}


def ladder_of(family: str) -> tuple[LadderPlayer, ...]:
    """Who of the ladder plays the games of a family, in the table's order."""
    return tuple(player for player in LADDER if family in player.games)
