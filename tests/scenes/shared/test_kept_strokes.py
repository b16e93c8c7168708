"""Strokes of snooker and carom that decided a match, and what is counted of a stroke of carom."""

from __future__ import annotations

import math
from types import SimpleNamespace

import pytest

from game.app.scene.film.strokes import FilmOfStrokes
from game.billiards.game.arrangement import Stroke
from game.billiards.game.deciding import Marked, deciding_of, with_marked
from game.billiards.game.kinds import POINT
from game.scenes.carom import layout as carom_layout
from game.scenes.shared.tables.beside.figures import FOOT, TIGHTEST, UNDER_FOOT, Number, pitch_of
from game.stage import Action, Decision, SetParameter, Stage
from tests.app.scene.test_match_film import Kept
from tests.scenes.carom import carom_stages
from tests.scenes.snooker import snooker_stages

SCORES = Decision("play", (1.6, 0.0, 0.0, 0.0, 0.0))


def scored_at_carom(**parameters) -> Stage:
    """A point of straight rail has been made by the best stroke of the map."""
    stage = carom_stages.open_level("straight-rail", target=1, **parameters)
    stroke = stage.scene.advisor.now().map.groups[0].stroke
    stage.post(Decision("play", tuple(stroke)))
    carom_stages.seconds(stage, 0.2)
    carom_stages.until_aiming(stage)
    return stage


def potted_at_snooker() -> Stage:
    """A red has been potted with the simple stroke, or at least played at."""
    stage = snooker_stages.open_level("practice-03-long-pot")
    stage.post(Action("strike"))
    snooker_stages.seconds(stage, 0.2)
    snooker_stages.until_aiming(stage)
    return stage


def test_a_point_of_carom_is_marked_and_its_excerpt_comes_to_the_same_end():
    stage = scored_at_carom()
    course, places = stage.scene.course, stage.scene.model.frame.places
    (marked,) = course.marked
    assert (marked.scored, marked.rack, marked.number) == (1, 1, 1)
    (excerpt,) = stage.scene.highlights()
    again = Stage(stage.scene_type, level=excerpt.level, effects=excerpt.active, seed=excerpt.seed)
    for event in excerpt.events:
        again.post(event)
    again.run(excerpt.steps)
    assert again.fault is None
    assert again.scene.course.phase == "aiming", "the excerpt lasts until the balls lie still"
    assert again.scene.model.frame.places == places


def test_the_film_of_carom_has_pictures_and_sounds():
    stage = scored_at_carom()
    film = FilmOfStrokes(stage.scene_type, stage.scene.highlights(), Kept(), "dark")
    while not film.finished:
        film.step()
        film.draw()
    assert len(film.writer.pictures) > 5 and max(film.writer.sounds) > 0 and not film.failed


def test_the_button_of_the_film_wants_a_game_that_is_over():
    stage = scored_at_carom()
    scene = stage.scene
    row = carom_layout.BUTTONS.index("film-strokes")
    carom_stages.click(stage, *carom_layout.button_box(row).middle)
    assert scene.film_wanted == 0 and not scene.course.may_film
    while not scene.course.over:
        stroke = scene.advisor.now()
        if scene.model.frame.game.options:
            scene.course.take_option(0)
        scene.course.skip()
        values = stroke.map.groups[-1].stroke if stroke is not None else Stroke(1.0, 0.3)
        if scene.course.phase == "aiming" and scene.model.frame.playable:
            stage.post(Decision("play", tuple(values)))
        carom_stages.seconds(stage, 0.5)
        carom_stages.until_aiming(stage)
    carom_stages.click(stage, *carom_layout.button_box(row).middle)
    assert scene.film_wanted == 1


def test_what_is_taken_back_decides_nothing():
    stage = scored_at_carom()
    stage.post(Action("undo"))
    assert stage.scene.course.marked == () and stage.scene.highlights() == ()
    stage = scored_at_carom()
    stage.post(Action("next"))
    assert stage.scene.model.frame.strokes or stage.scene.course.marked == ()


def test_the_sight_of_carom_has_a_button():
    stage = carom_stages.open_level()
    row = carom_layout.BUTTONS.index("eye")
    before = bool(stage.scene.course.parameters.eye)
    carom_stages.click(stage, *carom_layout.button_box(row).middle)
    assert bool(stage.scene.course.parameters.eye) is not before
    boxes = [carom_layout.button_box(k) for k in range(len(carom_layout.BUTTONS))]
    for k, box in enumerate(boxes):
        assert box.left >= carom_layout.FOOT.right and box.bottom <= carom_layout.FOOT.bottom + 0.02
        assert not any(box.holds(*other.middle) for other in boxes[:k])


