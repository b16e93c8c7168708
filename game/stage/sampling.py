"""When readouts are taken for the charts: some times a second, and not where no chart will show them."""

from __future__ import annotations

import sys

from game.stage.series import StripSeries
from game.stage.session import Session

_MANY = 1e9  # steps; stands for a quotient that an absurdly short step makes infinite


class Sampling:
    """The series of a stage, and ``due``: the step from which on the next sample is to be taken.

    charts: whether any is ever taken.
    """

    def __init__(self, charts: bool = True) -> None:
        self.series = StripSeries()
        self.due = 0
        self._charts = charts

    def take(self, session: Session) -> None:
        """A sample of the readouts as they are now."""
        if not self._charts:
            self.due = sys.maxsize
            return
        self.series.sample(session.step, session.time_s, session.scene.readouts())
        self.due = session.step + max(1, round(min(1.0 / (self.series.rate_hz * session.dt), _MANY)))

    def skip_to(self, last: int, dt: float) -> None:
        """Leave out what the charts can no longer show when the step ``last`` is reached. dt: s."""
        charted = int(min(self.series.window_s / dt, _MANY)) + 1
        self.due = max(self.due, last - charted)

    def skip_no_more(self, step: int) -> None:
        """From the step after this one on, samples are due again, if there are any."""
        if self._charts:
            self.due = min(self.due, step + 1)

    def go_back(self, step: int) -> None:
        """Forget samples of later steps."""
        self.series.cut(step)
        self.due = step + 1 if self._charts else sys.maxsize
