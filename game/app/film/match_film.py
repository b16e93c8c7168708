"""A match on film: a scene that shows its rounds one after the other, and the story that tells them."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, ClassVar, NamedTuple

import numpy as np
import pygame

from game.app.film.match_acts import END_S, TITLE_S, WHOLE, Act, acts_of, potted_at, what_matters, width_of
from game.app.film.match_tally import draw_tally
from game.app.film.story_film import Excerpt, StoryFilm, write_story_film
from game.arrays import Floats
from game.billiards.game.rules import CUE_BALL
from game.billiards.laws.state import BALL_POCKET
from game.billiards.players.match import PLAYERS, Match
from game.billiards.shot.trajectory import rotation_matrices
from game.billiards.table.table import CUSHION_DEPTH, Table
from game.levels import Level
from game.scenes.billiards.layout import pocket_words
from game.scenes.shared.tables.demo_shots import scattered_orientations
from game.scenes.shared.tables.rolling import FALL_S
from game.scenes.shared.tables.sounds import sounds_of
from game.scenes.shared.tables.view import WOOD, Balls, draw_balls
from game.stage import Frame, Hearing, Readout, Scene, Sound
from game.stage.script.lines import WHOLE as EVERYTHING
from game.stage.script.lines import Expect, Follow, HandOver, Look, Moment, Say, Story, StoryLine, Title
from game.stage.story.reading import written_story
from game.stage.story.rehearsal import rehearse
from game.ui.canvas.canvas import Canvas
from game.ui.painters.cue import draw_cue
from game.ui.painters.table import TableView, table_picture

BACKDROP_SCALE = 700.0  # px/m, of the painted table
SURROUND = 0.8  # m of floor round the bed in the backdrop
BANDS = ("chalk", "vermilion")  # of the two cues
BAND = (0.79, 0.85)  # m from the tip, where a cue shows whose it is
HEARD_S = 0.6  # s of sounds before the present moment that are still told
EASE_S = 1.2
HEADING = "A billiard match"


class MatchState(NamedTuple):
    """clock: (1,) s since the match began."""

    clock: Floats


class MatchScene(Scene):
    """The rounds of a match that has been played, along their exact paths."""

    name, task, title = "match", "", HEADING
    quarter_turns = 1
    story_row = 60  # below the table: no pocket is covered
    covers = True
    match: ClassVar[Match]

    def build(self, level: Level | None) -> None:
        self.clock = np.zeros(1)
        self.acts = acts_of(self.match)
        self._widths = [width_of(act) for act in self.acts]
        self._turns = self._all_turns()
        self._backdrop: pygame.Surface | None = None
        self._sounds = [
            sound._replace(time=sound.time + act.hits)
            for act in self.acts
            for sound in sounds_of(act.round.trajectory, act.round.stroke.cue_speed)
        ]

    def advance(self, dt: float) -> None:
        self.clock[0] += dt

    def state(self) -> MatchState:
        return MatchState(self.clock)

    def act_at(self, time: float) -> Act | None:
        """The round that is on at a moment; None before the first and after the last."""
        return next((act for act in self.acts if act.begins <= time < act.ends), None)

    def frame(self) -> Frame:
        table = self._table()
        x, y, up = 0.5 * table.width, 0.5 * table.length, 0.5 * WHOLE * 9.0 / 16.0
        return Frame(x - up, y - 0.5 * WHOLE, x + up, y + 0.5 * WHOLE)

    def draw_story_row(self, surface: pygame.Surface, look: Any, row: pygame.Rect) -> None:
        draw_tally(surface, look, row, BANDS, self.potted_at(float(self.clock[0])))

    def story_targets(self) -> dict[str, tuple[float, float]]:
        time = float(self.clock[0])
        act = self.act_at(time) or (self.acts[0] if time < self.acts[0].begins else self.acts[-1])
        low, high = what_matters(act, min(time, act.hits + potted_at(act.round)))
        table, share = self._table(), 1.0 - self._widths[act.round.number - 1] / WHOLE
        middle = 0.5 * np.array((table.width, table.length))
        reach = share * middle  # the wider the view, the nearer its middle stays to the table's
        x, y = np.clip(0.5 * (low + high), middle - reach, middle + reach).tolist()
        return {"play": (x, y)}

    def readouts(self) -> list[Readout]:
        time = float(self.clock[0])
        potted = self.potted_at(time)
        begun = sum(1 for act in self.acts if act.begins <= time)
        points = [
            Readout(f"potted by {name}", len(balls)) for name, balls in zip(PLAYERS, potted, strict=True)
        ]
        over = float(time >= self.acts[-1].ends)
        return [
            Readout("round", begun),
            Readout("potted", sum(map(len, potted))),
            *points,
            Readout("over", over),
        ]

    def hearing(self) -> Hearing:
        now = float(self.clock[0])
        near: list[Sound] = [sound for sound in self._sounds if now - HEARD_S < sound.time <= now]
        return Hearing("match", now, near)

    # -- picture ------------------------------------------------------------------------------------

    def draw(self, canvas: Any, alpha: float) -> None:
        before = float(self.previous.clock[0])
        time = before + alpha * (float(self.clock[0]) - before)
        self._draw_backdrop(canvas)
        act = self.act_at(time)
        if act is not None:
            self._draw_act(canvas, act, time)
        elif time < self.acts[0].begins:
            self._draw_rest(canvas, 0, 0.0)
        else:
            self._draw_rest(canvas, len(self.match.rounds) - 1, math.inf)

    def _table(self) -> Table:
        return self.match.rounds[0].shot.table

    def _painted(self, canvas: Canvas) -> pygame.Surface:
        """The table, painted once, larger than it is seen as a whole."""
        if self._backdrop is None:
            table, k = self._table(), BACKDROP_SCALE
            size = (
                round((table.length + 2.0 * SURROUND) * k),
                round((table.width + 2.0 * SURROUND) * k),
            )
            view = TableView(SURROUND * k, SURROUND * k, k)
            self._backdrop = table_picture(size, table, view, canvas.theme)
        return self._backdrop

    def _all_turns(self) -> list[Floats]:
        """How the sixteen balls lie at the beginning of each round, (16, 3, 3)."""
        turns = rotation_matrices(scattered_orientations(16, self.match.seed))
        found = []
        for one in self.match.rounds:
            found.append(turns.copy())
            rows = [int(name) for name in one.trajectory.shot.ids]
            turns[rows] = one.trajectory.orientations_at(one.trajectory.end_time, turns[rows])
        return found

    def _draw_backdrop(self, canvas: Canvas) -> None:
        """The part of the painted table that the camera sees, brought to its place and size."""
        seen, k, backdrop = canvas.camera.visible(), BACKDROP_SCALE, self._painted(canvas)
        canvas.surface.fill(backdrop.get_at((0, 0)), canvas.rect)
        left, top = (seen.bottom + SURROUND) * k, (seen.left + SURROUND) * k
        width, height = (seen.top - seen.bottom) * k, (seen.right - seen.left) * k
        part = pygame.Rect(math.floor(left), math.floor(top), math.ceil(width) + 2, math.ceil(height) + 2)
        part = part.clip(backdrop.get_rect())
        if not (part.w and part.h):
            return
        zoom = canvas.rect.w / width
        x0, y0 = canvas.rect.x + (part.x - left) * zoom, canvas.rect.y + (part.y - top) * zoom
        place = pygame.Rect(round(x0), round(y0), 0, 0)
        place.size = round(x0 + part.w * zoom) - place.x, round(y0 + part.h * zoom) - place.y
        canvas.surface.blit(pygame.transform.smoothscale(backdrop.subsurface(part), place.size), place)

    def _draw_act(self, canvas: Canvas, act: Act, time: float) -> None:
        number = act.round.number - 1
        since = time - act.hits
        self._draw_rest(canvas, number, since)
        gap, solid = act.motion.track.sample(since + act.motion.hit_s).tolist()
        if solid > 0.05 and since <= act.motion.end_s - act.motion.hit_s:
            self._draw_cue(canvas, act, gap)

    def _draw_rest(self, canvas: Canvas, number: int, since: float) -> None:
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
        draw_balls(canvas, Balls(positions, radii, numbers, turns, opacities), self._table())
        self._draw_waiting_cue(canvas, 1 - one.player)

    def _draw_cue(self, canvas: Canvas, act: Act, gap: float) -> None:
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
            canvas,
            (x - back * ux - aside * uy, y - back * uy + aside * ux),
            (ux, uy),
            stroke.elevation,
            one.player,
        )

    def _draw_waiting_cue(self, canvas: Canvas, player: int) -> None:
        """The other player's cue, laid beside the table."""
        table = self._table()
        x = table.width + CUSHION_DEPTH + WOOD + 0.045
        self._stick(
            canvas, (x, 0.5 * table.length + (1 - 2 * player) * 0.735), (0.0, 1.0 - 2.0 * player), 0.0, player
        )

    def _stick(
        self, canvas: Canvas, tip: tuple[float, float], way: tuple[float, float], raised: float, player: int
    ) -> None:
        table = self._table()
        pixels, clip = canvas.raster_target
        x, y = canvas.place(tip)
        far_x, far_y = canvas.place((tip[0] - way[0], tip[1] - way[1]))
        scale = canvas.pixels_per_unit
        middle = canvas.place((0.5 * table.width, 0.5 * table.length))
        draw_cue(pixels, clip, (x, y), ((far_x - x) / scale, (far_y - y) / scale), scale, raised, middle)
        flat = math.cos(raised)
        ends = [(tip[0] - way[0] * d * flat, tip[1] - way[1] * d * flat) for d in BAND]
        canvas.line(ends[0], ends[1], BANDS[player], 2.0 * 0.0095 * scale / canvas.k)

    def potted_at(self, time: float) -> tuple[tuple[int, ...], tuple[int, ...]]:
        """The balls that each player has potted by a moment."""
        found: tuple[list[int], list[int]] = ([], [])
        for act in self.acts:
            if act.hits + potted_at(act.round) <= time:
                found[act.round.player].append(act.round.fallen.ball)
        return tuple(found[0]), tuple(found[1])


