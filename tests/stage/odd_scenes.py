"""Scenes that try the stage: growing arrays, memory beside the state, failures on demand."""

from __future__ import annotations

from collections import deque
from typing import NamedTuple

import msgspec
import numpy as np

from game.physics.kernels.limits import LimitError
from game.stage import Action, Param, Pointer, Readout, Scene, SceneAction


class CloudContent(msgspec.Struct, forbid_unknown_fields=True):
    """Where the cloud's first points are, m."""

    points: list[tuple[float, float]] = []
    speed: float = 1.0


class Clock(NamedTuple):
    """A state within a state."""

    time: float
    ticks: int


class CloudState(NamedTuple):
    """Points (n, 2) m, their ages (n,) float32, and a clock."""

    points: np.ndarray
    ages: np.ndarray
    clock: Clock


class Cloud(Scene):
    """Points born at random; the scene keeps lists, numbers and a random generator beside its state."""

    name, task, title = "cloud", "X01", "Cloud"
    content_type = CloudContent
    step_length = Param(0.01, 1e-4, 0.1, unit="s")
    births = Param(0.3, 0.0, 1.0)
    first = Param(3, 0, 50, whole=True, rebuild=True)
    actions = (SceneAction("burst", "Burst", "b"), SceneAction("clear", "Clear", "c"))

    def build(self, level):
        content = level.content if level is not None and level.content is not None else CloudContent()
        if any(abs(x) > 100.0 for point in content.points for x in point):
            raise ValueError("points: further than 100 m out")
        self.random = np.random.default_rng(self.seed)
        given = np.array(content.points, dtype=np.float64).reshape(-1, 2)
        self.points = np.concatenate([given, self.random.random((self.first, 2))])
        self.ages = np.zeros(len(self.points), dtype=np.float32)
        self.clock = Clock(0.0, 0)
        self.log = []
        self.trail = deque(maxlen=3)
        self.held = None

    def advance(self, dt):
        self.ages += np.float32(dt)
        self.points += dt * (self.random.random(self.points.shape) - 0.5)
        self.clock = Clock(self.clock.time + dt, self.clock.ticks + 1)
        self.trail.append(self.clock.ticks)
        if self.random.random() < self.births:
            self.add(1)

    def add(self, count):
        self.points = np.concatenate([self.points, self.random.random((count, 2))])
        self.ages = np.concatenate([self.ages, np.zeros(count, dtype=np.float32)])
        self.log.append((self.clock.ticks, count))

    def state(self):
        return CloudState(self.points, self.ages, self.clock)

    def pointer(self, event: Pointer):
        if event.kind == "down" and len(self.points):
            self.held = 0
        elif event.kind in ("up", "cancel"):
            self.held = None
        if self.held is not None:
            self.points[self.held] = event.x, event.y

    def action(self, name):
        if name == "burst":
            self.add(5)
        else:
            self.points, self.ages = self.points[:0], self.ages[:0]
            self.held = None

    def readouts(self):
        return [Readout("points", len(self.points)), Readout(f"at {self.clock.ticks // 100}", 1.0)]


class FragileState(NamedTuple):
    """Height (1,) m and a field (4, 4) that may be anything."""

    height: np.ndarray
    field: np.ndarray


class Fragile(Scene):
    """Fails on demand: at a step by a value that is not finite or an exception, or when it is touched."""

    name, task, title = "fragile", "X02", "Fragile"
    may_be_infinite = frozenset({"field"})
    break_at = Param(1e9, 0.0, 1e9)
    weight = Param(1.0, 0.0, 10.0)
    size = Param(4, 1, 8, whole=True, rebuild=True)
    actions = tuple(SceneAction(name, name, "") for name in ("nan", "raise", "burst", "refuse"))

    def build(self, level):
        if self.size == 7:
            raise ValueError("size: seven is not to be had")
        self.height = np.array([0.0])
        self.field = np.full((self.size, self.size), np.inf)
        self.count = 0
        self.how = "nan"

    def advance(self, dt):
        self.count += 1
        self.height[0] += self.weight * dt
        if self.count >= self.break_at:
            if self.how == "raise":
                raise ZeroDivisionError("nothing to\ndivide by")
            self.height[0] = np.nan

    def state(self):
        return FragileState(self.height, self.field)

    def action(self, name):
        if name == "burst":
            self.height[0] = np.inf
        elif name == "refuse":
            self.height[0] = -5.0
            raise ValueError("not now")
        else:
            self.how = name

    def pointer(self, event):
        self.height[0] = 77.0
        raise RuntimeError("touched")


class CrowdState(NamedTuple):
    """Breadths (n,) m, and where each stands, (n,) m."""

    breadths: np.ndarray
    places: np.ndarray


class Crowd(Scene):
    """Newcomers are as broad as the parameter says; those who are there stay as they are. Room is limited."""

    name, task, title = "crowd", "X03", "Crowd"
    room = 100.0  # m
    count = Param(20, 1, 50, whole=True)
    breadth = Param(2.0, 0.5, 10.0, unit="m")

    def build(self, level):
        self.breadths, self.places = np.empty(0), np.empty(0)
        self.parameter_changed("count")

    def parameter_changed(self, name):
        if name == "count":
            if self.count * self.breadth > self.room:
                raise LimitError(f"no room for {self.count} of {self.breadth} m")
            self.breadths = np.full(self.count, self.breadth)
            self.places = np.arange(self.count) * self.breadth

    def advance(self, dt):
        self.places += dt * self.breadths

    def state(self):
        return CrowdState(self.breadths, self.places)


BURST = Action("burst")
