"""The view from the cue over a corner of the table; a stroke seen from its side in place of from above."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import pygame

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.laws.state import IN_RADIUS
from game.billiards.shot.trajectory import Trajectory
from game.billiards.table.table import Table
from game.scenes.shared.tables.boxes import Box, rect_of
from game.scenes.shared.tables.eye.cameras import CLOSER, Room, behind, beside, looking
from game.scenes.shared.tables.eye.inset import inner_corner
from game.scenes.shared.tables.eye.lines import Ghost, Line
from game.scenes.shared.tables.eye.picture import EyePicture, Furniture, Seen
from game.scenes.shared.tables.moments import Moments, moments_of, path_of
from game.scenes.shared.tables.view import Balls
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT_LINE
from game.ui.painters.perspective.eye import Eye, room_points

LEAST_RISE = math.radians(4.0)  # how steeply a cue lies that is not raised
APPROACH_S = 0.25  # s of the cue ball's way to the contact that are in view
AHEAD_S = 0.15  # s before and after a moment over which a camera that follows looks
EDGE = 1.5  # design px


class Aimed(NamedTuple):
    """The stroke that an eye looks along.

    place: of the cue ball, m; gap: between tip and ball, m, None: no cue is drawn.
    """

    place: tuple[float, float]
    stroke: Stroke
    radius: float
    gap: float | None = None


class Shown(NamedTuple):
    """A stroke on its way: what was computed of it, and the row of the ball that was struck."""

    trajectory: Trajectory
    cue: int


class EyeView:
    """Paints what an eye sees; keeps what it has computed of the last stroke."""

    def __init__(self) -> None:
        self._picture = EyePicture()
        self._of: Trajectory | None = None
        self._moments = Moments(0)
        self._side: tuple[Room, Eye] | None = None

    def draw_inset(
        self, canvas: Canvas, box: Box, furniture: Furniture, aimed: Aimed, seen: Seen, chosen: Any
    ) -> None:
        """The view from the cue in a box. chosen: the parameters of `eye.choices`."""
        rect, table = rect_of(canvas, box), furniture.table
        eye_at = (float(chosen.eye_height), math.radians(float(chosen.eye_tilt)))
        eye = behind(table, aimed.place, aimed.stroke.azimuth, eye_at, room_of(rect))
        cue = cue_of(aimed, table) if aimed.gap is not None else None
        self._picture.draw(canvas, rect, furniture, eye, seen._replace(cue=cue))
        _draw_frame(canvas, rect, canvas.camera.to_screen(*inner_corner(box, table)))

    def draw_side(
        self, canvas: Canvas, rect: pygame.Rect, furniture: Furniture, balls: Balls, shown: Shown,
        follows: float | None = None,
    ) -> None:  # fmt: skip
        """A stroke from its best side over a rectangle px. follows: s, when its ball is followed there."""
        room = room_of(rect)
        eye = self.side_eye(shown, furniture.table, room)
        if follows is not None:
            target = self._target(shown, furniture.table, follows)
            eye = looking(np.array(eye[:3]), target, room, CLOSER)
        self._picture.draw(canvas, rect, furniture, eye, Seen(balls))

    def moments(self, shown: Shown) -> Moments:
        """Those of a stroke."""
        if self._of is not shown.trajectory:
            self._of, self._side = shown.trajectory, None
            self._moments = moments_of(shown.trajectory, shown.cue)
        return self._moments

    def side_eye(self, shown: Shown, table: Table, room: Room) -> Eye:
        """The eye beside the deciding ball's path."""
        moments = self.moments(shown)
        if self._side is None or self._side[0] != room:
            self._side = room, _eye_beside(shown, moments, table, room)
        return self._side[1]

    def _target(self, shown: Shown, table: Table, time: float) -> Floats:
        """Where the ball that decides is about a time, after it was met; before that the cue ball. (3,) m"""
        moments = self.moments(shown)
        share = 1.0 if moments.contact is None else min(max((time - moments.contact) / 0.3 + 1.0, 0.0), 1.0)
        share = share * share * (3.0 - 2.0 * share)
        places = []
        for at in (time - AHEAD_S, time, time + AHEAD_S):
            state = shown.trajectory.state_at(min(max(at, 0.0), shown.trajectory.end_time)).positions
            places.append((1.0 - share) * state[shown.cue] + share * state[moments.ball])
        return room_points(np.mean(places, axis=0)[None], 0.0, table.width, table.length)[0]


