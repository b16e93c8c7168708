"""What a step may be asked to simulate, and how it is switched.

An effect is a name that levels, recordings and the command line use. A scene's set of effects may span rooms
of physics. Each room that computes effects gives them bits of a mask of its own. So a new room never runs out
of bits and never renumbers another:

    PARTICLES = Room("particles", GRAVITY | DRAG | OBSTACLES)
    GRAVITY_BIT = PARTICLES.bit(GRAVITY)
    step = step_kernel(PARTICLES.mask(effects))     # effects of other rooms are left out

A kernel asks ``if mask & GRAVITY_BIT`` with both numbers known when it is compiled (a closure over plain
integers). So the machine code of an effect that is off is not there at all.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import chain

MOST_BITS = 63  # masks travel through kernels as signed 64-bit integers

_NAME = re.compile(r"[a-z][a-z0-9-]*")
_by_name: dict[str, Effect] = {}


class EffectError(ValueError):
    """An effect that is not there, or that collides with another."""


@dataclass(frozen=True, slots=True)
class Effect:
    """One thing that a step can compute or leave out.

    name: for level files and the command line (``cloth-friction``). label: for the panel. help: one sentence.
    ``effect | other`` gives an EffectSet.
    """

    name: str
    label: str
    help: str

    def __or__(self, other: Effect | EffectSet) -> EffectSet:
        return EffectSet([self]) | other


def declare_effect(name: str, label: str, help: str) -> Effect:
    """Make an effect known to the whole house and return it.

    Declaring the very same effect again (a module loaded twice) gives the first one back. EffectError if the
    name is none, or is taken by another effect.
    """
    if not _NAME.fullmatch(name):
        raise EffectError(f"effect {name!r}: a name is made of a-z, 0-9 and -, beginning with a letter")
    effect = Effect(name, label, help)
    taken = _by_name.setdefault(name, effect)
    if taken != effect:
        raise EffectError(f"effect {name!r}: the name is taken by the effect labelled {taken.label!r}")
    return taken


def effect_named(name: str) -> Effect:
    """The declared effect of that name; EffectError if there is none."""
    if name not in _by_name:
        raise EffectError(f"effect {name!r}: not declared; known are {', '.join(sorted(_by_name)) or 'none'}")
    return _by_name[name]


class EffectSet:
    """An immutable set of declared effects; iterates in the order in which they were put together.

    ``EffectSet([WALLS, FRICTION])``, ``WALLS | FRICTION``, ``set.without("walls")``, ``"walls" in set``;
    members may be given as effects or by name. Sets are equal if their members are, in whatever order.
    """

    __slots__ = ("_members",)
    _members: dict[Effect, None]

    def __init__(self, effects: Iterable[Effect | str] = ()) -> None:
        object.__setattr__(self, "_members", dict.fromkeys(map(_declared, effects)))

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the members."""
        return tuple(effect.name for effect in self._members)

    def with_(self, effect: Effect | str) -> EffectSet:
        """This set and the effect."""
        return EffectSet([*self, effect])

    def without(self, effect: Effect | str) -> EffectSet:
        """This set but for the effect, which need not be in it."""
        gone = _declared(effect)
        return EffectSet(member for member in self if member != gone)

    def __or__(self, other: Effect | EffectSet) -> EffectSet:
        return EffectSet(chain(self, [other] if isinstance(other, Effect) else other))

    def __and__(self, other: EffectSet) -> EffectSet:
        return EffectSet(member for member in self if member in other)

    def __contains__(self, effect: object) -> bool:
        if isinstance(effect, Effect):
            return effect in self._members
        return isinstance(effect, str) and effect in self.names

    def __iter__(self) -> Iterator[Effect]:
        return iter(self._members)

    def __len__(self) -> int:
        return len(self._members)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, EffectSet) and self._members.keys() == other._members.keys()

    def __hash__(self) -> int:
        return hash(frozenset(self._members))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("an EffectSet cannot be changed; with_() and without() make a new one")

    def __reduce__(self) -> tuple[Callable[[Iterable[str]], EffectSet], tuple[tuple[str, ...]]]:
        return EffectSet, (self.names,)

    def __repr__(self) -> str:
        return f"EffectSet({', '.join(self.names)})"


class Room:
    """The effects that one room of physics computes, and the bit that each has in that room's mask.

    name: for messages, a plural ("particles"). known: the effects, of this room or of others; the first has
    bit 0. EffectError for more than `MOST_BITS`.
    """

    __slots__ = ("_bits", "known", "name")

    def __init__(self, name: str, known: EffectSet) -> None:
        if len(known) > MOST_BITS:
            raise EffectError(f"{name}: {len(known)} effects; a mask takes at most {MOST_BITS}")
        self.name = name
        self.known = known
        self._bits = {effect: 1 << number for number, effect in enumerate(known)}

    def bit(self, effect: Effect) -> int:
        """An integer of this effect's one bit; EffectError if the room does not compute it."""
        if effect not in self._bits:
            raise EffectError(f"effect {effect.name!r}: {self.name} know nothing of it")
        return self._bits[effect]

    def mask(self, effects: Effect | EffectSet) -> int:
        """The bits of those effects that this room computes; what other rooms compute is left out."""
        members = (effects,) if isinstance(effects, Effect) else effects
        return sum(self._bits.get(effect, 0) for effect in members)

    def checked(self, effects: Effect | str | Iterable[Effect | str]) -> EffectSet:
        """The effects that something is asked to compute, as a set: one, or several, or their names.

        EffectError for those that this room does not compute, and for what is no effect.
        """
        try:
            asked = EffectSet([effects] if isinstance(effects, Effect | str) else effects)
        except (TypeError, AttributeError):
            raise EffectError(f"effects = {effects!r}: expected an effect or several") from None
        foreign = [effect.name for effect in asked if effect not in self._bits]
        if foreign:
            names = ", ".join(self.known.names)
            raise EffectError(f"effects: {self.name} know nothing of {', '.join(foreign)}, only of {names}")
        return asked


def _declared(effect: Effect | str) -> Effect:
    """The effect itself, if it was declared."""
    if isinstance(effect, str):
        return effect_named(effect)
    if _by_name.get(effect.name) != effect:
        raise EffectError(f"effect {effect.name!r}: not declared")
    return effect
