"""What a step may be asked to simulate, and how it is switched.

An effect is one bit of a 64-bit mask. Each room of the house has a range of bits of its own, so that a new
room never renumbers an old one:

    room         bits      what
    fields        0 .. 7   gravity, drag, wind, heat
    billiards     8 .. 19  walls, ball collisions, friction of the cloth, pockets, spin
    particles    20 .. 27  obstacles, lifetimes, contacts between particles
    rigid        28 .. 35  contacts, friction, rotation
    constraints  36 .. 43  links, bending, ground, tearing
    broadphase   44 .. 47  boundary, births and deaths of boxes
    animation    48 .. 51  interpolation, skinning
    fluids       52 .. 54  pressure, viscosity, surface tension
    proximity    55 .. 57  shapes' own motion, coherence, exact answers
    spare        58 .. 62
Bit 63 is never used: masks travel through kernels as signed 64-bit integers.

A kernel asks ``if mask & WALLS_BIT`` with both numbers known when it is compiled (a closure over plain
integers), so the machine code of an effect that is off is not there at all.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

ROOMS: dict[str, range] = {
    "fields": range(8),
    "billiards": range(8, 20),
    "particles": range(20, 28),
    "rigid": range(28, 36),
    "constraints": range(36, 44),
    "broadphase": range(44, 48),
    "animation": range(48, 52),
    "fluids": range(52, 55),
    "proximity": range(55, 58),
    "spare": range(58, 63),
}

_NAME = re.compile(r"[a-z][a-z0-9-]*")
_by_bit: dict[int, Effect] = {}
_by_name: dict[str, Effect] = {}


class EffectError(ValueError):
    """An effect that is not there, or that collides with another."""


@dataclass(frozen=True, slots=True)
class Effect:
    """One thing that a step can compute or leave out.

    name: for level files and the command line (``cloth-friction``). bit: 0 to 62. label: for the panel.
    help: one sentence. ``effect | other`` gives an EffectSet.
    """

    name: str
    bit: int
    label: str
    help: str

    @property
    def mask(self) -> int:
        """An integer of this one bit: what kernels are specialised by."""
        return 1 << self.bit

    @property
    def room(self) -> str:
        """The room in whose range the bit lies."""
        return next(room for room, bits in ROOMS.items() if self.bit in bits)

    def __or__(self, other: Effect | EffectSet) -> EffectSet:
        return EffectSet([self]) | other


def declare_effect(room: str, name: str, bit: int, label: str, help: str) -> Effect:
    """Make an effect known to the whole house and return it.

    Declaring the very same effect again (a module loaded twice) gives the first one back. EffectError if
    the room is unknown, the bit is outside its range, or the bit or the name is taken.
    """
    if room not in ROOMS:
        raise EffectError(f"effect {name!r}: no room {room!r}; rooms are {', '.join(ROOMS)}")
    if isinstance(bit, bool) or not isinstance(bit, int) or bit not in ROOMS[room]:
        bits = ROOMS[room]
        raise EffectError(f"effect {name!r}: bit {bit!r} is outside {bits[0]} to {bits[-1]} of room {room!r}")
    if not _NAME.fullmatch(name):
        raise EffectError(f"effect {name!r}: a name is made of a-z, 0-9 and -, beginning with a letter")
    effect = Effect(name, bit, label, help)
    for taken in (_by_bit.get(bit), _by_name.get(name)):
        if taken is not None and taken != effect:
            raise EffectError(f"effect {name!r}: bit {bit} or name is taken by effect {taken.name!r}")
    _by_bit[bit] = effect
    _by_name[name] = effect
    return effect


def effect_named(name: str) -> Effect:
    """The declared effect of that name; EffectError if there is none."""
    if name not in _by_name:
        raise EffectError(f"effect {name!r}: not declared; known are {', '.join(sorted(_by_name)) or 'none'}")
    return _by_name[name]


class EffectSet:
    """An immutable set of declared effects; iterates in the order of bits.

    ``EffectSet([WALLS, FRICTION])``, ``WALLS | FRICTION``, ``set.without("walls")``, ``"walls" in set``;
    members may be given as effects or by name. `mask` is the integer that kernels are specialised by.
    """

    __slots__ = ("mask",)
    mask: int

    def __init__(self, effects: Iterable[Effect | str] = ()) -> None:
        mask = 0
        for effect in effects:
            mask |= _declared(effect).mask
        object.__setattr__(self, "mask", mask)

    @classmethod
    def from_mask(cls, mask: int) -> EffectSet:
        """Set of the effects whose bits are set; EffectError if a bit belongs to no declared effect."""
        if isinstance(mask, bool) or not isinstance(mask, int) or mask < 0:
            raise EffectError(f"effect mask: must be an integer that is not negative, got {mask!r}")
        bits = [bit for bit in range(mask.bit_length()) if mask >> bit & 1]
        for bit in bits:
            if bit not in _by_bit:
                raise EffectError(f"effect mask: bit {bit} belongs to no declared effect")
        return cls(_by_bit[bit] for bit in bits)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the members, in the order of bits."""
        return tuple(effect.name for effect in self)

    def with_(self, effect: Effect | str) -> EffectSet:
        """This set and the effect."""
        return EffectSet([*self, effect])

    def without(self, effect: Effect | str) -> EffectSet:
        """This set but for the effect, which need not be in it."""
        return EffectSet.from_mask(self.mask & ~_declared(effect).mask)

    def __or__(self, other: Effect | EffectSet) -> EffectSet:
        return EffectSet([*self, *([other] if isinstance(other, Effect) else other)])

    def __and__(self, other: EffectSet) -> EffectSet:
        return EffectSet.from_mask(self.mask & other.mask)

    def __contains__(self, effect: object) -> bool:
        if isinstance(effect, Effect):
            return bool(self.mask >> effect.bit & 1)
        return isinstance(effect, str) and effect in self.names

    def __iter__(self) -> Iterator[Effect]:
        return (_by_bit[bit] for bit in range(self.mask.bit_length()) if self.mask >> bit & 1)

    def __len__(self) -> int:
        return self.mask.bit_count()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, EffectSet) and self.mask == other.mask

    def __hash__(self) -> int:
        return hash(("EffectSet", self.mask))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("an EffectSet cannot be changed; with_() and without() make a new one")

    def __reduce__(self) -> tuple[Callable[[int], EffectSet], tuple[int]]:
        return EffectSet.from_mask, (self.mask,)

    def __repr__(self) -> str:
        return f"EffectSet({', '.join(self.names)})"


def effects_of(effects: Effect | str | Iterable[Effect | str], known: EffectSet, who: str) -> EffectSet:
    """The effects that something is asked to compute, as a set: one, or several, or their names.

    known: all that it can compute. ValueError, in the name of ``who``, for others, and for what is no effect.
    """
    try:
        wanted = EffectSet([effects] if isinstance(effects, Effect | str) else effects)
    except (TypeError, AttributeError):
        raise ValueError(f"effects = {effects!r}: an effect or several are wanted") from None
    foreign = [effect.name for effect in wanted if effect not in known]
    if foreign:
        raise ValueError(f"effects: {who} nothing of {', '.join(foreign)}, only of {', '.join(known.names)}")
    return wanted


def _declared(effect: Effect | str) -> Effect:
    """The effect itself, if it was declared."""
    if isinstance(effect, str):
        return effect_named(effect)
    if _by_bit.get(effect.bit) != effect:
        raise EffectError(f"effect {effect.name!r}: not declared")
    return effect
