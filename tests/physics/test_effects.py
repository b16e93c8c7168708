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
from game.physics.effects import Effect, EffectError, EffectSet, Room, declare_effect, effect_named
from game.physics.fields import GRAVITY
from game.physics.particles import ParticleSystem
from game.physics.rigid import RigidBody
from game.physics.spheres.collisions import CollidingSpheres
from game.physics.spheres.spheres import SphereBodies

RAIN = declare_effect("test-gravity", "Gravity", "Pulls everything down.")
SNOW = declare_effect("test-ground", "Ground", "The ball comes back from the ground.")
HAIL = declare_effect("test-drag", "Air drag", "Slows the ball with its speed.")


def test_declaring_twice_is_harmless_but_taking_a_name_is_refused():
    assert declare_effect("test-gravity", "Gravity", "Pulls everything down.") is RAIN
    with pytest.raises(EffectError, match="taken by the effect labelled 'Gravity'"):
        declare_effect("test-gravity", "Rain", "x")


@pytest.mark.parametrize("name", ["A b", "", "3a", "a_b"])
def test_bad_names_are_refused(name):
    with pytest.raises(EffectError, match=f"effect '{name}'"):
        declare_effect(name, "label", "help")


def test_an_effect_is_found_by_its_name():
    assert effect_named("test-gravity") is RAIN
    with pytest.raises(EffectError, match="test-fog"):
        effect_named("test-fog")


def test_each_room_has_bits_of_its_own():
    wet, cold = Room("clouds", RAIN | SNOW), Room("winters", SNOW | HAIL)
    assert (wet.bit(RAIN), wet.bit(SNOW)) == (1, 2)
    assert (cold.bit(SNOW), cold.bit(HAIL)) == (1, 2)
    with pytest.raises(EffectError, match="clouds know nothing"):
        wet.bit(HAIL)


def test_a_room_sees_its_own_part_of_a_set():
    wet = Room("clouds", RAIN | SNOW)
    assert wet.mask(EffectSet()) == 0
    assert wet.mask(RAIN) == wet.mask(HAIL | RAIN) == 1
    assert wet.mask(HAIL | SNOW | RAIN) == 3
    assert wet.checked(SNOW | RAIN) == RAIN | SNOW
    assert wet.checked(RAIN) == wet.checked("test-gravity") == EffectSet([RAIN])
    assert wet.checked([SNOW, "test-gravity"]) == wet.known and wet.checked(()) == EffectSet()
    with pytest.raises(ValueError, match=r"^effects: clouds know nothing of test-drag, only of test-gr"):
        wet.checked(RAIN | HAIL)
    for nonsense in (3, None, [3]):
        with pytest.raises(ValueError, match="expected an effect or several"):
            wet.checked(nonsense)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="test-fog"):
        wet.checked("test-fog")


def test_a_mask_leaves_the_sign_alone():
    many = [declare_effect(f"test-many-{i}", str(i), "") for i in range(64)]
    full = Room("crowds", EffectSet(many[:63]))
    assert full.mask(EffectSet(many[:63])) == 2**63 - 1
    with pytest.raises(EffectError, match="64 effects"):
        Room("crowds", EffectSet(many))


def test_sets_join_iterate_and_answer_by_effect_or_name():
    weather = SNOW | RAIN
    assert list(weather) == [SNOW, RAIN]  # as they were put together
    assert weather.names == ("test-ground", "test-gravity")
    assert RAIN in weather and "test-ground" in weather and HAIL not in weather and 3 not in weather
    assert weather.without(RAIN) == EffectSet([SNOW]) == weather.without("test-gravity")
    assert weather.with_("test-drag") == RAIN | SNOW | HAIL
    assert weather | HAIL == HAIL | weather
    assert (weather & (SNOW | HAIL)) == EffectSet(["test-ground"])
    assert len({weather, RAIN | SNOW}) == 1
    assert repr(weather) == "EffectSet(test-ground, test-gravity)"


def test_sets_cannot_be_changed():
    with pytest.raises(AttributeError, match="cannot be changed"):
        EffectSet([RAIN]).names = ()  # type: ignore[misc]


def test_undeclared_effects_are_refused():
    with pytest.raises(EffectError, match="not declared"):
        EffectSet([Effect("test-fog", "Fog", "")])
    with pytest.raises(EffectError, match="not declared"):
        EffectSet(["test-fog"])


@given(st.sets(st.sampled_from([RAIN, SNOW, HAIL])), st.sets(st.sampled_from([RAIN, SNOW, HAIL])))
def test_sets_behave_like_python_sets(first, second):
    a, b = EffectSet(first), EffectSet(second)
    assert set(a | b) == first | second
    assert set(a & b) == first & second
    assert len(a) == len(first)
    assert (a == b) == (first == second)
    assert a != b or hash(a) == hash(b)


def test_sets_survive_copying():
    weather = RAIN | SNOW
    assert copy.deepcopy(weather) == weather
    assert pickle.loads(pickle.dumps(weather)) == weather


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
    with pytest.raises(ValueError, match=r"^effects = 3: expected an effect or several"):
        make(3)
