"""What a scene is, without a screen: declarations, input events, fixed-step clock, snapshots, replay.

What runs a scene needs the compiler, whose import takes most of a second. It is imported when it is first
asked for, so that a menu or a list that only names scenes is there at once.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from game.definition import DefinitionError
from game.stage.catalogue import Catalogue, Entry
from game.stage.clock import FixedStep
from game.stage.declarations import (
    Comparison,
    Equation,
    Frame,
    Hearing,
    Hint,
    Inspected,
    Readout,
    SceneAction,
    Sound,
    Steady,
    Strip,
    Table,
    ToolButton,
    WarmUp,
)
from game.stage.events import Action, Decision, Pointer, SetEffect, SetParameter, StageEvent, Stamped
from game.stage.messages import Messages
from game.stage.parameters import Choice, Param, Parameter, ParameterError, Parameters, Toggle, control_of
from game.stage.part import Part
from game.stage.records.recording import Recording, RecordingError
from game.stage.scene import Scene
from game.stage.series import StripSeries

if TYPE_CHECKING:
    from game.stage.effect_costs import EffectMeter
    from game.stage.fault import Fault
    from game.stage.playing.paced import FASTEST, SLOWEST
    from game.stage.replaying import begin, replay, replay_scene
    from game.stage.stage import Stage
    from game.stage.states.interpolation import blend, blend_angles, blend_quaternions, jumped
    from game.stage.warming import Warming, WarmingProgress

__all__ = [
    "FASTEST",
    "SLOWEST",
    "Action",
    "Catalogue",
    "Choice",
    "Comparison",
    "Decision",
    "DefinitionError",
    "EffectMeter",
    "Entry",
    "Equation",
    "Fault",
    "FixedStep",
    "Frame",
    "Hearing",
    "Hint",
    "Inspected",
    "Messages",
    "Param",
    "Parameter",
    "ParameterError",
    "Parameters",
    "Part",
    "Pointer",
    "Readout",
    "Recording",
    "RecordingError",
    "Scene",
    "SceneAction",
    "SetEffect",
    "SetParameter",
    "Sound",
    "Stage",
    "StageEvent",
    "Stamped",
    "Steady",
    "Strip",
    "StripSeries",
    "Table",
    "Toggle",
    "ToolButton",
    "WarmUp",
    "Warming",
    "WarmingProgress",
    "begin",
    "blend",
    "blend_angles",
    "blend_quaternions",
    "control_of",
    "jumped",
    "replay",
    "replay_scene",
]

_LATER = {
    "EffectMeter": "game.stage.effect_costs",
    "FASTEST": "game.stage.playing.paced",
    "Fault": "game.stage.fault",
    "SLOWEST": "game.stage.playing.paced",
    "Stage": "game.stage.stage",
    "Warming": "game.stage.warming",
    "WarmingProgress": "game.stage.warming",
    "begin": "game.stage.replaying",
    "blend": "game.stage.states.interpolation",
    "blend_angles": "game.stage.states.interpolation",
    "blend_quaternions": "game.stage.states.interpolation",
    "jumped": "game.stage.states.interpolation",
    "replay": "game.stage.replaying",
    "replay_scene": "game.stage.replaying",
}


def __getattr__(name: str) -> Any:
    """A name of ``_LATER``, imported now and kept."""
    if name not in _LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = globals()[name] = getattr(import_module(_LATER[name]), name)
    return value
