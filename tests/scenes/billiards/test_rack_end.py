"""The end of a rack: its deciding pot from near and slowly, and the card with what was counted."""

import math
from itertools import pairwise

import msgspec
import numpy as np
import pygame
import pytest

from game.app.stagehand.files import present_level
from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import new_frame
from game.billiards.game.games.ghost import new_ghost
from game.billiards.game.rules import Pocketing, ShotSummary
from game.billiards.game.tally import Tally
from game.billiards.table.table import Table
from game.levels import LevelError, format_level, parse_level
from game.scenes import CATALOGUE
from game.scenes.billiards import layout
from game.scenes.billiards.play import SLOW
from game.scenes.billiards.scene import Billiards
from game.scenes.billiards.view import close_up, end_card
from game.scenes.billiards.view.beside.record import rating_words
from game.scenes.shared.tables.view import Balls, draw_table
from game.stage import Action, Decision, ParameterError, Stage
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import DARK, FELT
from tests.app.tests_app import Driver
from tests.scenes.billiards.billiards_stages import level_of, seconds, straight_pot, until_aiming

pytestmark = pytest.mark.compiled

LAST_POT = (
    'game = "nine-ball"\nballs = [{ number = 0, position = [0.7, 0.7] },'
    " { number = 5, position = [0.45, 0.45] }, { number = 9, position = [0.22, 0.22] }]"
)
STROKE = Decision("stroke", (3.0, math.atan2(-1.0, -1.0), 0.0, 0.0, 0.0, -1.0, -1.0, 0.0, 0.0))


def until_rolling(stage):
    stage.post(STROKE)
    while stage.scene.play.phase != "rolling":
        seconds(stage, stage.dt)
    return stage


def test_the_deciding_ball_falls_slowly():
    stage = until_rolling(level_of(LAST_POT))
    play, decided = stage.scene.play, stage.scene.model.decided
    assert decided is not None
    paces = []
    while play.phase == "rolling" and play.clock[0] < decided.time + 0.5:
        before = float(play.clock[0])
        seconds(stage, stage.dt)
        paces.append((before - decided.time, (float(play.clock[0]) - before) / stage.dt))
    assert all(pace == pytest.approx(SLOW) for since, pace in paces if -0.25 < since < 0.1)
    assert all(pace == pytest.approx(1.0) for since, pace in paces if since < -0.32 or since > 0.14)


def test_a_pot_that_decides_nothing_is_as_fast_as_any():
    stage = straight_pot("nine-ball")
    stage.post(STROKE)
    while stage.scene.play.phase != "rolling":
        seconds(stage, stage.dt)
    assert stage.scene.model.decided is None and stage.scene.play.pace == 1.0


def test_the_picture_comes_nearer_to_the_pocket_and_stays_on_the_table():
    assert close_up.nearness(-5.0) == close_up.nearness(5.0) == 1.0
    assert close_up.nearness(0.0) == close_up.CLOSEST
    sizes = [close_up.nearness(since) for since in np.linspace(-0.9, -0.35, 20).tolist()]
    assert sizes == sorted(sizes)
    whole = layout.TABLE
    for pocket in ((0.0, 0.0), (1.27, 1.27), (0.6, 2.5)):
        part = close_up.seen_from_near(2.0, pocket)
        assert whole.holds(part.top + 1e-9, part.left + 1e-9)
        assert whole.holds(part.bottom - 1e-9, part.right - 1e-9)
        assert part.holds(*pocket) and part.right - part.left == pytest.approx((whole.right - whole.left) / 2)


