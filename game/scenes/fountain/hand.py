"""The hand in the fountain: stones, their rims, nozzles and the vortex are dragged."""

from __future__ import annotations

from game.physics.fields import GROUND, WHIRL
from game.physics.kernels import elementary
from game.physics.particles import OBSTACLES
from game.scenes.fountain.level import MOST_STONES, Point
from game.scenes.fountain.model import FountainModel
from game.scenes.fountain.panes import pane_at, panes_of
from game.stage import Part, Pointer

REACH = 0.14  # m, how near to a handle the pointer takes it
LEAST_RADIUS, MOST_RADIUS = 0.02, 500.0  # m
FARTHEST = 1000.0  # m
NOTHING = ("", -1)


def rim_handle(x: float, y: float, radius: float) -> Point:
    """Where a stone's handle for its radius is: on the rim, up and to the right."""
    return x + 0.88 * radius, y + 0.475 * radius


class FountainHand(Part):
    """What is held, and its number; where it is to go, m; where it was taken hold of, m from that place."""

    def __init__(self, model: FountainModel):
        self.model = model
        self.held: tuple[str, int] = NOTHING
        self.target = self.grip = (0.0, 0.0)
        self.pane = 0  # where the pointer was pressed, of those side by side

    @property
    def stone(self) -> int:
        """The stone that is held, or -1."""
        what, index = self.held
        return index if what == "stone" else -1

    def take(self, event: Pointer) -> str:
        """A pointer event in world coordinates; what there is to say about it, or ""."""
        panes = panes_of(self.model)
        if event.kind == "down":
            self.pane = pane_at(panes, event.x)
        point = _within_reach(event.x - panes[self.pane].shift, event.y)
        if event.kind == "down" and event.button == 1:
            return self._press(point, event.shift)
        if event.kind == "down" and event.button == 3:
            self._remove_stone(point)
        elif event.kind == "move" and self.held != NOTHING:
            self._drag(point)
        elif event.kind in ("up", "cancel"):
            self.held = NOTHING
        return ""

    def _press(self, point: Point, new: bool) -> str:
        self.held = self._thing_at(point)
        if self.held != NOTHING:
            x, y = self._place_held()
            self.target, self.grip = (x, y), (x - point[0], y - point[1])
        elif new:
            index = self.model.add_stone(point)
            if index < 0:
                return f"There can be at most {MOST_STONES} stones."
            self.held, self.target, self.grip = ("stone", index), point, (0.0, 0.0)
        return ""

    def _thing_at(self, point: Point) -> tuple[str, int]:
        """What is to be dragged at a point: rim, stone, nozzle or vortex, with its number; or NOTHING."""
        model = self.model
        if OBSTACLES in model.active:
            stones = model.system.solids.rows[:, :3].tolist()
            for j, (x, y, radius) in enumerate(stones):
                if elementary.dist(point, rim_handle(x, y, radius)) < REACH:
                    return "rim", j
            for j, (x, y, radius) in enumerate(stones):
                if elementary.dist(point, (x, y)) < max(radius, REACH):
                    return "stone", j
        for e in range(len(model.content.nozzles)):
            if elementary.dist(point, model.nozzle_position(e)) < 2.0 * REACH:
                return "nozzle", e
        if WHIRL in model.active and elementary.dist(point, model.vortex_centre) < 2.0 * REACH:
            return "vortex", 0
        return NOTHING

    def _place_held(self) -> Point:
        """The point (m) that follows the hand: of what is held, its centre or the handle on its rim."""
        what, index = self.held
        if what == "vortex":
            return self.model.vortex_centre
        if what == "nozzle":
            return self.model.nozzle_position(index)
        x, y, radius = self.model.system.solids.rows[index, :3].tolist()
        return rim_handle(x, y, radius) if what == "rim" else (x, y)

    def _drag(self, point: Point) -> None:
        model, (what, index) = self.model, self.held
        x, y = _within_reach(point[0] + self.grip[0], point[1] + self.grip[1])
        if what == "stone":
            self.target = (x, y)
        elif what == "rim":
            row = model.system.solids.rows[index]
            row[2] = min(max(elementary.dist((x, y), row[:2].tolist()), LEAST_RADIUS), MOST_RADIUS)
        elif what == "nozzle":
            lowest = model.content.floor if GROUND in model.active else -FARTHEST
            model.place_nozzle(index, (x, max(y, lowest)))
        elif what == "vortex":
            model.place_vortex((x, y))

    def _remove_stone(self, point: Point) -> None:
        what, index = self._thing_at(point)
        if what in ("stone", "rim"):
            self.model.remove_stone(index)
            self.held = NOTHING


def _within_reach(x: float, y: float) -> Point:
    """The nearest place (m) that a level file can name."""
    return min(max(x, -FARTHEST), FARTHEST), min(max(y, -FARTHEST), FARTHEST)
