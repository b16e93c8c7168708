"""What is hot as it is seen: by the temperature of the black body that is as bright."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary

SECOND = 0.014388  # m K, Planck's second constant of radiation
WAVES = (610e-9, 550e-9, 465e-9)  # m, of red, green, blue
WAVE = WAVES[0]


class GlowLook(NamedTuple):
    """When gas is seen. dark, bright: K of a black body that is just seen, and that is seen brightest; clear:
    optical depth of hot gas without soot; opaque: kg/m³ of soot that add an optical depth of 1; thick: kg/m³
    of soot over which smoke would hide all, and most: what it hides at most; burns: K from which gas counts
    as flame.
    """

    dark: float
    bright: float
    clear: float
    opaque: float
    thick: float
    most: float
    burns: float


@inner_kernel
def brightness_temperature(kelvin: Any, depth: Any) -> Any:
    """K of the black body that is as bright in red light as a layer of a temperature and an optical depth:
    Wien's law with the layer's emissivity 1 - exp(-depth).
    """
    emissivity = -elementary.expm1(-depth)
    return kelvin / (1.0 - kelvin * (WAVE / SECOND) * elementary.log(emissivity))


@lean_kernel
def see_glowing(look: Any, temperature: Any, soot: Any, edge: Any, veil: Any) -> None:
    """veil (ny, nx, 2) float32, written: how thick the smoke and how bright the flames are, 0 to 1.

    temperature K, soot kg/m³, edge: share that is seen of each cell; all (ny, nx). Bright is the share on
    the way from look.dark to look.bright of the temperature of the black body that is as bright.
    """
    for j in range(veil.shape[0]):
        for i in range(veil.shape[1]):
            there, kelvin, light = max(soot[j, i], 0.0), temperature[j, i], 0.0
            depth = look.clear + there / look.opaque
            if kelvin > look.dark and depth > 0.0:
                kelvin = brightness_temperature(kelvin, depth)
                light = min(max((kelvin - look.dark) / (look.bright - look.dark), 0.0), 1.0)
            veil[j, i, 1] = light * edge[j, i]
            thick = min(there / look.thick, look.most)
            veil[j, i, 0] = thick * (1.0 - min(3.0 * light, 1.0)) * edge[j, i]


def warm_up_glowing() -> None:
    """Compile what gas is seen by."""
    cells, veil = np.full((2, 2, 5), 900.0), np.zeros((2, 2, 2), np.float32)
    look = GlowLook(500.0, 1000.0, 0.5, 1.0, 1.0, 1.0, 1.0)
    see_glowing(look, cells[..., 0], cells[..., 3], np.ones((2, 2)), veil)
