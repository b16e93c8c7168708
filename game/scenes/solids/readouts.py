"""What the playground of solids measures."""

from __future__ import annotations

from game.physics.kernels import elementary
from game.scenes.solids.measures import contact_points, energies
from game.scenes.solids.model import SolidModel
from game.stage import Readout

UNITS = {
    "right": "m", "up": "m", "sink": "m", "way": "m", "turn": "°", "speed": "m/s", "spin": "rad/s",
    "force": "N", "passed": "", "fallen": "", "when": "s", "highest": "m",
    "moment": "N m", "period": "s", "between": "s", "broken": "", "fastest": "m/s", "gap": "m",
}  # fmt: skip
COUNTED = ("passed", "fallen", "broken")


def readouts(model: SolidModel) -> list[Readout]:
    """The level's gauges first, then what every level measures."""
    world = model.world
    rows = [
        Readout(
            gauge.name,
            int(value) if gauge.measure in COUNTED else value,
            UNITS[gauge.measure],
        )
        for gauge, value in zip(model.content.gauges, model.gauges.values.tolist(), strict=True)
    ]
    found, points = energies(world), contact_points(world)
    return [
        *rows,
        Readout("sum", found.total, "J"),
        Readout("moving", found.moving, "J"),
        Readout("turning", found.turning, "J"),
        Readout("height", found.height, "J"),
        Readout("elastic", found.elastic, "J"),
        Readout("momentum", elementary.length(*found.momentum.tolist()), "N s"),
        Readout("deepest", max(0.0, float(points.depths.max(initial=0.0))), "m"),
        Readout("contacts", len(points.depths)),
        Readout("bodies", len(model.movable())),
        Readout("awake", model.awake()),
        Readout("a step", model.watch.median("step"), "s"),
    ]
