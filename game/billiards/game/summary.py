"""From a played shot to what the referee sees of it: the summary that `rules` judges.

The stroke that sent a ball into its pocket is followed contact by contact. A moving ball that meets one at
rest sends it on its way; where both move, each counts as sent on by the other. A ball that comes back to one
that it owes its motion to does not send that one: a chain names no ball twice.
"""

from __future__ import annotations

from game.billiards.game.rules import CUE_BALL, Pocketing, ShotSummary
from game.billiards.laws import state as s
from game.billiards.shot.crossing import short_contact
from game.billiards.shot.trajectory import Trajectory
from game.billiards.table.rack import HEAD_SPOT

MOUTH = 4.0  # ball radii that the mouth of a pocket reaches beyond its circle
FROZEN = 1e-4  # m; a ball that is so near to a cushion lies against it
STOPS = (s.ROLLING_STATIONARY, s.ROLLING_SPINNING, s.SPINNING_STATIONARY)

Row = tuple[float, int, int, int]


def summarize(trajectory: Trajectory) -> ShotSummary:
    """Summary of a played shot whose balls are named by their numbers, the cue ball "0".

    ValueError if a ball's name is no number.
    """
    numbers = ball_numbers(trajectory.shot.ids)
    rows: list[Row] = [(t, int(e), int(i), int(j)) for t, e, i, j in trajectory.rows.tolist()]
    cue = numbers.index(CUE_BALL) if CUE_BALL in numbers else -1
    first_time = next((t for t, e, i, j in rows if e == s.BALL_BALL and cue in (i, j)), None)
    first = tuple(
        numbers[j if i == cue else i] for t, e, i, j in rows
        if t == first_time and e == s.BALL_BALL and cue in (i, j)
    )  # fmt: skip
    end = trajectory.end
    rest = tuple(
        (number, *row[s.IN_X : s.IN_X + 2]) for number, row in zip(numbers, end.tolist(), strict=True)
        if int(row[s.IN_MOTION]) not in (s.POCKETED, s.OFF_TABLE)
    )  # fmt: skip
    touched = [k for _, e, i, j in rows if e == s.BALL_BALL for k in (i, j)]
    return ShotSummary(
        first,
        _pocketings(trajectory, rows, numbers, cue),
        any(e == s.BALL_POCKET and i == cue for _, e, i, _ in rows),
        tuple(numbers[k] for k in _cushioned(trajectory, rows, first_time)),
        tuple(numbers[i] for _, e, i, _ in rows if e == s.BALL_OFF),
        _cue_path(rows, numbers, cue),
        tuple(numbers[k] for k in dict.fromkeys(touched) if k != cue),
        rest,
        first_time is not None and is_short(trajectory, cue, numbers.index(first[0]), first_time),
    )


def ball_numbers(ids: tuple[str, ...]) -> list[int]:
    """Numbers of balls by their names; ValueError if one is none."""
    try:
        return [int(name) for name in ids]
    except ValueError:
        raise ValueError(f"balls: games need numbers for names, got {', '.join(ids)}") from None


def _pocketings(
    trajectory: Trajectory, rows: list[Row], numbers: list[int], cue: int
) -> tuple[Pocketing, ...]:
    """The numbered balls that went down, in order, with their chains and cushions."""
    moving = [
        int(row[s.IN_MOTION]) not in (s.STATIONARY, s.POCKETED) for row in trajectory.shot.balls.tolist()
    ]
    chains: list[tuple[int, ...]] = [(k,) if moving[k] else () for k in range(len(numbers))]
    touches: list[list[float]] = [[] for _ in numbers]  # s, of cushions and jaws
    fallen = []
    at = 0
    while at < len(rows):
        time, event, i, j = rows[at]
        if event == s.BALL_BALL:
            contacts = []
            while at < len(rows) and rows[at][0] == time and rows[at][1] == s.BALL_BALL:
                contacts.append(rows[at][2:])
                at += 1
            pass_on(contacts, moving, chains)
            continue
        if event in STOPS or event == s.BALL_OFF:
            moving[i] = False
        elif event in (s.BALL_CUSHION, s.BALL_JAW):
            touches[i].append(time)
        elif event == s.BALL_POCKET:
            moving[i] = False
            if i != cue:
                chain = tuple(numbers[k] for k in chains[i])
                rails = sum(not _in_mouth(trajectory, i, j, touch) for touch in touches[i])
                fallen.append(Pocketing(numbers[i], j, chain, len(touches[i]), rails))
        at += 1
    return tuple(fallen)


