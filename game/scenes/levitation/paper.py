"""The paper on levitated grains that draw (P28)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from game.lab.timing import least_time
from game.physics.acoustics import Levitator, LevitatorSettings, facing_rows
from game.physics.acoustics.levitator import POLYSTYRENE
from game.scenes.levitation import model
from game.scenes.levitation.figure import draw_focus, draw_standing_wave
from game.scenes.levitation.model import WAVE
from game.scenes.shared.marks import dot
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

DT, STRENGTH, LOUDEST = 1.0 / 240.0, 10.0, 40.0
TRIALS = 8


def _levitator(
    speed: float, figure: str = "circle", size: float = 0.02, strength: float = STRENGTH
) -> Levitator:
    """One grain in the trap of a focus that is led so fast."""
    levitator = Levitator(
        facing_rows(2, model.COUNT, model.PITCH, model.APART, strength), [], figure=figure, size=size,
        settings=LevitatorSettings(substeps=16, speed=speed, acceleration=1.0),
    )  # fmt: skip
    levitator.add(levitator.place)
    return levitator


def _carries(speed: float, figure: str) -> bool:
    """Whether the grain is still in its trap after four seconds."""
    levitator = _levitator(speed, figure)
    for _ in range(960):
        levitator.step(DT)
        if np.hypot(*(levitator.positions[0] - levitator.place)) > model.FAR:
            return False
    return True


def escape_speed(figure: str, low: float, high: float) -> float:
    """The fastest (m/s) that a grain is led along a figure of 4 cm without being lost, by halving."""
    for _ in range(TRIALS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _carries(middle, figure) else (low, middle)
    return low


def _draw_heart(pen: Pen) -> None:
    """The way of a grain that is led along a heart slowly, and of one that is led too fast."""
    for speed, color, steps in ((0.25, "green", 240), (1.6, "vermilion", 200)):
        levitator = _levitator(speed, "heart", 0.03)
        levitator.settings = LevitatorSettings(substeps=16, speed=speed, acceleration=4.0)
        way = []
        for _ in range(steps):
            levitator.step(DT)
            x, y = levitator.positions[0].tolist()
            if abs(y) > 0.032:
                break
            way.append((148.0 + 2600.0 * x, 104.0 - 2600.0 * y))
        pen.line(way, color, 2.0)
        dot(pen, way[-1], "yellow", 4.5)
    pen.words("0.25 m/s", 20.0, 22.0, "green", "left")
    pen.words("1.6 m/s", 20.0, 40.0, "vermilion", "left")


def _draw_node(pen: Pen) -> None:
    """Pressure amplitude about the focus: both rows in step, and one of them turned by half a wave."""
    cells, side = 24, 5.2
    for left, turned, words in ((16.0, False, "in step"), (155.0, True, "half a wave turned")):
        still = _levitator(0.0)
        if not turned:
            still.array.focus(still.wave.number, still.place, np.zeros_like(still.offsets))
        at = (np.arange(cells) + 0.5) / cells * 2.4 * WAVE - 1.2 * WAVE
        x, y = still.place
        places = np.stack([np.tile(x + at, cells), np.repeat(y + at, cells)], axis=1)
        field = still.sample(places)
        loud = np.hypot(field[:, 0], field[:, 1]).reshape(cells, cells)
        for j in range(cells):
            for i in range(cells):
                color = pen.veiled("chalk", 1.0 - float(loud[j, i] / loud.max()))
                pen.box(left + side * i, 164.0 - side * (j + 1), side + 0.3, side + 0.3, color)
        if turned:
            dot(pen, (left + 0.5 * side * cells, 164.0 - 0.5 * side * cells), "yellow", 4.5)
        pen.words(words, left + 0.5 * side * cells, 182.0, "text2")
    pen.words("pressure about the focus", 148.0, 20.0, "text2")


def _draw_lattice(pen: Pen) -> None:
    """Grains that were let go off the nodes of plane waves from four sides, and where each has come."""
    array = facing_rows(4, model.COUNT, model.PITCH, model.APART, STRENGTH)
    settings = LevitatorSettings(substeps=16, gravity=0.0, pattern="plane")
    places = [((i - 2.5) * 0.55 * WAVE, (j - 1.5) * 0.55 * WAVE) for j in range(4) for i in range(6)]
    levitator = Levitator(array, places, settings=settings)
    ways = [levitator.positions]
    for _ in range(120):
        levitator.step(DT)
        ways.append(levitator.positions)
    scale = 70.0 / WAVE
    for way in np.stack(ways, axis=1).tolist():
        line = [(148.0 + scale * x, 104.0 - scale * y) for x, y in way]
        pen.line(line, "text3", 1.2)
        pen.disc(*line[0], 2.0, "text2")
        dot(pen, line[-1], "yellow", 4.5)


def _measure() -> Iterator[Comparison]:
    still = _levitator(0.0)
    x, y = still.place
    z = np.linspace(-2.2, 2.2, 8801) * WAVE
    depth = still.sample(np.stack([np.full_like(z, x), y + z], axis=1))
    lowest = np.flatnonzero((depth[1:-1, 3] < depth[:-2, 3]) & (depth[1:-1, 3] < depth[2:, 3])) + 1
    gap = float(np.mean(np.diff(z[lowest])))
    yield Comparison("half a wave, in our air", "4.25 mm", f"{500.0 * WAVE:.2f} mm")
    yield Comparison(
        "from one trap to the next about a focus, where waves come aslant as well", "", f"{1e3 * gap:.2f} mm"
    )
    for figure, words in (("circle", "a circle of 4 cm"), ("line", "a line of 4 cm, back at once")):
        fastest = escape_speed(figure, 0.05, 2.5)
        yield Comparison(
            f"fastest that a grain of {2e3 * POLYSTYRENE.radius:.1f} mm across is led along {words}",
            "0.72 m/s",
            f"{fastest:.2f} m/s",
        )
    for strength in (STRENGTH, LOUDEST):
        heaviest = _heaviest(strength)
        let_go = _heaviest_let_go(strength, heaviest)
        yield Comparison(
            f"heaviest grain at {strength:g} Pa m: held where the force is greatest; let go in the node",
            "7 g/cm³",
            f"{heaviest / 1000.0:.2g} g/cm³; {let_go / 1000.0:.2g} g/cm³",
        )
    cost = least_time(lambda: still.step(DT), 30) / 16
    yield Comparison(f"one grain, one substep, {2 * model.COUNT} transducers", "", f"{1e6 * cost:.1f} µs")


def _heaviest(strength: float) -> float:
    """kg/m³ at which the strongest force upwards is the weight."""
    levitator = _levitator(0.0, strength=strength)
    x, y = levitator.place
    z = -np.linspace(0.0, 0.5, 401) * 0.5 * WAVE
    low, high = 10.0, 1e5
    for _ in range(40):
        middle = (low * high) ** 0.5
        levitator.set_grain(POLYSTYRENE._replace(density=middle))
        push = levitator.sample(np.stack([np.full_like(z, x), y + z], axis=1))[:, 5]
        low, high = (middle, high) if float(np.max(push)) > 9.81 * levitator.grain.mass else (low, middle)
    return low


def _heaviest_let_go(strength: float, most: float) -> float:
    """kg/m³, up to ``most``, at which a grain that is let go in the node is still there after two seconds."""
    low, high = 10.0, most
    for _ in range(TRIALS):
        middle = (low * high) ** 0.5
        levitator = _levitator(0.0, strength=strength)
        levitator.set_grain(POLYSTYRENE._replace(density=middle))
        for _ in range(480):
            levitator.step(DT)
        stays = np.hypot(*(levitator.positions[0] - levitator.place)) < model.FAR
        low, high = (middle, high) if stays else (low, middle)
    return low


PIXIE_DUST = Paper(
    problem=(
        "Small grains can float in a standing sound wave. Until then they hung in the fixed nodes between "
        "a speaker and a plate. Can many of them be moved together, in any direction, quickly enough that "
        "the eye sees a picture in the air?",
    ),
    idea=(
        "Take arrays of ultrasonic transducers that face each other and can each be given a phase. Where "
        "they are made to arrive together, a standing wave forms. Move that place by the phases alone, and "
        "the traps with the grains in them move along.",
    ),
    steps=(
        Step(
            "Two waves against each other stand still. Every half wave length lies a node of the "
            "pressure; there the potential of a light grain is lowest.",
            draw_standing_wave,
            r"F = 4 \pi a^3 k E (\frac{f_1}{3} + \frac{f_2}{2}) \sin 2 k z",
        ),
        Step(
            "Give each transducer the phase that its distance takes: all waves arrive together in a "
            "focus, some thousand pascal loud.",
            draw_focus,
        ),
        Step(
            "Turn one of two facing rows by half a wave, so that the focus is a node and holds a grain.",
            _draw_node,
        ),
        Step(
            "Move the focus, and renew the phases all the time. The grain follows like a mass on a "
            "spring, with the air's drag; led too fast it is left behind.",
            _draw_heart,
        ),
        Step(
            "With plane waves from four sides the nodes make a lattice, which holds a picture of many "
            "grains.",
            _draw_lattice,
        ),
    ),
    showed=(
        "Grains 4.25 mm apart, placed to 0.5 mm and led at up to 0.72 m/s, of materials up to 7 g/cm³. "
        "They were a screen for a projector, figures drawn in the air and a lattice of points. Hands and "
        "things that were tracked moved them too.",
    ),
    measure=_measure,
    limits=(
        "Ours is the plane through the middle of the arrays: each transducer stands for a column, and "
        "grains do not scatter the sound on to each other. Gor'kov's potential holds for grains much "
        "smaller than the wave. Streaming of the air is left out, so light grains are steadier here than "
        "in a room.",
    ),
    after=(
        "One-sided arrays that make twin, vortex and bottle traps (Marzo and others 2015), and many grains "
        "moved one by one (Marzo and Drinkwater 2019). A grain led at metres a second draws a picture that "
        "the eye sees whole, lit and touchable (Hirayama and others 2019).",
    ),
)
