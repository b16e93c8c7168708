"""The rules of snooker, a case for each paragraph (WPBSA, section.rule)."""

import msgspec
import pytest

from game.billiards.game.rules import Call
from game.billiards.game.snooker.rules import QUIET, new_snooker
from game.billiards.table.snooker import SPOTS
from tests.billiards.game.snooker.referee import (
    BLACK,
    BLUE,
    BROWN,
    GREEN,
    OPEN,
    PINK,
    YELLOW,
    game,
    order,
    seen,
    shot,
)

ALL = (YELLOW, GREEN, BROWN, BLUE, PINK, BLACK)


# -- 3.1, 3.3: order of play, points ----------------------------------------------------------------


def test_a_frame_begins_in_hand_with_a_red_on():
    start = new_snooker()
    assert start.in_hand == "in the D" and start.balls_on() == tuple(range(1, 16))
    assert start.points_left == 147 and start.target().value == 1


def test_each_potted_red_counts_one_and_a_colour_is_on_then():
    after = game().judge(shot(1, down=(1, 2))).game
    assert after.points == (2, 0) and after.turn == 0 and after.stage == "colour"
    assert after.on_table == ALL and after.balls_on() == ALL


def test_a_nominated_colour_counts_its_value_and_comes_back():
    verdict = game(stage="colour").judge(shot(BLACK, down=(BLACK,)), Call(BLACK))
    assert verdict.game.points == (7, 0) and verdict.game.stage == "red"
    assert verdict.spot == (BLACK,) and BLACK in verdict.game.on_table


def test_after_the_last_red_any_colour_then_the_colours_in_order():
    after = game(on_table=(1, *ALL)).judge(shot(1, down=(1,))).game
    assert after.stage == "colour"
    verdict = after.judge(shot(PINK, down=(PINK,)), Call(PINK))
    assert verdict.spot == (PINK,) and verdict.game.stage == "order"
    assert verdict.game.balls_on() == (YELLOW,)


def test_colours_potted_in_order_stay_down():
    verdict = order(*ALL).judge(shot(YELLOW, down=(YELLOW,)))
    assert verdict.spot == () and verdict.game.on_table == ALL[1:] and verdict.game.points == (2, 0)
    assert verdict.game.balls_on() == (GREEN,)


def test_a_miss_without_a_foul_passes_the_turn_and_reds_are_on():
    after = game(stage="colour", run=1).judge(shot(BLUE), Call(BLUE)).game
    assert after.turn == 1 and after.stage == "red" and after.run == 0 and after.points == (0, 0)
    assert order(*ALL).judge(shot(YELLOW)).game.stage == "order"


def test_break_and_highest_break_are_counted():
    state = game()
    for stroke, call in ((shot(1, down=(1,)), Call()), (shot(BLACK, down=(BLACK,)), Call(BLACK))):
        state = state.judge(stroke, call).game
    assert state.run == 8 and state.high == (8, 0)
    after = state.judge(shot(2)).game
    assert after.run == 0 and after.high == (8, 0)


def test_points_left_and_snookers_needed():
    assert game().points_left == 2 * 8 + 27
    assert game(stage="colour").points_left == 2 * 8 + 27 + 7
    assert order(BLUE, PINK, BLACK).points_left == 18
    behind = game(points=(10, 60))
    assert behind.snookers_needed(0) == 2  # 50 behind, 43 left: 7 points, two fouls of 4
    assert behind.snookers_needed(1) == 0
    assert game(points=(10, 53)).snookers_needed(0) == 0
    assert order(PINK, BLACK, points=(0, 20)).snookers_needed(0) == 2  # 7 points at 6 a foul


# -- 3.10: fouls and their points -------------------------------------------------------------------


