"""What the rigid body scene measures: energy, momenta, moments, and what each method has made of them."""

from __future__ import annotations

import math

from game.physics.rigid.motion import P, Q
from game.physics.rigid.quaternion import angle_between
from game.physics.rigid.turning import measure
from game.scenes.rigid_body import bodies as b
from game.scenes.rigid_body.model import RigidModel
from game.stage import Readout

ROUNDING = 1e-12  # shares up to this are shown as none


def readouts_of(model: RigidModel) -> list[Readout]:
    """What is shown and charted; energies are those of rotation unless another is named."""
    bodies = model.bodies
    body = bodies.all[b.A]
    shift, _, momentum, _, *spin = measure(body.state, body.constants[0])
    shown = [(index, "AB"[index]) for index in model.panes.shown]
    found = [
        Readout("error", angular_error(model, b.A), "°"),
        Readout("angular speed", math.sqrt(sum(w * w for w in spin)), "rad/s"),
        *(Readout(f"{name}: flips", int(bodies.accounts[index, b.FLIPS])) for index, name in shown),
        Readout("exact: flips", int(bodies.accounts[b.EXACT, b.FLIPS])),
        Readout("mass", body.mass, "kg"),
        Readout("exact: energy", measure(bodies.all[b.EXACT].state, body.constants[0])[1], "J"),
        Readout("greatest energy", body.largest_rotation_energy, "J"),
        Readout("|L|", momentum, "kg m²/s"),
        Readout("|P|", math.sqrt(2.0 * shift * body.mass), "kg m/s"),
        Readout("translational energy", shift, "J"),
    ]
    found.extend(Readout(f"I{k + 1}", moment, "kg m²") for k, moment in enumerate(body.moments.tolist()))
    for index, name in shown:
        found.extend(account_of(model, index, name))
    return found


def account_of(model: RigidModel, index: int, name: str) -> list[Readout]:
    """What a body's method has made of energy, angular momentum and |q|."""
    body, account = model.bodies.all[index], model.bodies.accounts[index]
    _, rotation, momentum, size, *_ = measure(body.state, body.constants[0])
    had, was = rotation - account[b.MADE_ENERGY], momentum - account[b.MADE_MOMENTUM]
    made = account[b.MADE_MOMENTUM] / was if was > 0.0 else 0.0
    return [
        Readout(f"{name}: energy", rotation, "J"),
        Readout(f"{name}: energy error", account[b.MADE_ENERGY] / had if had > 0.0 else 0.0),
        Readout(f"{name}: L error", _above_rounding(made)),
        Readout(f"{name}: |q| error", _above_rounding(size - 1.0)),
        Readout(f"{name}: angular error", angular_error(model, index), "°"),
    ]


def angular_error(model: RigidModel, index: int) -> float:
    """Angle (degrees) between a body and the exact one."""
    rows = model.bodies.rows
    turns = (tuple(rows[i, Q:P].tolist()) for i in (index, b.EXACT))
    return math.degrees(angle_between(*turns))


def _above_rounding(value: float) -> float:
    """A measured share, 0 where it is rounding."""
    return value if abs(value) > ROUNDING else 0.0
