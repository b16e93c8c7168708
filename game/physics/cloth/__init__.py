"""A cloth that hangs in the wind and burns where it is written on."""

from game.physics.cloth.charring import Flame, GasAt
from game.physics.cloth.cloth import Cloth, ClothState
from game.physics.cloth.fabric import Fabric
from game.physics.cloth.hanging import Hanging
from game.physics.cloth.sheet import Breeze
from game.physics.cloth.speeds import creeping_speed

__all__ = ["Breeze", "Cloth", "ClothState", "Fabric", "Flame", "GasAt", "Hanging", "creeping_speed"]
