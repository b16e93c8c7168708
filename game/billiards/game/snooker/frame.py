"""A frame of snooker between two strokes, with its balls on the twelve-foot table."""

from __future__ import annotations

import math

import numpy as np

from game.billiards.game.arrangement import Arrangement, BallSet, bed_for
from game.billiards.game.frame import Frame
from game.billiards.game.rules import CUE_BALL, Call, ShotSummary, Verdict
from game.billiards.game.snooker.rules import REPLAY, Snooker
from game.billiards.game.snooker.sight import Discs, Places
from game.billiards.game.snooker.stroke import Seen
from game.billiards.laws.state import BALL_BALL
from game.billiards.shot.cloths import SNOOKER_CLOTH
from game.billiards.shot.paths import Paths
from game.billiards.shot.physics import Physics
from game.billiards.shot.trajectory import Trajectory
from game.billiards.table import snooker as s
from game.billiards.table.snooker import Point, nearest_in_the_d, opening_places, respotted, touching
from game.billiards.table.table import Table
from game.physics.kernels import elementary, elementwise, linear

TIP_CONTACT_S = 0.001  # s that a tip stays at the ball (Alciatore: 1 to 2 ms, from memory)
FINE_EDGE = math.radians(75.0)  # a cut so thin is the fine edge that 2.19(b) lets pass


class SnookerFrame(Frame, frozen=True, eq=False):
    """A frame whose game is a `Snooker`. put_back: where the balls lay before a miss that was read from a
    file, and so has no last stroke.
    """

    put_back: Arrangement | None = None

    @property
    def before_miss(self) -> Arrangement | None:
        """Where the balls lay before the last stroke."""
        return self.last.frame.layout if self.last is not None else self.put_back

    @property
    def snooker(self) -> Snooker:
        """The rules' state."""
        assert isinstance(self.game, Snooker)
        return self.game

    @property
    def places_by_number(self) -> Places:
        """Where the balls lie, m."""
        return {number: (x, y) for number, x, y in self.layout.places}

    # -- the cue ball in hand -----------------------------------------------------------------------

    def place_cue_ball(self, x: float, y: float) -> Frame:
        """The cue ball put down at (x, y) m. ValueError if it is not in hand, or not allowed there."""
        if not self._allowed(x, y):
            raise ValueError(f"cue ball: ({x:.3f}, {y:.3f}) m is not free, or not {self._hand()}")
        return self.replace(layout=self.layout.with_ball(CUE_BALL, (x, y)))

    def move_cue_ball(self, x: float, y: float) -> Frame:
        """The cue ball put at (x, y) m, or as near to it as it may lie. ValueError if it is not in hand."""
        return self.place_cue_ball(*self.nearest_place(x, y))

    def nearest_place(self, x: float, y: float) -> Point:
        """Where the cue ball in hand may lie near (x, y) m: in the D, touching nothing (3.5)."""
        if self._hand() == "in the D":
            x, y = nearest_in_the_d(x, y)
        for ring in range(400):
            for spoke in range(max(1, 6 * ring)):
                angle = 2.0 * math.pi * spoke / max(1, 6 * ring)
                at = (
                    x + 0.1 * s.BALL_RADIUS * ring * elementary.cos(angle),
                    y + 0.1 * s.BALL_RADIUS * ring * elementary.sin(angle),
                )
                if self._hand() == "in the D":
                    at = nearest_in_the_d(*at)
                if self._allowed(*at):
                    return at
        raise ValueError(f"cue ball: there is no free place near ({x:.3f}, {y:.3f}) m")

    def _allowed(self, x: float, y: float) -> bool:
        left, right, lower, upper = bed_for(self.table, s.BALL_RADIUS)
        if not (left <= x <= right and lower <= y <= upper):
            return False
        if self._hand() == "in the D" and elementary.dist(nearest_in_the_d(x, y), (x, y)) > 1e-9:
            return False
        reach = 2.0 * s.BALL_RADIUS + 0.5 * s.APART
        return all(
            elementary.hypot(px - x, py - y) > reach
            for number, px, py in self.layout.places
            if number != CUE_BALL
        )

    def with_cue_ball(self) -> Frame:
        """The cue ball in the D, between brown and yellow, if it is in hand and not on the table."""
        if self.cue_ball is not None or not self.game.in_hand:
            return self
        return self.move_cue_ball(s.MIDDLE + 0.15, s.BAULK - 0.02)

    # -- strokes ------------------------------------------------------------------------------------

    def judged(self, trajectory: Trajectory, summary: ShotSummary, call: Call) -> Verdict:
        """What the referee says of a stroke that was played from here."""
        game = self.snooker
        seen = Seen(
            self.places_by_number, curves_of(self.table), nearest_gap(trajectory, game.target(call).first),
            pushes(trajectory, self.places_by_number),
        )  # fmt: skip
        return game.judge(summary, call, seen)

    def choose(self, name: str, seed: int | None = None) -> Frame:
        """The frame after a choice; with `REPLAY` the balls lie as they did before the miss (3.14(a))."""
        following = super().choose(name, seed)
        if name == REPLAY.name and self.before_miss is not None:
            following = following.replace(layout=self.before_miss)
        return following.replace(put_back=None)

    def ruled(self, verdict: Verdict) -> SnookerFrame:
        """The frame after what no stroke brought about: a concession, a claim, a restart."""
        layout = self._layout_after(verdict, self.layout, None)
        following = self._following(verdict, layout)
        assert isinstance(following, SnookerFrame)
        return following.replace(earlier=None, last=None) if verdict.rack else following  # type: ignore[return-value]

    def _layout_after(self, verdict: Verdict, layout: Arrangement, seed: int | None) -> Arrangement:
        """What a verdict makes of the balls: colours go back to their spots (3.7)."""
        if verdict.reset:
            return self.layout
        assert isinstance(verdict.game, Snooker)
        if verdict.rack:
            return opening_layout(verdict.game.reds)
        placed = {number: (x, y) for number, x, y in layout.places}
        if verdict.game.black_again and verdict.game.options:
            placed = {}  # the black alone; the cue ball is in hand
        return snooker_layout(respotted(placed, verdict.spot)) if verdict.spot else layout


