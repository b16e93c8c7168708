"""The practice record beside the table, and the ghost on the score board: words, rows, curve; all views
drawn.
"""

import pygame
import pytest

from game.billiards.game.games import Ghost
from game.scenes.billiards.practice.columns import ROWS
from game.scenes.billiards.scene import Billiards
from game.scenes.billiards.view.beside.record import (
    CHART_ROWS,
    RecordView,
    draw_curve,
    points_of,
    rows_of,
    summary_of,
)
from game.scenes.shared.tables import grip
from game.stage import Action, Decision, SetParameter, replay_scene
from game.stage.records.history import PracticeSet, history_path, keep_set
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from tests.scenes.billiards.billiards_stages import level_of, open_level, seconds, standing, until_aiming

NO_CALL = (-1.0, -1.0, 0.0, 0.0)


def kept(made: int, tried: int, day: int = 1, of: int = 10, key: str = "k") -> PracticeSet:
    return PracticeSet(key, "K", f"2026-11-{day:02d}T10:00:00", made, tried, of)


def test_the_line_over_the_record():
    assert summary_of((), ghost=True) == "No set yet. The first try begins one."
    assert summary_of([kept(3, 9)], ghost=True) == "1 set, 3 of 9, 33 %"
    assert summary_of([kept(2, 10), kept(3, 10)], ghost=True) == "2 sets, 5 of 20, 25 %; rating −149 ± 72"
    assert summary_of([kept(2, 10), kept(3, 10)], ghost=False) == "2 sets, 5 of 20, 25 %"


def test_the_newest_sets_stand_first_and_no_more_than_there_is_space_for():
    rows = rows_of([kept(k, 10, k + 1) for k in range(10)] + [kept(2, 5, 20)])
    assert len(rows) == min(ROWS - CHART_ROWS, 11)
    assert (rows[0].lead, rows[0].words, rows[0].under) == (
        "40 %",
        "2 of 5 (not finished of 10)",
        "20 Nov 2026, 10:00",
    )
    assert rows[1].words == "9 of 10" and rows[1].share == 0.9
    assert rows_of([kept(2, 5, of=0)])[0].words == "2 of 5"


def test_the_curve_goes_from_the_first_to_the_last_and_up_with_the_share():
    sets = [kept(0, 10), kept(5, 10), kept(10, 10)]
    assert points_of(sets, (100.0, 200.0), (80.0, 20.0)) == [(100.0, 80.0), (150.0, 50.0), (200.0, 20.0)]
    assert points_of(sets[1:2], (100.0, 200.0), (80.0, 20.0)) == [(100.0, 50.0)]
    surface = pygame.Surface((300, 160))
    draw_curve(surface, Look(DARK, 1.0), surface.get_rect(), sets)
    green = Look(DARK, 1.0).color("green")
    lit = [
        (x, y)
        for x in range(300)
        for y in range(160)
        if surface.get_at((x, y))[:3] == (green.r, green.g, green.b)
    ]
    assert min(x for x, _ in lit) < 60 and max(x for x, _ in lit) > 270
    assert min(lit)[1] > 100 > 40 > max(lit)[1]


def test_the_view_reads_the_file_again_when_it_has_changed(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    view = RecordView()
    assert view.sets("k") == ()
    keep_set(kept(3, 10))
    keep_set(kept(3, 10, key="other"))
    assert view.sets("k") == (kept(3, 10),)
    history_path().write_text("broken")
    assert view.sets("k") == ()


def strike(stage, speed=7.0, azimuth=1.58):
    stage.post(Decision("stroke", (speed, azimuth, 0.0, 0.0, 0.0, *NO_CALL)))
    return until_aiming(seconds(stage, 0.25))


class TestGhostAtTheTable:
    def test_a_rack_that_is_lost_and_the_next(self):
        stage = open_level("ghost-09")
        assert stage.scene.practised == ("ghost nine-ball 10", "9-ball ghost", 0, 0, 10)
        strike(stage)
        game = stage.scene.model.frame.game
        assert game.in_hand == "anywhere" and standing(stage).caption == "0 of 10 racks"
        strike(stage, 1.0, -1.5)
        assert stage.scene.model.frame.game.winner == 1
        assert stage.scene.practised[2:] == (0, 1, 10) and not stage.scene.play.match_over
        assert standing(stage).cards[1].status == "won the rack"
        stage.post(Action("rack"))
        assert stage.scene.model.frame.game.opening and stage.scene.model.frame.game.won == (0, 1)
        assert replay_scene(stage.recording, Billiards).step_number == stage.step_number

    def test_after_ten_racks_a_new_set_begins(self):
        stage = open_level("ghost-09")
        frame = stage.scene.model.frame
        import msgspec

        over = msgspec.structs.replace(frame.game, won=(4, 6), winner=1, opening=False)
        stage.scene.model.frame = frame.replace(game=over)
        assert stage.scene.play.match_over and stage.scene.practised[2:] == (4, 10, 10)
        assert ("rack", "New match", True) in stage.scene.buttons.rows()
        stage.scene.play.rack()
        assert stage.scene.practised[2:] == (0, 0, 10)

    @pytest.mark.parametrize("name", ["ghost-08", "ghost-09", "ghost-10"])
    def test_the_levels_are_ghosts(self, name):
        stage = open_level(name)
        assert isinstance(stage.scene.model.frame.game, Ghost) and "ghost" in standing(stage).title
        assert int(name[-2:]) == max(stage.scene.model.frame.game.on_table, key=lambda b: b == int(name[-2:]))

    def test_the_computer_may_play_it_and_nothing_is_counted_then(self):
        stage = level_of('game = "ghost-nine-ball"', first_player="expert")
        assert stage.scene.practised is None
        stage.run(round(1.0 / stage.dt), players=True)
        until_aiming(seconds(stage, 6.0))
        assert stage.scene.model.frame.strokes >= 1

    def test_a_click_on_the_ghosts_card_does_nothing(self):
        from game.scenes.billiards import layout

        stage = open_level("ghost-09")
        assert stage.scene.buttons.at(*layout.card_box(1).middle) == grip.NOTHING
        assert stage.scene.buttons.at(*layout.card_box(0).middle) == grip.card(0)

    def test_the_parameter_begins_it_as_well(self):
        stage = open_level("default")
        stage.post(SetParameter("game", "ghost-ten-ball"))
        assert stage.scene.model.frame.game.discipline == "ten-ball"
