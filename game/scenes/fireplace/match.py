"""A match that is led along a curve: struck on the hearth, held to the kindling, taken away."""

from __future__ import annotations

from game.physics.animation.keyframes import Keyframes
from game.physics.kernels import elementary
from game.physics.solids import Capsule, Material, SolidWorld
from game.physics.surfaces import KeyFrames
from game.stage import Part

LONG, THICK = 0.12, 0.0045  # m: of a match for fireplaces, and half its thickness
TIMES = (0.0, 0.7, 1.15, 1.9, 2.7, 4.5, 7.5, 8.5, 9.5)  # s after it is taken out
# m, m, rad: its head, and which way the wood lies from there
KEYS = (
    (1.05, 0.5, 0.9), (0.78, 0.014, 0.55), (0.56, 0.014, 0.55), (0.36, 0.13, 0.5), (0.16, 0.035, 0.4),
    (0.14, 0.03, 0.4), (0.15, 0.032, 0.4), (0.5, 0.26, 0.7), (1.1, 0.6, 0.9),
)  # fmt: skip
STRUCK, OUT = 0.95, 8.1  # s after it was taken out: it flares up, it is shaken out
FLARE = 0.35  # s
POWER = 14_000.0  # W/m of its flame, a metre deep as all else is
Point = tuple[float, float]


class Match(Part):
    """began: s at which it was taken out, or -1; by: whether the hand holds it, then where."""

    def __init__(self, world: SolidWorld):
        self.world = world
        self.began = -1.0
        self.held: Point | None = None
        self._curve = Keyframes(TIMES, KEYS, "centripetal", geometry=(0, 1))
        wood = Material(density=300.0, friction=0.3)
        away = KEYS[0]
        tail = (LONG, 0.0)
        body = world.add_body(Capsule((0.0, 0.0), tail, THICK, wood), away[:2], away[2], kind="fixed")
        self.body = body
        self._half = 0.5 * LONG
        self._lead = KeyFrames(world, body, self._middle)

    def _at(self, time: float) -> tuple[float, float, float]:
        """Head (m) and angle (rad) at a time of the story of the match."""
        if self.began < 0.0:
            return KEYS[0]
        x, y, turn = self._curve.sample(min(time - self.began, TIMES[-1])).tolist()
        return x, y, turn

    def _middle(self, time: float) -> tuple[float, float, float]:
        """Its centre of mass and angle."""
        x, y, turn = self._at(time)
        if self.held is not None:
            (x, y), turn = self.held, 0.8
        return x + self._half * elementary.cos(turn), y + self._half * elementary.sin(turn), turn

    def strike(self, time: float) -> None:
        """Take it out, and play its curve from now on."""
        if self.began < 0.0 or time - self.began > TIMES[-1]:
            self.began = time

    def lead(self, time: float, dt: float) -> None:
        """Give it the velocity of its curve, for a step."""
        self._lead.lead(time, dt)

    def lit(self, time: float) -> bool:
        """Whether it burns."""
        return self.held is not None or (self.began >= 0.0 and STRUCK <= time - self.began < OUT)

    def power(self, time: float) -> float:
        """W/m of its flame: it flares up as it is struck."""
        if not self.lit(time):
            return 0.0
        since = time - self.began - STRUCK
        return POWER * (1.0 + 1.2 * elementary.exp(-since / FLARE) if self.held is None else 1.0)

    def place(self, time: float) -> tuple[Point, Point] | None:
        """Its head and its end, m; None while it is out of sight."""
        idle = self.began < 0.0 or time - self.began > TIMES[-1]
        if self.held is None and idle:
            return None
        x, y, turn = self._at(time)
        if self.held is not None:
            (x, y), turn = self.held, 0.8
        return (x, y), (x + LONG * elementary.cos(turn), y + LONG * elementary.sin(turn))
