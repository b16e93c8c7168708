"""Which balls can be hit (WPBSA 2.17, 3.14)."""

import math

from game.billiards.game.snooker.sight import (
    any_path,
    full_path,
    obstructions,
    snookered,
    snookering_balls,
)
from game.billiards.table.snooker import BALL_RADIUS, BAULK, MIDDLE, SPOTS

R = BALL_RADIUS
BLUE, PINK = 19, 20


def test_a_ball_between_hides_both_edges_and_the_full_ball():
    places = {0: (0.9, 1.0), 1: (0.9, 3.0), BLUE: (0.9, 1.5)}
    assert obstructions(places, (1,), 1) == (BLUE,)
    assert snookered(places, (1,)) and not full_path(places, (1,)) and not any_path(places, (1,))
    assert snookering_balls(places, (1,)) == (BLUE,)


def test_one_hidden_edge_is_a_snooker_but_part_of_the_ball_can_be_hit():
    aside = 2.6 * R  # covers the one edge, not the middle
    places = {0: (0.9, 1.0), 1: (0.9, 3.0), BLUE: (0.9 + aside, 2.5)}
    assert snookered(places, (1,)) and any_path(places, (1,)) and full_path(places, (1,))
    free = {**places, BLUE: (0.9 + 4.1 * R, 2.5)}
    assert not snookered(free, (1,))


def test_balls_on_hide_nothing_and_one_open_ball_is_enough():
    places = {0: (0.9, 1.0), 1: (0.9, 3.0), 2: (0.9, 1.5)}
    assert not snookered(places, (1, 2)) and obstructions(places, (1, 2), 1) == ()
    places = {0: (0.9, 1.0), 1: (0.9, 3.0), BLUE: (0.9, 1.5), 2: (0.2, 1.0)}
    assert not snookered(places, (1, 2)) and snookered(places, (1,))


def test_different_balls_that_hide_different_reds_are_no_effective_snooker():
    places = {0: (0.9, 1.0), 1: (0.9, 3.0), BLUE: (0.9, 1.5), 2: (0.2, 1.0), PINK: (0.5, 1.0)}
    assert snookered(places, (1, 2)) and snookering_balls(places, (1, 2)) == ()  # 2.17(c)
    nearer = {**places, 2: (0.9, 2.5)}
    assert snookering_balls(nearer, (1, 2)) == (BLUE,)


def test_a_curved_cushion_that_is_nearer_than_the_ball_is_no_snooker():
    places = {0: (0.10, 0.3), 1: (0.02, 1.0), BLUE: (0.05, 0.9)}
    assert snookered(places, (1,))
    curve = ((-0.02, 0.5, 0.08),)
    assert not snookered(places, (1,), curve)  # 2.17(e)
    assert snookered(places, (1,), ((-0.02, 0.985, 0.08),))  # farther than the blue


def test_a_touching_ball_on_is_not_hidden():
    places = {0: (0.9, 1.0), 1: (0.9 + 2.0 * R, 1.0), BLUE: (0.9, 1.0 + 2.0 * R)}
    assert not snookered(places, (1,))
    nearly = {0: (0.9, 1.0), 1: (0.9 + 2.0 * R + 5e-5, 1.0), BLUE: (0.9, 1.0 + 2.0 * R + 1e-3)}
    assert not snookered(nearly, (1,))
    away = {0: (0.9, 1.0), 1: (0.2, 1.0), BLUE: (0.9 + 2.0 * R, 1.0)}
    assert not snookered(away, (1,))  # a touching ball behind hides nothing


def test_in_hand_the_whole_d_counts():
    places = {1: (MIDDLE, BAULK + 0.5), BLUE: (MIDDLE, BAULK + 0.2)}
    assert snookered({**places, 0: (MIDDLE, BAULK - 0.1)}, (1,))
    assert not snookered(places, (1,))  # from the end of the D the red is seen
    near = {
        1: (MIDDLE, 3.0),
        BLUE: (MIDDLE - 1.02 * R, 3.0 - 1.9 * R),
        PINK: (MIDDLE + 1.02 * R, 3.0 - 1.9 * R),
    }
    assert snookered(near, (1,))


def test_angles_and_edges_are_the_finest_contacts():
    places = {0: (0.5, 0.5), 1: (0.5, 1.5)}
    edge = math.asin(2.0 * R / 1.0)
    x = 0.5 + 0.5 * math.tan(edge) + 1.99 * R / math.cos(edge)
    assert obstructions({**places, BLUE: (x, 1.0)}, (1,), 1) == (BLUE,)
    x = 0.5 + 0.5 * math.tan(edge) + 2.01 * R / math.cos(edge)
    assert obstructions({**places, BLUE: (x, 1.0)}, (1,), 1) == ()
    assert SPOTS[BLUE][1] == 0.5 * 3.569


# the brown hides the first red, which alone hides the second
PACK = {0: (0.9, 0.5), 1: (0.985, 1.9), 2: (1.05, 2.1), 18: (0.9, 1.2)}


def test_reds_do_not_hide_reds_from_a_full_ball():
    """3.14(c): a red counts if no ball that is not on obstructs it."""
    assert not full_path(PACK, (1,)) and not full_path(PACK, (2,))
    assert full_path(PACK, (1, 2))
    assert not full_path({**PACK, 17: (0.98, 1.2)}, (1, 2))


def test_a_colour_hides_a_colour_that_is_on_too():
    places = {0: (0.9, 1.0), 19: (0.9, 2.0), 20: (0.93, 1.5)}
    assert not full_path(places, (19,)) and full_path(places, (19, 20))
