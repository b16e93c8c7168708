"""How far a ball goes that nothing is in the way of: the speed of a stroke in lengths of the table."""

from __future__ import annotations

from game.billiards.shot.shot import Physics

ROLLING_SHARE = 5.0 / 7.0  # of its first speed that a ball sliding without spin rolls with


def free_run(speed: float, physics: Physics) -> float:
    """How far, m, a ball goes that sets off without spin at a speed (m/s): sliding until it rolls at 5/7 of its
    speed, then rolling to rest (Alciatore, TP 4.1); cushions take nothing. Infinite without rolling resistance.
    """
    rolling = speed if physics.sliding <= 0.0 else ROLLING_SHARE * speed
    slid = 0.0
    if physics.sliding > 0.0:
        slid = (speed * speed - rolling * rolling) / (2.0 * physics.sliding * physics.gravity)
    if physics.rolling <= 0.0:
        return float("inf")
    return slid + rolling * rolling / (2.0 * physics.rolling * physics.gravity)
