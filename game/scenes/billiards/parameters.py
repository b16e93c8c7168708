"""The parameters of the billiard game: who plays what, the stroke, the table and its balls."""

from __future__ import annotations

from game.scenes.billiards.beside import BESIDE, BESIDE_LABELS
from game.scenes.billiards.level import MOST_RADIUS_SPREAD
from game.scenes.billiards.opponents.thinking import GRADE_LABELS, GRADES
from game.scenes.billiards.stroke.guide import GUIDE_LABELS, GUIDES
from game.scenes.shared.tables.cue import MAX_SPEED
from game.scenes.shared.tables.unsteady import HANDS
from game.stage import Choice, Param, Parameters, Toggle

OWN = "own"  # hand
LEAST_POWER = 0.1  # m/s
LARGEST_TIP = 0.6  # ball radii
STEEPEST_DEG = 80.0
TABLE_PARAMETERS = (
    "sliding", "rolling", "ball_restitution", "cushion_restitution", "slate_restitution", "cushion_hop",
)  # fmt: skip


class BilliardsParameters(Parameters):
    """What of game and table can be chosen."""

    game = Choice(
        "level",
        (
            "level", "eight-ball", "nine-ball", "combination", "practice",
            "ghost-nine-ball", "ghost-ten-ball", "ghost-eight-ball",
        ),
        labels=(
            "As the level says", "8-ball", "9-ball", "Combination match", "Practice", "9-ball ghost",
            "10-ball ghost", "8-ball ghost",
        ),
        group="Game", rebuild=True,
    )  # fmt: skip
    first_player = Choice(
        "person", ("person", *GRADES), labels=("A person", *GRADE_LABELS),
        group="Game", label="First player", help="you, or a computer player",
    )  # fmt: skip
    second_player = Choice(
        "person", ("person", *GRADES), labels=("A person", *GRADE_LABELS),
        group="Game", label="Second player", help="you, or a computer player",
    )  # fmt: skip
    beside = Choice(
        "none", BESIDE, labels=BESIDE_LABELS, group="Game", label="Beside the table",
        help="strokes to go back to, every pot there is, or what was practised",
    )  # fmt: skip
    race = Choice(
        "open", ("open", "1", "3", "5", "7"), labels=("No end", "1 rack", "3 racks", "5 racks", "7 racks"),
        group="Game", label="Race to", help="so many racks win the match",
    )  # fmt: skip
    considered = Toggle(
        False, group="Game", label="Show its thoughts", help="the strokes that a computer player considered"
    )
    power = Param(
        4.0, LEAST_POWER, MAX_SPEED, unit="m/s", group="Stroke",
        help="speed of a ball that is struck in its middle",
    )  # fmt: skip
    tip_left = Param(0.0, -LARGEST_TIP, LARGEST_TIP, unit="R", group="Stroke", label="Tip left")
    tip_up = Param(0.0, -LARGEST_TIP, LARGEST_TIP, unit="R", group="Stroke", label="Tip up",
                   help="follow above, draw below")  # fmt: skip
    elevation = Param(0.0, 0.0, STEEPEST_DEG, unit="°", group="Stroke", help="of the butt of the cue")
    guide = Choice(
        "auto", ("auto", *GUIDES), labels=("As suits the game", *GUIDE_LABELS), group="Stroke",
        formerly={True: "auto", False: "none"},  # of a toggle
        help="what is shown of a stroke before it: in practice its whole path, else that to the first ball",
    )  # fmt: skip
    events = Param(
        30, 1, 120, whole=True, group="Stroke", label="Events ahead", help="where a whole path ends"
    )
    hand = Choice(
        "none", tuple(HANDS), group="Stroke", label="Noise of the hand",
        help="how far a person's tip, elevation, azimuth and speed stray, as a computer player's do",
    )  # fmt: skip
    cloud = Toggle(
        False, group="Stroke", label="Landing cloud", help="where the cue ball ends for the noise of a hand"
    )
    odds = Choice(
        "club", (*GRADES, OWN), labels=(*GRADE_LABELS, "Your own, measured"), group="Stroke",
        label="Hand of map and cloud", help="your own is measured from your strokes with a noise of the hand",
    )  # fmt: skip
    sliding = Param(0.2, 0.02, 0.6, group="Table", label="Sliding friction", help="of ball and cloth")
    rolling = Param(0.01, 0.002, 0.05, group="Table", label="Rolling resistance")
    ball_restitution = Param(0.95, 0.5, 1.0, group="Table", label="Ball restitution")
    cushion_restitution = Param(0.85, 0.3, 1.0, group="Table", label="Cushion restitution")
    slate_restitution = Param(
        0.5, 0.0, 0.9, group="Table", label="Slate restitution", help="of a ball that falls on the bed"
    )
    cushion_hop = Param(
        0.0, 0.0, 1.0, group="Table", label="Hop off cushions",
        help="share of the slate's restitution that is left when a cushion presses a ball down",
    )  # fmt: skip
    radius_spread = Param(
        0.0, 0.0, MOST_RADIUS_SPREAD, group="Balls", rebuild=True, help="how much smaller some balls are"
    )
    mass_spread = Param(0.0, 0.0, 0.9, group="Balls", rebuild=True, help="how much the densities differ")
