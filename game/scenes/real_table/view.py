"""How the real table is drawn: track and paths on the table, beside it what each model is off and costs."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.billiards.table.table import Table
from game.scenes.real_table.comparison import LABELS, MODELS, Played
from game.scenes.real_table.model import RealTableModel
from game.scenes.shared.tables import view as table_view
from game.scenes.shared.tables.view import SURROUND, Balls
from game.stage import Frame
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT, FELT_LINE, FELT_WARM

COLORS = {"han": "chalk", "mathavan": "green", "stronge": "violet", "stepped": "yellow", "lecture": "pink"}
NUMBERS = (0, 1, 3)  # a white, a yellow and a red ball
GAP, BREADTH = 0.12, 2.3  # m, between the table and the list beside it; of the list
BELOW, CHART = 0.48, 0.75  # m, from the cushion down to the chart; its height
LEAST, MOST = 1e-4, 1.0  # m; of the chart's logarithmic axis
ROW = 0.15  # m, of the list
PATH_STEP = 0.01  # s


def frame_of(model: RealTableModel) -> Frame:
    """The table, which lies turned by a quarter, with room beside and below it."""
    size = model.size
    wide = size.length + SURROUND + GAP + BREADTH
    return Frame(-SURROUND, -SURROUND, size.width + BELOW + CHART + 0.15, wide + 0.15)


def draw(canvas: Canvas, model: RealTableModel, time: float) -> None:
    """Everything at a time of the track's clock, s."""
    canvas.fill("bg")
    bed = Table.bare(model.size.width, model.size.length)
    table_view.draw_table(canvas, bed, alone=False)
    canvas.halo = FELT
    han = model.compared.models.get("han")
    if han is not None:
        _draw_paths(canvas, model, han, time)
    _draw_tracks(canvas, model, time)
    if han is not None:
        _draw_balls(canvas, model, han, time, bed)
    canvas.halo = canvas.theme.bg
    _draw_list(canvas, model)
    _draw_chart(canvas, model, time)


def _draw_paths(canvas: Canvas, model: RealTableModel, played: Played, time: float) -> None:
    """Computed paths up to now."""
    times = np.arange(0.0, min(time, model.shot.end_time) + PATH_STEP, PATH_STEP)
    places = played.places(times)
    for ball in range(places.shape[1]):
        if np.ptp(places[:, ball], axis=0).max() > 0.0:
            canvas.polyline(places[:, ball], FELT_LINE, 1.4, alpha=0.8)


def _draw_tracks(canvas: Canvas, model: RealTableModel, time: float) -> None:
    """Samples: those up to now, or all, in the colour of what is seen."""
    for track in model.shot.tracks:
        shown = np.ones(len(track.times), bool) if model.parameters.tail else track.times <= time
        canvas.discs(track.places[shown], canvas.px(1.9), FELT_WARM, alpha=0.9)


def _draw_balls(canvas: Canvas, model: RealTableModel, played: Played, time: float, bed: Table) -> None:
    """The balls where they are computed, a ring where they were last seen."""
    moment = min(time, model.shot.end_time)
    count = len(model.shot.tracks)
    radius = 0.5 * model.size.ball_diameter
    numbers = np.array([NUMBERS[k] if k < len(NUMBERS) else k + 1 for k in range(count)])
    balls = Balls(
        played.places(np.array([moment]))[0],
        np.full(count, radius),
        numbers,
        played.trajectory.orientations_at(max(moment - played.stroke.start, 0.0)),
        np.ones(count),
    )
    table_view.draw_balls(canvas, balls, bed)
    for track in model.shot.tracks:
        at = max(int(np.searchsorted(track.times, moment, side="right")) - 1, 0)
        x, y = track.places[at].tolist()
        canvas.circle((x, y), radius, outline=FELT_WARM, width=1.5)


def _draw_list(canvas: Canvas, model: RealTableModel) -> None:
    """Each model: how far off it is, and what a shot costs."""
    left = model.size.length + SURROUND + GAP
    source = model.source.replace("\\", "/").rsplit("/", 1)[-1]
    made = model.content.made
    words = source or f"made by the program, {made.noise_mm:g} mm of noise"
    canvas.label((0.0, left), f"Shot {model.shot.id}: {words}", "text1", 14, "semibold", anchor="left")
    columns = (left + 1.5, left + 1.9, left + BREADTH)
    for across, title in zip(columns, ("cue ball", "all balls", "a shot"), strict=True):
        canvas.label((1.3 * ROW, across), title, "text3", 11, anchor="right")
    for row, name in enumerate(MODELS):
        down = (2.3 + row) * ROW
        canvas.line((down, left), (down, left + 0.09), COLORS[name], 3.0)
        canvas.label((down, left + 0.13), LABELS[name], "text1", 12, anchor="left")
        played = model.compared.models.get(name)
        cells: tuple[str, ...] = ("cannot be played",)
        if played is not None:
            cells = (_length(played.rmse_cue), _length(played.rmse_all), _duration(played.price_s))
        for across, cell in zip(columns[-len(cells) :], cells, strict=True):
            canvas.label((down, across), cell, "text2", 12, anchor="right")
    words = "root mean square over all samples; processor time"
    canvas.label(((2.4 + len(MODELS)) * ROW, left), words, "text3", 11, anchor="left")


def _draw_chart(canvas: Canvas, model: RealTableModel, time: float) -> None:
    """Distance of the cue ball from its track over time, up to now."""
    width = model.size.length + SURROUND + GAP + BREADTH
    top = model.size.width + BELOW
    seconds = max(model.shot.end_time, 1.0)
    canvas.label((top - 0.1, 0.0), "Cue ball off its track", "text2", 12, "semibold", anchor="left")
    for power in range(round(math.log10(LEAST)), round(math.log10(MOST)) + 1):
        down = top + float(_depth(np.array([10.0**power]))[0])
        canvas.line((down, 0.0), (down, width), "grid", 1.0)
        canvas.label((down, width), _length(10.0**power), "text3", 11, anchor="right", offset=(0.0, -7.0))
    track = model.shot.tracks[0]
    now = int(np.searchsorted(track.times, time, side="right"))
    for name in reversed(MODELS):
        played = model.compared.models.get(name)
        if played is not None and now > 1:
            along = track.times[:now] / seconds * width
            points = np.column_stack([top + _depth(played.errors[0][:now]), along])
            canvas.polyline(points, COLORS[name], 1.6)
    along_now = min(time, seconds) / seconds * width
    canvas.line((top, along_now), (top + CHART, along_now), "amber", 1.2)
    for second in range(0, math.floor(seconds) + 1, 2):
        at = (top + CHART + 0.07, second / seconds * width)
        canvas.label(at, "0 s" if second == 0 else str(second), "text3", 11)


def _depth(errors: Floats) -> Floats:
    """How far below the chart's upper edge distances (m) stand, on a logarithmic axis."""
    share = np.log10(np.clip(errors, LEAST, MOST) / LEAST) / math.log10(MOST / LEAST)
    return (1.0 - share) * CHART


def _length(metres: float) -> str:
    """A distance in words."""
    if metres >= 0.9995:
        return f"{metres:.3g} m"
    return f"{100.0 * metres:.3g} cm" if metres >= 0.00995 else f"{1000.0 * metres:.2g} mm"


def _duration(seconds: float) -> str:
    """A time in words."""
    return f"{1e6 * seconds:.0f} µs" if seconds < 1e-3 else f"{1e3 * seconds:.1f} ms"
