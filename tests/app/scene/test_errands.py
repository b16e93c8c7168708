"""What takes long is done by a thread, in the order in which it was asked for."""

from threading import Event, current_thread, main_thread

import pygame
import pytest

from game.app.scene.errands import Errands
from game.app.scene.playing.standstill import PATIENCE_S, Standstill
from game.stage import SetEffect, SetParameter
from game.ui.look.look import Look
from game.ui.look.theme import DARK

LONG_S = 600.0


def test_what_is_asked_for_acts_at_once_when_nothing_is_under_way():
    errands, done = Errands(in_background=True), []
    errands.act(lambda: done.append("a"))
    assert done == ["a"] and not errands.busy


def test_what_comes_meanwhile_waits_for_its_turn():
    errands, done, go_on = Errands(in_background=True), [], Event()

    def work():
        assert go_on.wait(LONG_S)
        thread = current_thread()
        return lambda: done.append(("work", thread is main_thread(), current_thread() is main_thread()))

    errands.work(work)
    errands.act(lambda: done.append("after"))
    errands.update(0.1)
    errands.update(0.1)
    assert errands.busy and not done
    assert errands.seconds == pytest.approx(0.2)
    go_on.set()
    errands.wait(LONG_S)
    errands.update(0.1)
    assert done == [("work", False, True), "after"] and not errands.busy
    errands.update(0.1)
    assert errands.seconds == 0.0


def test_of_what_waits_under_one_name_the_last_counts():
    errands, done, go_on = Errands(in_background=True), [], Event()
    errands.work(lambda: go_on.wait(LONG_S) and done.clear)
    for value in (1, 2):
        errands.act(lambda value=value: done.append(value), "parameter")
    errands.act(lambda: done.append("other"))
    errands.act(lambda: done.append(3), "parameter")
    go_on.set()
    errands.wait(LONG_S)
    errands.update(0.0)
    assert done == [2, "other", 3]


def test_nobody_looks_on_so_that_all_is_done_at_once():
    errands, done = Errands(in_background=False), []
    errands.work(lambda: lambda: done.append(current_thread() is main_thread()))
    assert done == [True] and not errands.busy


def test_what_is_to_be_kept_is_finished_when_the_scene_is_left():
    errands, done, go_on = Errands(in_background=True), [], Event()
    errands.work(lambda: go_on.wait(LONG_S) and done.clear)
    errands.work(lambda: lambda: done.append("kept"), kept=True)
    errands.act(lambda: done.append("not kept"))
    go_on.set()
    errands.close()
    assert done == ["kept"] and not errands.busy


def test_what_goes_wrong_in_the_thread_is_raised_in_the_window_and_the_rest_goes_on():
    errands, done = Errands(in_background=True), []

    def fail():
        raise ArithmeticError("no")

    errands.work(fail)
    errands.act(lambda: done.append("after"))
    errands.wait(LONG_S)
    with pytest.raises(ArithmeticError, match="no"):
        errands.update(0.0)
    errands.act(lambda: done.append("later"))
    assert done == ["after", "later"] and not errands.busy


def test_an_effect_acts_at_the_step_at_which_it_was_switched_however_long_its_code_takes(start, monkeypatch):
    quick, slow = start(), start()
    slow.app.background = True
    ends = []
    for driver in (quick, slow):
        play = driver.open().play
        driver.frames(20)
        go_on = Event()
        prepare = play.record.variants.prepare

        def prepare_late(events, prepare=prepare, go_on=go_on):
            assert go_on.wait(LONG_S)
            prepare(events)

        monkeypatch.setattr(play.record.variants, "prepare", prepare_late)
        if driver is quick:
            go_on.set()
        at = play.stage.step_number
        play.post(SetEffect("test-gravity", False))
        play.post(SetParameter("restitution", 0.5))
        if driver is slow:
            driver.frames(7)
            assert play.stage.step_number == at and "test-gravity" in play.stage.scene.active
            go_on.set()
            play.record.errands.wait(LONG_S)
        driver.frames(30)
        assert [stamped.step for stamped in play.stage.recording.events] == [at, at]
        assert "test-gravity" not in play.stage.scene.active and play.stage.scene.restitution == 0.5
        ends.append((at, play.stage))
    assert ends[0][0] == ends[1][0]
    stages = [stage for _, stage in ends]
    for stage in stages:
        stage.run(ends[0][0] + 200 - stage.step_number)
    assert stages[0].digest() == stages[1].digest()


def test_a_level_opens_in_the_background(start, tmp_path):
    driver = start()
    driver.app.background = True
    play = driver.open().play
    driver.frames(5)
    play.shelf.save()
    play.record.errands.wait(LONG_S)
    driver.frames(1)
    (saved,) = play.shelf.saved()[:1]
    play.open_file(saved.value)
    assert play.record.errands.busy
    play.record.errands.wait(LONG_S)
    driver.frames(1)
    assert play.shelf.present == saved.value and not play.record.errands.busy


def test_work_inside_says_so_and_of_what_waits_under_one_name_the_last_counts():
    errands, done, go_on = Errands(in_background=True), [], Event()
    errands.work_inside(lambda: done.append("first") if go_on.wait(LONG_S) else None, "parameter")
    for value in (1, 2):
        errands.work_inside(lambda value=value: done.append(value), "parameter")
    assert errands.inside
    go_on.set()
    while errands.busy:
        errands.wait(LONG_S)
        errands.update(0.0)
    assert done == ["first", 2] and not errands.inside


def test_after_a_moment_it_is_said_that_the_scene_is_being_worked_at():
    look, stage = Look(DARK), pygame.Rect(0, 0, 300, 200)
    surface = pygame.Surface((300, 200), 0, 32)
    Standstill.tell(surface, look, stage, PATIENCE_S)
    assert not pygame.surfarray.array3d(surface).any()
    Standstill.tell(surface, look, stage, PATIENCE_S + 0.1)
    rows = pygame.surfarray.array3d(surface).any(axis=(0, 2)).nonzero()[0]
    assert rows.min() > 150 and rows.max() < 200


def test_while_nobody_may_look_the_last_picture_stays():
    standstill, surface = Standstill(), pygame.Surface((4, 4), 0, 32)
    surface.fill("red")
    standstill.show(surface)
    surface.fill("blue")
    standstill.show(surface)
    assert surface.get_at((1, 1)) == pygame.Color("red")
    standstill.end()
    surface.fill("blue")
    standstill.show(surface)
    assert surface.get_at((1, 1)) == pygame.Color("blue")


def test_a_thread_that_rests_lets_the_window_look_once_and_whoever_waits_for_it_is_not_kept():
    errands, looks = Errands(in_background=True), []

    def work():
        for number in range(3):
            looks.append(number)
            errands.rest()

    errands.work_inside(work)
    for number in range(2):
        while errands.inside:
            errands.update(0.0)
        assert looks == list(range(number + 1)) and errands.busy
        errands.update(0.0)
        assert not errands.inside  # until the picture is drawn
        errands.shown()
        assert errands.inside
    errands.wait(LONG_S)
    errands.update(0.0)
    assert looks == [0, 1, 2] and not errands.busy