@pytest.mark.parametrize(
    ("state", "stroke", "call", "points"),
    [
        (game(), shot(), Call(), 4),  # (a)(vi) no ball hit
        (game(), shot(1, cue=True), Call(), 4),  # (a)(vii) in-off
        (order(BLUE, PINK, BLACK), shot(BLUE, cue=True), Call(), 5),
        (game(), shot(BLACK), Call(), 7),  # (b)(ii) a ball not on hit first
        (game(), shot(YELLOW), Call(), 4),
        (game(stage="colour"), shot(1), Call(PINK), 6),
        (game(stage="colour"), shot(BLUE), Call(BLACK), 7),
        (game(), shot(1, down=(PINK,)), Call(), 6),  # (b)(i) a ball not on goes down
        (game(stage="colour"), shot(YELLOW, down=(BLACK,)), Call(YELLOW), 7),
        (game(stage="colour"), shot(BLUE, down=(BLUE, 1)), Call(BLUE), 5),
        (game(), shot(1, off=(BLUE,)), Call(), 5),  # (b)(vi) off the table
        (game(), shot(1, off=(0,)), Call(), 4),
        (game(), shot(1, BLUE), Call(), 5),  # (c) two balls at once
        (order(BLUE, PINK, BLACK), shot(BLUE, BLACK), Call(), 7),
        (game(stage="colour"), shot(1), Call(), 7),  # (d) a red again, no colour nominated
        (game(stage="colour"), shot(), Call(), 7),
    ],
)
def test_a_foul_costs_four_or_the_value_of_the_ball_on_or_concerned(state, stroke, call, points):
    verdict = state.judge(stroke, call)
    assert verdict.fouls and verdict.game.points == (0, points) and verdict.game.turn == 1
    assert [option.name for option in verdict.game.options][:2] == ["play", "again"]
    assert str(points) in verdict.words[0]  # the consequence comes first


def test_the_worst_of_several_fouls_counts_once():
    assert game().judge(shot(YELLOW, down=(BLACK,), cue=True)).game.points == (0, 7)  # 3.11(d)


def test_two_reds_at_once_are_no_foul():
    assert game().judge(shot(1, 2)).legal  # 3.6


def test_points_of_the_foul_stroke_do_not_count_and_reds_stay_down():
    verdict = game(run=8, points=(8, 0)).judge(shot(1, down=(1, YELLOW)))
    assert verdict.game.points == (8, 4) and verdict.game.run == 0
    assert verdict.game.on_table == (2, *ALL) and verdict.spot == (YELLOW,)


def test_in_off_leaves_the_cue_ball_in_the_d():
    assert game().judge(shot(1, cue=True)).game.in_hand == "in the D"
    assert game().judge(shot()).game.in_hand == ""


# -- 3.8, 2.19: touching ball, push stroke ----------------------------------------------------------

TOUCHING = {**OPEN, 0: (0.4, 2.0 - 0.0525)}  # the cue ball lies at red 1


def test_a_touching_ball_on_counts_as_hit_when_it_is_played_away_from():
    assert game().judge(shot(), seen=seen(TOUCHING)).legal
    assert game().judge(shot(BLUE), seen=seen(TOUCHING)).legal  # what is hit then is free


def test_playing_into_a_touching_ball_is_a_push_stroke():
    verdict = game().judge(shot(1), seen=seen(TOUCHING))
    assert [foul.kind for foul in verdict.fouls] == ["push stroke"] and verdict.game.points == (0, 4)


def test_away_from_a_touching_ball_that_is_not_on_a_ball_on_must_be_hit():
    at_black = {**OPEN, 0: (SPOTS[BLACK][0], SPOTS[BLACK][1] - 0.0525)}
    assert not game().judge(shot(), seen=seen(at_black)).legal
    assert game().judge(shot(1), seen=seen(at_black)).legal
    verdict = game().judge(shot(BLACK), seen=seen(at_black))
    assert verdict.game.points == (0, 7)


