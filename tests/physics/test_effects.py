"""Effects: bits, rooms, sets."""

import copy
import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.effects import ROOMS, Effect, EffectError, EffectSet, declare_effect, effect_named

RAIN = declare_effect("spare", "test-gravity", 59, "Gravity", "Pulls everything down.")
SNOW = declare_effect("spare", "test-ground", 60, "Ground", "The ball comes back from the ground.")
HAIL = declare_effect("spare", "test-drag", 61, "Air drag", "Slows the ball with its speed.")


def test_rooms_share_no_bit_and_leave_the_sign_alone():
    bits = [bit for room in ROOMS.values() for bit in room]
    assert sorted(bits) == list(range(63))


def test_declaring_twice_is_harmless_but_taking_a_bit_or_name_is_refused():
    assert declare_effect("spare", "test-gravity", 59, "Gravity", "Pulls everything down.") is not None
    with pytest.raises(EffectError, match="taken by effect 'test-gravity'"):
        declare_effect("spare", "test-other", 59, "Other", "x")
    with pytest.raises(EffectError, match="taken by effect 'test-gravity'"):
        declare_effect("spare", "test-gravity", 62, "Rain", "x")


@pytest.mark.parametrize(
    ("room", "name", "bit"),
    [("attic", "a", 3), ("spare", "a", 3), ("spare", "a", 63), ("spare", "A b", 61), ("spare", "a", True)],
)
def test_bad_declarations_are_refused(room, name, bit):
    with pytest.raises(EffectError, match=name):
        declare_effect(room, name, bit, "label", "help")


def test_an_effect_knows_its_room_and_mask():
    assert (RAIN.room, RAIN.mask) == ("spare", 1 << 59)
    assert effect_named("test-gravity") == RAIN
    with pytest.raises(EffectError, match="test-fog"):
        effect_named("test-fog")


def test_sets_join_iterate_and_answer_by_effect_or_name():
    weather = SNOW | RAIN
    assert list(weather) == [RAIN, SNOW]
    assert weather.names == ("test-gravity", "test-ground")
    assert RAIN in weather and "test-ground" in weather and HAIL not in weather and 3 not in weather
    assert weather.without(RAIN) == EffectSet([SNOW]) == weather.without("test-gravity")
    assert weather.with_("test-drag") == RAIN | SNOW | HAIL
    assert weather | HAIL == HAIL | weather
    assert (weather & (SNOW | HAIL)) == EffectSet(["test-ground"])
    assert len({weather, RAIN | SNOW}) == 1
    assert repr(weather) == "EffectSet(test-gravity, test-ground)"


def test_sets_cannot_be_changed():
    with pytest.raises(AttributeError, match="cannot be changed"):
        EffectSet([RAIN]).mask = 0


def test_undeclared_effects_and_bits_are_refused():
    with pytest.raises(EffectError, match="not declared"):
        EffectSet([Effect("test-fog", 62, "Fog", "")])
    with pytest.raises(EffectError, match="bit 62"):
        EffectSet.from_mask(1 << 62)
    with pytest.raises(EffectError, match="mask"):
        EffectSet.from_mask(-1)


@given(st.sets(st.sampled_from([RAIN, SNOW, HAIL])), st.sets(st.sampled_from([RAIN, SNOW, HAIL])))
def test_sets_behave_like_python_sets(first, second):
    a, b = EffectSet(first), EffectSet(second)
    assert set(a | b) == first | second
    assert set(a & b) == first & second
    assert len(a) == len(first)
    assert EffectSet.from_mask(a.mask) == a


def test_sets_survive_copying():
    weather = RAIN | SNOW
    assert copy.deepcopy(weather) == weather
    assert pickle.loads(pickle.dumps(weather)) == weather
