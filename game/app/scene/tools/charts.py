"""The charts of a scene in play: any readout in any of them, two against each other, numbers as a file."""

from __future__ import annotations

import math
from collections.abc import Callable
from datetime import datetime
from pathlib import Path

from game.app.scene.in_play import InPlay
from game.app.scene.shell import Shell
from game.app.screens.host import Host
from game.files import FileProblem, write_text
from game.folders import pictures_folder
from game.stage import Readout, Stage, Strip
from game.ui.charts.phase import Phase
from game.ui.charts.strips import MOST
from game.ui.look.numerals import format_si
from game.ui.widgets.list_row import ListRow

NEW = -1  # in place of a chart's number: one more, or the last one where there are as many as there can be


class Charts:
    """Asks for a readout and puts it into a chart."""

    def __init__(self, host: Host, record: InPlay, shell: Shell) -> None:
        self._host, self._record, self._shell = host, record, shell

    def readouts(self) -> list[Readout]:
        """What can be picked: everything measured and not hidden by the level."""
        return self._shell.shown(self._record.stage)

    def ask(self, chart: int = NEW) -> None:
        """Offer what a chart can show."""
        strips = self._shell.strips
        if strips is None:
            return
        rows = [row._replace(chip="chart", value=("chart", row.value)) for row in self._rows()]
        rows.append(
            ListRow("Two readouts against each other", "A phase plot", "phase", value=("phase", None))
        )
        if strips.strips != strips.declared:
            rows.append(ListRow("As the scene has them", "All charts", "", value=("declared", None)))
        if chart >= len(strips.declared):
            rows.append(ListRow("Take this chart away", "", "", value=("away", None)))
        rows.append(
            ListRow("Save the numbers", "All readouts of the last ten seconds", "csv", value=("csv", None))
        )
        title = "One more chart" if chart == NEW else f"Chart {chart + 1}"
        self._host.cards.open_choices(title, rows, lambda value: self._take(chart, *value))

    def _take(self, chart: int, kind: str, readout: Readout | None = None) -> None:
        strips = self._shell.strips
        assert strips is not None
        if kind == "chart" and readout is not None:
            self.put(chart, strip_of(readout))
        elif kind == "phase":
            self._then(lambda: self._ask_to_the_right(chart))
        elif kind == "csv":
            self.save()
        elif kind == "away":
            self._show([one for i, one in enumerate(strips.strips) if i != chart])
        else:
            self._show(strips.declared)

    def ask_phase(self) -> None:
        """Offer what a phase plot can show."""
        self._ask_to_the_right(NEW)

    def _then(self, act: Callable[[], object]) -> None:
        """Do this when the card that is open has gone."""
        self._record.later.append(act)

    def _ask_to_the_right(self, chart: int) -> None:
        rows = self._rows()
        self._host.cards.open_choices(
            "To the right", rows, lambda x: self._then(lambda: self._ask_upwards(chart, x))
        )

    def _ask_upwards(self, chart: int, x: Readout) -> None:
        rows = [row for row in self._rows() if row.value.name != x.name]
        self._host.cards.open_choices(
            f"Upwards, against {x.name}", rows, lambda y: self.put(chart, Phase(x.name, y.name))
        )

    def _rows(self) -> list[ListRow]:
        return [
            ListRow(one.name[:1].upper() + one.name[1:], format_si(one.value, one.unit), "", value=one)
            for one in self.readouts()
        ]

    def put(self, chart: int, strip: Strip | Phase) -> None:
        """Show it in place of a chart, by its number, or as one more."""
        assert self._shell.strips is not None
        strips = list(self._shell.strips.strips)
        if chart == NEW and len(strips) < MOST:
            strips.append(strip)
        else:
            strips[min(chart, len(strips) - 1) if chart != NEW else MOST - 1] = strip
        self._show(strips)
        if self._shell.layout.strips.h < 1:
            self._host.tell("There is no space for charts.", "In a higher window they are shown.", "warning")
        elif chart == NEW and len(self._shell.layout.charts) < len(strips):
            self._host.tell("There is no space for one more chart.", "A wider window shows it.", "warning")

    def _show(self, strips: list[Strip | Phase] | tuple[Strip | Phase, ...]) -> None:
        assert self._shell.strips is not None
        self._shell.strips.show(strips)
        self._host.restyle()

    # -- numbers ------------------------------------------------------------------------------------

    def save(self) -> None:
        """Write the numbers of the last ten seconds, in the background, and say where."""
        stage, names = self._record.stage, [one.name for one in self.readouts()]
        units = {one.name: one.unit for one in self.readouts()}
        text, path = csv_text(stage, names, units), free_path(stage.scene.name)
        self._record.errands.work(lambda: self._write(path, text))

    def _write(self, path: Path, text: str) -> Callable[[], object]:
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            write_text(path, text)
        except (FileProblem, OSError) as problem:
            why = str(problem)
            return lambda: self._host.tell("Numbers not saved.", why, "warning")
        return lambda: self._host.tell("Numbers saved", str(path))


def strip_of(readout: Readout) -> Strip:
    """The chart of one readout; a unit that it has not always is left to it."""
    return Strip(readout.name[:1].upper() + readout.name[1:], "", (readout.name,))


def csv_text(stage: Stage, names: list[str], units: dict[str, str]) -> str:
    """The samples of readouts as comma-separated values (RFC 4180): step, time, then each with its unit."""
    series = stage.series
    heads = [f"{name} [{units[name]}]" if units.get(name) else name for name in names]
    columns = [series.values(name) if name in series.names else None for name in names]
    lines = [",".join(map(_quoted, ("step", "time [s]", *heads)))]
    for i, (step, time_s) in enumerate(zip(series.steps.tolist(), series.times.tolist(), strict=True)):
        cells = [_cell(column[i]) if column is not None else "" for column in columns]
        lines.append(",".join((str(step), repr(time_s), *cells)))
    return "\r\n".join(lines) + "\r\n"


def _cell(value: float) -> str:
    """The number so that it is read back to the last bit; nothing where nothing was measured."""
    number = float(value)
    return repr(number) if math.isfinite(number) else ""


def _quoted(words: str) -> str:
    return '"' + words.replace('"', '""') + '"' if any(c in words for c in ',"\r\n') else words


def free_path(scene_name: str) -> Path:
    """A name in the pictures folder that no file has yet."""
    folder, stamp = pictures_folder(), f"{datetime.now():%Y-%m-%d-%H%M%S}"
    path, number = folder / f"carom-{scene_name}-{stamp}.csv", 2
    while path.exists():
        path, number = folder / f"carom-{scene_name}-{stamp}-{number}.csv", number + 1
    return path