def scene_of(match: Match) -> type[Scene]:
    """The scene of one match."""
    return type("MatchOnFilm", (MatchScene,), {"match": match, "__doc__": MatchScene.__doc__})


def story_of(match: Match, title: str = "") -> Story:
    """The story of a match: a chapter for each round. ``title``: of the match, with a name."""
    words = f"{PLAYERS[0]} against {PLAYERS[1]}: each ball by way of another"
    lines: list[StoryLine] = [
        Look(EVERYTHING, cut=True),
        Title(title or HEADING, words, seconds=TITLE_S, meanwhile=True),
    ]
    for act in acts_of(match):
        lines += _round_lines(act)
    points = [sum(1 for one in match.rounds if one.player == player) for player in range(2)]
    lines.append(Moment("the end", when="over > 0.5", deadline=120.0))
    winner = PLAYERS[points.index(max(points))]
    outcome = "A draw" if points[0] == points[1] else f"{winner} wins"
    lines.append(HandOver(f"{outcome}, {max(points)} : {min(points)}", seconds=END_S))
    return written_story(
        f"match-{match.seed}", scene_of(match), lines,
        [Expect("potted", least=float(len(match.rounds)))], title=HEADING,
    )  # fmt: skip


def _round_lines(act: Act) -> list[StoryLine]:
    one = act.round
    chain = [number for number in one.fallen.chain if number not in (CUE_BALL, one.fallen.ball)]
    way = f" by way of {' and '.join(map(str, chain))}" if chain else ""
    said = f"{PLAYERS[one.player]}: ball {one.fallen.ball}{way}, {pocket_words(one.fallen.pocket)}."
    down = f"ball {one.fallen.ball} is down"
    return [
        Moment(f"round {one.number}", when=f"round >= {one.number}", deadline=120.0),
        Follow("play", width=width_of(act), ease=EASE_S, meanwhile=True),
        Say(said, until=down),
        Moment(down, when=f"potted >= {one.number}", deadline=120.0, chapter=f"Ball {one.fallen.ball}"),
        Look(EVERYTHING, ease=EASE_S, after=0.3, meanwhile=True),
    ]


def write_match_film(
    match: Match, path: Path, title: str, size: tuple[int, int] = (1280, 720), fps: int = 30,
    seconds: float = math.inf,
) -> float:  # fmt: skip
    """Draw and encode the film of a match, or its first seconds; its length, s. VideoError in one line."""
    story, scene_type = story_of(match, title), scene_of(match)
    found = rehearse(story, scene_type)
    film = StoryFilm(story, scene_type, size)
    return write_story_film(film, found, path, fps, Excerpt(seconds=seconds)).length_s
