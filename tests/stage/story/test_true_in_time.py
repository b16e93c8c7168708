"""Words come when what they tell comes: within 0.3 s of simulated time, or the run fails."""

from __future__ import annotations

import itertools

import pytest

from game.stage.script.course import LATE_S, READING, SLOWEST
from game.stage.story.rehearsal import Rehearsal, rehearse, stage_of
from game.stage.story.runner import Runner
from tests.stage.story.bouncing import StoryBall, story

HEAD = 'scene = "story-ball"\ntitle = "A ball"\n[parameters]\nheight = 12.0\n'
END = '[[line]]\nhand_over = "Kick it."\nseconds = 3.0\n'


def moment(name: str, when: str, more: str = "") -> str:
    """A moment's line."""
    return f'[[line]]\nmoment = "{name}"\nwhen = "{when}"\ndeadline = 20.0\n{more}'


def say(words: str, more: str = "") -> str:
    """A caption's line."""
    return f'[[line]]\nsay = "{words}"\n{more}'


def run(*lines: str) -> tuple[Runner, Rehearsal]:
    """A story of some lines, at its end."""
    told = story(HEAD + "".join(lines) + END)
    stage = stage_of(told, StoryBall)
    found = rehearse(told, StoryBall, stage=stage)
    assert isinstance(stage.cue, Runner)
    return stage.cue, found


ONE = moment("one", "bounces >= 1")
TWO = moment("two", "bounces >= 2")


def test_words_at_once_are_in_time():
    runner, found = run(ONE, say("It has bounced {bounces}."))
    assert found.failures == [] and found.moments[0].said_late_s == 0.0
    assert runner.course.captions()[0].text == "It has bounced 1."


def test_a_caption_that_is_delayed_by_two_seconds_fails():
    _, found = run(ONE, say("It has bounced.", "after = 2.0\n"))
    assert found.failures == ["story: the words of 'one' come 2.00 s after it"]
    _, found = run(ONE, "[[line]]\nlook = [0.0, 1.0]\nease = 2.0\n", say("It has bounced."))
    assert found.failures == ["story: the words of 'one' come 2.00 s after it"]


def test_words_at_a_moment_out_of_their_turn_are_held_to_it_as_well():
    _, found = run(ONE, TWO, say("It has bounced.", 'at = "one"\nafter = 0.5\n'))
    assert found.failures == ["story: the words of 'one' come 0.50 s after it"]


def test_a_moment_comes_when_its_condition_does_though_words_wait_before_it():
    """Falling takes 1.5 s: the second caption can not be read till then, and is dropped."""
    runner, found = run(say("x" * 34), say("What was before it bounced."), ONE, say("It bounces."))
    assert found.failures == [] and found.dropped == ("What was before it bounced.",)
    assert [one.text for one in runner.course.captions()] == ["x" * 34, "It bounces."]
    assert found.moments[0].late_s == 0.0 and 1.4 < found.moments[0].time_s < 1.6


def test_what_is_to_be_done_is_not_passed_over_and_the_moment_is_late():
    _, found = run(
        say("x" * 51), '[[line]]\ndo = { parameter = "restitution", value = 0.9 }\n', ONE, say("It bounces.")
    )
    late = found.moments[0].late_s
    assert late == pytest.approx(3.0 - (2.0 * 12.0 / 9.81) ** 0.5, abs=0.02)  # reading, less the fall
    assert found.failures == [f"story: the moment 'one' is {late:.2f} s late: it was so before its turn"]


def test_camera_and_pace_are_told_though_words_are_dropped():
    runner, found = run(
        say("x" * 34), say("Dropped."), "[[line]]\nslow = 0.5\n", "[[line]]\nlook = [7.0, 1.0]\n", ONE
    )
    assert found.dropped == ("Dropped.",)
    assert 3 in runner.course.begun and runner.course.speed == 0.5
    assert runner._aim.x == 7.0