def _in_mouth(trajectory: Trajectory, ball: int, pocket: int, time: float) -> bool:
    """True if a ball is in the mouth of a pocket at a time, s; its row, the pocket's."""
    x, y, radius = trajectory.shot.table.pockets[pocket].tolist()
    here, there = trajectory.state_at(time).positions[ball].tolist()
    reach = radius + MOUTH * float(trajectory.end[ball, s.IN_RADIUS])
    return (here - x) * (here - x) + (there - y) * (there - y) <= reach * reach


def pass_on(contacts: list[tuple[int, int]], moving: list[bool], chains: list[tuple[int, ...]]) -> None:
    """Contacts of one moment: from the balls that move on to those that they send, and so on."""
    waiting = list(contacts)
    while waiting:
        ready = [pair for pair in waiting if moving[pair[0]] or moving[pair[1]]] or waiting
        i, j = ready[0]
        waiting.remove((i, j))
        was_i, was_j = (moving[i], chains[i]), (moving[j], chains[j])
        for (other_moved, chain), k in ((was_i, j), (was_j, i)):
            if other_moved and chain and k not in chain and chains[k] != (k,):
                chains[k] = (*chain, k)
        moving[i] = moving[j] = True


def _cushioned(trajectory: Trajectory, rows: list[Row], first_time: float | None) -> list[int]:
    """Balls driven to a cushion after the first contact, by row, each once.

    A ball that lay against a cushion is not driven to it before it has left it.
    """
    if first_time is None:
        return []
    found: dict[int, None] = {}
    for time, event, i, j in rows:
        if event not in (s.BALL_CUSHION, s.BALL_JAW) or time < first_time or i in found:
            continue
        if event == s.BALL_CUSHION and _still_frozen(trajectory, i, j, time):
            continue
        found[i] = None
    return list(found)


def _still_frozen(trajectory: Trajectory, ball: int, cushion: int, time: float) -> bool:
    """True if a ball has been against a cushion from the start of the shot to this time."""
    x, y, _, _, nx, ny = trajectory.shot.table.cushions[cushion].tolist()
    radius = float(trajectory.end[ball, s.IN_RADIUS])
    start_x, start_y = trajectory.shot.positions[ball].tolist()
    if (start_x - x) * nx + (start_y - y) * ny - radius > FROZEN:
        return False
    for row in trajectory.segments.tolist():
        if int(row[s.SEG_BALL]) == ball and row[s.SEG_TIME] <= time:
            middle = 0.5 * (row[s.SEG_TIME] + time)
            here = trajectory.state_at(middle).positions[ball].tolist()
            for px, py in ((row[s.SEG_X], row[s.SEG_Y]), here):
                if (px - x) * nx + (py - y) * ny - radius > FROZEN:
                    return False
    return True


def is_short(trajectory: Trajectory, cue: int, ball: int, time: float) -> bool:
    """True if a ball lies behind the head string when the cue ball touches it at a time, s, not having
    crossed it yet. cue, ball: rows.
    """
    line = HEAD_SPOT * trajectory.shot.table.length
    return bool(short_contact(trajectory.segments, cue, ball, time, line))


def _cue_path(rows: list[Row], numbers: list[int], cue: int) -> tuple[tuple[str, int], ...]:
    """What the cue ball touched, in order."""
    path = []
    for _, event, i, j in rows:
        if event == s.BALL_BALL and cue in (i, j):
            path.append(("ball", numbers[j if i == cue else i]))
        elif event in (s.BALL_CUSHION, s.BALL_JAW) and i == cue:
            path.append(("cushion", j))
    return tuple(path)
