"""The row of hints gives way to a message: no hint is drawn where the message stands."""

import pygame

from tests.app.tests_app import Driver


def widths(driver: Driver, monkeypatch) -> list[int | None]:
    """What the row of hints is told that it may take, px."""
    told: list[int | None] = []
    shell = driver.top.shell
    draw = shell.hints.draw

    def noted(surface: pygame.Surface, width: int | None = None) -> None:
        told.append(width)
        draw(surface, width)

    monkeypatch.setattr(shell.hints, "draw", noted)
    return told


def test_hints_have_the_whole_row_or_what_a_message_leaves_of_it(driver: Driver, monkeypatch):
    driver.open("example")
    driver.app.toasts.clear()
    driver.frames(3)
    told = widths(driver, monkeypatch)
    driver.frames(1)
    assert told[-1] is None
    driver.app.tell("Somebody says something.", "It is long enough to take a part of the row.")
    driver.frames(30)
    row = driver.top.shell.layout.hint_bar
    taken = driver.app.toasts.width(row.w)
    assert 100 < taken < row.w
    assert told[-1] == row.w - taken - driver.app.look.px(16)
