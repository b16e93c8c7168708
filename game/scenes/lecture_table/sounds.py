"""What is to be heard of the lecture's table: its marks, which are impacts with their ages, as sounds."""

from __future__ import annotations

from typing import TYPE_CHECKING

from game.scenes.shared.tables.sounds import REMEMBERED_S, pan_of
from game.stage import Hearing, Sound

if TYPE_CHECKING:
    from game.scenes.lecture_table.scene import LectureTable

POCKET_SPEED = 1.0  # m/s, at which a ball is taken to fall in


def hearing_of(scene: LectureTable) -> Hearing:
    """The impacts of the last moments, in the middle of the step in which the table found them."""
    now, half = scene.played_s, 0.5 * scene.step_length
    state, length = scene.table.state, scene.table.table.length
    mass = float(scene.table.masses.mean())
    sounds = [
        Sound(
            now - age - half, "ball" if impulse > 0.0 else "cushion", abs(impulse) / mass, pan_of(y, length)
        )
        for _, y, age, impulse in scene.marks.tolist()
        if age < REMEMBERED_S and impulse != 0.0
    ]
    places = (state.offsets[:, 1] + 0.5 * length).tolist()
    for age, y in zip(scene.sunk_s.tolist(), places, strict=True):
        if age < REMEMBERED_S:
            sounds.append(Sound(now - age - half, "pocket", POCKET_SPEED, pan_of(y, length)))
    if now - scene.struck_s < REMEMBERED_S:
        sounds.append(Sound(scene.struck_s - half, "tip", scene.cue.speed, 0.0))
    return Hearing("lecture's table", now, sounds)
