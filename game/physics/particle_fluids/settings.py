"""What a fluid of particles is made of, and how it is stepped."""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple

from game.physics.particle_fluids.search import SEARCHES
from game.physics.particle_fluids.smoothing import NAMES
from game.physics.particle_fluids.walls import WALLS
from game.settings import Number, Option

LAWS = ("mueller-2003", "clavet-2005", "position-based", "dfsph")
MUELLER, CLAVET, POSITIONS, DFSPH = range(4)
NEVER = 1e9  # K: it does not boil


class Liquid(NamedTuple):
    """A kind of liquid, or of gas that is as hard to squeeze.

    density kg/m³; viscosity Pa s; tension N/m; swelling 1/K: how its density falls with its temperature;
    boils: K, latent: K of its own heat capacity that boiling takes; vapour: the kind that it becomes, or -1;
    springy: whether slime's springs hold it together; air: whether it is made and taken away on demand.
    """

    density: float = 1000.0
    viscosity: float = 0.001
    tension: float = 0.0
    swelling: float = 0.0
    boils: float = NEVER
    latent: float = 0.0
    vapour: int = -1
    springy: bool = False
    air: bool = False

    def checked(self, kinds: int) -> Liquid:
        """Itself; ValueError for what no liquid has."""
        if not 0.0 < self.density < math.inf:
            raise ValueError(f"density = {self.density!r}: expected a number above 0 kg/m³")
        for name in ("viscosity", "tension", "latent"):
            if not 0.0 <= getattr(self, name) < math.inf:
                raise ValueError(f"{name} = {getattr(self, name)!r}: expected a number, at least 0")
        if not (math.isfinite(self.swelling) and self.boils > 0.0):
            raise ValueError("swelling, boils: expected finite numbers, a temperature above 0 K")
        if not -1 <= self.vapour < kinds:
            raise ValueError(f"vapour = {self.vapour!r}: there are {kinds} kinds")
        return self


class FluidSettings(NamedTuple):
    """How a fluid of particles is stepped."""

    gravity: Annotated[float, Number(0.0, 30.0, help="downwards", unit="m/s²")] = 9.81
    law: Annotated[int, Option(LAWS, help="what keeps particles apart")] = DFSPH
    walls: Annotated[int, Option(WALLS, help="what a particle feels of a wall")] = 2
    kernel: Annotated[int, Option(NAMES[:2], help="how much of a particle is felt at a distance")] = 0
    search: Annotated[int, Option(SEARCHES, help="how neighbours are found")] = 0
    iterations: Annotated[int, Number(1, 200, help="at most, of a step's pressures")] = 30
    error: Annotated[float, Number(1e-6, 0.1, help="of the mean density, at which they end")] = 1e-3
    softness: Annotated[
        float, Number(2.0, 200.0, unit="m/s", help="speed of sound, of laws that squeeze")
    ] = 10.0
    stiffness: Annotated[float, Number(0.0, 20_000.0, unit="1/s²", help="of slime's springs")] = 300.0
    borne: Annotated[float, Number(0.0, 1.0, help="share that a spring bears before it flows")] = 0.1
    flow: Annotated[float, Number(0.0, 50.0, unit="1/s", help="how fast springs flow beyond")] = 0.5
    sticking: Annotated[float, Number(0.0, 1.0, help="share of the drag at a wall")] = 1.0
    diffusivity: Annotated[float, Number(0.0, 0.1, unit="m²/s", help="how fast heat spreads")] = 1e-4
    courant: Annotated[float, Number(0.05, 0.5, help="spacings that the fastest goes in a step")] = 0.2
