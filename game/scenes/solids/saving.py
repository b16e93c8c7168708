"""The world as it stands, as the content of a level file."""

from __future__ import annotations

import math

import msgspec

from game.scenes.solids.bodies import entry_of, joint_entry, whole_joints
from game.scenes.solids.level import GROUND, BodyEntry, SolidContent, SwingEntry
from game.scenes.solids.model import ANCHOR, SolidModel

SOON = 1e-6  # s


def content_of(model: SolidModel) -> SolidContent:
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
    entry = entry_of(model.world, body, int(model.tints[body]))
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
