"""The tally of a match on film: names and balls stand side by side."""

from __future__ import annotations

import pygame

from game.app.film.match_tally import draw_tally
from game.billiards.players.match import PLAYERS
from game.ui.look.look import Look
from game.ui.look.theme import DARK


def test_the_balls_leave_the_name_of_the_player_as_it_is():
    pygame.font.init()
    look, row = Look(DARK), pygame.Rect(0, 0, 1280, 60)
    pictures = []
    for balls in ((), (1, 9)):
        surface = pygame.Surface(row.size, 0, 32)
        draw_tally(surface, look, row, ("amber", "pink"), (balls, ()))
        pictures.append(surface)
    name = look.fonts.size(PLAYERS[0], 13, "semibold")[0]
    words = pygame.Rect(look.px(24 + 32), row.centery - look.px(12), name, look.px(24))
    bare, full = (pygame.image.tobytes(picture.subsurface(words), "RGB") for picture in pictures)
    assert bare == full
    beyond = words.move(name + look.px(10), 0)  # where the balls are
    bare, full = (pygame.image.tobytes(picture.subsurface(beyond), "RGB") for picture in pictures)
    assert bare != full


def test_every_ball_is_on_the_card_of_its_player():
    pygame.font.init()
    look, row, balls = Look(DARK), pygame.Rect(0, 0, 1280, 60), (1, 2, 3, 9, 10)
    surface = pygame.Surface(row.size, 0, 32)
    draw_tally(surface, look, row, ("amber", "pink"), (balls, balls))
    names = [look.fonts.size(player, 13, "semibold")[0] for player in PLAYERS]
    first = look.px(24 + 32 + 20) + names[0], row.right - look.px(24 + 8 + 24 * len(balls))
    for x in first:
        for place in range(len(balls)):  # beside the number, which is dark
            at = x + look.px(24) * place + look.px(6), row.centery
            assert max(surface.get_at(at)[:3]) > 100, place
