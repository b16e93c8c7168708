"""Players without a hand: what a computer player decides, and the table that plays by itself."""

from __future__ import annotations

from typing import TYPE_CHECKING

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import Call
from game.billiards.shot.cue import strike as struck_ball
from game.scenes.billiards import round as rounds
from game.scenes.billiards.play import AIMING, begin_stroke, lay_out, rack, take_option, word_of
from game.scenes.billiards.players import decision_of, simple_stroke
from game.scenes.billiards.thinker import Question
from game.stage import Decision

if TYPE_CHECKING:
    from game.scenes.billiards.scene import Billiards

NEXT_STROKE_S = 0.7  # s of rest before the next stroke of a computer player, or of the table itself
NEW_RACK_S = 2.5


def question_of(scene: Billiards) -> Question:
    """What a computer player at turn is asked."""
    key = (scene.round.strokes, word_of(scene.round))
    seed = int.from_bytes(key[1].encode()[:7], "little")
    return Question(key, scene.round.frame, scene.grade_of(scene.round.game.turn), seed)


def decisions(scene: Billiards, at_once: bool = False) -> list[Decision]:
    """What the computer player at turn has decided, if it is one and has. at_once: it does so now."""
    players = range(len(scene.round.game.players))
    if not at_once and any(scene.grade_of(player) != "person" for player in players):
        scene.thinker.prepare()
    computer = not scene.person_plays and not scene.plays_itself and not scene.round.game.over
    if not computer or scene.phase != AIMING or scene.grip:
        scene.thinker.forget()
        return []
    rested = scene.rest_s > NEXT_STROKE_S
    if at_once:
        thought = scene.thinker.answer(question_of(scene)) if rested else None
    else:
        thought = scene.thinker.ask(question_of(scene))
    if thought is None:
        return []
    scene.kept.considered = thought.considered
    if not rested:
        return []
    if not thought.decisions:  # it failed; the game goes on
        return [decision_of(simple_stroke(scene.round.frame, scene.round.strokes))]
    return list(thought.decisions)


def decide(scene: Billiards, event: Decision) -> None:
    """Let a decision act. ValueError for one that cannot be."""
    values = event.values
    if scene.phase != AIMING:
        raise ValueError(f"{event.name}: nothing is to be decided now")
    if event.name == "stroke" and len(values) == 9:
        ball, pocket = (None if value < 0.0 else int(value) for value in values[5:7])
        call = Call(ball, pocket, bool(values[7]), bool(values[8]))
        stroke = Stroke(*values[:5])
        struck_ball(*stroke)  # refuses what no stroke can be
        begin_stroke(scene, stroke, call, practised=True)
    elif event.name == "white" and len(values) == 2:
        scene.round = rounds.white_moved(scene.round, *values)
        lay_out(scene)
    elif event.name == "option" and len(values) == 1:
        options = scene.round.game.options
        if not 0 <= int(values[0]) < len(options):
            raise ValueError(f"option {int(values[0])}: there are {len(options)}")
        take_option(scene, int(values[0]))
    else:
        raise ValueError(f"{event.name}: stroke, white or option, each with its numbers, are wanted")


def play_by_itself(scene: Billiards) -> None:
    """A new rack when one is over; and while the table plays itself its own strokes, the same for the same
    round.
    """
    game = scene.round.game
    if game.over:
        if scene.rest_s > NEW_RACK_S:
            rack(scene)
    elif scene.plays_itself and scene.rest_s > NEXT_STROKE_S:
        if game.options:
            take_option(scene, 0)
        elif scene.round.playable:
            stroke = simple_stroke(scene.round.frame, scene.seed + scene.round.strokes)
            begin_stroke(scene, stroke, Call(), practised=True)
