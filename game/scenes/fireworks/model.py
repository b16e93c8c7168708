"""The show itself: stars, the programme that fires shells, the wind, flashes, sound on its way."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from itertools import islice
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.physics.effects import EffectSet
from game.physics.fields import QUADRATIC_DRAG, WIND
from game.physics.generations import Air, StarSystem, step
from game.physics.generations import kinds as k
from game.physics.generations.system import StarState
from game.physics.kernels import elementary
from game.scenes.fireworks.aiming import LEAST_RISE, aim
from game.scenes.fireworks.level import FARTHEST, FireworksContent, Point
from game.scenes.fireworks.parameters import FireworksParameters
from game.scenes.fireworks.shells import BURSTS, HEADS, SHELL_DRAG, SHELLS, Amounts, all_kinds
from game.scenes.fireworks.thunder import Thunder
from game.worlds.world import Kept, Member, World

MUZZLE = 1.2  # m above the ground
TUBES_EVERY = 20.0  # m
ROCKET_START = 24.0  # m/s
WIND_CEILING = 400.0  # m
SOFT_S = 0.35  # s, with which the camera follows its bearing
BANK = 10.0  # m above the lower edge of the view, where the listener stands
FLASHES = 96
MARKS = 256
INSTANT, FLASH_X, FLASH_Y, FLASH_DEPTH, FLASH_WHAT, FLASH_SHELL = range(6)
LAUNCHED, BURST_COUNT, FLASHED, DUDS = range(4)  # columns of the counts
LOUDNESS = {"mortar": 2.4, "burst": 6.0, "crackle": 1.0}
NO_BURST = -1.0


class Salvo(NamedTuple):
    """One shell of the programme: s, shell, where it is to burst m, where it is fired from m, depth m."""

    time: float
    shell: str
    at: Point
    tube: float
    depth: float


class Programme:
    """The level's cues shell by shell, in the order of time."""

    def __init__(self, content: FireworksContent) -> None:
        rows = []
        for cue in content.cues:
            for i in range(cue.count):
                at = (cue.at[0] + i * cue.step[0], cue.at[1] + i * cue.step[1])
                tube = at[0] if cue.tube is None else cue.tube
                rows.append(Salvo(cue.time + i * cue.delay, cue.shell, at, tube, cue.depth))
        self.rows = tuple(sorted(rows, key=lambda row: row.time))
        self.gust_times = tuple(one.time for one in content.gusts)

    def gust(self, content: FireworksContent, time: float) -> float:
        """What the gusts add to the wind (m/s) at a time (s) of the programme."""
        if not content.gusts:
            return 0.0
        after = bisect_right(self.gust_times, time)
        if after == 0 or after == len(content.gusts):
            return content.gusts[max(after - 1, 0)].wind
        a, b = content.gusts[after - 1], content.gusts[after]
        return a.wind + (b.wind - a.wind) * (time - a.time) / (b.time - a.time)


class FireworksState(NamedTuple):
    """Stars as `StarSystem` keeps them; sound waves, what was heard and the listener; flashes and counts."""

    fields: Floats
    identities: Longs
    alive: Longs
    tallies: Longs
    clock: Floats
    waves: Floats
    heard: Floats
    sound_counts: Longs
    ear: Floats
    flashes: Floats
    burst: Floats
    counts: Longs
    marks: Floats


class Stars(Member):
    """The stars of a system, whose fields stand in the state one by one."""

    def __init__(self, system: StarSystem):
        self.system = system

    def state(self) -> StarState:
        return self.system.state()

    def restore(self, fields: Iterator[Any]) -> None:
        self.system.restore(StarState(*islice(fields, len(StarState._fields))))


