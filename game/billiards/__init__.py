"""Billiards: the lecture's table stepped in time, and the exact table from event to event.

The names below can be imported from here; each module is loaded when one of its names is asked for.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

_HOMES = {
    "Arrangement": "arrangement",
    "BallSet": "arrangement",
    "Call": "rules",
    "Frame": "frame",
    "GAMES": "games",
    "ShotSummary": "rules",
    "Stroke": "arrangement",
    "Verdict": "rules",
    "arrange": "arrangement",
    "new_frame": "frame",
    "racked": "arrangement",
    "summarize": "summary",
    "Ball": "ball",
    "Event": "trajectory",
    "Physics": "shot",
    "Shot": "shot",
    "ShotError": "shot",
    "SimulationError": "simulation",
    "Strike": "cue",
    "Table": "table",
    "TableState": "trajectory",
    "Trajectories": "many",
    "Trajectory": "trajectory",
    "Decision": "opponents",
    "Effort": "search.looking",
    "GRADES": "opponents",
    "Grade": "opponents",
    "decide": "opponents",
    "stroke_of_hand": "opponents",
    "FoundShot": "search.finding",
    "Noise": "search.strokes",
    "eight_ball_rack": "rack",
    "find_shots": "search.finding",
    "load_shot": "shot_file",
    "make_shot": "shot",
    "nine_ball_rack": "rack",
    "run_shot_file": "simulation",
    "simulate": "simulation",
    "simulate_many": "many",
    "strike": "cue",
}
__all__ = sorted(_HOMES)


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)


def __dir__() -> list[str]:
    return [*__all__, *globals()]