@pytest.mark.parametrize("letters", [30, 40, 90])
def test_the_clock_waits_for_words_to_be_read(letters):
    """The first caption would be read only after the bounce: time goes slowly until then."""
    runner, found = run(say("x" * letters), ONE, say("It bounces."))
    first, second = runner.course.captions()
    assert first.ends - first.begins >= letters / READING - 1e-9 and second.begins >= first.ends - 1e-9
    assert found.failures == [] and found.dropped == ()
    assert 0.0 <= found.moments[0].said_late_s <= LATE_S
    slowest = min(pace for _, _, pace in found.paces)
    assert slowest == 1.0 if letters == 30 else SLOWEST <= slowest < 1.0
    assert found.paces[-1][2] == 1.0  # and then on as before


def test_the_clock_goes_on_as_before_when_the_words_it_waited_for_are_dropped():
    """The ball has left the ground again before the words of its bounce could come: they are passed over."""
    runner, found = run(say("x" * 60), ONE, say("It bounces."), moment("up", "height > 0.5"), TWO)
    assert found.dropped == ("It bounces.",)
    assert found.paces[-2][2] < 0.5 and found.paces[-1][2] == 1.0
    reached = runner.course.reached
    simulated = reached["two"].time_s - reached["up"].time_s
    assert reached["two"].film_s - reached["up"].film_s == pytest.approx(simulated, abs=0.02)


def test_words_too_long_to_wait_for_fail():
    _, found = run(say("x" * 280), ONE, say("It bounces."))
    assert any("the words of 'one' come" in line for line in found.failures)


def test_a_condition_that_went_again_before_its_turn_is_late():
    """The ball is low at 1.5 s, then high, and low again at 4 s, when a deed has let the moment come."""
    deed = '[[line]]\ndo = { parameter = "gravity", value = 9.81 }\n'
    _, found = run(say("x" * 51), deed, moment("low", "height < 1"), say("Low."))
    assert 2.0 < found.moments[0].late_s < 3.0 and len(found.failures) == 1


def test_what_was_so_before_a_story_waits_for_it_is_of_no_account():
    """The ball is above 2 m from the start, is not when it bounces, and is so again after that."""
    _, found = run(ONE, moment("high", "height > 2"), say("High."))
    assert found.failures == [] and found.moments[1].late_s == 0.0
    assert found.moments[1].time_s > found.moments[0].time_s + 0.1


def test_the_numbers_are_those_of_the_moment():
    runner, _ = run(say("x" * 40), ONE, say("{height:.4f}"))
    reached = runner.course.reached["one"]
    said = runner.course.captions()[1]
    assert said.begins > reached.film_s  # it waited
    stage = stage_of(story(HEAD + END), StoryBall)
    stage.run(reached.step)
    height = next(one for one in stage.scene.readouts() if one.name == "height")
    assert said.text == f"{height.value:.4f}"


def test_a_threshold_said_as_a_number_fails():
    _, found = run(moment("low", "height < 4.0"), say("It is {height} up."))
    assert found.failures == ["story: the words of 'low' repeat what it waited for: height"]


def test_a_step_back_forgets_when_a_condition_came():
    runner, _ = run(say("x" * 40), ONE, say("It bounces."), TWO, say("Again."))
    entries, steps = list(runner.course.entries), runner.stage.step_number
    for share in (0.9, 0.5, 0.2):
        runner.return_to(int(share * steps))
        runner.stage.run(steps - runner.stage.step_number)
        assert runner.course.entries == entries
    times = [entry.step for entry in entries]
    assert all(a <= b for a, b in itertools.pairwise(times))


def test_what_has_nothing_new_for_more_than_eight_seconds_is_told_and_nothing_else():
    """Between words and the next: 6 s are no idle span, 9 s are one."""
    for pause, many in ((6.0, 0), (9.0, 1)):
        runner, found = run(say("It falls."), say("It rests.", f"after = {pause}\n"))
        assert len(found.idle) == many
        for begins, ends in found.idle:
            assert ends - begins >= pause - 1e-6 and ends in runner.course.news()
