"""Shots as data: what `shot_file` reads."""

from __future__ import annotations

from typing import Any

from game.billiards.laws.state import IN_VZ, IN_Z, MOTIONS
from game.billiards.shot.physics import Physics
from game.billiards.shot.shot import Shot
from game.billiards.shot.shot_file import OPTIONAL_FIELDS, PHYSICS_FIELDS


def shot_data(shot: Shot) -> dict[str, Any]:
    """The content of a shot file (see `shot_file`), of plain values that JSON keeps to the last bit."""
    physics = shot.physics
    groups: dict[str, dict[str, float]] = {}
    for place, field in PHYSICS_FIELDS.items():
        group, name = place.split(".")
        groups.setdefault(group, {})[name] = getattr(physics, field)
    for place, field in OPTIONAL_FIELDS.items():
        group, name = place.split(".")
        if getattr(physics, field) != getattr(Physics(), field):
            groups.setdefault(group, {})[name] = getattr(physics, field)
    return {
        "format": "shot",
        "version": 1,
        "gravity": physics.gravity,
        "models": {"ball_ball": physics.ball_ball, "cushion": physics.cushion},
        **groups,
        "table": _table_data(shot),
        "balls": [_ball_data(shot, i) for i in range(len(shot.balls))],
    }


def _table_data(shot: Shot) -> dict[str, Any]:
    """Cushions, jaws and pockets with their ids."""
    table = shot.table
    return {
        "cushion_height": table.cushion_height,
        "cushions": [
            {"id": name, "from": row[0:2], "to": row[2:4], "normal": row[4:6]}
            for name, row in zip(shot.cushion_ids, table.cushions.tolist(), strict=True)
        ],
        "jaws": [
            {"id": name, "center": row[:2], "radius": row[2]}
            for name, row in zip(shot.jaw_ids, table.jaws.tolist(), strict=True)
        ],
        "pockets": [
            {"id": name, "center": row[:2], "radius": row[2]}
            for name, row in zip(shot.pocket_ids, table.pockets.tolist(), strict=True)
        ],
    }


def _ball_data(shot: Shot, i: int) -> dict[str, Any]:
    """One ball."""
    row = shot.balls[i].tolist()
    lift = {"height": row[IN_Z], "rise": row[IN_VZ]} if shot.flies and (row[IN_Z] or row[IN_VZ]) else {}
    return {
        "id": shot.ids[i],
        "radius": row[7],
        "mass": row[8],
        "position": shot.positions[i].tolist(),
        "velocity": row[2:4],
        "spin": row[4:7],
        "motion": MOTIONS[int(row[9])],
        **lift,
    }
