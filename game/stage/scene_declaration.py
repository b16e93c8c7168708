"""What a scene declares: names, parameters and effects, and what its help page and its panel say."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

import msgspec

from game.physics.effects import Effect, EffectSet
from game.stage.declarations import Equation, Hint, SceneAction, Strip
from game.stage.events import Stamped
from game.stage.parameters import Parameter, ParameterError, Parameters, parameters_of

if TYPE_CHECKING:
    from game.lab import Study
    from game.stage.script.lines import Story


class SceneDeclaration:
    """The attributes that the class of a scene sets, and the declared things by name."""

    name: ClassVar[str] = ""  # command line name, e.g. "c04"
    task: ClassVar[str] = ""  # id of the task, e.g. "C04"
    title: ClassVar[str] = ""
    effects: ClassVar[EffectSet] = EffectSet(())  # what is ever computed
    parameters_type: ClassVar[type[Parameters]] = Parameters  # beside those declared on the scene itself
    dt: ClassVar[float] = 1.0 / 120.0  # s, length of a step; a parameter "step_length" says it instead
    may_be_infinite: ClassVar[frozenset[str]] = frozenset()  # fields of the state where inf or NaN is meant
    unit: ClassVar[str] = "m"
    y_up: ClassVar[bool] = True
    legend_in_panel: ClassVar[bool] = False  # it would hide too much of the picture
    refits: ClassVar[bool] = False  # its frame changes in play, and the whole of it is to be seen
    builds: ClassVar[bool] = False  # a hand builds in it: kept when it is left, undone press by press
    edits: ClassVar[frozenset[str]] = frozenset()  # actions and parameters that are undone as presses are
    covers: ClassVar[bool] = False  # its picture covers the whole canvas, so that no ground is laid
    quarter_turns: ClassVar[int] = 0  # the picture turned clockwise by so many right angles
    content_type: ClassVar[type[msgspec.Struct] | None] = None  # the [content] of its level files
    default_content: ClassVar[Any] = None  # without one
    level_parameter: ClassVar[str] = ""  # each of its values has a level, which a window opens in its place
    study: ClassVar[Study | None] = None
    takes: ClassVar[frozenset[str]] = frozenset()  # of "wheel", "middle", "right": not for zoom and pan
    strips: ClassVar[tuple[Strip, ...]] = ()
    equations: ClassVar[tuple[Equation, ...]] = ()
    figure: ClassVar[staticmethod[[Any], None] | None] = None  # draws a help page's figure, with a ui.pen.Pen
    try_this: ClassVar[tuple[str, ...]] = ()
    hints: ClassVar[tuple[Hint, ...]] = ()
    actions: ClassVar[tuple[SceneAction, ...]] = ()
    stories: ClassVar[tuple[Story, ...]] = ()  # beside those in files
    play_action: ClassVar[str] = ""  # by it a timeline of the scene's own plays and pauses, if it has one
    demo: ClassVar[tuple[Stamped, ...]] = ()  # events by which the scene shows itself when no person plays

    former_parameters: ClassVar[Mapping[str, str]] = {}  # old name: present name

    @classmethod
    def declared_parameters(cls) -> dict[str, Parameter[Any]]:
        """Parameters by name, in the order of declaration."""
        return {**parameters_of(cls.parameters_type), **parameters_of(cls)}

    @classmethod
    def parameter(cls, name: str) -> Parameter[Any]:
        """The parameter of that name, or formerly of it; ParameterError if there is none."""
        declared = cls.declared_parameters()
        name = cls.former_parameters.get(name, name)
        if name not in declared:
            raise ParameterError(
                f"{name}: {cls.name} has no such parameter; it has {', '.join(declared) or 'none'}"
            )
        return declared[name]

    @classmethod
    def effect(cls, name: str) -> Effect:
        """The declared effect of that name; ParameterError if there is none."""
        for effect in cls.effects:
            if effect.name == name:
                return effect
        declared = ", ".join(cls.effects.names) or "none"
        raise ParameterError(f"{name}: {cls.name} declares no such effect; it has {declared}")