class FireworksModel(World):
    """Stars, programme, wind and sound. ``fired``: shells of the programme so far, ``round``: its repeats;
    ``off_mark``: m by which the last one missed; ``walk_to``: where along the bank the listener goes, m;
    ``bearing``: from where the show is seen, degrees.
    """

    state_type = FireworksState
    content: FireworksContent
    parameters: FireworksParameters

    def __init__(
        self, content: FireworksContent, parameters: FireworksParameters, active: EffectSet, seed: int
    ):
        super().__init__(content, parameters, active)
        self.programme = Programme(content)
        kinds = all_kinds(Amounts(parameters.sparks, parameters.places))
        self.system = StarSystem(kinds, effects=active, method=parameters.method, seed=seed)
        self.system.state().clock[0] = content.begins
        self._drags = self.system.table.kinds[:, (k.LINEAR, k.QUADRATIC)].copy()
        self._light = np.array([kind.name not in SHELLS and kind.name != "smoke" for kind in kinds])
        self.thunder = Thunder(content.listener, parameters.distance)
        self.flashes = np.full((FLASHES, 6), NO_BURST)
        self.burst = np.array(
            (NO_BURST, 0.0, 0.0, 0.0, NO_BURST)
        )  # the newest measured: s, x, y, depth, shell
        self.counts = np.zeros(4, dtype=np.int64)
        self.off_mark = 0.0
        self.marks = np.full(
            (MARKS, 4), NO_BURST
        )  # of shells in the air: kind, instant s and place m of the burst
        self.members = (Stars(self.system), self.thunder, Kept(self, "flashes", "burst", "counts", "marks"))
        self.was_full = False
        self.fired = self.rounds = 0
        self.walk_to = content.listener
        self.bearing = self._turning = parameters.bearing
        self.configure()
        for one in content.aloft:
            self._put(one.shell, one.position, one.velocity, one.depth, one.fuse)

    # -- the world ----------------------------------------------------------------------------------

    @property
    def show_s(self) -> float:
        """Time (s) of the programme, in its present round."""
        return self.system.time_s - self.content.begins - self.rounds * self.content.again

    @property
    def wind(self) -> float:
        """Wind (m/s) at the ground, now."""
        return (
            self.parameters.wind + self.programme.gust(self.content, self.show_s)
            if WIND in self.active
            else 0.0
        )

    def listener_place(self) -> Point:
        """Where the listener is drawn, m."""
        return float(self.thunder.ear[0]), self.content.view.bottom + BANK

    def configure(self, ahead: float = 0.0) -> None:
        """Hand all parameters to the system; ``ahead``: s from now at which the wind is taken."""
        system, parameters = self.system, self.parameters
        system.effects = self.active
        system.method = parameters.method
        wind = min(
            max(parameters.wind + self.programme.gust(self.content, self.show_s + ahead), -1000.0), 1000.0
        )
        system.air = Air(parameters.gravity, wind, parameters.shear, WIND_CEILING, 0.0)
        lighter = np.where(self._light, parameters.air / parameters.star_mass, parameters.air)
        system.table.kinds[:, k.LINEAR] = self._drags[:, 0] * lighter
        system.table.kinds[:, k.QUADRATIC] = self._drags[:, 1] * lighter

    def change_parameter(self, name: str) -> None:
        self.configure()

    def change_effects(self, active: EffectSet) -> None:
        self.active = active
        self.configure()

    # -- shells -------------------------------------------------------------------------------------

    def fire(
        self, shell: str, at: Point, tube: float | None = None, depth: float = 0.0, *, blind: bool = False
    ) -> None:
        """Fire a shell that is to burst at a place (m). blind: laid as for still air."""
        start = TUBES_EVERY * round(at[0] / TUBES_EVERY) if tube is None else tube
        way = (at[0] - start, max(at[1] - MUZZLE, LEAST_RISE))
        if shell == "rocket":
            turn = elementary.atan2(way[0], way[1])
            self._put(
                shell,
                (start, MUZZLE),
                (ROCKET_START * elementary.sin(turn), ROCKET_START * elementary.cos(turn)),
                depth,
            )
        else:
            drag = SHELL_DRAG * self.parameters.air if QUADRATIC_DRAG in self.active else 0.0
            wind = 0.0 if blind else self.wind * (1.0 + self.parameters.shear * 0.5 * at[1])
            velocity, fuse = aim(way, self.gravity(), drag, wind)
            self._put(shell, (start, MUZZLE), velocity, depth, fuse)
            instant = self.system.time_s + fuse
            self.marks[int(self.counts[LAUNCHED]) % MARKS] = SHELLS.index(shell), instant, *at
        self.counts[LAUNCHED] += 1
        place = (start, MUZZLE, depth)
        self._flash(self.system.time_s, place, 0.0, shell)
        self.thunder.emit(self.system.time_s, place, "mortar", LOUDNESS["mortar"])

    def burst_at(self, shell: str, at: Point, depth: float = 0.0) -> None:
        """Let a shell burst at a place (m) at once: its fuse is as short as it can be."""
        self._put(shell, at, (0.0, 0.0), depth, 1e-6)
        self.counts[LAUNCHED] += 1

    def _put(self, shell: str, at: Point, velocity: Point, depth: float, fuse: float | None = None) -> None:
        """Put a shell into the air now; with a fuse of its own (s)."""
        before = self.system.stars(shell).shape[1]
        self.system.launch(shell, at, velocity, depth)
        stars = self.system.stars(shell)
        if stars.shape[1] == before:
            return
        if fuse is not None:
            stars[step.DIES, -1] = stars[step.BORN, -1] + fuse
            stars[step.BURNT, -1] = 0.0

    def fire_all(self) -> None:
        """Fire one shell of each kind, side by side."""
        for i, shell in enumerate(SHELLS):
            x = 16.0 * (i - 0.5 * (len(SHELLS) - 1))
            self.fire(shell, (x, 105.0 + 25.0 * (i % 2)), x)

    def clear(self) -> None:
        """Put out all stars."""
        state = self.system.state()
        state.tallies[step.ENDED] += len(self.system)
        state.counts[:] = 0

    def _follow_programme(self) -> None:
        """Fire what is due. A programme that goes round begins anew in its time."""
        if not self.parameters.programme:
            self._skip()
            return
        again = self.content.again
        if again > 0.0 and self.show_s >= again:
            self.rounds += 1
            self.fired = 0
        now = self.show_s + 1e-9
        while self.fired < len(self.programme.rows) and self.programme.rows[self.fired].time <= now:
            _, shell, at, tube, depth = self.programme.rows[self.fired]
            self.fire(shell, at, tube, depth, blind=True)
            self.fired += 1

    def _skip(self) -> None:
        """Let what is due pass unfired."""
        while (
            self.fired < len(self.programme.rows)
            and self.programme.rows[self.fired].time <= self.show_s + 1e-9
        ):
            self.fired += 1

    # -- a step -------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        """One step of everything."""
        now = self.system.time_s
        self._go_round(dt)
        self._follow_programme()
        self.configure(0.5 * dt)
        self.system.step(dt)
        for row in self.system.reports.tolist():
            self._take(row)
        walk_to = (min(max(self.walk_to, -FARTHEST), FARTHEST), self.parameters.distance)
        self.thunder.go_on(now, dt, walk_to)
        if self.was_full or not self.system.tally(step.DROPPED):
            return ""
        self.was_full = True
        return "No place is left for some stars: they are dropped and counted."

    def _go_round(self, dt: float) -> None:
        """The bearing follows its parameter softly: twice over by the same share."""
        share = -elementary.expm1(-dt / SOFT_S)
        self._turning += share * (self.parameters.bearing - self._turning)
        self.bearing += share * (self._turning - self.bearing)

    def _take(self, row: list[float]) -> None:
        """What a report means: a flash, a sound, the newest burst."""
        what, kind, instant, x, y, depth = row[:6]
        name = self.system.kinds[int(kind)].name
        if what == k.AT_BIRTH:
            return
        if name == "popping":
            self.thunder.emit(instant, (x, y, depth), "crackle", LOUDNESS["crackle"])
            return
        if what != k.AT_DEATH:
            self.counts[DUDS] += 1
            return
        mark = self.marks[(self.marks[:, 0] == SHELLS.index(name)) & (self.marks[:, 1] == instant)]
        if len(mark):
            self.off_mark = elementary.hypot(x - float(mark[0, 2]), y - float(mark[0, 3]))
        if not BURSTS[name]:
            return
        self.counts[BURST_COUNT] += 1
        self._flash(instant, (x, y, depth), 1.0, name)
        self.thunder.emit(instant, (x, y, depth), "burst", LOUDNESS["burst"])
        if name in HEADS:
            self.burst[:] = instant, x, y, depth, SHELLS.index(name)

    def _flash(self, instant: float, place: tuple[float, float, float], what: float, shell: str) -> None:
        line = int(self.counts[FLASHED]) % FLASHES
        self.flashes[line] = instant, *place, what, SHELLS.index(shell)
        self.counts[FLASHED] += 1
