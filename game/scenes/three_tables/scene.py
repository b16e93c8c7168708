"""One stroke on three tables: the lecture's, a stepped one with all of the physics, and the exact one."""

from __future__ import annotations

import math
from collections import deque
from functools import lru_cache
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from game.billiards.shot.cue import strike
from game.billiards.shot.shot import Shot, make_shot
from game.billiards.shot_effects import physics_of, table_of
from game.billiards.table.table import Table
from game.lab.studies.billiards.tables import billiards_study
from game.levels import Level
from game.scenes.shared.tables import view as table_view
from game.scenes.shared.tables.cue import AIMING, CueControl
from game.scenes.shared.tables.demo_shots import choose_stroke
from game.scenes.three_tables import THREE_TABLES, view
from game.scenes.three_tables.figure import draw_chaos
from game.scenes.three_tables.layout import free_spot, laid_out
from game.scenes.three_tables.level import ThreeTablesContent
from game.scenes.three_tables.parameters import ThreeTablesParameters
from game.scenes.three_tables.readouts import readouts_of
from game.scenes.three_tables.shot import MODELS, PlayedShot, ShotShelf, Steps
from game.scenes.three_tables.state import (
    AIM,
    ELEVATION,
    LEFT,
    PLAYING,
    SPEED,
    STROKES,
    TIME,
    UP,
    ThreeTablesState,
)
from game.stage import (
    Equation,
    Frame,
    Hint,
    Pointer,
    Readout,
    SceneAction,
    Strip,
    WarmUp,
)

Array = NDArray[np.float64]

NEXT_STROKE_S = 1.5  # s between the end of a shot and the next stroke that the table plays itself