def test_a_stroke_of_snooker_is_marked_and_its_excerpt_comes_to_the_same_end():
    stage = potted_at_snooker()
    (marked,) = stage.scene.course.marked
    assert marked.struck.stroke == stage.scene.course.made
    stage.scene.course.marked = (marked._replace(scored=1),)
    (excerpt,) = stage.scene.highlights()
    again = Stage(stage.scene_type, level=excerpt.level, effects=excerpt.active, seed=excerpt.seed)
    for event in excerpt.events:
        again.post(event)
    again.run(excerpt.steps)
    assert again.fault is None and again.scene.course.phase == "aiming"
    ended = again.scene.model.played.trajectory.digest
    assert ended == stage.scene.model.played.trajectory.digest


def marked(number: int, shooter: str, scored: int, rack: int = 1, winner: str = "") -> Marked:
    return Marked(number, rack, shooter, scored, winner, None, 1.0)


def test_a_run_is_counted_in_points_and_ends_with_rack_and_shooter():
    line = [
        marked(1, "Ada", 1), marked(2, "Ada", 7), marked(3, "Ada", 0), marked(4, "Ben", 1),
        marked(5, "Ben", 1, winner="Ben"), marked(6, "Ben", 6, rack=2),
    ]  # fmt: skip
    assert [one.number for one in deciding_of(line)] == [1, 2, 5]


def test_a_stroke_of_carom_is_measured_with_its_chance_and_its_cushions():
    stage = scored_at_carom(second_player="tom")
    found = stage.scene.stroke_measured()
    assert found is not None and found.kind == POINT
    assert found.made and found.stray is None and found.cushions == 0
    group = stage.scene.model.frame.last
    assert 0.3 < found.chance <= 1.0 and found.distance > 0.1 and 0.0 <= found.cut <= 90.0
    assert found.speed == pytest.approx(group.stroke.cue_speed)
    bank = carom_stages.open_level("classic-04-bank")
    bank.post(SetParameter("second_player", "tom"))
    assert bank.scene.stroke_measured() is None


def test_how_far_a_hand_strayed_is_measured_at_carom_where_the_cue_ball_stopped():
    stage = carom_stages.open_level("straight-rail", second_player="tom", hand="average")
    before = stage.scene.model.frame
    stage.post(Action("strike"))
    carom_stages.seconds(stage, 0.2)
    carom_stages.until_aiming(stage)
    meant, made = stage.scene.course.aimed_and_done
    assert meant != made
    ends = [before.play(stroke).summary.rest[before.game.cue] for stroke in (meant, made)]
    found = stage.scene.stroke_measured()
    assert found is not None and found.stray == pytest.approx(math.dist(*ends), abs=1e-6)


@pytest.mark.parametrize("captioned", [False, True])
def test_figures_end_before_the_buttons_begin(captioned: bool):
    numbers = [Number("Aim", "0.00°"), Number("Margin", "±1°"), Number("Pot", "6 %", under="h" * captioned)]
    assert pitch_of(numbers, 48.0, 500.0) == (48.0, True)
    for room in (110.0, 116.0, 132.0, 140.0):
        pitch, captions = pitch_of(numbers, 48.0, room)
        assert pitch >= TIGHTEST
        last = UNDER_FOOT if captions and captioned else FOOT
        assert 2.0 * pitch + last <= room + 1e-9, room
        assert captions or captioned
    assert math.isclose(pitch_of(numbers[:1], 48.0, 60.0)[0], 48.0, abs_tol=15.0)


def test_a_rack_ends_with_its_winner_and_points_are_those_of_the_shooter():
    def played(before, after, winner=None):
        players, turn = ("Ada", "Ben"), 0 if after[0] > before[0] else 1
        first = SimpleNamespace(players=players, turn=turn, points=before)
        then = SimpleNamespace(players=players, points=after, over=winner is not None, winner=winner)
        struck = SimpleNamespace(frame=SimpleNamespace(game=first, strokes=0))
        return struck, SimpleNamespace(
            frame=SimpleNamespace(game=then), trajectory=SimpleNamespace(end_time=2.5)
        )

    line = ()
    for before, after, winner in (((0, 0), (5, 0), None), ((5, 0), (9, 0), 0), ((0, 0), (4, 0), None),
                                  ((4, 0), (4, 0), None)):  # fmt: skip
        line = with_marked(line, *played(before, after, winner))
    assert [one.rack for one in line] == [1, 1, 2, 2]
    assert [one.winner for one in line] == ["", "Ada", "", ""]
    assert [one.scored for one in line] == [5, 4, 4, 0]
    assert [one.number for one in line] == [1, 2, 3, 4] and line[0].end_s == 2.5
    assert line[3].shooter == "Ben"
