"""Turns on the lecture's table: whose cue it is, the white ball's return, and play without a person."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from game.scenes.shared.tables.cue import AIMING
from game.scenes.shared.tables.demo_shots import choose_stroke, free_head_spot

if TYPE_CHECKING:
    from game.scenes.lecture_table.scene import LectureTable

NEXT_STROKE_S = 1.2  # s of rest before the table's own next stroke
NEW_RACK_S = 2.0  # s of rest on an empty table before the balls come back


def end_turn(scene: LectureTable) -> None:
    """All balls have come to rest: the white one comes back, and who potted nothing passes the cue."""
    scene.turn_open = False
    down = scene.balls_down
    if scene.has_white and not scene.table.state.in_play[0]:
        _put_back_white(scene)
        scene.told.append("The white ball comes back to the head spot.")
        scene.player = 1 - scene.player
    elif down == scene.down_before:
        scene.player = 1 - scene.player
    if down and down == len(scene.numbers) - 1 and len(scene.numbers) > 2:
        scene.told.append(f"The table is empty after {scene.strokes} strokes.")
    scene.down_before = down


def _put_back_white(scene: LectureTable) -> None:
    table = scene.table
    radius = float(table.state.radii[0])
    place = free_head_spot(table.table, radius, lambda place: table.is_clear(0, place))
    if place is not None:
        table.place(0, place)


def play_by_itself(scene: LectureTable) -> None:
    """Strokes of the level's own, and a new rack when the table is empty."""
    if scene.down_before and scene.down_before == len(scene.numbers) - 1:
        if scene.rest_s > NEW_RACK_S:
            scene.action("rack")
        return
    if not scene.white_ready or scene.cue.phase != AIMING:
        return
    if scene.stroke is not None:
        if scene.rest_s >= scene.stroke.after_s and scene.strokes == 0:
            scene.cue.strike(math.radians(scene.stroke.angle_deg), scene.stroke.speed)
    elif scene.plays_itself and scene.rest_s > NEXT_STROKE_S:
        table = scene.table
        chosen = choose_stroke(
            table.positions, table.state.radii, table.state.in_play, table.table, scene.seed, scene.strokes
        )
        scene.cue.strike(chosen.aim, chosen.speed)