class ThreeTables(ThreeTablesParameters):
    """The same stroke on three tables. The first is the lecture's: a velocity added to the position in every
    step, no spin. The second steps too, but with all of the physics: balls slide, roll and spin, throw each
    other, and rebound as Han's cushion has it. The third does not step at all. It computes the times of the
    next events, and between them every ball follows a formula, so that its picture is exact at any moment.

    The chart shows how far the balls lie from those of the exact table. A small error at one contact is a
    larger one at the next: choose a perturbation of a picometre, and two exact tables part by a metre after
    a hundred contacts. No table can be predicted for longer, however small its step.
    """

    name, task, title = THREE_TABLES.names
    quarter_turns = 1
    takes = frozenset(("right",))
    content_type = ThreeTablesContent
    study = billiards_study

    strips = (
        Strip("Difference", "log10 m", ("lecture", "stepped", "perturbed")),
        Strip("Energy, exact", "J", ("energy",)),
        Strip("Events", "", ("events",)),
    )
    hints = (Hint(("Move",), "aim"), Hint(("Drag",), "pull back"), Hint(("Esc",), "take back"))
    actions = (
        SceneAction("rack", "new rack", "R"),
        SceneAction("demo", "plays itself", "D"),
        SceneAction("left", "turn the cue left", "left"),
        SceneAction("right", "turn the cue right", "right"),
    )
    figure = staticmethod(draw_chaos)
    equations = (
        Equation(
            "Sliding", r"\v{r} = \v{r}_0 + \v{v}_0 t - \frac{1}{2} \mu g t^2 \v{u}", "Leckie, Greenspan 2006"
        ),
        Equation("Next contact of two balls", r"|\v{r}_2(t) - \v{r}_1(t)|^2 = 4 R^2", "a quartic in t"),
        Equation("Cue and ball", r"v = \frac{2 V}{1 + m/M + \frac{5}{2} (a^2 + b^2)}", "Alciatore, TP A-30"),
    )
    try_this = (
        "Draw the tip down and play a straight shot: the lecture's ball stops, the other two come back.",
        "Set the stepped table's step to 0.05 s and break: balls pass through each other.",
        "Choose a perturbation of 1 pm and break: watch the curve climb to a metre.",
    )

    # -- building -----------------------------------------------------------------------------------

    def build(self, level: Level | None) -> None:
        content = level.content if level is not None and level.content is not None else None
        self.content = content or ThreeTablesContent(plays_itself=True)
        self.bed = Table.bare(1.27, 2.54) if self.content.bare else Table.pool()
        self._lay_balls()
        self.cue = CueControl(0.5 * math.pi)
        self.shot = np.zeros(8)
        self.wait_s = 0.0
        self.grasped = 2  # the table that the pointer is on
        self.plays_itself = self.content.plays_itself
        self.known_s = 0.0  # s of the shot that have been computed for sure
        self.told: deque[str] = deque(maxlen=8)
        self.shelf = ShotShelf()
        self._play()
        if self.content.speed > 0.0:
            self._strike(math.radians(self.content.angle_deg), self.content.speed)

    def _lay_balls(self) -> None:
        self.numbers, self.start, self.radii, self.masses = laid_out(self.content.balls, self.bed)
        self.in_play = np.ones(len(self.numbers), dtype=np.bool_)
        self.places = np.repeat(self.start[None], 3, axis=0)

    def state(self) -> ThreeTablesState:
        return ThreeTablesState(self.start, self.in_play, self.shot, self.cue.data, self.places)

    def restore(self, state: ThreeTablesState) -> None:
        super().restore(state._replace(cue=self.cue.data))
        self.cue.data[:] = state.cue
        self._play()

    def effects_changed(self) -> None:
        self._play()

    def parameter_changed(self, name: str) -> None:
        self._play()

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [WarmUp("three tables", cls), *table_view.warm_ups()]

    # -- the shot -----------------------------------------------------------------------------------

    def _shot_now(self, moved: float = 0.0) -> Shot:
        """The shot as it lies, struck if one is being played; the white ball ``moved`` m aside."""
        rows = np.flatnonzero(self.in_play)
        positions = self.start[rows].copy()
        positions[0, 0] += moved
        bed = table_of(self.active, self.bed)
        shot = make_shot(
            bed,
            positions,
            radii=self.radii[rows],
            masses=self.masses[rows],
            physics=physics_of(self.active),
            ids=tuple(str(number) for number in self.numbers[rows].tolist()),
        )
        if not self.shot[PLAYING]:
            return shot
        blow = strike(
            self.shot[SPEED] / _speed_ratio(),
            self.shot[AIM],
            self.shot[ELEVATION],
            self.shot[LEFT],
            self.shot[UP],
            ball_mass=float(self.masses[0]),
            ball_radius=float(self.radii[0]),
        )
        return shot.struck(0, blow.velocity, blow.spin)

    def _play(self) -> None:
        """Play the shot on all tables, unless it is the one that is being played already."""
        shot = self.shot[[PLAYING, SPEED, AIM, LEFT, UP, ELEVATION]].tobytes()
        balls = self.start.tobytes() + self.in_play.tobytes()
        steps = Steps(self.lecture_step, self.stepped_step, int(self.passes))
        key = (shot, balls, steps, self.perturbation, self.active)
        before = self.shelf.latest
        self.played = self.shelf.get(key, lambda: self._played_with(steps))
        if self.played is not before:
            self.known_s = 0.0

    def _played_with(self, steps: Steps) -> PlayedShot:
        moved = None if self.perturbation == "none" else self._shot_now(float(self.perturbation))
        return PlayedShot(self._shot_now(), moved, steps)

    @property
    def shown_s(self) -> float:
        """Time of the shot up to which it is known, s, at most the time that it has come to.

        It lies behind for a moment when a step has become very short in the middle of a long shot.
        """
        return min(float(self.shot[TIME]), self.played.reached_s) if self.shot[PLAYING] else 0.0

    def differences_until(self, time: float) -> dict[str, list[float]]:
        """Largest distance of any ball to its place on the exact table, m, at SAMPLES_HZ up to a time (s)."""
        self.played.compute(time)
        return self.played.differences.until(min(max(time, 0.0), self.played.least_end_s))

    def _strike(self, aim: float, speed: float) -> None:
        tip = self.tip_left, self.tip_up, math.radians(self.elevation)
        self.shot[:] = 1.0, 0.0, speed, aim, *tip, self.shot[STROKES] + 1.0
        self._play()

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
        self.shot[PLAYING] = 0.0
        self.wait_s = 0.0
        if self.in_play.sum() == 1 and len(self.numbers) > 1:
            self._lay_balls()
        self._play()

    # -- stepping -----------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        if self.cue.advance(dt) and not self.shot[PLAYING]:
            self._strike(self.cue.aim, self.cue.speed)
        if self.shot[PLAYING]:
            if self._caught_up():
                self.shot[TIME] += dt
                self._place_balls()
                if self.played.is_over(float(self.shot[TIME])):
                    self._end_shot()
        else:
            self.wait_s += dt
            if self.plays_itself and self.wait_s > NEXT_STROKE_S and self.cue.phase == AIMING:
                first = int(self.shot[STROKES])
                chosen = choose_stroke(self.start, self.radii, self.in_play, self.bed, self.seed, first)
                self.cue.strike(chosen.aim, chosen.speed)

    def _caught_up(self) -> bool:
        """True if the shot is known up to now. Else a slice more of it is computed, and time stands still.

        How many steps that takes depends on nothing but the shot, whatever has been computed of it before.
        """
        self.known_s = min(self.known_s + self.played.steps.slice_s, float(self.shot[TIME]))
        self.played.compute(self.known_s)
        return self.known_s >= self.shot[TIME]

    def _place_balls(self) -> None:
        self.known_s = float(self.shot[TIME])
        self.played.compute(self.known_s)
        rows = np.flatnonzero(self.in_play)
        for k, name in enumerate(MODELS):
            self.places[k, rows] = self.played.tables[name].state_at(self.shot[TIME]).positions

    # -- the hand -----------------------------------------------------------------------------------

    def pointer(self, event: Pointer) -> None:
        if event.kind == "down" and event.button == 1 and self.plays_itself:
            self.plays_itself = False
            self.told.append("The cue is yours: pull back and let go.")
        if self.plays_itself:
            return
        if self.cue.phase == AIMING:
            self.grasped = view.table_at(event.x, event.y)
        x, y = view.ORIGINS[self.grasped]
        local = msgspec.structs.replace(event, x=event.x - x, y=event.y - y)
        white = self.start[0]
        self.cue.pointer(local, float(white[0]), float(white[1]), not self.shot[PLAYING])

    def action(self, name: str) -> None:
        if name == "rack":
            plays = self.plays_itself
            self.build(self.level)
            self.plays_itself = plays
        elif name == "demo":
            self.plays_itself = not self.plays_itself
            self.cue.let_go()
        else:
            self.cue.nudge(name)

    # -- what is shown ------------------------------------------------------------------------------

    def frame(self) -> Frame:
        return view.FRAME

    def draw(self, canvas: Any, alpha: float) -> None:
        view.draw(self, canvas, alpha)

    def readouts(self) -> tuple[Readout, ...]:
        return readouts_of(self)

    def messages(self) -> list[str]:
        told = list(self.told)
        self.told.clear()
        return told


@lru_cache(maxsize=1)
def _speed_ratio() -> float:
    """Speed of a ball struck in the middle over that of the cue (Alciatore, TP A-30)."""
    return float(np.linalg.norm(strike(1.0, 0.0).velocity))
