"""A world: members that step one after the other. What it keeps, and what it measures, is theirs."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any, ClassVar

from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.stage import Part
from game.worlds.tables import packed, unpacked


class Member(Part):
    """A thing of a world. Each method may be left as it is: then it does nothing, or keeps what is ``kept``.

    kept: names of attributes that are arrays, or tables of `game.worlds.tables`, in their order.
    """

    kept: Sequence[str] = ()

    def check(self) -> None:
        """All is built. ValueError if it could not go on like that."""

    def step(self, dt: float) -> None:
        """Go on by dt (s)."""

    def change(self, name: str) -> None:
        """A parameter has a new value."""

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""

    def state(self) -> tuple[Any, ...]:
        """All that later steps depend on: its own fields of the world's state, in their order."""
        return kept_fields(self, self.kept)

    def restore(self, fields: Iterator[Any]) -> None:
        """Take over copies of these fields, by as many calls of ``next`` as `state` gives."""
        take_fields(self, self.kept, fields)


class Kept(Member):
    """Attributes of another part, as a member keeps its own: arrays that a world has itself."""

    def __init__(self, owner: Part, *names: str):
        self.owner, self.names = owner, names

    def state(self) -> tuple[Any, ...]:
        return kept_fields(self.owner, self.names)

    def restore(self, fields: Iterator[Any]) -> None:
        take_fields(self.owner, self.names, fields)


class Whole(Member):
    """A thing of physics as one field, by its own ``state`` and ``restore``."""

    def __init__(self, thing: Any):
        self.thing = thing

    def state(self) -> tuple[Any, ...]:
        return (self.thing.state(),)

    def restore(self, fields: Iterator[Any]) -> None:
        self.thing.restore(next(fields))


def kept_fields(part: Part, names: Sequence[str]) -> tuple[Any, ...]:
    """Attributes of a part as fields of a state."""
    values = [getattr(part, name) for name in names]
    return tuple([packed(one) if isinstance(one, tuple) else one for one in values])


def take_fields(part: Part, names: Sequence[str], fields: Iterator[Any]) -> None:
    """Set attributes of a part to copies of what `kept_fields` gave."""
    for name in names:
        now, then = getattr(part, name), next(fields)
        setattr(part, name, unpacked(type(now), then) if isinstance(now, tuple) else then.copy())


class World(Part):
    """The members of a level's content, in the order in which they step and stand in the state.

    parameters: as the scene has them; active: effects that are computed; time: s, since the beginning.
    """

    state_type: ClassVar[Callable[..., Any]]

    def __init__(self, content: Any, parameters: Any, active: EffectSet, *members: Member):
        self.content, self.parameters, self.active = content, parameters, active
        self.members = members
        self.time = 0.0

    def advance(self, dt: float) -> str:
        """One step of dt (s); what there is to say about it, or ""."""
        for member in self.members:
            member.step(dt)
        self.time += dt
        return ""

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value."""
        for member in self.members:
            member.change(name)

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        self.active = active
        for member in self.members:
            member.change_effects(active)

    def gravity(self) -> float:
        """m/s² downwards, as it acts now."""
        return float(self.parameters.gravity) if GRAVITY in self.active else 0.0

    def state(self) -> Any:
        """All that later steps depend on, field by field."""
        fields: list[Any] = []
        for member in self.members:  # quicker than a generator, in each step
            fields += member.state()
        return self.state_type(*fields)

    def restore(self, state: Any) -> None:
        """Take over a copy of a state."""
        fields = iter(state)
        for member in self.members:
            member.restore(fields)
