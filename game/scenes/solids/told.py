"""What a story says of the playground: readouts, sounds, and the level as it is now."""

from __future__ import annotations

import math

import msgspec

from game.physics.kernels import elementary
from game.scenes.solids import measures
from game.scenes.solids.bodies import entry_of, joint_entry, whole_joints
from game.scenes.solids.level import GROUND, BodyEntry, SolidContent, SwingEntry
from game.scenes.solids.measures import contact_points, energies
from game.scenes.solids.model import ANCHOR, SolidModel
from game.stage import Hearing, Readout
from game.worlds.rubbing import rubbing_heard

SOON = 1e-6  # s
LOUD = 60.0  # W, of rolling or sliding that is as loud as can be
NAMES = {
    measures.THUD: "thud",
    measures.WOOD: "wood",
    measures.STONE: "stone",
    measures.STEEL: "steel",
    measures.SNAP: "crackle",
}
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
        Readout("angular momentum", found.spin, "N m s"),
        Readout("deepest", max(0.0, float(points.depths.max(initial=0.0))), "m"),
        Readout("contacts", len(points.depths)),
        Readout("bodies", len(model.movable())),
        Readout("awake", model.solids.awake()),
        Readout("a step", model.solids.watch.median("step"), "s"),
    ]


def hearing(model: SolidModel) -> Hearing:
    """Contacts that began in the last moments and what rolls and slides, from left to right of the view."""
    view = model.content.view
    middle, half = 0.5 * (view.left + view.right), 0.5 * max(view.right - view.left, 1e-9)
    steady = rubbing_heard(model.world, model.parameters.values["step_length"], LOUD, half, middle)
    return Hearing("solids", model.time, model.heard.sounds(NAMES, half, middle), steady)


def saved(model: SolidModel) -> SolidContent:
    """Body by body, joint by joint; the view stays, gauges do not: they count from the level's beginning."""
    ids = model.movable().tolist()
    numbers = {body: k for k, body in enumerate(ids)}
    numbers.update(dict.fromkeys((ANCHOR, *model.floors), GROUND))
    content = model.content
    return SolidContent(
        bodies=tuple(_body(model, body) for body in ids),
        joints=tuple(joint_entry(model.world, joint, numbers) for joint in whole_joints(model.world)),
        floor=content.floor,
        walls=content.walls,
        floor_friction=content.floor_friction,
        view=content.view,
    )


def _body(model: SolidModel, body: int) -> BodyEntry:
    """One that swings goes on in its swing; one that goes, or is set free, does so after what is left."""
    entry = entry_of(model.world, body, int(model.tints.rows[body]))
    for shake in model.shakes:
        if shake.body == body:
            phase = math.degrees(math.remainder(shake.rate * model.time + shake.phase, math.tau))
            swing = SwingEntry(amplitude=shake.amplitude, rate=shake.rate, phase=phase)
            entry = msgspec.structs.replace(entry, swing=swing)
    for name, rows in (("gone_at", model.leaving), ("free_at", model.freed)):
        for moment, other in rows:
            if other == body:
                entry = msgspec.structs.replace(entry, **{name: max(moment - model.time, SOON)})
    return entry
