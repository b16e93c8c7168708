"""What can be chosen at every cue table, declared once: the players, the stroke and the guide."""

from __future__ import annotations

from collections.abc import Mapping

from game.billiards.players.ladder import BY_NAME, ladder_of
from game.scenes.shared.tables.cue import MAX_SPEED
from game.scenes.shared.tables.unsteady import HANDS, STEADY_HAND
from game.stage import Choice, Param, Toggle

PERSON = "person"
OWN = "own"  # the player's own hand, as it was measured
GRADES = ("novice", "club", "expert", "master")  # of game.billiards.players
GRADE_LABELS = ("Novice", "Club player", "Expert", "Master")
LEAST_POWER = 0.1  # m/s
LARGEST_TIP = 0.6  # ball radii
STEEPEST_DEG = 80.0
WHOLE, FIRST, NONE = GUIDES = ("whole", "first", "none")
GUIDE_LABELS = ("Full path", "To the first ball", "None")
GUIDE_BUTTONS = {WHOLE: "Full path", FIRST: "First ball", NONE: "No guide"}


def player(label: str, family: str) -> Choice:
    """A person, the grade of a computer player, or one of the ladder that plays the games of a family."""
    ladder = ladder_of(family)
    return Choice(
        PERSON, (PERSON, *GRADES, *(one.name for one in ladder)),
        labels=("A person", *GRADE_LABELS, *(f"{one.title}, {one.style.lower()}" for one in ladder)),
        group="Game", label=label, help="you, a computer player of a grade, or one of the ladder",
    )  # fmt: skip


def head_start(unit: str) -> Param:
    """What the first player begins a match with; below 0 the second."""
    return Param(
        0, -20, 20, whole=True, group="Game", rebuild=True,
        help=f"{unit} that the first player begins with; below 0 it is the second",
    )  # fmt: skip


def ahead(head_start: float) -> tuple[int, int]:
    """What both players begin with."""
    return max(int(head_start), 0), max(-int(head_start), 0)


def thoughts() -> Toggle:
    """Whether what a computer player thought is told."""
    return Toggle(
        False, group="Game", label="Show its thoughts",
        help="the stroke that a computer player chose, its chance, and what there was instead",
    )  # fmt: skip


def player_words(grade: str) -> str:
    """What stands beside the name of a computer player; empty for one that is called by its own name."""
    return "" if grade in BY_NAME else GRADE_LABELS[GRADES.index(grade)].lower()


def coach() -> Toggle:
    """Whether the coach stands beside the table."""
    return Toggle(
        False, group="Game", label="Coach", help="after a stroke: what there was, why it missed, what is left"
    )


def power(default: float) -> Param:
    """Speed of the struck ball, m/s."""
    return Param(
        default, LEAST_POWER, MAX_SPEED, unit="m/s", group="Stroke",
        help="speed of a ball that is struck in its middle",
    )  # fmt: skip


def tip(label: str, help: str = "") -> Param:
    """Offset of the tip from the middle of the ball, ball radii."""
    return Param(0.0, -LARGEST_TIP, LARGEST_TIP, unit="R", group="Stroke", label=label, help=help)


def elevation(steepest: float = STEEPEST_DEG) -> Param:
    """How far the butt of the cue is raised, degrees."""
    return Param(0.0, 0.0, steepest, unit="°", group="Stroke", help="of the butt of the cue")


def guide(formerly: Mapping[str | bool, str] | None = None) -> Choice:
    """How much of a stroke is shown before it. formerly: as of `Choice`."""
    return Choice(
        "auto", ("auto", *GUIDES), labels=("As suits the game", *GUIDE_LABELS), group="Stroke",
        formerly=formerly,
        help="what is shown of a stroke before it: in practice its whole path, else that to the first ball",
    )  # fmt: skip


def events_ahead() -> Param:
    """How many events of a stroke the guide shows."""
    return Param(30, 1, 120, whole=True, group="Stroke", label="Events ahead", help="where a whole path ends")


def noise_of_hand(help: str) -> Choice:
    """How much a person's hand shakes."""
    return Choice(STEADY_HAND, tuple(HANDS), group="Stroke", label="Noise of the hand", help=help)


def sliding(default: float) -> Param:
    """Coefficient of friction of a sliding ball."""
    return Param(default, 0.02, 0.6, group="Table", label="Sliding friction", help="of ball and cloth")


def rolling(default: float) -> Param:
    """Coefficient of resistance of a rolling ball."""
    return Param(default, 0.002, 0.05, group="Table", label="Rolling resistance")


def ball_restitution(default: float) -> Param:
    """Coefficient of restitution of two balls."""
    return Param(default, 0.5, 1.0, group="Table", label="Ball restitution")


def cushion_restitution(default: float) -> Param:
    """Coefficient of restitution of ball and cushion."""
    return Param(default, 0.3, 1.0, group="Table", label="Cushion restitution")


def following(option: str, options: tuple[str, ...]) -> str:
    """The option after one, round the end. ValueError if it is none of them."""
    return options[(options.index(option) + 1) % len(options)]


def next_player(grade: str) -> str:
    """The player that follows: a person, then computer players from weak to strong."""
    return PERSON if grade in BY_NAME else following(grade, (PERSON, *GRADES))
