"""What a scene is, without a screen: declarations, input events, fixed-step clock, snapshots, replay."""

from game.stage.catalogue import Catalogue, Entry
from game.stage.clock import FixedStep
from game.stage.effect_costs import EffectMeter
from game.stage.events import Action, Pointer, SetEffect, SetKnob, StageEvent, Stamped
from game.stage.interpolation import blend, blend_angles, blend_quaternions, jumped
from game.stage.knobs import Choice, Knob, KnobError, Param, Toggle
from game.stage.recording import Recording, RecordingError
from game.stage.replay import begin, replay, replay_scene
from game.stage.scene import Equation, Frame, Hint, Readout, Scene, SceneAction, Strip, WarmUp
from game.stage.series import StripSeries
from game.stage.session import Fault
from game.stage.stage import FASTEST, SLOWEST, Stage
from game.stage.warming import Warming, WarmingProgress

__all__ = [
    "FASTEST",
    "SLOWEST",
    "Action",
    "Catalogue",
    "Choice",
    "EffectMeter",
    "Entry",
    "Equation",
    "Fault",
    "FixedStep",
    "Frame",
    "Hint",
    "Knob",
    "KnobError",
    "Param",
    "Pointer",
    "Readout",
    "Recording",
    "RecordingError",
    "Scene",
    "SceneAction",
    "SetEffect",
    "SetKnob",
    "Stage",
    "StageEvent",
    "Stamped",
    "Strip",
    "StripSeries",
    "Toggle",
    "WarmUp",
    "Warming",
    "WarmingProgress",
    "begin",
    "blend",
    "blend_angles",
    "blend_quaternions",
    "jumped",
    "replay",
    "replay_scene",
]
