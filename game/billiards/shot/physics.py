"""What a shot is played with: cloth, balls and cushions as numbers, checked."""

from __future__ import annotations

import math
from typing import NamedTuple

from game.billiards.laws.contacts import BALL_MODELS, CUSHION_MODELS

OPTIONAL = ("cushion_restitution_fall", "cushion_compliance", "slate_restitution", "cushion_hop")


class ShotError(ValueError):
    """A shot that cannot be played; the message names the field and the reason."""


class Physics(NamedTuple):
    """Cloth, balls and cushions of a table. Frictions and restitutions have no unit; gravity is in m/s^2.

    cushion_restitution_fall: by how much the restitution of cushions falls with the closing speed, s/m.
    cushion_compliance: tangential over normal, of `stronge-2000`; for rubber (2 - nu)/(2 - 2 nu) = 1.5.
    slate_restitution: of a ball that falls on the bed (Alciatore, physical properties of pool balls and
    tables: 0.5). cushion_hop: share of it that is left when a cushion presses a ball down, 0 to 1, see
    `flight.nose`. airborne: balls may leave the slate; else vertical speed is left out.
    Defaults are those of a pool table in play. A friction of 0 takes the effect away.
    """

    ball_ball: str = "alciatore-2006"
    cushion: str = "han-2005"
    gravity: float = 9.81
    sliding: float = 0.2
    rolling: float = 0.01
    spinning: float = 0.0127
    ball_friction: float = 0.05
    cushion_friction: float = 0.2
    ball_restitution: float = 0.95
    cushion_restitution: float = 0.85
    cushion_restitution_fall: float = 0.0
    cushion_compliance: float = 1.5
    slate_restitution: float = 0.5
    cushion_hop: float = 0.0
    airborne: bool = True

    def __repr__(self) -> str:
        """All numbers; those that not every table has only where they are not the default.

        Words that stand for a table stay what they were before it could have these numbers. Whether balls may
        leave the slate is not said: it changes nothing about the table.
        """
        said = [f"{name}={value!r}" for name, value in self._asdict().items() if name != "airborne"
                and (name not in OPTIONAL or value != self._field_defaults[name])]  # fmt: skip
        return f"Physics({', '.join(said)})"


FRICTIONLESS = Physics(
    "elastic", "mirror", sliding=0.0, rolling=0.0, spinning=0.0, ball_friction=0.0, cushion_friction=0.0,
    ball_restitution=1.0, cushion_restitution=1.0,
)  # fmt: skip


def check_physics(physics: Physics) -> None:
    """ShotError if a model is unknown or a number absurd."""
    if physics.ball_ball not in BALL_MODELS:
        raise ShotError(f"models.ball_ball: {physics.ball_ball!r} is not one of {', '.join(BALL_MODELS)}")
    if physics.cushion not in CUSHION_MODELS:
        raise ShotError(f"models.cushion: {physics.cushion!r} is not one of {', '.join(CUSHION_MODELS)}")
    if not (math.isfinite(physics.gravity) and 0.0 < physics.gravity <= 1e4):
        raise ShotError(f"gravity: must be positive, at most 1e4 m/s^2, got {physics.gravity!r}")
    names = {
        "sliding": "friction.sliding",
        "rolling": "friction.rolling",
        "spinning": "friction.spinning",
        "ball_friction": "friction.ball_ball",
        "cushion_friction": "friction.cushion",
    }
    for field, name in names.items():
        value = getattr(physics, field)
        if not (math.isfinite(value) and (value == 0.0 or 1e-9 <= value <= 1e3)):
            raise ShotError(f"{name}: must be 0, or between 1e-9 and 1e3, got {value!r}")
    for field, name, least, most in (
        ("cushion_restitution_fall", "restitution.cushion_fall", 0.0, 10.0),
        ("cushion_compliance", "compliance.cushion", 0.01, 100.0),
        ("cushion_hop", "restitution.cushion_hop", 0.0, 1.0),
    ):
        if not least <= getattr(physics, field) <= most:
            raise ShotError(
                f"{name}: must be between {least:g} and {most:g}, got {getattr(physics, field)!r}"
            )
    for field in ("ball_restitution", "cushion_restitution", "slate_restitution"):
        value = getattr(physics, field)
        if not 0.0 <= value <= 1.0:
            raise ShotError(f"restitution.{field.split('_')[0]}: must be between 0 and 1, got {value!r}")
