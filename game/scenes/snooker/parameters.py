"""The parameters of snooker: who plays what, the stroke, the cloth, and what is shown of a stroke."""

from __future__ import annotations

from game.billiards.shot.cloths import SNOOKER_CLOTH
from game.scenes.shared.tables import choices
from game.scenes.shared.tables.eye import choices as eyes
from game.scenes.shared.tables.furnishing import choices as furnishing
from game.scenes.shared.tables.minds import hurry
from game.scenes.shared.tables.seats import hot_seat
from game.scenes.shared.tables.through import choices as through
from game.stage import Choice, Parameters


class SnookerParameters(Parameters):
    """What of game, stroke and table can be chosen."""

    game = Choice(
        "level", ("level", "snooker", "six-red"), labels=("As the level says", "Snooker", "Six-red"),
        group="Game", rebuild=True,
    )  # fmt: skip
    first_player = choices.player("First player", "snooker")
    second_player = choices.player("Second player", "snooker")
    hand_over = hot_seat.hand_over()
    their_strokes = hurry.their_strokes()
    head_start = choices.head_start("frames")
    best_of = Choice(
        "open", ("open", "1", "3", "5", "7", "9"),
        labels=("No end", "1 frame", "3 frames", "5 frames", "7 frames", "9 frames"),
        group="Game", label="Best of", help="frames of a match",
    )  # fmt: skip
    miss = Choice(
        "professional", ("professional", "club", "off"), labels=("Professional", "Club", "None called"),
        group="Game", label="Miss", help="how good an attempt the referee expects (rule 3.14)",
    )  # fmt: skip
    considered = choices.thoughts()
    coach = choices.coach()
    power = choices.power(3.0)
    tip_left = choices.tip("Tip left")
    tip_up = choices.tip("Tip up", "follow above, draw below")
    elevation = choices.elevation()
    guide = choices.guide()
    events = choices.events_ahead()
    magnifier = Choice(
        "auto", ("auto", "on", "off"), labels=("Where balls are small", "Always", "Never"), group="Stroke",
        help="the contact that is aimed at, seen from near",
    )  # fmt: skip
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
    eye = eyes.shown()
    eye_size = eyes.size()
    eye_height = eyes.height()
    eye_tilt = eyes.tilt()
    eye_follows = eyes.follow()
    felt = furnishing.felt()
    table = furnishing.table()
    sliding = choices.sliding(SNOOKER_CLOTH.sliding)
    rolling = choices.rolling(SNOOKER_CLOTH.rolling)
    ball_restitution = choices.ball_restitution(SNOOKER_CLOTH.ball_restitution)
    cushion_restitution = choices.cushion_restitution(SNOOKER_CLOTH.cushion_restitution)
