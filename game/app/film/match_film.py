"""The film of a match: drawn off screen picture by picture, with titles, two cues and a moving camera."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pygame
from numpy.typing import NDArray

from game.app.film.captions import draw_caption, draw_end, draw_row, draw_tally, draw_title, row_of_words
from game.app.film.progress import Progress
from game.app.film.script import WHOLE, Act, Script, write_script
from game.app.film.soundtrack import Soundtrack
from game.app.film.video import VideoWriter
from game.app.stagehand.headless import prepare
from game.billiards.game.rules import CUE_BALL
from game.billiards.laws.state import BALL_POCKET
from game.billiards.players.match import Match
from game.billiards.shot.trajectory import rotation_matrices
from game.billiards.table.table import CUSHION_DEPTH, Table
from game.scenes.shared.tables.sounds import sounds_of
from game.scenes.billiards.view.balls import FALL_S
from game.scenes.shared.tables.demo_shots import scattered_orientations
from game.scenes.shared.tables.view import WOOD, Balls, draw_balls
from game.stage import Frame
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.look.layout import auto_scale
from game.ui.look.look import Look
from game.ui.look.theme import theme_named
from game.ui.painters.cue import draw_cue
from game.ui.painters.table import TableView, table_picture

Array = NDArray[np.float64]

BACKDROP = 1.6  # the table is painted so many times larger than it is seen as a whole
SURROUND = 0.6  # m of floor round the bed in the backdrop
BANDS = ("chalk", "vermilion")  # of the two cues
BAND = (0.79, 0.85)  # m from the tip, where a cue shows whose it is


class MatchFilm:
    """Draws any moment of a film. ``size``: px."""

    def __init__(self, match: Match, size: tuple[int, int], title: str, theme: str = "dark") -> None:
        prepare()
        self.match = match
        self.title = title
        self.script: Script = write_script(match)
        self.look = Look(theme_named(theme), auto_scale(*size))
        self.surface = pygame.Surface(size, 0, 32)
        self.row = row_of_words(size, self.look)
        self.stage = pygame.Rect(0, 0, size[0], self.row.top)
        self._canvas = Canvas(self.look)
        self._camera = Camera(quarter_turns=1)
        self._scale = BACKDROP * size[0] / WHOLE
        self._backdrop = self._paint_backdrop()
        self._turns = self._all_turns()

    @property
    def length(self) -> float:
        """How long it lasts, s."""
        return self.script.length

    def _table(self) -> Table:
        return self.match.rounds[0].shot.table

    def _paint_backdrop(self) -> pygame.Surface:
        table = self._table()
        size = (
            round((table.length + 2.0 * SURROUND) * self._scale),
            round((table.width + 2.0 * SURROUND) * self._scale),
        )
        view = TableView(SURROUND * self._scale, SURROUND * self._scale, self._scale)
        return table_picture(size, table, view, self.look.theme)

    def _all_turns(self) -> list[Array]:
        """How the sixteen balls lie at the beginning of each round, (16, 3, 3)."""
        turns = rotation_matrices(scattered_orientations(16, self.match.seed))
        found = []
        for one in self.match.rounds:
            found.append(turns.copy())
            rows = [int(name) for name in one.trajectory.shot.ids]
            turns[rows] = one.trajectory.orientations_at(one.trajectory.end_time, turns[rows])
        return found

    # -- a moment -----------------------------------------------------------------------------------

    def picture(self, time: float) -> pygame.Surface:
        """The picture of a moment, s; drawn over by the next one."""
        self._point_camera(time)
        self._canvas.begin(self.surface, self.stage, self._camera)
        try:
            self._draw_backdrop()
            act = self.script.act_at(time)
            if act is not None:
                self._draw_act(act, time)
            elif time < self.script.acts[0].begins:
                self._draw_rest(0, 0.0)
            else:
                self._draw_rest(len(self.match.rounds) - 1, math.inf)
        finally:
            self._canvas.end()
        self._draw_words(time)
        return self.surface

    def _point_camera(self, time: float) -> None:
        x, y, length = self.script.camera.sample(time).tolist()
        width, height = self.stage.size
        half, down = 0.5 * length, 0.5 * length * height / width
        frame = Frame(x - down, y - half, x + down, y + half)
        self._camera.fit(frame, self.stage, 0.0)

    def _draw_backdrop(self) -> None:
        """The part of the painted table that the camera sees, brought to the picture's size."""
        seen = self._camera.visible()
        left, top = (seen.bottom + SURROUND) * self._scale, (seen.left + SURROUND) * self._scale
        width, height = (seen.top - seen.bottom) * self._scale, (seen.right - seen.left) * self._scale
        part = pygame.Rect(round(left), round(top), round(width), round(height))
        part.clamp_ip(self._backdrop.get_rect())
        part = part.clip(self._backdrop.get_rect())
        seen_now = self.surface.subsurface(self.stage)
        pygame.transform.smoothscale(self._backdrop.subsurface(part), self.stage.size, seen_now)

    def _draw_act(self, act: Act, time: float) -> None:
        number = act.round.number - 1
        since = act.shot_time(time)
        self._draw_rest(number, since)
        gap, solid = act.motion.track.sample(since + act.motion.hit_s).tolist()
        if solid > 0.05 and since <= act.motion.end_s - act.motion.hit_s:
            self._draw_cue(act, gap)

    def _draw_rest(self, number: int, since: float) -> None:
        """The balls of a round at a time after its hit; before it they lie still."""
        one = self.match.rounds[number]
        trajectory = one.trajectory
        at = min(max(since, 0.0), trajectory.end_time)
        numbers = np.array([int(name) for name in trajectory.shot.ids])
        positions = trajectory.state_at(at).positions.copy()
        radii = self.match.balls.radii[numbers].copy()
        opacities = np.ones(len(numbers))
        for time, code, ball, hole in trajectory.rows.tolist():
            if int(code) == BALL_POCKET and time <= since:
                fallen, row = min((since - time) / FALL_S, 1.0), int(ball)
                opacities[row] = 1.0 - fallen
                radii[row] *= 1.0 - 0.2 * fallen
                hole_place = trajectory.shot.table.pockets[int(hole), :2]
                positions[row] += min(2.0 * fallen, 1.0) * (hole_place - positions[row])
        turns = trajectory.orientations_at(at, self._turns[number][numbers])
        draw_balls(self._canvas, Balls(positions, radii, numbers, turns, opacities), self._table())
        self._draw_waiting_cue(1 - one.player)

    def _draw_cue(self, act: Act, gap: float) -> None:
        one = act.round
        row = one.shot.ids.index(str(CUE_BALL))
        x, y = one.shot.positions[row].tolist()
        radius = float(self.match.balls.radii[CUE_BALL])
        stroke = one.stroke
        ux, uy = math.cos(stroke.azimuth), math.sin(stroke.azimuth)
        aside = radius * stroke.tip_left
        depth = radius * math.sqrt(max(1.0 - stroke.tip_left**2 - stroke.tip_up**2, 0.0))
        back = (depth + gap) * math.cos(stroke.elevation)
        self._stick(
            (x - back * ux - aside * uy, y - back * uy + aside * ux), (ux, uy), stroke.elevation, one.player
        )

    def _draw_waiting_cue(self, player: int) -> None:
        """The other player's cue, laid beside the table."""
        table = self._table()
        x = table.width + CUSHION_DEPTH + WOOD + 0.045
        self._stick(
            (x, 0.5 * table.length + (1 - 2 * player) * 0.735), (0.0, 1.0 - 2.0 * player), 0.0, player
        )

    def _stick(self, tip: tuple[float, float], way: tuple[float, float], raised: float, player: int) -> None:
        canvas, table = self._canvas, self._table()
        pixels, clip = canvas.raster_target
        x, y = canvas.place(tip)
        far_x, far_y = canvas.place((tip[0] - way[0], tip[1] - way[1]))
        scale = canvas.pixels_per_unit
        middle = canvas.place((0.5 * table.width, 0.5 * table.length))
        draw_cue(pixels, clip, (x, y), ((far_x - x) / scale, (far_y - y) / scale), scale, raised, middle)
        flat = math.cos(raised)
        ends = [(tip[0] - way[0] * d * flat, tip[1] - way[1] * d * flat) for d in BAND]
        canvas.line(ends[0], ends[1], BANDS[player], 2.0 * 0.0095 * scale / canvas.k)

    def _draw_words(self, time: float) -> None:
        first, last = self.script.acts[0].begins, self.script.acts[-1].ends
        draw_row(self.surface, self.look, self.row)
        if time < first:
            draw_title(self.surface, self.look, self.title, self.match, time, first)
            return
        potted = self.potted_at(time)
        draw_tally(self.surface, self.look, self.row, potted)
        act = self.script.act_at(time)
        if act is not None:
            draw_caption(self.surface, self.look, self.row, act, time)
        elif time >= last:
            draw_end(self.surface, self.look, self.title, self.match, time - last)

    def potted_at(self, time: float) -> tuple[tuple[int, ...], tuple[int, ...]]:
        """The balls that each player has potted by a moment."""
        found: tuple[list[int], list[int]] = ([], [])
        for act in self.script.acts:
            if act.potted <= time:
                found[act.round.player].append(act.round.fallen.ball)
        return tuple(found[0]), tuple(found[1])


def write_match_film(
    match: Match, path: Path, title: str, size: tuple[int, int] = (1280, 720), fps: int = 30,
    seconds: float = math.inf,
) -> float:  # fmt: skip
    """Draw and encode the film of a match, or its first seconds; its length, s. VideoError in one line."""
    progress = Progress("Film")
    with VideoWriter(path, size, fps, sound=True) as video:
        film = MatchFilm(match, size, title)
        track = Soundtrack()
        for act in film.script.acts:
            heard = sounds_of(act.round.trajectory, act.round.stroke.cue_speed)
            track.schedule([one._replace(time=act.film_time(one.time)) for one in heard], 0.0)
        length = min(film.length, seconds)
        count = round(length * fps)
        for i in range(count):
            video.add(film.picture(i / fps), track.take((i + 1) / fps))
            progress.tell(i + 1, count)
    return length
