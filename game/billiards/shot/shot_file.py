"""Shot files: one shot as JSON. SI units, angles in radians.

    format "shot", version 1, gravity
    models.ball_ball, models.cushion
    friction.sliding, .rolling, .spinning, .ball_ball, .cushion
    restitution.ball_ball, .cushion; optional: restitution.cushion_fall, compliance.cushion
    table.cushion_height, table.cushions[] (from, to, normal)
    table.jaws[] and table.pockets[] (center, radius)
    balls[] (id, radius, mass, position, velocity, spin, motion)

Rows of the table may carry an `id`; else events name them by their number. What else stands in a file is
not read. What is missing or wrong is named by its place in the file.
"""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from game.arrays import Floats
from game.billiards.laws.contacts import BALL_MODELS, CUSHION_MODELS
from game.billiards.laws.state import MOTIONS, POCKETED
from game.billiards.shot.physics import Physics, ShotError
from game.billiards.shot.shot import Shot, make_shot
from game.billiards.table.table import Table, checked_table

PHYSICS_FIELDS = {  # place in the file: field of Physics
    "friction.sliding": "sliding",
    "friction.rolling": "rolling",
    "friction.spinning": "spinning",
    "friction.ball_ball": "ball_friction",
    "friction.cushion": "cushion_friction",
    "restitution.ball_ball": "ball_restitution",
    "restitution.cushion": "cushion_restitution",
}
OPTIONAL_FIELDS = {  # as above; left out of files where it is as `Physics` has it
    "restitution.cushion_fall": "cushion_restitution_fall",
    "compliance.cushion": "cushion_compliance",
    "restitution.slate": "slate_restitution",
    "restitution.cushion_hop": "cushion_hop",
}


def load_shot(path: str | Path) -> Shot:
    """Read and check a shot file. ShotError, with the file's name, if it cannot be read or is wrong."""
    file = Path(path)
    try:
        text = file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "not a text file"
        raise ShotError(f"{file}: {reason}") from None
    try:
        return parse_shot(json.loads(text))
    except json.JSONDecodeError as error:
        raise ShotError(f"{file}: not JSON: {error.msg} in line {error.lineno}") from None
    except RecursionError:
        raise ShotError(f"{file}: not a shot: nested too deeply") from None
    except ValueError as error:
        raise ShotError(f"{file}: {error}") from None


def parse_shot(data: object) -> Shot:
    """Shot from the content of a shot file. ShotError names the field and the reason."""
    root = _member_object(data, "the file")
    if root.get("format", "shot") != "shot":
        raise ShotError(f'format: must be "shot", got {root["format"]!r}')
    if root.get("version", 1) != 1:
        raise ShotError(f"version: only 1 is known, got {root['version']!r}")
    physics = _read_physics(root)
    table_data = _member_object(_member(root, "table"), "table")
    table, element_ids = _read_table(table_data)
    return _read_balls(_member(root, "balls"), table, element_ids, physics)


def _read_physics(root: dict[str, Any]) -> Physics:
    models = _member_object(_member(root, "models"), "models")
    names = {}
    for field, known in (("ball_ball", BALL_MODELS), ("cushion", CUSHION_MODELS)):
        names[field] = _choice(_member(models, field, "models"), f"models.{field}", tuple(known))
    values: dict[str, Any] = {}
    for place, field in PHYSICS_FIELDS.items():
        group, name = place.split(".")
        values[field] = _number(_member(_member_object(_member(root, group), group), name, group), place)
    for place, field in OPTIONAL_FIELDS.items():
        group, name = place.split(".")
        members = _member_object(root.get(group, {}), group)
        if name in members:
            values[field] = _number(members[name], place)
    gravity = _number(_member(root, "gravity"), "gravity")
    return Physics(names["ball_ball"], names["cushion"], gravity)._replace(**values)


def _read_table(
    data: dict[str, Any],
) -> tuple[Table, tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]]:
    height = _number(_member(data, "cushion_height", "table"), "table.cushion_height")
    cushions, cushion_ids = _read_rows(data, "cushions", (("from", 2), ("to", 2), ("normal", 2)))
    jaws, jaw_ids = _read_rows(data, "jaws", (("center", 2), ("radius", 1)))
    pockets, pocket_ids = _read_rows(data, "pockets", (("center", 2), ("radius", 1)))
    corner = cushions[:, :4].reshape(-1, 2).max(axis=0, initial=0.0)
    width, length = (float(v) if v > 0.0 else 1.0 for v in corner)
    return checked_table(width, length, height, cushions, jaws, pockets), (cushion_ids, jaw_ids, pocket_ids)


