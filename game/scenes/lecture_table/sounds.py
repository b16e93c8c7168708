"""What is to be heard of the lecture's table: its marks, which are impacts with their ages, as sounds."""

from __future__ import annotations

from game.scenes.lecture_table.model import LectureTableModel
from game.scenes.shared.tables.sounds import pan_of
from game.stage import Hearing, Sound
from game.worlds.hearing import REMEMBERED_S

POCKET_SPEED = 1.0  # m/s, at which a ball is taken to fall in


def hearing_of(model: LectureTableModel, stroke_speed: float) -> Hearing:
    """The impacts of the last moments and the stroke (m/s), in the middle of the step that found them."""
    now, half = model.played_s, 0.5 * model.parameters.step_length
    state, length = model.table.state, model.table.table.length
    mass = float(model.table.masses.mean())
    sounds = [
        Sound(
            now - age - half, "ball" if impulse > 0.0 else "cushion", abs(impulse) / mass, pan_of(y, length)
        )
        for _, y, age, impulse in model.marks.rows.tolist()
        if age < REMEMBERED_S and impulse != 0.0
    ]
    places = (state.offsets[:, 1] + 0.5 * length).tolist()
    for age, y in zip(model.sunk_s.tolist(), places, strict=True):
        if age < REMEMBERED_S:
            sounds.append(Sound(now - age - half, "pocket", POCKET_SPEED, pan_of(y, length)))
    if now - model.struck_s < REMEMBERED_S:
        sounds.append(Sound(model.struck_s - half, "tip", stroke_speed, 0.0))
    return Hearing("lecture's table", now, sounds)
