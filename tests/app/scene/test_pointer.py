"""The hand: pixels to world coordinates, what is the scene's and what is the view's."""

import example_scene
import pygame
import pytest

from game.app.scene.playing.pointer import ScenePointer
from game.stage import Frame
from game.ui.canvas.camera import Camera

STAGE = pygame.Rect(0, 50, 400, 300)


@pytest.fixture
def hand() -> ScenePointer:
    pygame.display.init()
    pygame.Window("hand", (400, 400))
    camera = Camera()
    camera.fit(Frame(-2.0, -1.0, 2.0, 2.0), STAGE, 0.0)
    return ScenePointer(example_scene.BouncingBall, camera)


def event(kind: int, x: int, y: int, button: int = 1) -> pygame.Event:
    if kind == pygame.MOUSEMOTION:
        return pygame.Event(kind, pos=(x, y), rel=(5, 0), buttons=(0, 0, 0))
    return pygame.Event(kind, pos=(x, y), button=button)


MOVE, DOWN, UP = pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP


def test_press_move_release_in_world_coordinates(hand: ScenePointer):
    for kind, x in ((DOWN, 200), (MOVE, 299), (UP, 299)):
        hand.handle(event(kind, x, 200), STAGE)
    events = hand.take()
    assert [e.kind for e in events] == ["move", "down", "move", "up"]
    assert events[1].x == pytest.approx(0.005)  # the middle of a pixel
    assert events[3].x == pytest.approx(0.995)
    assert [e.button for e in events] == [0, 1, 1, 1]
    assert hand.take() == []


def test_of_moves_only_the_last_counts(hand: ScenePointer):
    for x in range(100, 120):
        hand.handle(event(MOVE, x, 200), STAGE)
    (move,) = hand.take()
    assert move.x == pytest.approx(hand.camera.to_world(119.5, 200.5)[0])
    hand.handle(event(MOVE, 119, 200), STAGE)
    assert hand.take() == []


def test_drag_goes_on_outside_the_stage(hand: ScenePointer):
    hand.handle(event(DOWN, 200, 200), STAGE)
    assert hand.handle(event(MOVE, 390, 20), STAGE)
    assert hand.handle(event(UP, 390, 20), STAGE)
    assert hand.take()[-1].kind == "up"


def test_press_outside_is_not_the_scenes(hand: ScenePointer):
    assert not hand.handle(event(DOWN, 200, 20), STAGE)
    assert not hand.handle(event(MOVE, 200, 20), STAGE)
    assert not hand.handle(event(UP, 200, 20), STAGE)
    assert hand.take() == []


def test_cancel_ends_a_drag_once(hand: ScenePointer):
    hand.handle(event(DOWN, 200, 200), STAGE)
    assert hand.cancel()
    assert not hand.cancel()
    assert [e.kind for e in hand.take()] == ["move", "down", "cancel"]
    assert not hand.handle(event(UP, 200, 200), STAGE)


def test_middle_and_right_drag_pan(hand: ScenePointer):
    for button in (2, 3):
        before = hand.camera.center[0]
        hand.handle(event(DOWN, 200, 200, button), STAGE)
        hand.handle(event(MOVE, 205, 200), STAGE)
        hand.handle(event(UP, 205, 200, button), STAGE)
        assert hand.camera.center[0] == pytest.approx(before - 5 / hand.camera.scale)
    assert hand.take() == []


def test_second_button_during_a_drag_is_nothing(hand: ScenePointer):
    hand.handle(event(DOWN, 200, 200), STAGE)
    hand.handle(event(DOWN, 210, 200, 3), STAGE)
    hand.handle(event(UP, 210, 200, 3), STAGE)
    assert hand.held == 1
    assert [e.button for e in hand.take() if e.kind != "move"] == [1]


def test_scene_may_take_wheel_and_right_button(monkeypatch: pytest.MonkeyPatch, hand: ScenePointer):
    monkeypatch.setattr(example_scene.BouncingBall, "takes", frozenset({"wheel", "right"}), raising=False)
    greedy = ScenePointer(example_scene.BouncingBall, hand.camera)
    scale = greedy.camera.scale
    greedy.handle(pygame.Event(pygame.MOUSEWHEEL, x=0, y=-2, precise_y=-2.0, pos=(200, 200)), STAGE)
    greedy.handle(event(DOWN, 200, 200, 3), STAGE)
    greedy.handle(event(UP, 200, 200, 3), STAGE)
    events = greedy.take()
    assert [(e.kind, e.wheel) for e in events if e.kind == "wheel"] == [("wheel", -2.0)]
    assert [e.button for e in events if e.kind in ("down", "up")] == [3, 3]
    greedy.camera.update(10.0)
    assert greedy.camera.scale == scale


def test_who_has_panned_everything_away_is_told_the_key_home(start, monkeypatch):
    from game.app.scene.playing import picture

    driver, said = start(), []
    screen = driver.open("example")
    monkeypatch.setattr(picture, "draw_signs", lambda surface, look, layout, lines: said.append(lines))
    driver.frames(2)
    assert not screen.play.view.lost and not any("Out of view" in line for line in said[-1])
    screen.play.view.camera.pan(4000.0, 0.0)
    driver.frames(2)
    assert screen.play.view.lost and "Out of view · Home shows all of it" in said[-1]
    driver.key(pygame.K_HOME)
    driver.frames(120)
    assert not screen.play.view.lost and not any("Out of view" in line for line in said[-1])


def test_a_scene_made_as_small_as_a_dot_is_out_of_view(start):
    driver = start()
    view = driver.open("example").play.view
    view.camera.zoom(0.02, view.rect.center)
    driver.frames(120)
    assert view.lost
