"""The parameters of carom: who plays what, the stroke, the cloth, and what is shown of the map."""

from __future__ import annotations

from game.billiards.shot.cloths import CLOTH_LABELS, CLOTHS, HEATED
from game.scenes.shared.tables.cue import MAX_SPEED
from game.scenes.shared.tables.unsteady import HANDS
from game.stage import Choice, Param, Parameters, Toggle

KINDS = ("three-cushion", "one-cushion", "straight-rail")
KIND_LABELS = ("Three-cushion", "One-cushion", "Straight rail")
GRADES = ("novice", "club", "expert", "master")  # of game.billiards.players.carom
GRADE_LABELS = ("Novice", "Club player", "Expert", "Master")
LEAST_POWER = 0.1  # m/s
LARGEST_TIP = 0.6  # ball radii
OWN = "own"


class CaromParameters(Parameters):
    """What of game, stroke, table and map can be chosen."""

    game = Choice(
        "level", ("level", *KINDS), labels=("As the level says", *KIND_LABELS), group="Game", rebuild=True
    )
    first_player = Choice(
        "person", ("person", *GRADES), labels=("A person", *GRADE_LABELS),
        group="Game", label="First player", help="you, or a computer player",
    )  # fmt: skip
    second_player = Choice(
        "person", ("person", *GRADES), labels=("A person", *GRADE_LABELS),
        group="Game", label="Second player", help="you, or a computer player",
    )  # fmt: skip
    target = Param(15, 0, 200, whole=True, group="Game", label="Race to", help="points; 0: no end")
    innings = Param(0, 0, 100, whole=True, group="Game", label="Most innings", help="of each; 0: no limit")
    map = Toggle(True, group="Map", label="Show the map", help="all strokes that score, while you may play")
    odds = Choice(
        "club", (*GRADES, OWN), labels=(*GRADE_LABELS, "My own"), group="Map", label="Chance of a hand",
        help="whose noise counts; your own is measured from strokes you play after choosing one of the map",
    )  # fmt: skip
    explain = Toggle(True, group="Map", label="Explain", help="the first three choices in words")
    ends = Toggle(False, group="Map", label="Where balls end", help="after the chosen stroke, by that hand")
    power = Param(
        4.0, LEAST_POWER, MAX_SPEED, unit="m/s", group="Stroke",
        help="speed of a ball that is struck in its middle",
    )  # fmt: skip
    tip_left = Param(0.0, -LARGEST_TIP, LARGEST_TIP, unit="R", group="Stroke", label="Tip left")
    tip_up = Param(0.0, -LARGEST_TIP, LARGEST_TIP, unit="R", group="Stroke", label="Tip up")
    elevation = Param(0.0, 0.0, 60.0, unit="°", group="Stroke", help="of the butt of the cue")
    hand = Choice(
        "none", tuple(HANDS), group="Stroke", label="Noise of the hand",
        help="how far your tip, elevation, azimuth and speed stray",
    )  # fmt: skip
    path = Toggle(True, group="Stroke", label="Path of the stroke", help="what the aimed stroke would do")
    cloth = Choice(
        HEATED, tuple(CLOTHS), labels=tuple(CLOTH_LABELS.values()), group="Table",
        help="friction and cushions of a match table, or of a club's",
    )  # fmt: skip
    felt = Choice(
        "blue", ("blue", "green"), labels=("Blue", "Green"), group="Table", label="Colour of the cloth"
    )