def test_a_push_costs_the_ball_concerned():
    verdict = game(stage="colour").judge(shot(BLUE), Call(BLUE), seen(pushed=True))
    assert [foul.kind for foul in verdict.fouls] == ["push stroke"] and verdict.game.points == (0, 5)


# -- 3.11 to 3.13: choices, free ball ---------------------------------------------------------------

HIDDEN = {0: (0.9, 3.0), 1: (0.4, 1.6), 2: (1.2, 1.6), YELLOW: (0.85, 2.9), GREEN: (0.93, 2.9),
          **{ball: SPOTS[ball] for ball in (BROWN, BLUE, PINK, BLACK)}}  # fmt: skip


def test_after_a_foul_the_other_plays_or_lets_play_again():
    fouled = game().judge(shot()).game
    assert fouled.choose("play").game.turn == 1
    again = fouled.choose("again").game
    assert again.turn == 0 and again.stage == "red" and not again.free_ball
    with pytest.raises(ValueError, match="option"):
        fouled.choose("replay")
    with pytest.raises(ValueError, match="choose first"):
        fouled.judge(shot(1))


def test_snookered_after_a_foul_there_is_a_free_ball():
    fouled = game().judge(shot(YELLOW, rest=HIDDEN)).game
    assert fouled.free_ball and "free ball" in fouled.options[0].words
    assert fouled.choose("play").game.free_ball
    assert not fouled.choose("again").game.free_ball  # 3.12(b)
    assert not game().judge(shot(YELLOW)).game.free_ball


def test_a_free_ball_counts_as_the_ball_on_and_comes_back():
    verdict = game(free_ball=True).judge(shot(BLACK, down=(BLACK,)), Call(BLACK))
    assert verdict.game.points == (1, 0) and verdict.spot == (BLACK,) and verdict.game.stage == "colour"
    verdict = order(BLUE, PINK, BLACK, free_ball=True).judge(shot(PINK, down=(PINK,)), Call(PINK))
    assert verdict.game.points == (5, 0) and verdict.spot == (PINK,)
    assert verdict.game.balls_on() == (BLUE,) and not verdict.game.free_ball


def test_free_ball_and_ball_on_down_together():
    both = game(free_ball=True).judge(shot(BLACK, down=(BLACK, 1)), Call(BLACK))
    assert both.game.points == (2, 0)  # 3.12(f): each, where red is on
    both = order(BLUE, PINK, BLACK, free_ball=True).judge(shot(PINK, down=(PINK, BLUE)), Call(PINK))
    assert both.game.points == (5, 0) and both.spot == (PINK,)  # else the ball on alone
    assert both.scored == (BLUE,)
    assert both.game.on_table == (PINK, BLACK)


def test_the_free_ball_must_be_hit_first_or_with_the_ball_on():
    state = game(free_ball=True)
    assert state.judge(shot(BLACK), Call(BLACK)).legal
    assert state.judge(shot(BLACK, 1), Call(BLACK)).legal  # 3.6
    assert state.judge(shot(1), Call(BLACK)).game.points == (0, 4)
    assert state.judge(shot(YELLOW), Call(BLACK)).game.points == (0, 4)
    assert state.judge(shot(1)).legal  # no free ball was nominated


def test_nobody_may_be_snookered_behind_the_free_ball():
    rest = {0: (0.889, 2.0), 1: (0.889, 3.4), YELLOW: (0.889, 2.2),
            GREEN: SPOTS[GREEN], BROWN: SPOTS[BROWN], BLUE: SPOTS[BLUE], PINK: (0.3, 0.4),
            BLACK: (1.4, 0.4)}  # fmt: skip
    state = game(on_table=(1, *ALL), free_ball=True)
    verdict = state.judge(shot(YELLOW, rest=rest), Call(YELLOW))
    assert [foul.kind for foul in verdict.fouls] == ["behind the ball"] and verdict.game.points == (0, 4)
    assert state.judge(shot(BLUE, rest=rest), Call(BLUE)).legal  # another ball hides it
    two = {0: (0.889, 2.0), PINK: (0.889, 3.4), BLACK: (0.889, 2.2)}
    assert order(PINK, BLACK, free_ball=True).judge(shot(BLACK, rest=two), Call(BLACK)).legal


