"""Rigid bodies of any shape in a plane: contacts, joints, and several solvers for them on one set of
contacts.
"""

from game.physics.solids.settings import TIERS, SolidSettings
from game.physics.solids.shapes import Capsule, Chain, Disc, Material, Polygon, box
from game.physics.solids.solvers import SOLVERS, SUGGESTED
from game.physics.solids.solvers.impact_law import IMPACT_LAWS
from game.physics.solids.store import SolidState
from game.physics.solids.world import NotFiniteError, RunawayError, SolidWorld

__all__ = [
    "IMPACT_LAWS",
    "SOLVERS",
    "SUGGESTED",
    "TIERS",
    "Capsule",
    "Chain",
    "Disc",
    "Material",
    "NotFiniteError",
    "Polygon",
    "RunawayError",
    "SolidSettings",
    "SolidState",
    "SolidWorld",
    "box",
]
