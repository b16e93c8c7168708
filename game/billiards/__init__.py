"""Billiards: the lecture's table stepped in time, and the exact table from event to event.

The names below can be imported from here; each module is loaded when one of its names is asked for.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

_HOMES = {
    "Arrangement": "game.arrangement",
    "BallSet": "game.arrangement",
    "Call": "game.rules",
    "Frame": "game.frame",
    "GAMES": "game.games",
    "ShotSummary": "game.rules",
    "Stroke": "game.arrangement",
    "Verdict": "game.rules",
    "arrange": "game.arrangement",
    "new_frame": "game.frame",
    "racked": "game.arrangement",
    "summarize": "game.summary",
    "Ball": "lecture.ball",
    "Event": "shot.trajectory",
    "Physics": "shot.physics",
    "Shot": "shot.shot",
    "ShotError": "shot.physics",
    "SimulationError": "simulation",
    "Strike": "shot.cue",
    "Table": "table.table",
    "TableState": "shot.trajectory",
    "Trajectories": "many",
    "Trajectory": "shot.trajectory",
    "Decision": "players.opponents",
    "Effort": "search.looking",
    "GRADES": "players.opponents",
    "Grade": "players.opponents",
    "decide": "players.opponents",
    "stroke_of_hand": "players.opponents",
    "FoundShot": "search.finding",
    "Noise": "search.strokes",
    "eight_ball_rack": "table.rack",
    "find_shots": "search.finding",
    "load_shot": "shot.shot_file",
    "make_shot": "shot.shot",
    "nine_ball_rack": "table.rack",
    "run_shot_file": "simulation",
    "simulate": "simulation",
    "simulate_many": "many",
    "strike": "shot.cue",
}
__all__ = sorted(_HOMES)


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)


def __dir__() -> list[str]:
    return [*__all__, *globals()]