# -- 3.14: foul and a miss --------------------------------------------------------------------------


def missed(state, **more):
    """A stroke past everything, of an open table."""
    return state.judge(shot(), seen=seen(**more))


def test_a_miss_lets_the_balls_be_put_back():
    fouled = missed(game(stage="red", points=(5, 5))).game
    assert [option.name for option in fouled.options] == ["play", "again", "replay"]
    verdict = fouled.choose("replay")
    assert verdict.reset and verdict.game.turn == 0 and verdict.game.stage == "red"
    assert verdict.game.points == (5, 9) and verdict.game.misses == 1


def test_put_back_the_same_is_on_as_before():
    fouled = game(stage="colour").judge(shot(1, down=(1,)), Call(PINK), seen()).game
    assert fouled.on_table == (2, *ALL)
    again = fouled.choose("replay").game
    assert again.stage == "colour" and again.on_table == (1, 2, *ALL)


def test_hitting_a_ball_on_is_no_miss_whatever_else_happens():
    assert not game().judge(shot(1, cue=True), seen=seen()).game.misses


def test_a_third_miss_with_a_full_ball_to_be_hit_loses_the_frame():
    state = game()
    for count in (1, 2):
        verdict = missed(state)
        assert verdict.game.full_misses == count
        state = verdict.game.choose("replay").game
    assert any("third miss" in words for words in verdict.words)
    lost = missed(state)
    assert lost.game.winner == 1 and lost.game.won == (0, 1)
    played_on = missed(missed(game()).game.choose("again").game)
    assert played_on.game.full_misses == 1  # another position begins to count again


# the brown hides the first red, which alone hides the second
PACK = {**SPOTS, 0: (0.9, 0.5), 1: (0.985, 1.9), 2: (1.05, 2.1), BROWN: (0.9, 1.2)}


def test_a_red_that_only_a_red_hides_can_be_hit_full():
    state, places = game(), PACK
    for count in (1, 2):
        verdict = state.judge(shot(), seen=seen(places))
        assert verdict.game.full_misses == count
        state = verdict.game.choose("replay").game
    assert verdict.words[0].startswith("Foul and a miss") and "third miss" in verdict.words[1]
    assert state.judge(shot(), seen=seen(places)).game.winner == 1


def test_another_colour_that_could_have_been_nominated_counts_as_full():
    """After a red the nominated colour is hidden, another one is not."""
    places = {0: (0.9, 1.2), 1: (0.4, 2.0), 2: (0.9, 1.45), **SPOTS, PINK: (0.9, 1.7)}
    state = game(stage="colour")
    assert state.judge(shot(), Call(PINK), seen(places)).game.full_misses == 1


def test_a_free_ball_is_worth_what_it_can_still_bring():
    red, late = game(free_ball=True), order(PINK, BLACK, free_ball=True)
    assert red.points_left == 2 * 8 + 27 + 8 and late.points_left == 6 + 13
    first = red.judge(shot(BLUE, down=(BLUE,)), Call(BLUE)).game
    assert first.points == (1, 0) and first.points_left == red.points_left - 1
    second = late.judge(shot(BLACK, down=(BLACK,)), Call(BLACK)).game
    assert second.points == (6, 0) and second.points_left == late.points_left - 6


def test_without_a_full_ball_to_be_hit_misses_never_lose_the_frame():
    state = game()
    for _ in range(4):
        verdict = state.judge(shot(), seen=seen(HIDDEN))
        assert verdict.game.misses and not verdict.game.full_misses
        state = verdict.game.choose("replay").game


