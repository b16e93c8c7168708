"""What lies below a ball in the air: bed, pocket, or the top of the rails."""

from __future__ import annotations

from game.billiards.laws import state as s
from game.billiards.laws.lean import inner_kernel
from game.billiards.table.table import CUSHION_DEPTH


@inner_kernel
def faces_cushion(x, y, cushions, k):
    """True if the foot of (x, y) on the line of cushion k lies on the cushion."""
    dx = cushions[k, s.TO_X] - cushions[k, s.FROM_X]
    dy = cushions[k, s.TO_Y] - cushions[k, s.FROM_Y]
    along = (x - cushions[k, s.FROM_X]) * dx + (y - cushions[k, s.FROM_Y]) * dy
    return 0.0 <= along <= dx * dx + dy * dy


@inner_kernel
def pocket_below(x, y, pockets):
    """The pocket whose hole (x, y) is over; -1 if none."""
    for k in range(pockets.shape[0]):
        dx = x - pockets[k, 0]
        dy = y - pockets[k, 1]
        if dx * dx + dy * dy < pockets[k, 2] * pockets[k, 2]:
            return k
    return -1


@inner_kernel
def is_over_bed(x, y, elements, physics):
    """True where there is slate, or a hole in it, below (x, y): between the noses, or in a pocket's mouth."""
    outside = max(
        max(physics[s.FREE_LEFT] - x, x - physics[s.FREE_RIGHT]),
        max(physics[s.FREE_LOWER] - y, y - physics[s.FREE_UPPER]),
    )
    if outside <= 0.0:
        return True
    if elements.pockets.shape[0] == 0 or outside > CUSHION_DEPTH:
        return False
    for k in range(elements.cushions.shape[0]):
        row = elements.cushions[k]
        gap = (x - row[s.FROM_X]) * row[s.NORMAL_X] + (y - row[s.FROM_Y]) * row[s.NORMAL_Y]
        if -CUSHION_DEPTH <= gap < 0.0 and faces_cushion(x, y, elements.cushions, k):
            return False
    for k in range(elements.jaws.shape[0]):
        dx = x - elements.jaws[k, 0]
        dy = y - elements.jaws[k, 1]
        if dx * dx + dy * dy < elements.jaws[k, 2] * elements.jaws[k, 2]:
            return False
    return True