def room_of(rect: pygame.Rect) -> Room:
    """A rectangle px as cameras take it."""
    return Room(float(rect.x), float(rect.y), float(rect.w), float(rect.h))


def cue_of(aimed: Aimed, table: Table) -> tuple[Floats, Floats]:
    """Tip (3,) m of the room, and the unit vector (3,) along the cue away from the ball."""
    stroke, radius = aimed.stroke, aimed.radius
    rise = max(stroke.elevation, LEAST_RISE)
    (x, y, _), _ = room_points(np.array((aimed.place, (0.0, 0.0))), 0.0, table.width, table.length)
    heading = stroke.azimuth - 0.5 * math.pi
    ahead, left = (
        np.array((math.cos(heading), math.sin(heading))),
        np.array((-math.sin(heading), math.cos(heading))),
    )
    along = np.array((-ahead[0] * math.cos(rise), -ahead[1] * math.cos(rise), math.sin(rise)))
    depth = radius * math.sqrt(max(1.0 - stroke.tip_left**2 - stroke.tip_up**2, 0.0))
    back = depth + (aimed.gap or 0.0)
    tip = np.array((x, y, radius + radius * stroke.tip_up)) + along * back
    tip[:2] += left * radius * stroke.tip_left
    return tip, along


def _eye_beside(shown: Shown, moments: Moments, table: Table, room: Room) -> Eye:
    """The eye that sees broadside the way of the deciding ball and the end of the cue ball's way to it."""
    trajectory, size = shown.trajectory, (table.width, table.length)
    end = min(time for time in (moments.drop, trajectory.end_time) if time is not None)
    begin = moments.contact if moments.contact is not None else 0.0
    _, way = path_of(trajectory, moments.ball, begin, end)
    _, approach = path_of(trajectory, shown.cue, max(begin - APPROACH_S, 0.0), begin)
    first = trajectory.state_at(0.0).positions
    others = np.delete(first, [moments.ball, shown.cue], axis=0)
    height = float(trajectory.shot.balls[moments.ball, IN_RADIUS])
    path = np.concatenate([way[:1], approach, way])
    return beside(room_points(path, height, *size), room_points(others, height, *size), room)


def _draw_frame(canvas: Canvas, rect: pygame.Rect, corner: tuple[float, float]) -> None:
    """The edge of the view, and its corner that is dragged."""
    surface, width = canvas.surface, max(1, round(EDGE * canvas.k))
    pygame.draw.rect(surface, FELT_LINE, rect, width)
    x, y = corner
    into_x, into_y = (1 if x <= rect.centerx else -1), (1 if y <= rect.centery else -1)
    x, y = x + 4 * into_x * canvas.k, y + 4 * into_y * canvas.k
    for step in (6, 11, 16):
        reach = round(step * canvas.k)
        start, end = (round(x) + into_x * reach, round(y)), (round(x), round(y) + into_y * reach)
        pygame.draw.line(surface, FELT_LINE, start, end, width)


def ghost_of(sight: Any, radius: float, foul: bool) -> Ghost | None:
    """The ghost ball of a sight; None if no ball is met."""
    return Ghost(sight.ghost, radius, foul) if sight is not None and sight.ghost is not None else None


__all__ = ["Aimed", "EyeView", "Line", "Shown", "cue_of", "ghost_of", "room_of"]
