"""The shot on the three tables: what is played, up to which moment it is known, and what comes after it."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.billiards.shot.cue import speed_ratio, strike
from game.billiards.shot.shot import Shot, make_shot
from game.billiards.shot_effects import physics_of, table_of
from game.billiards.table.table import Table
from game.physics.effects import EffectSet
from game.scenes.three_tables import state as s
from game.scenes.three_tables.layout import free_spot, laid_out
from game.scenes.three_tables.level import ThreeTablesContent
from game.scenes.three_tables.parameters import ThreeTablesParameters
from game.scenes.three_tables.shot import MODELS, PlayedShot, ShotShelf
from game.scenes.three_tables.state import ThreeTablesState
from game.stage import Part


class ThreeTablesModel(Part):
    """Balls before the shot, the stroke, and the shot on all tables. effects: those that are active.

    shot (8,), start (n, 2) m, in_play (n,), places (3, n, 2) m: see `ThreeTablesState`. played: the shot on
    all tables, known as far as it has been computed.
    """

    played: PlayedShot

    def __init__(
        self, content: ThreeTablesContent, parameters: ThreeTablesParameters, effects: EffectSet
    ) -> None:
        self.parameters = parameters
        self.effects = effects
        self.balls = content.balls
        self.bed = Table.bare(1.27, 2.54) if content.bare else Table.pool()
        self._lay_balls()
        self.shot = np.zeros(8)
        self.idle_s = 0.0  # s since the last shot ended
        self.known_s = 0.0  # s of the shot that have been computed for sure
        self._shelf = ShotShelf()
        self.play()
        if content.speed > 0.0:
            self.strike(math.radians(content.angle_deg), content.speed)

    def _lay_balls(self) -> None:
        self.numbers, self.start, self.radii, self.masses = laid_out(self.balls, self.bed)
        self.in_play = np.ones(len(self.numbers), dtype=np.bool_)
        self.places = np.repeat(self.start[None], 3, axis=0)

    def state(self, cue: Floats) -> ThreeTablesState:
        """All that later steps depend on, with that of the cue."""
        return ThreeTablesState(self.start, self.in_play, self.shot, cue, self.places)

    # -- the shot -----------------------------------------------------------------------------------

    @property
    def playing(self) -> bool:
        """True while a shot runs."""
        return bool(self.shot[s.PLAYING])

    @property
    def strokes(self) -> int:
        """Strokes so far."""
        return int(self.shot[s.STROKES])

    def strike(self, aim: float, speed: float) -> None:
        """Begin a shot: direction, rad, and speed of the cue ball struck in its centre, m/s."""
        chosen = self.parameters
        tip = chosen.tip_left, chosen.tip_up, math.radians(chosen.elevation)
        self.shot[:] = 1.0, 0.0, speed, aim, *tip, self.shot[s.STROKES] + 1.0
        self.play()

    def play(self) -> None:
        """Play the shot on all tables, unless it is the one that is being played already."""
        shot = self.shot[[s.PLAYING, s.SPEED, s.AIM, s.LEFT, s.UP, s.ELEVATION]].tobytes()
        balls = self.start.tobytes() + self.in_play.tobytes()
        key = (shot, balls, self.parameters.steps, self.parameters.perturbation, self.effects)
        before = self._shelf.latest
        self.played = self._shelf.get(key, self._play_shot)
        if self.played is not before:
            self.known_s = 0.0

    def _play_shot(self) -> PlayedShot:
        perturbation = self.parameters.perturbation
        moved = None if perturbation == "none" else self._shot_now(float(perturbation))
        return PlayedShot(self._shot_now(), moved, self.parameters.steps)

    def _shot_now(self, moved: float = 0.0) -> Shot:
        """The shot as it stands, struck if one is being played; the cue ball ``moved`` m aside."""
        rows = np.flatnonzero(self.in_play)
        positions = self.start[rows].copy()
        positions[0, 0] += moved
        shot = make_shot(
            table_of(self.effects, self.bed),
            positions,
            radii=self.radii[rows],
            masses=self.masses[rows],
            physics=physics_of(self.effects),
            ids=tuple(str(number) for number in self.numbers[rows].tolist()),
        )
        if not self.playing:
            return shot
        blow = strike(
            self.shot[s.SPEED] / speed_ratio(float(self.masses[0])),
            self.shot[s.AIM],
            self.shot[s.ELEVATION],
            self.shot[s.LEFT],
            self.shot[s.UP],
            ball_mass=float(self.masses[0]),
            ball_radius=float(self.radii[0]),
        )
        return shot.struck(0, blow.velocity, blow.spin)

    @property
    def shown_s(self) -> float:
        """Time of the shot up to which it is known, s, at most the time that it has come to.

        It lies behind for a moment when a step has become very short in the middle of a long shot.
        """
        return min(float(self.shot[s.TIME]), self.played.reached_s) if self.playing else 0.0

    def differences_until(self, time: float) -> dict[str, list[float]]:
        """Largest distance of any ball to its place on the exact table, m, at SAMPLES_HZ up to a time (s)."""
        self.played.compute(time)
        return self.played.differences.until(min(max(time, 0.0), self.played.least_end_s))

    # -- stepping -----------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        """One step of a shot, or of waiting for the next."""
        if not self.playing:
            self.idle_s += dt
        elif self._caught_up():
            self.shot[s.TIME] += dt
            self._place_balls()
            if self.played.is_over(float(self.shot[s.TIME])):
                self._end_shot()

    def _caught_up(self) -> bool:
        """True if the shot is known up to now. Else a slice more of it is computed, and time stands still.

        How many steps that takes depends on nothing but the shot, whatever has been computed of it before.
        """
        self.known_s = min(self.known_s + self.played.steps.slice_s, float(self.shot[s.TIME]))
        self.played.compute(self.known_s)
        return self.known_s >= self.shot[s.TIME]

    def _place_balls(self) -> None:
        self.known_s = float(self.shot[s.TIME])
        self.played.compute(self.known_s)
        rows = np.flatnonzero(self.in_play)
        for k, name in enumerate(MODELS):
            self.places[k, rows] = self.played.tables[name].state_at(self.shot[s.TIME]).positions

    def _end_shot(self) -> None:
        """The next shot begins on all tables from where the exact one has ended."""
        rows = np.flatnonzero(self.in_play)
        exact = self.played.tables["exact"]
        final = exact.state_at(exact.end_time)
        pocketed = np.array([place == "pocketed" for place in exact.final.values()])
        self.start[rows] = final.positions
        self.in_play[rows] = ~pocketed
        if not self.in_play[0]:
            self.start[0] = free_spot(self.bed, self.start[1:][self.in_play[1:]], float(self.radii.max()))
            self.in_play[0] = True
        self.shot[s.PLAYING] = 0.0
        self.idle_s = 0.0
        if self.in_play.sum() == 1 and len(self.numbers) > 1:
            self._lay_balls()
        self.play()
