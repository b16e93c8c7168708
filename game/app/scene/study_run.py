"""A study that runs in the background, and what the accuracy page shows of it."""

from __future__ import annotations

import threading
from collections.abc import Mapping
from typing import Any

from game.lab import Row, StoppedError, Study, StudyTable, measure_present, run_study
from game.ui.charts.accuracy_data import AccuracyData, Progress
from game.ui.charts.accuracy_study import study_data

ENOUGH_S = 5e-3  # of repeats of a cheap point


class StudyRun:
    """Measures in a thread; ``table`` fills while it runs and may be gone on with later."""

    def __init__(
        self,
        study: Study,
        parameters: Mapping[str, Any],
        table: StudyTable | None = None,
        after: StudyRun | None = None,
    ):
        self._after = after  # is waited for, so that no two measure at once
        self.study = study
        self.table = table if table is not None else StudyTable(study)
        self.present: Row | None = None
        self.progress = Progress(
            len(self.table), max(len(study.settings()), 1), "the present setting", running=True
        )
        self.error = ""
        self.failure: Exception | None = None
        self.place = ""  # what the present setting is measured on, or why there is none, in words
        self._parameters = dict(parameters)
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._work, name=f"study {study.name}", daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """Stop after the present repeat."""
        self._stop.set()

    def wait(self, seconds: float | None = None) -> None:
        """Wait for the end, for tests."""
        self._thread.join(seconds)

    def _work(self) -> None:
        if self._after is not None:
            self._after.wait()
            self._after = None
        try:
            if self._stop.is_set():
                self.progress = self.progress._replace(running=False)
                return
            _, self.place = self.study.place(self._parameters)
            self.present = measure_present(
                self.study, self._parameters, seconds=ENOUGH_S, stop=self._stop.is_set
            )
            run_study(self.study, self._report, self._stop.is_set, self.table, seconds=ENOUGH_S)
        except StoppedError:
            pass
        except Exception as error:  # a study's own code; the page says so and the scene goes on
            self.error = " ".join(str(error).split()) or type(error).__name__
            self.failure = error
        self.progress = self.progress._replace(done=len(self.table), running=False)

    def _report(self, done: int, total: int, label: str, left_s: float) -> None:
        self.progress = Progress(done, total, label, left_s, running=True)


def accuracy_data(run: StudyRun, title: str) -> AccuracyData:
    """What has been measured so far, as the page draws it."""
    table = StudyTable(run.study, list(run.table.rows))
    return study_data(table, title, run.present, run.error, run.place)