def test_from_near_a_ball_is_drawn_where_its_part_of_the_table_is():
    from game.app.stagehand.headless import prepare

    prepare()
    canvas, surface = Canvas(Look(DARK)), pygame.Surface((1280, 720), 0, 32)
    camera = Camera(quarter_turns=1)
    camera.fit(layout.FRAME, surface.get_rect(), 0.0)
    table, part = Table.pool(), close_up.seen_from_near(2.0, (0.0, 0.0))
    ball = Balls(np.array([(0.2, 0.45)]), np.array([0.0286]), np.array([3]), np.eye(3)[None], np.ones(1))
    pictures = []
    for shown in (ball, ball._replace(opacities=np.zeros(1))):
        canvas.begin(surface, surface.get_rect(), camera)
        draw_table(canvas, table)
        close_up.CloseUpView().draw(canvas, table, shown, part, FELT)
        canvas.end()
        pictures.append(pygame.surfarray.array3d(surface).astype(int))
    changed = np.argwhere(np.abs(pictures[0] - pictures[1]).sum(axis=2) > 120)
    x = 80.0 + 2.0 * layout.PIXELS * (0.45 - layout.TABLE.left)
    y = 56.0 + 2.0 * layout.PIXELS * (0.2 - layout.TABLE.top)
    assert np.abs(changed.mean(axis=0) - (x, y)).max() < 6.0
    assert np.ptp(changed[:, 0]) == pytest.approx(4.0 * 0.0286 * layout.PIXELS, rel=0.3)


def test_near_only_while_it_falls_and_never_with_less_motion():
    stage = until_rolling(level_of(LAST_POT))
    play, view = stage.scene.play, close_up.CloseUpView()
    at = stage.scene.model.decided.time
    assert view.part(play, at, False) is not None and view.part(play, at + 2.0, False) is None
    assert view.part(play, at, True) is None
    until_aiming(stage)
    assert view.part(play, at, False) is None


def test_the_card_says_what_was_counted():
    assert end_card.HEADS == ("Potting rate", "Longest run", "Fouls")
    assert end_card.figures_of(Tally(8, 6, 0, 4, 1)) == ("75 % of 8", "4", "1")
    assert end_card.figures_of(Tally()) == ("–", "0", "0")
    direct = ShotSummary(pocketed=(Pocketing(5, 0, (0, 5), 0),))
    assert end_card.words_of(direct) == "The 5 down"
    wild = ShotSummary(pocketed=(Pocketing(2, 1, (0, 2), 1), Pocketing(9, 0, (0, 2, 4, 9), 3, 2)))
    assert end_card.words_of(wild) == "The 2 and the 9 down, by way of the 2 and the 4, off 2 cushions"


def test_the_best_stroke_is_played_over_and_over():
    stage = until_aiming(until_rolling(level_of(LAST_POT)))
    card, play, best = end_card.EndCard(), stage.scene.play, stage.scene.model.frame.best
    assert end_card.is_shown(play)
    times = []
    for _ in range(80):
        seconds(stage, 0.1)
        times.append(card.time(play, best))
    assert max(times) > 1.0 and sum(later < before for before, later in pairwise(times))
    stage.post(Action("set-up"))
    seconds(stage, 0.1)
    assert not end_card.is_shown(play)


def test_what_was_counted_is_saved_and_goes_with_undo():
    stage = until_aiming(until_rolling(level_of(LAST_POT)))
    tallies = stage.scene.model.frame.tallies
    assert tallies == (Tally(1, 1, 1, 1, 0), Tally())
    text = format_level(present_level(stage, "kept"))
    again = Stage(Billiards, level=parse_level(text, "billiards", Billiards.content_type))
    assert again.scene.model.frame.tallies == tallies
    stage.post(Action("undo"))
    seconds(stage, 0.1)
    assert stage.scene.model.frame.tallies == (Tally(), Tally())


def test_the_best_stroke_of_a_rack_is_there_in_the_next_session():
    stage = until_aiming(until_rolling(level_of(LAST_POT)))
    best = stage.scene.model.frame.best
    text = format_level(present_level(stage, "kept"))
    again = Stage(Billiards, level=parse_level(text, "billiards", Billiards.content_type))
    found = again.scene.model.frame.best
    assert found.merit == best.merit and found.summary == best.summary
    assert found.struck.stroke == best.struck.stroke and found.struck.call == best.struck.call
    assert np.array_equal(found.struck.frame.layout.positions, best.struck.frame.layout.positions)
    assert format_level(present_level(again, "kept")) == text


