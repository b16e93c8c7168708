"""What is measured of skins (C02) and of solvers (C03)."""

from __future__ import annotations

from game.scenes.skeletons.parameters import SHOWN
from game.scenes.skeletons.reaching_model import ReachingModel
from game.scenes.skeletons.skinning_model import SkinningModel
from game.stage import Readout

NAMES = ("gradient", "Buss", "Armijo", "damped", "CCD", "FABRIK")


def readouts_of_skin(model: SkinningModel) -> list[Readout]:
    """Of C02."""
    rig, watch, blend = model.rig, model.watch, model.parameters.blend
    return [
        Readout("bones", rig.skeleton.count),
        Readout("points", len(rig.skinned)),
        Readout("area kept", 100.0 * model.skin_areas[blend], "%"),
        Readout("skin", watch.median(blend), "s"),
        Readout("linear", 100.0 * model.skin_areas["linear"], "%"),
        Readout("rotor", 100.0 * model.skin_areas["rotor"], "%"),
        Readout("apart", model.apart, "m"),
        Readout("forward error", model.forward_error(), "m"),
        Readout("linear time", watch.median("linear"), "s"),
        Readout("rotor time", watch.median("rotor"), "s"),
    ]


def readouts_of_methods(model: ReachingModel) -> list[Readout]:
    """Of C03: the chosen method first, then all."""
    chosen = model.measured[model.parameters.master]
    rows = [
        Readout("error", chosen.error, "m"),
        Readout("iterations", chosen.iterations),
        Readout("solve", model.watch.median(model.parameters.method), "s"),
        Readout("reach", model.solver.chain.reach if model.solver is not None else 0.0, "m"),
    ]
    for k, name in enumerate(NAMES):
        rows.append(Readout(name, model.measured[k].error, "m"))
        rows.append(Readout(f"{name} iterations", model.measured[k].iterations))
        rows.append(Readout(f"{name} time", model.watch.median(SHOWN[k]), "s"))
    return rows
