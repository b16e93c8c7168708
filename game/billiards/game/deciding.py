"""Which strokes of a match decided it: those that won its last racks, and the highest run."""

from __future__ import annotations

from game.billiards.game.log import START, Log, Logged

LAST_RACKS = 3  # whose winning strokes count
MOST_OF_RUN = 8  # strokes of the highest run, its last ones


def line_of(log: Log) -> list[Logged]:
    """The strokes that led to the frame in play, the oldest first; what was taken back is left out."""
    found: list[Logged] = []
    at = log.at
    while at != START and (entry := log.find(at)) is not None:
        found.append(entry)
        at = entry.after
    return found[::-1]


def highest_run(line: list[Logged]) -> list[Logged]:
    """The strokes by which a player has potted most balls one after the other; of equal runs the first."""
    best: list[Logged] = []
    run: list[Logged] = []
    for entry in line:
        scores = bool(entry.down) and not entry.foul
        goes_on = bool(run) and run[-1].rack == entry.rack and run[-1].shooter == entry.shooter
        run = ([*run, entry] if goes_on else [entry]) if scores else []
        if sum(len(one.down) for one in run) > sum(len(one.down) for one in best):
            best = run
    return best


def deciding_strokes(log: Log) -> tuple[Logged, ...]:
    """The strokes that decided a match, as they were played; none before a ball is down."""
    line = line_of(log)
    winning = [entry for entry in line if entry.winner][-LAST_RACKS:]
    run = highest_run(line)[-MOST_OF_RUN:]
    numbers = {entry.number for entry in (*winning, *run)}
    return tuple(entry for entry in line if entry.number in numbers)
