"""The match of the fireplace: struck on the hearth, held to the kindling, taken away."""

from __future__ import annotations

from game.physics.animation.keyframes import Keyframes
from game.physics.kernels import elementary
from game.physics.solids import Capsule, Material, SolidWorld
from game.physics.surfaces import KeyFrames
from game.worlds.members.match import LedMatch, Way

THICK = 0.0045  # m, half its thickness
TIMES = (0.0, 0.7, 1.15, 1.9, 2.7, 4.5, 7.5, 8.5, 9.5)  # s after it is taken out
# m, m, rad: its head, and which way the wood lies from there
KEYS = (
    (1.05, 0.5, 0.9), (0.78, 0.014, 0.55), (0.56, 0.014, 0.55), (0.36, 0.13, 0.5), (0.16, 0.035, 0.4),
    (0.14, 0.03, 0.4), (0.15, 0.032, 0.4), (0.5, 0.26, 0.7), (1.1, 0.6, 0.9),
)  # fmt: skip
WAY = Way(Keyframes(TIMES, KEYS, "centripetal", geometry=(0, 1)), 0.95, 8.1, TIMES[-1])
POWER = 14_000.0  # W/m of its flame, a metre deep as all else is


class Match(LedMatch):
    """A long match for fireplaces: a body among the logs, which the hand takes through them."""

    long, rest, tilt, flares = 0.12, KEYS[0], 0.8, 1.2

    def __init__(self, world: SolidWorld):
        super().__init__()
        wood, (x, y, turn) = Material(density=300.0, friction=0.3), self.rest
        shape = Capsule((0.0, 0.0), (self.long, 0.0), THICK, wood)
        self.body = world.add_body(shape, (x, y), turn, kind="fixed")
        self._lead = KeyFrames(world, self.body, self._middle)

    def way(self) -> Way:
        return WAY

    def _middle(self, time: float) -> tuple[float, float, float]:
        """Its centre of mass (m, m) and angle (rad)."""
        x, y, turn = self.pose(time)
        half = 0.5 * self.long
        return x + half * elementary.cos(turn), y + half * elementary.sin(turn), turn

    def strike(self, time: float) -> None:
        """Take it out, and play its curve from now on."""
        if self.is_away(time):
            self.began = time

    def hidden(self, time: float) -> bool:
        """Whether it is out of sight."""
        return self.held is None and self.is_away(time)

    def lead(self, time: float, dt: float) -> None:
        """Give it the velocity of its curve, for a step."""
        self._lead.lead(time, dt)

    def power(self, time: float) -> float:
        """W/m of its flame."""
        return POWER * self.strength(time)