def snooker_balls() -> BallSet:
    """Radii and masses (22,) of a set of balls."""
    return BallSet(np.full(s.BALLS, s.BALL_RADIUS), np.full(s.BALLS, s.BALL_MASS))


def snooker_layout(places: Places) -> Arrangement:
    """Balls where they lie, m by number. ValueError for a number that no ball has."""
    numbers = tuple(sorted(places))
    if any(not 0 <= number < s.BALLS for number in numbers):
        raise ValueError(f"balls: expected numbers from 0 to {s.BALLS - 1}, got {numbers}")
    positions = np.array([places[number] for number in numbers], dtype=np.float64).reshape(-1, 2)
    return Arrangement(numbers, positions, snooker_balls())


def opening_layout(reds: int) -> Arrangement:
    """The object balls before the break-off."""
    return snooker_layout(opening_places(reds))


def new_snooker_frame(
    game: Snooker, places: Places | None = None, table: Table | None = None, physics: Physics = SNOOKER_CLOTH
) -> SnookerFrame:
    """A frame at its beginning, or with balls at places (m by number); a cue ball in hand is put down."""
    layout = opening_layout(game.reds) if places is None else snooker_layout(places)
    frame = SnookerFrame(game, layout, Table.snooker() if table is None else table, physics)
    following = frame.with_cue_ball()
    assert isinstance(following, SnookerFrame)
    return following


def curves_of(table: Table) -> Discs:
    """The curved cushions of a table."""
    return tuple((x, y, radius) for x, y, radius in table.jaws.tolist())


def pushes(trajectory: Trajectory, places: Places) -> bool:
    """2.19: the cue ball meets a ball while the tip is at it still, and not at its fine edge.

    A ball that the cue ball touches before the stroke is judged by itself (3.8).
    """
    cue = trajectory.shot.ids.index(str(CUE_BALL))
    rows = trajectory.rows
    met = rows[(rows[:, 1] == BALL_BALL) & ((rows[:, 2] == cue) | (rows[:, 3] == cue))]
    if not len(met) or met[0, 0] > TIP_CONTACT_S:
        return False
    other = int(met[0, 3] if int(met[0, 2]) == cue else met[0, 2])
    if int(trajectory.shot.ids[other]) in touching(places):
        return False
    velocity = trajectory.shot.balls[cue, 2:4]
    line = trajectory.shot.positions[other] - trajectory.shot.positions[cue]
    size = elementary.length(*velocity) * elementary.length(*line)
    return size > 0.0 and float(linear.product(velocity, line)) / size > elementary.cos(FINE_EDGE)


def nearest_gap(trajectory: Trajectory, on: tuple[int, ...]) -> float:
    """How near the cue ball comes to a ball on before it meets any ball, gap in m; inf without one on."""
    numbers = [int(name) for name in trajectory.shot.ids]
    cue = numbers.index(CUE_BALL)
    others = [k for k, number in enumerate(numbers) if number in on]
    if not others:
        return math.inf
    rows = trajectory.rows
    met = rows[(rows[:, 1] == BALL_BALL) & ((rows[:, 2] == cue) | (rows[:, 3] == cue))]
    until = float(met[0, 0]) if len(met) else trajectory.end_time
    path = Paths(trajectory).path(cue, 0.0, until)
    found = math.inf
    for x, y in trajectory.shot.positions[others].tolist():  # they lie still until then
        found = min(found, _distance_to(path, x, y))
    return found - 2.0 * s.BALL_RADIUS


def _distance_to(path: np.ndarray, x: float, y: float) -> float:
    """Distance of a point from a path (n, 2), m."""
    if len(path) < 2:
        return float(elementwise.hypot(*(path[0] - (x, y))))
    start, along = path[:-1], np.diff(path, axis=0)
    square = np.maximum((along * along).sum(axis=1), 1e-300)
    share = np.clip((((x, y) - start) * along).sum(axis=1) / square, 0.0, 1.0)
    return float(elementwise.hypot(*(start + share[:, None] * along - (x, y)).T).min())
