"""What is measured in the broad-phase scenes."""

from __future__ import annotations

import math

from game.scenes.boxes.model.base import BoxesModel
from game.scenes.boxes.model.hierarchical_grids import HierarchicalGridModel
from game.scenes.boxes.model.race import RaceModel
from game.scenes.boxes.model.sweep_and_prune import SweepAndPruneModel
from game.scenes.boxes.model.uniform_grid import UniformGridModel
from game.scenes.boxes.parameters import CONTESTANTS
from game.stage import Readout


def _boxes_and_pairs(model: BoxesModel) -> tuple[Readout, Readout]:
    return Readout("boxes", len(model.boxes)), Readout("pairs", len(model.pairs))


def _begun_and_ended(model: BoxesModel) -> tuple[Readout, Readout]:
    return Readout("begun", model.begun), Readout("ended", model.ended)


def _expected_alone(model: BoxesModel) -> list[Readout]:
    """What costs too much to be measured where no level expects it."""
    if any(entry.readout == "pairs missed" for entry in model.content.expected):
        return [Readout("pairs missed", model.missed_pairs())]
    return []


def grid_readouts(model: UniformGridModel) -> list[Readout]:
    """Of C05."""
    return [
        *_boxes_and_pairs(model),
        *_begun_and_ended(model),
        Readout("grid", model.watch.median("grid"), "s"),
        Readout("matrix", model.manager_s("matrix"), "s"),
        Readout("hash", model.manager_s("hash"), "s"),
        Readout("box tests", model.grid.tests),
        Readout("answers differ", 0 if model.same else 1),
        *_expected_alone(model),
    ]


def hierarchy_readouts(model: HierarchicalGridModel) -> list[Readout]:
    """Of C06."""
    return [
        *_boxes_and_pairs(model),
        *_begun_and_ended(model),
        Readout("hierarchical", model.watch.median("hierarchical"), "s"),
        Readout("naive", model.watch.median("naive"), "s"),
        Readout("pair manager", model.watch.median("keeper"), "s"),
        Readout("box tests", model.grid.tests),
        Readout("answers differ", 0 if model.same else 1),
        *_expected_alone(model),
    ]


def sweep_readouts(model: SweepAndPruneModel) -> list[Readout]:
    """Of C07."""
    return [
        *_boxes_and_pairs(model),
        Readout("swaps", model.swaps),
        Readout("mean", model.mean_swaps()),
        *_begun_and_ended(model),
        Readout("sweep", model.watch.median("sweep"), "s"),
        Readout("naive", model.watch.median("naive"), "s"),
        Readout("sorted again", model.sap.resorts),
        Readout("answers differ", 0 if model.same else 1),
        *_expected_alone(model),
    ]


def race_readouts(model: RaceModel) -> list[Readout]:
    """Of the race."""
    return [
        *_boxes_and_pairs(model),
        *_begun_and_ended(model),
        *(Readout(name, model.watch.median(name), "s") for name in (*CONTESTANTS, "matrix", "hash")),
        Readout("swaps", model.swaps),
        Readout("put anew", model.tree_work.repairs),
        Readout("cut anew", model.tree_work.moved / max(len(model.boxes), 1)),
        Readout("events", model.kinetic.events if model.kinetic else math.nan),
        Readout("false pairs", model.kinetic.false_pairs if model.kinetic else math.nan),
        Readout("answers differ", float(sum(not same for same in model.agree.values()))),
        *_expected_alone(model),
    ]
