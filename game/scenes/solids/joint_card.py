"""The card of a joint that was clicked: its kind, limits, drive and stiffness, and what it bears."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.physics.solids import SolidWorld
from game.physics.solids.arrays.layout import JOINT_NAMES
from game.scenes.solids.parameters import BEYOND, SolidParameters
from game.stage import Inspected

TURNS, WAYS = ("joint_least_turn", "joint_most_turn"), ("joint_least_way", "joint_most_way")
TURNING = ("joint_limited", *TURNS, "joint_speed", "joint_torque")
SOFT = ("joint_hertz", "joint_damping", "joint_break")
OF_KIND = {
    "pin": (*TURNING, *SOFT),
    "motor": (*TURNING, *SOFT),
    "slider": ("joint_limited", *WAYS, "joint_pace", "joint_force", *SOFT),
    "distance": ("joint_limited", *WAYS, *SOFT),
    "spring": ("joint_limited", *WAYS, *SOFT),
    "rope": SOFT,
    "weld": SOFT,
}
OF_JOINT = tuple(dict.fromkeys(name for names in OF_KIND.values() for name in names))
OPTIONS = {
    "joint_speed": "speed", "joint_pace": "speed", "joint_torque": "most", "joint_force": "most",
    "joint_hertz": "hertz", "joint_damping": "damping", "joint_break": "break_force",
}  # fmt: skip
UNBOUNDED = ("joint_torque", "joint_force", "joint_break")  # their right end stands for no bound


def kind_of(world: SolidWorld, joint: int) -> str:
    """Name of a joint's kind."""
    return JOINT_NAMES[int(world.joints.kinds[joint])]


def card_of(world: SolidWorld, joint: int) -> Inspected:
    """Title, parameters of its kind, and the load of the last step."""
    kind, (force, torque) = kind_of(world, joint), world.joint_load(joint)
    load = f"{force:.3g} N" if kind in ("rope", "distance", "spring") else f"{force:.3g} N, {torque:.3g} N m"
    return Inspected(f"{kind.capitalize()} {joint}", OF_KIND[kind], "card", load)


def show_joint(world: SolidWorld, parameters: SolidParameters, joint: int) -> None:
    """Let the parameters of the card say what a joint has, as near as they can say it."""
    options, kind = world.joint_options(joint), kind_of(world, joint)
    low, high = options.limits
    said: dict[str, Any] = {name: getattr(options, field) for name, field in OPTIONS.items()}
    said |= dict(zip(TURNS, np.degrees((low, high)).tolist(), strict=True))
    said |= dict(zip(WAYS, (low, high), strict=True))
    for name in OF_KIND[kind]:
        if name == "joint_limited":
            parameters.joint_limited = math.isfinite(low) or math.isfinite(high)
        else:
            ends = getattr(type(parameters), name)
            setattr(parameters, name, min(max(float(said[name]), ends.minimum), ends.maximum))


def give_joint(world: SolidWorld, parameters: SolidParameters, joint: int, name: str) -> str:
    """Give a joint what the parameter of that name says; why it cannot have it, or ""."""
    if name not in OF_KIND[kind_of(world, joint)]:
        return ""
    try:
        if name in OPTIONS:
            value = parameters.values[name]
            world.change_joint(
                joint, **{OPTIONS[name]: math.inf if name in UNBOUNDED and value >= BEYOND else value}
            )
        else:
            world.change_joint(joint, limits=_limits(world, parameters, joint))
    except ValueError as error:
        return f"{str(error)[:1].upper()}{str(error)[1:]}."
    return ""


def _limits(world: SolidWorld, parameters: SolidParameters, joint: int) -> tuple[float, float]:
    """Lower and upper (rad or m) as the card says; none if it is not limited."""
    if not parameters.joint_limited:
        return -math.inf, math.inf
    turning = TURNS[0] in OF_KIND[kind_of(world, joint)]
    low, high = (float(parameters.values[name]) for name in (TURNS if turning else WAYS))
    return (math.radians(low), math.radians(high)) if turning else (low, high)
