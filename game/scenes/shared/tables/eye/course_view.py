"""What an eye sees at a table with a `CueCourse`: along the cue, and from a stroke's side."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from game.scenes.shared.tables.boxes import Box, rect_of
from game.scenes.shared.tables.course import REPLAY, ROLLING, STRIKING, CueCourse
from game.scenes.shared.tables.eye.inset import Inset
from game.scenes.shared.tables.eye.picture import Furniture, Seen
from game.scenes.shared.tables.eye.view import Aimed, EyeView, Shown
from game.scenes.shared.tables.moments import OFF
from game.scenes.shared.tables.view import Balls
from game.ui.canvas.canvas import Canvas

Place = tuple[float, float]


class CourseEye:
    """Draws both. bed: the box of the table. lies: where the cue ball of a frame lies. row: of that ball in
    the trajectory of a stroke from a frame.
    """

    def __init__(
        self, course: CueCourse, inset: Inset, bed: Box, lies: Callable[[Any], Place | None],
        row: Callable[[Any], int], radius: float,
    ) -> None:  # fmt: skip
        self.course = course
        self.inset = inset
        self.bed = bed
        self.lies = lies
        self.row = row
        self.radius = radius
        self._eye = EyeView()

    @property
    def from_side(self) -> bool:
        """Whether the stroke that rolls, or is replayed, is seen from its side."""
        course = self.course
        if course.model.played is None or course.model.frame.last is None:
            return False
        if course.phase == ROLLING:
            return bool(course.parameters.eye_follows != OFF)
        return course.phase == REPLAY and course.from_side

    def draw_side(self, canvas: Canvas, furniture: Furniture, balls: Balls, time: float) -> None:
        """The stroke from its best side, over the table, at a time of it, s."""
        course = self.course
        shown = Shown(course.model.played.trajectory, self.row(course.model.frame.last.frame))
        follows = time if course.phase == ROLLING else None
        self._eye.draw_side(canvas, rect_of(canvas, self.bed), furniture, balls, shown, follows)

    def draw_inset(self, canvas: Canvas, furniture: Furniture, seen: Seen) -> None:
        """The view from the cue, if it is shown; of a stroke that rolls from where it was played."""
        course, box = self.course, self.inset.box
        if box is None or course.phase == REPLAY:
            return
        last = course.model.frame.last
        if course.phase == ROLLING and last is not None:
            before, stroke, gap = last.frame, last.stroke, None
        elif course.phase == STRIKING and course.pending is not None:
            before, stroke, gap = course.model.frame, course.pending, course.cue.gap
        else:
            before, stroke = course.model.frame, course.stroke
            gap = course.cue.gap if course.may_aim else None
            if course.push.chosen and gap is not None:
                stroke, gap = stroke._replace(azimuth=stroke.azimuth + course.push.swayed), course.push.gap
        place = self.lies(before)
        if place is not None:
            aimed = Aimed(place, stroke, self.radius, gap)
            self._eye.draw_inset(canvas, box, furniture, aimed, seen, course.parameters)