def test_a_best_stroke_that_cannot_be_is_refused_in_a_line():
    stage = until_aiming(until_rolling(level_of(LAST_POT)))
    text = format_level(present_level(stage, "kept"))
    head, _, rest = text.partition("[content.best")
    for bad in (rest.replace("turn = 0", "turn = 7"), rest.replace("number = 9", "number = 8", 1)):
        assert bad != rest
        with pytest.raises((LevelError, ParameterError), match="best"):
            Stage(
                Billiards, level=parse_level(f"{head}[content.best{bad}", "billiards", Billiards.content_type)
            )


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080)])
def test_in_the_window_the_card_comes_and_goes(tmp_path, monkeypatch, size):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    file = tmp_path / "last-pot.toml"
    file.write_text(f'scene = "billiards"\ntitle = "Last pot"\n[content]\n{LAST_POT}\n')
    driver = Driver(tmp_path, size, catalogue=CATALOGUE)
    driver.app.open_scene("billiards", file)
    driver.top.loader.wait(300.0)
    driver.frames(3)
    x, y = driver.stage.scene.model.frame.cue_ball
    camera = driver.top.play.view.camera

    def pixel(along: float) -> tuple[int, int]:
        px, py = camera.to_screen(x - along, y - along)
        return round(px), round(py)

    def inside() -> np.ndarray:
        """The colours just inside the card's left edge."""
        px, py = camera.to_screen(end_card.BOX.middle[0], end_card.BOX.left + 0.02)
        return pygame.surfarray.array3d(driver.window.surface)[round(px), round(py) - 40 : round(py) + 40]

    panel = driver.app.look.theme.panel[:3]
    before = inside()
    driver.stage.post(STROKE)
    for _ in range(400):
        driver.frames(1, 0.05)
        if end_card.is_shown(driver.stage.scene.play):
            break
    driver.frames(2)
    assert (inside() == panel).all() and not (before == panel).all()
    assert isinstance(driver.stage.scene, Billiards) and driver.top.play.trouble == ""
    driver.key(pygame.K_RETURN)
    driver.frames(3)
    assert driver.stage.scene.model.frame.game.opening and not (inside() == panel).all()
    driver.close()


def test_what_is_counted_on_the_card_is_of_this_rack_and_the_match_beside_it():
    stage = level_of(LAST_POT, race="3")
    for _ in range(2):
        stage.post(STROKE)
        until_aiming(seconds(stage, 0.5))
        if stage.scene.model.frame.game.over:
            break
    model = stage.scene.model
    assert model.frame.game.over and model.frame.rack_tallies == model.frame.tallies
    before = model.frame.tallies
    stage.post(Action("rack"))
    assert model.frame.tallies == before and model.frame.rack_tallies == (Tally(), Tally())
    assert not stage.scene.play.match_over
    again = level_of(LAST_POT, race="1")
    again.post(STROKE)
    until_aiming(seconds(again, 0.5))
    assert again.scene.play.match_over
    again.post(Action("rack"))  # a new match counts anew
    assert again.scene.model.frame.tallies == (Tally(), Tally())


def test_a_ball_that_rattles_in_the_mouth_of_its_pocket_came_off_no_cushion():
    stage = level_of(
        'game = "practice"\nballs = [{number=0,position=[0.5,0.9]},{number=3,position=[0.16,0.30]}]'
    )
    frame = stage.scene.model.frame
    aim = math.atan2(0.30 - 0.9, 0.16 - 0.5)
    rattled = banked = 0
    for off in np.linspace(-0.09, 0.09, 61).tolist():
        summary = frame.play(Stroke(2.0, aim + off)).summary
        fallen = summary.pocketing(3)
        if fallen is None or not fallen.cushions:
            continue
        said = end_card.words_of(summary)
        if abs(off) < 0.02 and fallen.pocket == 0:
            rattled += 1
            assert fallen.rails == 0 and "cushion" not in said
        elif fallen.pocket != 0:
            banked += 1
            assert 1 <= fallen.rails <= fallen.cushions and f"off {fallen.rails} cushion" in said
    assert rattled >= 2 and banked >= 2


def test_after_ten_racks_the_ghosts_card_rates_the_player(monkeypatch):
    game = msgspec.structs.replace(new_ghost("nine-ball"), won=(4, 6), winner=1, opening=False)
    assert game.set_over
    frame = new_frame(game)
    words = []
    look = Look(DARK)
    monkeypatch.setattr(look, "text", lambda surface, said, *more, **options: words.append(said))
    end_card._draw_figures(pygame.Surface((10, 10)), look, frame, 0.0, 0.0, 300, "0:01 min")
    assert "Rating" in words and rating_words(4, 6) in words
