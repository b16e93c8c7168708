"""The parameters of the billiard game: who plays what, the stroke, the table and its balls."""

from __future__ import annotations

from game.scenes.billiards.beside import BESIDE, BESIDE_LABELS
from game.scenes.billiards.level import MOST_RADIUS_SPREAD
from game.scenes.shared.tables import choices
from game.scenes.shared.tables.choices import GRADE_LABELS, GRADES, OWN
from game.scenes.shared.tables.eye import choices as eyes
from game.scenes.shared.tables.furnishing import choices as furnishing
from game.scenes.shared.tables.minds import hurry
from game.scenes.shared.tables.seats import hot_seat
from game.scenes.shared.tables.through import choices as through
from game.stage import Choice, Param, Parameters, Toggle

TABLE_PARAMETERS = (
    "sliding", "rolling", "ball_restitution", "cushion_restitution", "slate_restitution", "cushion_hop",
    "table",
)  # fmt: skip


class BilliardsParameters(Parameters):
    """What of game and table can be chosen."""

    game = Choice(
        "level",
        (
            "level", "eight-ball", "nine-ball", "ten-ball", "straight-pool", "combination", "practice",
            "ghost-nine-ball", "ghost-ten-ball", "ghost-eight-ball",
        ),
        labels=(
            "As the level says", "8-ball", "9-ball", "10-ball", "Straight pool", "Combination match",
            "Practice", "9-ball ghost", "10-ball ghost", "8-ball ghost",
        ),
        group="Game", rebuild=True,
    )  # fmt: skip
    first_player = choices.player("First player", "billiards")
    second_player = choices.player("Second player", "billiards")
    hand_over = hot_seat.hand_over()
    their_strokes = hurry.their_strokes()
    head_start = choices.head_start("racks")
    beside = Choice(
        "none", BESIDE, labels=BESIDE_LABELS, group="Game", label="Beside the table",
        help="strokes to go back to, every pot there is, what was practised, or a coach",
    )  # fmt: skip
    race = Choice(
        "open", ("open", "1", "3", "5", "7"), labels=("No end", "1 rack", "3 racks", "5 racks", "7 racks"),
        group="Game", label="Race to", help="so many racks win the match",
    )  # fmt: skip
    considered = choices.thoughts()
    power = choices.power(4.0)
    tip_left = choices.tip("Tip left")
    tip_up = choices.tip("Tip up", "follow above, draw below")
    elevation = choices.elevation()
    guide = choices.guide(formerly={True: "auto", False: "none"})  # of a toggle
    events = choices.events_ahead()
    hand = choices.noise_of_hand(
        "how far a person's tip, elevation, azimuth and speed stray, as a computer player's do"
    )
    stroke_by = through.stroke_by()
    reach = through.reach()
    sway = through.sway()
    miscues = through.miscues()
    chalk = through.chalk()
    wear = through.wear()
    recoil = through.recoil()
    cloud = Toggle(
        False, group="Stroke", label="Landing cloud", help="where the cue ball ends for the noise of a hand"
    )
    odds = Choice(
        "club", (*GRADES, OWN), labels=(*GRADE_LABELS, "Your own, measured"), group="Stroke",
        label="Hand of map and cloud", help="your own is measured from your strokes with a noise of the hand",
    )  # fmt: skip
    eye = eyes.shown()
    eye_size = eyes.size()
    eye_height = eyes.height()
    eye_tilt = eyes.tilt()
    eye_follows = eyes.follow()
    felt = furnishing.felt()
    table = furnishing.table()
    sliding = choices.sliding(0.2)
    rolling = choices.rolling(0.01)
    ball_restitution = choices.ball_restitution(0.95)
    cushion_restitution = choices.cushion_restitution(0.85)
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
