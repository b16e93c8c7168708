"""The ledger: the last collisions in figures, one line each."""

from __future__ import annotations

import math

from game.arrays import Floats
from game.physics.spheres import ledger
from game.scenes.spheres.model import CollisionModel
from game.stage import Table
from game.ui.look.numerals import NARROW_SPACE, format_number

ROWS = 6
MOST_SPHERES = 60  # with more, the ledger would say nothing
COLUMNS = ("pair", "J N s", "v m/s", "after", "ΔE J", "P lost")
HELP = (
    "Impulse, speed along the normal before and after, change of energy, and momentum that the spheres lose: "
    "none but for rounding, or what a wall takes"
)
ROUNDING = 1e-12  # of an impulse: momentum of which no more is lost is kept


def has_ledger(model: CollisionModel) -> bool:
    """Whether it is shown, and the spheres' numbers with it."""
    return bool(model.parameters.ledger) and len(model.world.bodies.composition.radii) <= MOST_SPHERES


def ledger_table(model: CollisionModel) -> Table | None:
    """The last collisions, newest first; each is known by its number, counted from the beginning."""
    if not has_ledger(model):
        return None
    entries = model.world.ledger()[-ROWS:][::-1]
    keys = tuple(model.world.collisions - i for i in range(len(entries)))
    return Table("Ledger", COLUMNS, tuple(_figures(model, entry) for entry in entries), keys, ROWS, HELP)


def entry_of(model: CollisionModel, key: int) -> Floats | None:
    """The entry of a collision by its number, or None if it is forgotten."""
    entries = model.world.ledger()
    back = model.world.collisions - key
    return entries[len(entries) - 1 - back] if 0 <= back < len(entries) else None


def momentum_lost(model: CollisionModel, entry: Floats) -> float:
    """Momentum (kg m/s) that a collision takes from the spheres: by rounding, or what a wall, or a sphere
    that nothing moves, takes up."""
    spheres = [int(entry[ledger.ONE]), int(entry[ledger.OTHER])]
    owners, masses = model.world.bodies.composition.owners, model.world.bodies.composition.masses
    if any(s < 0 or (s < len(owners) and math.isinf(masses[owners[s]])) for s in spheres):
        return _size(entry)
    lost = float(entry[ledger.LOST_MOMENTUM])
    return 0.0 if lost <= ROUNDING * _size(entry) else lost


def _size(entry: Floats) -> float:
    """Length of the impulse, N s."""
    return math.sqrt(float((entry[ledger.JX : ledger.JZ + 1] ** 2).sum()))


def _figures(model: CollisionModel, entry: Floats) -> tuple[str, ...]:
    """One entry of the ledger in words."""
    other = int(entry[ledger.OTHER])
    return (
        f"{int(entry[ledger.ONE]) + 1}, {other + 1 if other >= 0 else 'wall'}",
        _brief(_size(entry)),
        _brief(float(entry[ledger.BEFORE])),
        _brief(float(entry[ledger.AFTER])),
        _brief(float(entry[ledger.CHANGE]), 2),
        _brief(momentum_lost(model, entry)),
    )


def _brief(value: float, digits: int = 3) -> str:
    """A number that a narrow column holds: two digits of a small one, no space round the power of ten."""
    small = 0.0 < abs(value) < 0.01
    return format_number(value, 2 if small else digits).replace(f"{NARROW_SPACE}×{NARROW_SPACE}", "·")
