"""A knock-out of eight: who meets whom, who goes on, and who has the cup.

The field is seeded by strength: the first is drawn against the eighth, and the first two can only meet in the
final. It is text and numbers only, so that it can be kept in a file.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import msgspec

EIGHT = 8
ORDER = (0, 7, 3, 4, 1, 6, 2, 5)  # places of the draw, by strength: 1-8, 4-5, 2-7, 3-6
ROUNDS = ("Quarter-final", "Semi-final", "Final")


class Knockout(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A tournament. field: eight names in the order of the draw; winners: of each match played, in order.

    Matches 0 to 3 are quarter-finals, 4 and 5 semi-finals, 6 is the final.
    """

    field: tuple[str, ...]
    winners: tuple[str, ...] = ()

    @property
    def champion(self) -> str:
        """Who has the cup; empty while it goes on."""
        return self.winners[6] if len(self.winners) == 7 else ""

    def pair(self, match: int) -> tuple[str, str]:
        """Who plays a match. ValueError for one whose players are not known yet."""
        if 0 <= match < 4:
            return self.field[2 * match], self.field[2 * match + 1]
        if match not in (4, 5, 6) or len(self.winners) < (4 if match < 6 else 6):
            raise ValueError(f"match {match}: its players are not known")
        first = 2 * (match - 4)
        return self.winners[first], self.winners[first + 1]

    @property
    def next_pair(self) -> tuple[str, str] | None:
        """Who plays next; None once the cup is won."""
        return None if self.champion else self.pair(len(self.winners))

    @property
    def round_name(self) -> str:
        """The round that is being played."""
        played = len(self.winners)
        return ROUNDS[0 if played < 4 else 1 if played < 6 else 2]

    def is_out(self, name: str) -> bool:
        """Whether a player has lost a match."""
        return any(name in self.pair(k) and winner != name for k, winner in enumerate(self.winners))

    def reached(self, name: str) -> int:
        """How far a player came: 0 lost at once, 1 a semi-final, 2 the final, 3 the cup."""
        return self.winners.count(name)

    def with_winner(self, name: str) -> Knockout:
        """After the next match. ValueError if the cup is won, or for a name that does not play it."""
        pair = self.next_pair
        if pair is None:
            raise ValueError("tournament: the cup is won")
        if name not in pair:
            raise ValueError(f"tournament: {name} does not play {pair[0]} - {pair[1]}")
        return Knockout(self.field, (*self.winners, name))


def draw(strengths: Mapping[str, float]) -> Knockout:
    """The draw of eight players by strength. ValueError for another number of them."""
    if len(strengths) != EIGHT:
        raise ValueError(f"draw: {len(strengths)} players, expected {EIGHT}")
    ranked = sorted(strengths, key=lambda name: (-strengths[name], name))
    return Knockout(tuple(ranked[place] for place in ORDER))


def play_on(cup: Knockout, person: str, decide: Callable[[str, str, int], str]) -> Knockout:
    """Let the matches be played that a person is not in, until it is at turn or the cup is won.

    decide: the winner of two players in a match of a number.
    """
    while (pair := cup.next_pair) is not None and person not in pair:
        cup = cup.with_winner(decide(*pair, len(cup.winners)))
    return cup


def rounds_of(cup: Knockout) -> Sequence[tuple[str, tuple[tuple[str, str, str], ...]]]:
    """For people: each round's name with its matches, (player, player, winner or "") as far as known."""
    found = []
    for name, matches in zip(ROUNDS, (range(4), range(4, 6), range(6, 7)), strict=True):
        rows = []
        for match in matches:
            try:
                pair = cup.pair(match)
            except ValueError:
                pair = ("", "")
            rows.append((*pair, cup.winners[match] if match < len(cup.winners) else ""))
        found.append((name, tuple(rows)))
    return found