def test_no_miss_is_called_where_a_player_needs_snookers():
    for points in ((0, 60), (60, 0), (0, 43)):  # 43 are left: also if just that is missing
        assert not missed(game(points=points)).game.misses
    assert not missed(game(points=(0, 40))).game.misses  # needed as a result of the stroke
    assert missed(game(points=(0, 38))).game.misses
    assert game(points=(0, 43)).excused and not game(points=(0, 42)).excused


def test_after_a_miss_another_one_is_called_whatever_the_scores():
    state = game(points=(0, 38))
    again = missed(state).game.choose("replay").game
    assert again.excused is False and again.points == (0, 42)
    second = missed(again)  # 46 behind, 43 left
    assert second.game.full_misses == 2


def test_what_the_referee_expects_is_a_setting():
    for rule, near, called in (
        ("professional", 0.01, True), ("club", 0.01, False), ("club", 0.2, True), ("off", 0.2, False),
    ):  # fmt: skip
        verdict = game(miss_rule=rule).judge(shot(), seen=seen(HIDDEN, near=near))
        assert bool(verdict.game.misses) is called, (rule, near)
    open_table = game(miss_rule="club").judge(shot(), seen=seen(near=0.01))
    assert open_table.game.misses == 1  # a straight path was open


# -- 3.4, 2.1: how frames end -----------------------------------------------------------------------


def test_the_final_pot_or_foul_at_the_black_ends_the_frame():
    won = order(BLACK, points=(50, 40)).judge(shot(BLACK, down=(BLACK,)))
    assert won.game.winner == 0 and won.game.won == (1, 0) and won.game.points == (57, 40)
    lost = order(BLACK, points=(42, 40)).judge(shot(cue=True))
    assert lost.game.winner == 1 and lost.game.points == (42, 47)
    assert order(PINK, BLACK, points=(50, 40)).judge(shot(cue=True)).game.winner is None


def test_level_scores_put_the_black_back_and_lots_are_drawn():
    verdict = order(BLACK, points=(40, 47)).judge(shot(BLACK, down=(BLACK,)))
    state = verdict.game
    assert state.winner is None and state.black_again and verdict.spot == (BLACK,)
    assert state.in_hand == "in the D" and state.balls_on() == (BLACK,)
    assert {option.name for option in state.options} == {"first", "second"}
    assert state.choose("second").game.turn == 1 - state.turn
    first = state.choose("first").game
    lost = first.judge(shot())
    assert lost.game.winner == 1 - state.turn
    turns = {
        order(BLACK, points=(40, 47), lot=k).judge(shot(BLACK, down=(BLACK,))).game.turn for k in range(12)
    }
    assert turns == {0, 1}


def test_claim_and_concession():
    ahead = order(BLACK, points=(60, 50))
    assert ahead.may_claim and ahead.claim().game.winner == 0
    for not_yet in (
        order(BLACK, points=(57, 50)),
        order(PINK, BLACK, points=(90, 0)),
        order(BLACK, points=(0, 50)),
    ):
        assert not not_yet.may_claim
        with pytest.raises(ValueError, match="claimed"):
            not_yet.claim()
    assert game().concede().game.winner == 1
    with pytest.raises(ValueError, match="concede"):
        game(winner=0).concede()


def test_a_stalemate_begins_the_frame_again():
    state = game(points=(7, 1), high=(7, 1), breaker=1)
    for _ in range(QUIET):
        assert not state.may_restart
        state = state.judge(shot(1)).game
    verdict = state.restart()
    assert verdict.rack and verdict.game.points == (0, 0) and verdict.game.turn == 1
    assert verdict.game.won == (0, 0) and verdict.game.opening
    with pytest.raises(ValueError, match="without a point"):
        game().restart()


