"""What can be chosen of the view from the cue, declared once for every table."""

from __future__ import annotations

from game.scenes.shared.tables.moments import OFF, PERSPECTIVE
from game.stage import Choice, Param, Toggle

GROUP = "View from the cue"
LEAST_SIZE, MOST_SIZE = 0.22, 0.80  # of the bed's length
LOWEST, HIGHEST = 0.12, 1.20  # m
SIDES = {False: "Side view", True: "Above"}  # what a button offers, by where a replay is seen from


def shown() -> Toggle:
    """Whether the view from the cue lies over a corner of the table."""
    return Toggle(False, group=GROUP, label="Show it", help="the table as you see it over the cue")


def size() -> Param:
    """How broad the view is."""
    return Param(0.36, LEAST_SIZE, MOST_SIZE, group=GROUP, label="Size", help="share of the table's length")


def height() -> Param:
    """Where the eye is above the cloth."""
    return Param(0.32, LOWEST, HIGHEST, unit="m", group=GROUP, label="Height of the eye")


def tilt() -> Param:
    """How much farther down the eye looks."""
    return Param(
        0.0, -12.0, 30.0, unit="°", group=GROUP, label="Look down", help="beyond the cue ball low in view"
    )


def follow() -> Choice:
    """Whether a camera follows the ball that decides while balls roll."""
    return Choice(
        OFF, (OFF, PERSPECTIVE), labels=("Seen from above", "Followed"), group=GROUP, label="Rolling balls",
        help="a camera beside the table keeps the ball that decides in view; aiming stays as it is",
    )  # fmt: skip
