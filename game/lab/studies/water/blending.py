"""What accuracy costs for runs between recorded ones: a disc between two discs, aligned and plainly mixed."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from game.arrays import Floats
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.liquid.blending import Blend
from game.physics.liquid.distances import area_of, run_of

NODES = (4, 6, 10, 16, 24)  # of the deformation's lattice
ACROSS, FRAMES, CELL = 61, 9, 0.05  # nodes of a picture along a side, pictures, m
FIRST, OTHER = (-0.6, -0.3, 0.35), (0.6, 0.3, 0.55)  # x, y, radius of both discs, m
ALIGNED, PLAIN = "aligned", "plain"


def distance_of(x: float, y: float, radius: float) -> Floats:
    """(ACROSS, ACROSS) m from a disc."""
    places = (np.arange(ACROSS) - ACROSS // 2) * CELL
    along, up = places[None, :] - x, places[:, None] - y
    return np.asarray(np.sqrt(along * along + up * up) - radius)


class BlendTrial:
    """The run half of the way between two discs, picture by picture."""

    simulated_s = FRAMES / 30.0

    def __init__(self, setting: Setting):
        self.nodes, self.aligned = round(1.0 / setting.knob), setting.method == ALIGNED

    def reset(self) -> None:
        """Both runs are recorded."""
        fills = [np.clip(0.5 - 0.5 * distance_of(*one) / CELL, 0.0, 1.0) for one in (FIRST, OTHER)]
        self.runs = [run_of(np.repeat(one[None], FRAMES, axis=0), (CELL, CELL, CELL)) for one in fills]

    def run(self) -> None:
        """Align them, and mix."""
        blend = Blend(self.runs, nodes=self.nodes)
        self.found = [blend.at(frame, (0.5, 0.5), self.aligned) for frame in range(FRAMES)]

    def outcome(self) -> Outcome:
        """Liquid that is elsewhere than in the disc of mean place and radius."""
        x, y, radius = (0.5 * (a + b) for a, b in zip(FIRST, OTHER, strict=True))
        true = distance_of(x, y, radius)
        apart = area_of(np.minimum(self.found[4], true), CELL) - area_of(
            np.maximum(self.found[4], true), CELL
        )
        return Outcome(max(0.5 * apart / (math.pi * radius * radius), 1e-5), FRAMES)


def _settings() -> list[Setting]:
    aligned = [Setting(ALIGNED, 1.0 / n, {}, {"nodes": n}, float(n)) for n in NODES]
    return [*aligned, Setting(PLAIN, 1.0 / NODES[0], {}, {}, 1.0)]


def _present(parameters: Mapping[str, Any]) -> Setting:
    """The scene's deformation."""
    return Setting(ALIGNED, 1.0 / min(max(int(parameters["nodes"]), NODES[0]), NODES[-1]), {})


blending_study = Study(
    name="splash-blend",
    title="A disc between two discs",
    error="share of the area that lies elsewhere",
    error_unit="",
    counter="pictures",
    knob=Knob("pitch", "share of the side from node to node", ""),
    methods=(Method(ALIGNED, "aligned", None), Method(PLAIN, "plain mixing", 0.0)),
    settings=_settings,
    trial=BlendTrial,
    reference="the disc of mean place and radius",
    expectation="Aligned, a few nodes suffice for discs. Plain mixing has no liquid there at all.",
    present=_present,
    workload=Workload("two discs that barely meet, 9 pictures"),
)
