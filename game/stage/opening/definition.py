"""Is the class of a scene what each must be? What a programmer has to write is said in one line."""

from __future__ import annotations

from typing import Any

from game.definition import DefinitionError
from game.stage.parameters import STEP_LENGTH, Parameter, check_defaults, parameters_of
from game.stage.states.memory import OWN

REQUIRED = ("build", "advance", "state")  # methods without which nothing can be played


def check_class(scene: Any, base: type) -> None:
    """DefinitionError for a parameter that hides what each scene has in ``base``, or is declared twice."""
    for name, value in vars(scene).items():
        if isinstance(value, Parameter) and (hasattr(base, name) or name in OWN):
            raise DefinitionError(f"{scene.__name__}.{name}: a parameter cannot have this name")
    check_defaults(scene)
    if STEP_LENGTH in scene.declared_parameters() and "dt" in vars(scene):
        raise DefinitionError(f"{scene.__name__}.dt: the parameter {STEP_LENGTH} says it already")
    twice = parameters_of(scene).keys() & parameters_of(scene.parameters_type).keys()
    if twice:
        raise DefinitionError(
            f"{scene.__name__}.{min(twice)}: {scene.parameters_type.__name__} declares it as well"
        )


def check_whole(scene: type, base: type) -> None:
    """DefinitionError, saying what to write, for a class that lacks what each scene must define."""
    missing = [name for name in REQUIRED if getattr(scene, name) is getattr(base, name)]
    if missing:
        raise DefinitionError(f"{scene.__name__}: define {', '.join(missing)} (see the class Scene)")


def check_strips(scene: Any) -> None:
    """DefinitionError, naming strip and readout, if a chart asks for a value that is never measured."""
    measured = [readout.name for readout in scene.readouts()]
    for strip in scene.strips:
        for name in strip.series:
            if name not in measured and name not in strip.sometimes:
                raise DefinitionError(
                    f"{type(scene).__name__}.strips: {strip.title!r} charts {name!r}; readouts() gives "
                    + (", ".join(measured) or "nothing")
                )
