"""A knock-out of eight, or of four: who meets whom, who goes on, and who has the cup.

The field is seeded by strength: the first is drawn against the last, and the first two can only meet in the
final. It is text and numbers only, so that it can be kept in a file.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import msgspec

EIGHT, FOUR = 8, 4
# places of the draw, by strength: 1-8, 4-5, 2-7, 3-6; and 1-4, 2-3
ORDERS = {EIGHT: (0, 7, 3, 4, 1, 6, 2, 5), FOUR: (0, 3, 1, 2)}
ROUNDS = ("Quarter-final", "Semi-final", "Final")


class Knockout(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A tournament. field: eight or four names in the order of the draw; winners: of each match played, in
    order. Of eight, matches 0 to 3 are quarter-finals, 4 and 5 semi-finals, 6 is the final.
    """

    field: tuple[str, ...]
    winners: tuple[str, ...] = ()

    @property
    def champion(self) -> str:
        """Who has the cup; empty while it goes on."""
        last = len(self.field) - 1
        return self.winners[last - 1] if len(self.winners) == last else ""

    @property
    def rounds(self) -> tuple[tuple[str, range], ...]:
        """Name and matches of each round."""
        found, first, count = [], 0, len(self.field) // 2
        while count:
            found.append(range(first, first + count))
            first, count = first + count, count // 2
        return tuple(zip(ROUNDS[-len(found) :], found, strict=True))

    def pair(self, match: int) -> tuple[str, str]:
        """Who plays a match. ValueError for one whose players are not known yet."""
        half = len(self.field) // 2
        if 0 <= match < half:
            return self.field[2 * match], self.field[2 * match + 1]
        before = next((matches.start for _, matches in self.rounds if match in matches), None)
        if before is None or len(self.winners) < before:
            raise ValueError(f"match {match}: its players are not known")
        first = 2 * (match - half)
        return self.winners[first], self.winners[first + 1]

    @property
    def next_pair(self) -> tuple[str, str] | None:
        """Who plays next; None once the cup is won."""
        return None if self.champion else self.pair(len(self.winners))

    @property
    def round_name(self) -> str:
        """The round that is being played."""
        played = len(self.winners)
        return next((name for name, matches in self.rounds if played < matches.stop), ROUNDS[-1])

    def is_out(self, name: str) -> bool:
        """Whether a player has lost a match."""
        return any(name in self.pair(k) and winner != name for k, winner in enumerate(self.winners))

    def reached(self, name: str) -> int:
        """How far a player came: 0 a quarter-final, 1 a semi-final, 2 the final, 3 the cup."""
        return len(ROUNDS) - len(self.rounds) + self.winners.count(name)

    def with_winner(self, name: str) -> Knockout:
        """After the next match. ValueError if the cup is won, or for a name that does not play it."""
        pair = self.next_pair
        if pair is None:
            raise ValueError("tournament: the cup is won")
        if name not in pair:
            raise ValueError(f"tournament: {name} does not play {pair[0]} - {pair[1]}")
        return Knockout(self.field, (*self.winners, name))


def draw(strengths: Mapping[str, float]) -> Knockout:
    """The draw of eight players, or of four, by strength. ValueError for another number of them."""
    if len(strengths) not in ORDERS:
        raise ValueError(f"draw: {len(strengths)} players, expected {EIGHT} or {FOUR}")
    ranked = sorted(strengths, key=lambda name: (-strengths[name], name))
    return Knockout(tuple(ranked[place] for place in ORDERS[len(ranked)]))


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
    for name, matches in cup.rounds:
        rows = []
        for match in matches:
            try:
                pair = cup.pair(match)
            except ValueError:
                pair = ("", "")
            rows.append((*pair, cup.winners[match] if match < len(cup.winners) else ""))
        found.append((name, tuple(rows)))
    return found