def test_frames_are_begun_in_turns_and_a_match_ends():
    state = msgspec.structs.replace(new_snooker(best_of=3), winner=0, won=(1, 0), high=(33, 2))
    assert not state.match_over
    verdict = state.next_rack()
    assert verdict.rack and verdict.game.turn == 1 and verdict.game.won == (1, 0)
    assert verdict.game.high == (33, 2) and verdict.game.winner is None
    assert verdict.game.on_table == tuple(range(1, 22))
    over = msgspec.structs.replace(state, won=(2, 0))
    assert over.match_over and over.next_rack().game.won == (0, 0)


# -- six-red ----------------------------------------------------------------------------------------


def test_six_red_begins_with_six():
    start = new_snooker(reds=6)
    assert start.six_red and start.reds_left == (1, 2, 3, 4, 5, 6) and start.points_left == 75
    with pytest.raises(ValueError, match="reds"):
        new_snooker(reds=7)


def test_six_red_nobody_is_snookered_behind_a_nominated_colour():
    rest = {0: (0.889, 2.0), 1: (0.889, 3.4), YELLOW: (0.889, 2.2),
            GREEN: SPOTS[GREEN], BROWN: SPOTS[BROWN], BLUE: SPOTS[BLUE], PINK: (0.3, 0.4),
            BLACK: (1.4, 0.4)}  # fmt: skip
    state = game(on_table=(1, *ALL), stage="colour")
    assert state.judge(shot(YELLOW, rest=rest), Call(YELLOW)).legal
    six = msgspec.structs.replace(state, reds=6)
    assert [foul.kind for foul in six.judge(shot(YELLOW, rest=rest), Call(YELLOW)).fouls] == [
        "behind the ball"
    ]


def test_six_red_a_fifth_miss_brings_the_cue_ball_anywhere():
    state = game(reds=6)
    for count in range(1, 5):
        verdict = state.judge(shot(), seen=seen(HIDDEN))
        assert verdict.game.misses == count
        state = verdict.game.choose("replay").game
    assert any("fifth" in words for words in verdict.words)
    fifth = state.judge(shot(), seen=seen(HIDDEN)).game
    assert [option.name for option in fifth.options] == ["play", "again", "anywhere"]
    placed = fifth.choose("anywhere").game
    assert placed.turn == 1 and placed.in_hand == "anywhere"


# -- practice ---------------------------------------------------------------------------------------


def test_drills_count_attempts():
    alone = msgspec.structs.replace(
        new_snooker(("Player",)), on_table=(1, *ALL), opening=False, in_hand="", drill="escape"
    )
    hit = alone.judge(shot(1)).game
    assert hit.over and (hit.attempts, hit.made) == (1, 1)
    failed = alone.judge(shot(BLUE)).game
    assert failed.over and (failed.attempts, failed.made) == (1, 0)
    breaks = msgspec.structs.replace(alone, drill="break")
    running = breaks.judge(shot(1, down=(1,))).game
    assert not running.over and running.run == 1
    ended = running.judge(shot(BLUE), Call(BLUE)).game
    assert ended.over and ended.high == (1,) and ended.made == 0
    assert msgspec.structs.replace(alone, drill="pot").judge(shot(1, down=(1,))).game.made == 1


def test_a_ball_is_nominated_only_by_who_may_play_and_may_choose():
    assert game(stage="colour").needs_call() and game(free_ball=True).needs_call()
    assert not game().needs_call() and not game(stage="colour", winner=1).needs_call()
    asked = missed(game()).game
    assert asked.options and not msgspec.structs.replace(asked, stage="colour").needs_call()


def test_a_nomination_counts_only_where_it_is_one():
    assert game().target(Call(BLUE)) == game().target()
    assert game(free_ball=True).target(Call(1)).free is None  # a red is on anyway
    assert game(free_ball=True).target(Call(BLUE)).free == BLUE
    assert game(stage="colour").target(Call(1)).nominated is False
    gone = game(on_table=(1, 2, *ALL[1:]), free_ball=True)
    assert gone.target(Call(YELLOW)).free is None
