"""Winners of maps at random positions, replayed one by one by the exact model and judged by the referee.

    python -m tests.billiards.map.replays --winners 100000

prints how many were replayed, how many scored, and what a map cost.
"""

from __future__ import annotations

import argparse
import time
from typing import NamedTuple

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import CaromFrame, points_of
from game.billiards.game.games.carom import Carom
from game.billiards.game.games.carom_kinds import CUSHIONS
from game.billiards.map.carom import GLANCE, draw_map
from game.billiards.map.routes import touches
from game.billiards.search.strokes import Noise
from game.billiards.table.carom import RED
from tests.billiards.map.positions import position_at, random_places


class Replays(NamedTuple):
    """Counts, what failed as (places, stroke), and the processor time of a coarse map, s."""

    positions: int
    winners: int
    failures: list[tuple[object, Stroke]]
    map_s: float


def replay(winners: int, seed: int = 1, most_each: int = 60, search=GLANCE) -> Replays:
    """Draw maps of random positions until so many winners have been replayed."""
    random = np.random.default_rng(seed)
    kinds = list(CUSHIONS)
    done, positions, spent, failures = 0, 0, [], []
    while done < winners:
        places, kind, cue = random_places(random), kinds[positions % 3], int(random.integers(2))
        position = position_at(places, CUSHIONS[kind], cue)
        began = time.process_time()
        drawn = next(draw_map(position, Noise(), search))
        spent.append(time.process_time() - began)
        rows = np.flatnonzero(drawn.codes)
        if len(rows) > most_each:
            rows = random.choice(rows, most_each, replace=False)
        innings = (1, 1)
        game = Carom(kind=kind, turn=cue, innings=innings, opening=False, target=0)
        frame = CaromFrame(game, points_of(places), position.board.table, position.board.physics)
        for row in rows.tolist():
            stroke = Stroke(*drawn.strokes[row].tolist())
            played = frame.play(stroke)
            scoring = played.summary.scoring(cue)
            if not played.verdict.scored or order_of(scoring) != touches(int(drawn.codes[row])):
                failures.append((places.tolist(), stroke))
        done += len(rows)
        positions += 1
    return Replays(positions, done, failures, float(np.median(spent)))


def order_of(scoring) -> tuple[int, ...]:
    """A referee's order of touches as the digits of a route; a ball touched twice in a row counts once."""
    digits: list[int] = []
    for kind, number in scoring.order if scoring is not None else ():
        digit = number + 1 if kind == "cushion" else 6 if number == RED else 5
        if kind == "cushion" or digits[-1:] != [digit]:
            digits.append(digit)
    return tuple(digits[:20])


def main() -> None:
    """Replay as many as the command line says."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--winners", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=1)
    said = parser.parse_args()
    found = replay(said.winners, said.seed)
    print(f"{found.winners} winners of {found.positions} positions, {len(found.failures)} did not score")
    for places, stroke in found.failures[:10]:
        print("  ", places, stroke)


if __name__ == "__main__":
    main()
