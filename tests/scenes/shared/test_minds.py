"""What a computer player does while it thinks: where it walks, and what it tells."""

import math

import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.players.opponents import Decision
from game.billiards.search.finding import FoundShot
from game.scenes.billiards.scene import Billiards
from game.scenes.carom.scene import CaromScene
from game.scenes.shared.tables.minds.thoughts import Told, told_of
from game.scenes.shared.tables.minds.walking import BESIDE, PACE, Edge, Walk
from game.scenes.snooker.scene import SnookerScene
from game.stage import Action, SetParameter, Stage

EDGE = Edge(1.0, 2.0)


def test_the_edge_is_a_rectangle_round_the_bed():
    assert EDGE.around == pytest.approx(2.0 * (1.0 + 2.0 + 4.0 * BESIDE))
    corners = [0.0, 1.2, 3.4, 4.6]
    places = [EDGE.place(way) for way in corners]
    assert places == [
        pytest.approx(at) for at in ((-0.1, -0.1), (1.1, -0.1), (1.1, 2.1), (-0.1, 2.1))
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("azimuth", "place"),
    [
        (0.5 * math.pi, (0.5, -0.1)),
        (-0.5 * math.pi, (0.5, 2.1)),
        (0.0, (-0.1, 0.8)),
        (math.pi, (1.1, 0.8)),
        (0.25 * math.pi, (-0.1, 0.2)),
    ],
)
def test_one_stands_behind_the_ball(azimuth, place):
    assert EDGE.place(EDGE.stance((0.5, 0.8), azimuth)) == pytest.approx(place)


def test_a_walk_goes_the_shorter_way_at_its_pace():
    walk = Walk()
    walk.way = 0.2
    assert not walk.go(EDGE, EDGE.around - 0.3, 0.1)
    assert walk.way == pytest.approx((0.2 - 0.1 * PACE) % EDGE.around)
    assert walk.go(EDGE, EDGE.around - 0.3, 0.5)
    assert walk.way == pytest.approx(EDGE.around - 0.3)
    assert walk.go(EDGE, EDGE.around - 0.3, 0.0)  # the next rest: it stands where it stood


def test_what_was_thought_is_two_sentences():
    pot = Decision("", None, Stroke(2.0, 1.0), worth=0.58, chance=0.62, kind="bank", safe=0.41)
    assert told_of("Greta", pot, "the 3 into the upper left pocket") == Told(
        "Greta meant the 3 into the upper left pocket by a bank: 62 of 100.",
        "It then wins 58 of 100; after the best safety 41 of 100.",
    )
    safe = pot._replace(kind="safety", chance=0.9)
    assert told_of("Greta", safe, "")[0] == "Greta played safe: no foul in 90 of 100."
    assert told_of("Greta", safe, "").instead == "No pot was to be seen."
    seen = tuple(FoundShot(Stroke(2.0, 1.0), 3, 1, "direct", None, chance, 0.0) for chance in (0.2, 0.3))
    assert told_of("Greta", safe._replace(considered=seen), "").instead == "The surest pot: 30 of 100."
    assert told_of("Greta", pot._replace(safe=math.nan), "it").instead.startswith("Sure enough")
    assert told_of("Greta", Decision(option="play"), "") == Told()


@pytest.mark.parametrize(
    ("scene", "game", "pair"),
    [
        (Billiards, "nine-ball", ("ines", "greta")),
        (SnookerScene, "six-red", ("ines", "tom")),
        (CaromScene, "straight-rail", ("rocco", "kenji")),
    ],
)
def test_players_of_the_ladder_play_and_tell_at_every_table(scene, game, pair):
    stage = Stage(
        scene, parameters={"game": game, "first_player": pair[0], "second_player": pair[1], "head_start": -1}
    )
    course, opponents = stage.scene.course, stage.scene.opponents
    state = course.model.frame.game
    assert (state.points if scene is CaromScene else state.won) == (0, 1)
    for _ in range(4000):
        for decision in stage.scene.decisions(at_once=True):
            stage.post(decision)
        stage.run(4)
        if course.model.frame.strokes >= 2:
            break
    assert course.model.frame.strokes >= 2
    assert opponents.thinker.failure == ""
    assert opponents.told.chosen or scene is Billiards
    assert opponents.words_of_thoughts == Told()
    stage.post(Action("thoughts"))
    stage.run(1)
    assert opponents.words_of_thoughts == opponents.told
    assert opponents.walk.way is not None


def test_a_head_start_is_had_again_with_the_next_match():
    stage = Stage(Billiards, parameters={"game": "nine-ball", "race": "3", "head_start": 2})
    assert stage.scene.model.frame.game.won == (2, 0)
    stage.scene.model.rack(new_match=True)
    assert stage.scene.model.frame.game.won == (2, 0)
    stage.post(SetParameter("head_start", -1))
    stage.run(1)
    assert stage.scene.model.frame.game.won == (0, 1)
