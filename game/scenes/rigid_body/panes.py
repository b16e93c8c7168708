"""Where the bodies stand in the picture: one box, or two side by side in the space of one."""

from __future__ import annotations

import numpy as np

from game.physics.kernels import linear
from game.scenes.rigid_body.bodies import A, B
from game.scenes.rigid_body.camera import HOME, box_edges, camera_matrix
from game.stage import Frame

TITLE_HEIGHT = 0.25  # m
SPHERE_ROOM = 1.15  # m
GAP = 0.12  # m, between the boxes of the twin view


class Panes:
    """The boxes of a window whose half sides are (3,) m; ``twin``: B has one of its own beside that of A.

    shown: panes, A first. half_sides: (3,) m of each box. box: its edges (12, 2, 3) m about its middle.
    """

    def __init__(self, window: tuple[float, float, float], twin: bool):
        self.shown = (A, B) if twin else (A,)
        turned = np.abs(camera_matrix(*HOME))
        half = np.array(window, dtype=np.float64)
        x, y = (linear.product(turned, half)).tolist()[:2]
        self._half_picture = (x, y + TITLE_HEIGHT if twin else y)
        if twin:
            right, _, near = turned[0].tolist()
            half[0] = max(0.5 * (x - GAP) - near * half[2], 0.25 * half[0]) / right
        self.half_sides = half
        self.box = box_edges(half)

    def shift(self, pane: int) -> float:
        """Where (m) the middle of a pane is in the picture."""
        if B not in self.shown:
            return 0.0
        shift = 0.5 * self._half_picture[0]
        return shift if pane == B else -shift

    def at(self, x: float) -> int:
        """The pane at a place (m) of the picture."""
        return B if B in self.shown and x > 0.0 else A

    def frame(self) -> Frame:
        """All of the picture; beside the box of B there is space for the sphere of L."""
        x, y = self._half_picture
        return Frame(-x, -y, x + SPHERE_ROOM if B in self.shown else x, y)
