"""Effects: bits, rooms, sets."""

import copy
import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.animation.easing import Easing
from game.physics.animation.effects import EASING
from game.physics.animation.keyframes import Keyframes
from game.physics.animation.playback import Playback
from game.physics.constraints import PositionBasedDynamics
from game.physics.effects import (
    ROOMS,
    Effect,
    EffectError,
    EffectSet,
    declare_effect,
    effect_named,
    effects_of,
)
from game.physics.fields import GRAVITY
from game.physics.particles import ParticleSystem
from game.physics.rigid import RigidBody
from game.physics.spheres.collisions import CollidingSpheres
from game.physics.spheres.spheres import SphereBodies

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


def test_what_is_asked_for_is_one_or_several_or_names():
    known = RAIN | SNOW
    assert effects_of(RAIN, known, "clouds know") == effects_of("test-gravity", known, "clouds know")
    assert effects_of([SNOW, "test-gravity"], known, "clouds know") == known
    assert effects_of((), known, "clouds know") == EffectSet()
    with pytest.raises(ValueError, match=r"^effects: clouds know nothing of test-drag, only of test-gr"):
        effects_of(RAIN | HAIL, known, "clouds know")
    for nonsense in (3, None, [3]):
        with pytest.raises(ValueError, match="an effect or several are wanted"):
            effects_of(nonsense, known, "clouds know")
    with pytest.raises(ValueError, match="test-fog"):
        effects_of("test-fog", known, "clouds know")


def key_frames(effects):
    return Playback(Keyframes([0.0, 1.0], [(0.0, 0.0), (1.0, 0.0)]), easing=Easing("ease"), effects=effects)


@pytest.mark.parametrize(
    ("make", "one"),
    [
        (lambda effects: RigidBody(effects=effects), GRAVITY),
        (lambda effects: CollidingSpheres(SphereBodies([(0, 0)], [1]), effects=effects), GRAVITY),
        (lambda effects: PositionBasedDynamics([(0, 0)], effects=effects), GRAVITY),
        (lambda effects: ParticleSystem(4, effects=effects), GRAVITY),
        (key_frames, EASING),
    ],
)
def test_every_class_takes_one_effect_or_a_set_and_refuses_what_it_does_not_know(make, one):
    for given_effects in (one, EffectSet([one]), one.name):
        made = make(given_effects)
        holder = getattr(made, "settings", made)
        if hasattr(holder, "effects"):
            assert holder.effects == EffectSet([one])
    for foreign in (HAIL, one | HAIL, "test-drag"):
        with pytest.raises(ValueError, match=r"^effects: .* nothing of test-drag, only of [^\n]+$"):
            make(foreign)
    with pytest.raises(ValueError, match=r"^effects = 3: an effect or several"):
        make(3)