def _read_rows(
    data: dict[str, Any], name: str, fields: tuple[tuple[str, int], ...]
) -> tuple[Floats, tuple[str, ...]]:
    """Rows of numbers of one kind of element, and their ids."""
    place = f"table.{name}"
    rows, ids = [], []
    for k, item in enumerate(_list(_member(data, name, "table"), place)):
        here = f"{place}[{k}]"
        element = _member_object(item, here)
        row: list[float] = []
        for field, count in fields:
            row += _numbers(_member(element, field, here), f"{here}.{field}", count)
        rows.append(row)
        ids.append(_identifier(element.get("id", k), f"{here}.id"))
    if len(set(ids)) != len(ids):
        raise ShotError(f"{place}: two have the same id")
    columns = sum(count for _, count in fields)
    return np.array(rows, dtype=np.float64).reshape(-1, columns), tuple(ids)


def _read_balls(
    data: object,
    table: Table,
    element_ids: tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]],
    physics: Physics,
) -> Shot:
    items = _list(data, "balls")
    if not items:
        raise ShotError("balls: there must be at least one")
    fields = {"position": 2, "velocity": 2, "spin": 3, "radius": 1, "mass": 1}
    columns: dict[str, list[list[float]]] = {field: [] for field in fields}
    ids, motions, lifts = [], [], []
    for i, item in enumerate(items):
        here = f"balls[{i}]"
        ball = _member_object(item, here)
        ids.append(_identifier(_member(ball, "id", here), f"{here}.id"))
        if ids[-1] in ids[:-1]:
            raise ShotError(f"{here}.id: {ids[-1]!r} is there twice")
        for field, count in fields.items():
            columns[field].append(_numbers(_member(ball, field, here), f"{here}.{field}", count))
        motions.append(_choice(_member(ball, "motion", here), f"{here}.motion", MOTIONS[: POCKETED + 1]))
        lifts.append([_number(ball.get(name, 0.0), f"{here}.{name}") for name in ("height", "rise")])
    shot = make_shot(
        table,
        columns["position"],
        columns["velocity"],
        columns["spin"],
        radii=columns["radius"],
        masses=columns["mass"],
        motions=motions,
        physics=physics,
        ids=tuple(ids),
    )
    for i, (height, rise) in enumerate(lifts):
        if height or rise:
            shot = shot.lifted(i, height, rise)
    cushion_ids, jaw_ids, pocket_ids = element_ids
    return replace(shot, cushion_ids=cushion_ids, jaw_ids=jaw_ids, pocket_ids=pocket_ids)


def _member(data: dict[str, Any], name: str, place: str = "") -> Any:
    if name not in data:
        raise ShotError(f"{place}.{name}: is missing" if place else f"{name}: is missing")
    return data[name]


def _member_object(value: object, place: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise ShotError(f"{place}: must be an object, got {_named(value)}")
    return value


def _list(value: object, place: str) -> list[Any]:
    if not isinstance(value, list):
        raise ShotError(f"{place}: must be a list, got {_named(value)}")
    return value


def _number(value: object, place: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise ShotError(f"{place}: must be a number, got {_named(value)}")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise ShotError(f"{place}: must be finite, got {number!r}")
    return number


def _numbers(value: object, place: str, count: int) -> list[float]:
    """`count` numbers: a plain one for 1, else a list."""
    if count == 1:
        return [_number(value, place)]
    items = _list(value, place)
    if len(items) != count:
        raise ShotError(f"{place}: must be {count} numbers, got {len(items)}")
    return [_number(item, f"{place}[{k}]") for k, item in enumerate(items)]


def _choice(value: object, place: str, known: tuple[str, ...]) -> str:
    if not isinstance(value, str) or value not in known:
        raise ShotError(f"{place}: must be one of {', '.join(known)}, got {_named(value)}")
    return value


def _identifier(value: object, place: str) -> str:
    if isinstance(value, bool) or not isinstance(value, str | int):
        raise ShotError(f"{place}: must be a text or a whole number, got {_named(value)}")
    return str(value)


def _named(value: object) -> str:
    """A value as a short text for a message."""
    if value is None:
        return "null"
    text = repr(value)
    return text if len(text) <= 40 else f"{text[:37]}..."
