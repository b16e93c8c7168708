"""The parameters of snooker: who plays what, the stroke, the cloth, and what is shown of a stroke."""

from __future__ import annotations

from game.billiards.shot.cloths import SNOOKER_CLOTH
from game.scenes.shared.tables.cue import MAX_SPEED
from game.scenes.shared.tables.unsteady import HANDS
from game.stage import Choice, Param, Parameters, Toggle

GRADES = ("novice", "club", "expert", "master")  # of game.billiards.players.snooker
GRADE_LABELS = ("Novice", "Club player", "Expert", "Master")
PERSON = "person"
LEAST_POWER = 0.1  # m/s
LARGEST_TIP = 0.6  # ball radii
STEEPEST_DEG = 80.0
WHOLE, FIRST, NONE = GUIDES = ("whole", "first", "none")
GUIDE_LABELS = ("Full path", "To the first ball", "None")


class SnookerParameters(Parameters):
    """What of game, stroke and table can be chosen."""

    game = Choice(
        "level", ("level", "snooker", "six-red"), labels=("As the level says", "Snooker", "Six-red"),
        group="Game", rebuild=True,
    )  # fmt: skip
    first_player = Choice(
        PERSON, (PERSON, *GRADES), labels=("A person", *GRADE_LABELS),
        group="Game", label="First player", help="you, or a computer player",
    )  # fmt: skip
    second_player = Choice(
        PERSON, (PERSON, *GRADES), labels=("A person", *GRADE_LABELS),
        group="Game", label="Second player", help="you, or a computer player",
    )  # fmt: skip
    best_of = Choice(
        "open", ("open", "1", "3", "5", "7", "9"),
        labels=("No end", "1 frame", "3 frames", "5 frames", "7 frames", "9 frames"),
        group="Game", label="Best of", help="frames of a match",
    )  # fmt: skip
    miss = Choice(
        "professional", ("professional", "club", "off"), labels=("Professional", "Club", "None called"),
        group="Game", label="Miss", help="how good an attempt the referee expects (rule 3.14)",
    )  # fmt: skip
    considered = Toggle(
        False, group="Game", label="Show its thoughts", help="the pots that a computer player considered"
    )
    power = Param(
        3.0, LEAST_POWER, MAX_SPEED, unit="m/s", group="Stroke",
        help="speed of a ball that is struck in its middle",
    )  # fmt: skip
    tip_left = Param(0.0, -LARGEST_TIP, LARGEST_TIP, unit="R", group="Stroke", label="Tip left")
    tip_up = Param(0.0, -LARGEST_TIP, LARGEST_TIP, unit="R", group="Stroke", label="Tip up",
                   help="follow above, draw below")  # fmt: skip
    elevation = Param(0.0, 0.0, STEEPEST_DEG, unit="°", group="Stroke", help="of the butt of the cue")
    guide = Choice(
        "auto", ("auto", *GUIDES), labels=("As suits the game", *GUIDE_LABELS), group="Stroke",
        help="what is shown of a stroke before it: in practice its whole path, else that to the first ball",
    )  # fmt: skip
    events = Param(
        30, 1, 120, whole=True, group="Stroke", label="Events ahead", help="where a whole path ends"
    )
    magnifier = Choice(
        "auto", ("auto", "on", "off"), labels=("Where balls are small", "Always", "Never"), group="Stroke",
        help="the contact that is aimed at, seen from near",
    )  # fmt: skip
    hand = Choice(
        "none", tuple(HANDS), group="Stroke", label="Noise of the hand",
        help="how far a person's tip, elevation, azimuth and speed stray, as a computer player's do",
    )  # fmt: skip
    sliding = Param(SNOOKER_CLOTH.sliding, 0.02, 0.6, group="Table", label="Sliding friction",
                    help="of ball and cloth")  # fmt: skip
    rolling = Param(SNOOKER_CLOTH.rolling, 0.002, 0.05, group="Table", label="Rolling resistance")
    ball_restitution = Param(SNOOKER_CLOTH.ball_restitution, 0.5, 1.0, group="Table",
                             label="Ball restitution")  # fmt: skip
    cushion_restitution = Param(SNOOKER_CLOTH.cushion_restitution, 0.3, 1.0, group="Table",
                                label="Cushion restitution")  # fmt: skip
