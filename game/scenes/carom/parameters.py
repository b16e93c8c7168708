"""The parameters of carom: who plays what, the stroke, the cloth, and what is shown of the map."""

from __future__ import annotations

from game.billiards.game.games.carom_kinds import TITLES, Kind
from game.billiards.shot.cloths import CLOTH_LABELS, CLOTHS, HEATED
from game.scenes.shared.tables import choices
from game.scenes.shared.tables.choices import GRADE_LABELS, GRADES, OWN
from game.scenes.shared.tables.eye import choices as eyes
from game.scenes.shared.tables.furnishing import choices as furnishing
from game.scenes.shared.tables.furnishing.choices import CAROM_FELT_NAMES
from game.scenes.shared.tables.minds import hurry
from game.scenes.shared.tables.seats import hot_seat
from game.scenes.shared.tables.through import choices as through
from game.stage import Choice, Param, Parameters, Toggle

KINDS: tuple[Kind, ...] = (
    "three-cushion", "one-cushion", "straight-rail", "balkline-47-2", "balkline-47-1", "balkline-71-2",
    "artistic",
)  # fmt: skip
KIND_LABELS = tuple(TITLES[kind] for kind in KINDS)


class CaromParameters(Parameters):
    """What of game, stroke, table and map can be chosen."""

    game = Choice(
        "level", ("level", *KINDS), labels=("As the level says", *KIND_LABELS), group="Game", rebuild=True
    )
    first_player = choices.player("First player", "carom")
    second_player = choices.player("Second player", "carom")
    hand_over = hot_seat.hand_over()
    their_strokes = hurry.their_strokes()
    head_start = choices.head_start("points")
    target = Param(15, 0, 200, whole=True, group="Game", label="Race to", help="points; 0: no end")
    innings = Param(0, 0, 100, whole=True, group="Game", label="Most innings", help="of each; 0: no limit")
    considered = choices.thoughts()
    coach = choices.coach()
    map = Toggle(True, group="Map", label="Show the map", help="all strokes that score, while you may play")
    odds = Choice(
        "club", (*GRADES, OWN), labels=(*GRADE_LABELS, "My own"), group="Map", label="Chance of a hand",
        help="whose noise counts; your own is measured from strokes you play after choosing one of the map",
    )  # fmt: skip
    explain = Toggle(True, group="Map", label="Explain", help="the first three choices in words")
    ends = Toggle(False, group="Map", label="Where balls end", help="after the chosen stroke, by that hand")
    power = choices.power(4.0)
    tip_left = choices.tip("Tip left")
    tip_up = choices.tip("Tip up")
    elevation = choices.elevation(60.0)
    hand = choices.noise_of_hand("how far your tip, elevation, azimuth and speed stray")
    stroke_by = through.stroke_by()
    reach = through.reach()
    sway = through.sway()
    miscues = through.miscues()
    chalk = through.chalk()
    wear = through.wear()
    recoil = through.recoil()
    path = Toggle(True, group="Stroke", label="Path of the stroke", help="what the aimed stroke would do")
    eye = eyes.shown()
    eye_size = eyes.size()
    eye_height = eyes.height()
    eye_tilt = eyes.tilt()
    eye_follows = eyes.follow()
    cloth = Choice(
        HEATED, tuple(CLOTHS), labels=tuple(CLOTH_LABELS.values()), group="Table",
        help="friction and cushions of a match table, or of a club's",
    )  # fmt: skip
    felt = furnishing.felt(CAROM_FELT_NAMES)
