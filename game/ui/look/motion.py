"""Short changes of the interface: values that go from 0 to 1 and back in a set time, eased."""

from __future__ import annotations

HOVER_S, LIFT_S, SEGMENT_S, OVERLAY_S, SCENE_S = 0.08, 0.12, 0.12, 0.2, 0.22
TOAST_IN_S, TOAST_STAY_S, TOAST_OUT_S = 0.16, 4.0, 0.24


def ease_out(t: float) -> float:
    """Cubic, fast first; for what arrives."""
    t = min(max(t, 0.0), 1.0)
    return 1.0 - (1.0 - t) ** 3


def ease_in(t: float) -> float:
    """Cubic, slow first; for what leaves."""
    t = min(max(t, 0.0), 1.0)
    return t * t * t


class Fade:
    """A value that follows a switch: ``amount`` goes to 1 while on and to 0 while off."""

    def __init__(self, duration_s: float, on: bool = False) -> None:
        self.duration_s = duration_s
        self.on = on
        self._t = 1.0 if on else 0.0

    @property
    def amount(self) -> float:
        """Eased, 0 to 1."""
        return ease_out(self._t) if self.on else 1.0 - ease_out(1.0 - self._t)

    @property
    def resting(self) -> bool:
        """Whether it has arrived."""
        return self._t == (1.0 if self.on else 0.0)

    def update(self, dt_s: float, on: bool | None = None) -> bool:
        """Let time pass; True if the value has changed."""
        if on is not None:
            self.on = on
        goal = 1.0 if self.on else 0.0
        if self._t == goal:
            return False
        move = max(dt_s, 0.0) / self.duration_s if self.duration_s > 0.0 else 1.0
        self._t = min(self._t + move, 1.0) if self.on else max(self._t - move, 0.0)
        return True
