"""Every sign draws itself at every size, in its colour, in the middle, the same each time."""

import numpy as np
import pygame
import pytest

from game.ui.look.icons import SIGNS, icon, logo
from game.ui.look.theme import DARK, LIGHT

INK = pygame.Color("#B8BFC4")


@pytest.mark.parametrize("name", sorted(SIGNS))
@pytest.mark.parametrize("size", [1, 14, 20, 25, 40])
def test_each_sign_at_each_size(name, size):
    picture = icon(name, size, INK)
    assert picture.get_size() == (size, size)
    alpha = pygame.surfarray.array_alpha(picture).astype(float) / 255
    if size >= 14:
        share = alpha.mean()
        assert 0.02 < share < 0.5
        assert alpha.max() > 0.55  # a thin line may lie across two pixels
    rgb = pygame.surfarray.array3d(picture)
    assert (rgb[alpha > 0] == tuple(INK)[:3]).all()


def test_a_sign_covers_the_same_share_at_every_size():
    shares = [pygame.surfarray.array_alpha(icon("contrast", n, INK)).mean() / 255 for n in (20, 40, 160)]
    assert max(shares) - min(shares) < 0.01


def test_symmetric_signs_are_symmetric():
    alpha = pygame.surfarray.array_alpha(icon("pause", 20, INK))
    assert (alpha == alpha[::-1]).all()
    assert (alpha == alpha[:, ::-1]).all()
    step, back = (pygame.surfarray.array_alpha(icon(name, 40, INK)) for name in ("step", "step-back"))
    assert np.abs(step.astype(int) - back[::-1].astype(int)).max() <= 1


def test_signs_are_kept_and_follow_the_colours_alpha():
    assert icon("play", 20, INK) is icon("play", 20, INK)
    pale = pygame.Color(INK.r, INK.g, INK.b, 128)
    assert pygame.surfarray.array_alpha(icon("play", 20, pale)).max() == 128


def test_unknown_sign_is_refused_with_the_known():
    with pytest.raises(ValueError, match="icon 'heart': there is none; known are back"):
        icon("heart", 20, INK)


def test_the_mark_of_carom_wears_the_theme():
    dark, light = logo(44, DARK), logo(44, LIGHT)
    assert dark.get_size() == light.get_size() == (44, 44)
    assert tuple(dark.get_at((31, 11)))[:3] != tuple(light.get_at((31, 11)))[:3]
    assert logo(44, DARK) is dark
