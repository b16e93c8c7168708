"""A world: members that step one after the other. What it keeps, and what it measures, is theirs."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, ClassVar

from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.stage import Part


class Member(Part):
    """A thing of a world. Each method may be left as it is: then it does nothing."""

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
        return ()

    def restore(self, fields: Iterator[Any]) -> None:
        """Take over copies of these fields, by as many calls of ``next`` as `state` gives."""


class Kept(Member):
    """Arrays that are attributes of another part, in the order of their names."""

    def __init__(self, owner: Part, *names: str):
        self.owner, self.names = owner, names

    def state(self) -> tuple[Any, ...]:
        return tuple(getattr(self.owner, name) for name in self.names)

    def restore(self, fields: Iterator[Any]) -> None:
        for name in self.names:
            setattr(self.owner, name, next(fields).copy())


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
        return self.state_type(*(field for member in self.members for field in member.state()))

    def restore(self, state: Any) -> None:
        """Take over a copy of a state."""
        fields = iter(state)
        for member in self.members:
            member.restore(fields)
