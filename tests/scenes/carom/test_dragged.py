"""What is told of a stroke that is set, and of the map while a ball is on its way."""

from game.scenes.carom.view import picture
from game.scenes.carom.view.map_list import _figures
from game.stage import Pointer, SetParameter
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from tests.scenes.carom.carom_stages import open_level


def test_the_tip_is_told_with_its_side():
    stage = open_level("default")
    stage.post(SetParameter("tip_left", 0.4))
    stage.post(SetParameter("tip_up", -0.1))
    figures = dict(_figures(stage.scene.course, None))
    assert figures["Tip to the left"] == "+0.40 R" and figures["Tip up"] == "\N{MINUS SIGN}0.10 R"


def test_the_ways_of_the_last_map_stay_while_a_ball_is_dragged(monkeypatch):
    """On a busy machine the next map is late: no picture is without lines meanwhile."""
    stage = open_level("default")
    scene = stage.scene
    x, y = scene.model.frame.places[2]
    stage.post(Pointer("down", x, y, 1))
    stage.post(Pointer("move", x, y + 0.05, 1))  # from here on it is no opening stroke
    scene.advisor.now()
    seen = []
    monkeypatch.setattr(picture, "draw_faint", lambda canvas, sight: seen.append(sight))
    monkeypatch.setattr(scene.advisor.maker, "ask", lambda *question: None)  # no map comes any more
    canvas = Canvas(Look(DARK))
    for step in range(1, 6):
        stage.post(Pointer("move", x + 0.02 * step, y, 1))
        seen.clear()
        scene.view._draw_paths(canvas, scene.advisor.drawn())
        assert len(seen) == picture.FAINT and all(sight.scores for sight in seen)
    assert scene.model.frame.places[2][0] != x
