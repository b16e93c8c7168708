"""Effects of the exact table, and the physics that is left when some are off."""

from __future__ import annotations

from game.billiards.lecture.state import POCKETS
from game.billiards.shot.physics import Physics
from game.billiards.table.table import Table
from game.physics.effects import EffectSet, declare_effect

CLOTH = declare_effect("cloth", "Cloth", "Balls slide, roll and come to rest; without it they never stop.")
SPIN_DECAY = declare_effect("spin-decay", "Spin decay", "Spin about the vertical wears off.")
THROW = declare_effect("throw", "Throw", "Balls rub on each other: cut and spin throw them.")
RUBBER = declare_effect("rubber", "Cushion friction", "Spin and cushion act on each other.")
AIRBORNE = declare_effect(
    "airborne", "Airborne balls", "A raised cue makes a ball jump; it flies, bounces, may leave the table."
)
EXACT_EFFECTS = POCKETS | CLOTH | SPIN_DECAY | THROW | RUBBER
GAME_EFFECTS = EXACT_EFFECTS | AIRBORNE


def physics_of(active: EffectSet, full: Physics | None = None) -> Physics:
    """``full`` (default: a pool table in play) without the effects that are not active."""
    full = Physics() if full is None else full
    cloth, spin = CLOTH in active, SPIN_DECAY in active
    return full._replace(
        sliding=full.sliding if cloth else 0.0,
        rolling=full.rolling if cloth else 0.0,
        spinning=full.spinning if spin else 0.0,
        ball_ball=full.ball_ball if THROW in active else "wallace-1988",
        ball_friction=full.ball_friction if THROW in active else 0.0,
        cushion=full.cushion if RUBBER in active else "restitution",
        airborne=full.airborne and AIRBORNE in active,
    )


def table_of(active: EffectSet, table: Table) -> Table:
    """The table, or the same bed with unbroken rails if there are to be no pockets."""
    return table if POCKETS in active else Table.bare(table.width, table.length, table.cushion_height)
