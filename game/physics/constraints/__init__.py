"""Position based dynamics: links, areas and attachments by Gauss-Seidel, compliance, or solved at once."""

from game.physics.constraints.colours import ORDERS
from game.physics.constraints.effects import AREAS, ATTACHMENTS, CONTACTS, DAMPING, LINKED, LINKS, TEARING
from game.physics.constraints.links import MODELS
from game.physics.constraints.schemes import SCHEMES
from game.physics.constraints.settings import SOLVERS, Settings
from game.physics.constraints.system import LinkMeasures, PositionBasedDynamics, PositionState

__all__ = [
    "AREAS",
    "ATTACHMENTS",
    "CONTACTS",
    "DAMPING",
    "LINKED",
    "LINKS",
    "MODELS",
    "ORDERS",
    "SCHEMES",
    "SOLVERS",
    "TEARING",
    "LinkMeasures",
    "PositionBasedDynamics",
    "PositionState",
    "Settings",
]
