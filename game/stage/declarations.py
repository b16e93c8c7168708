"""The words in which a scene says what it measures, charts, explains, sounds like and warms up."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from game.arrays import Floats


class Readout(NamedTuple):
    """A measured value: name, value, unit (an SI unit takes prefixes in the picture)."""

    name: str
    value: float
    unit: str = ""


class Table(NamedTuple):
    """Figures of single things, such as the last collisions, in rows of words.

    ``keys``: by which the scene knows each row again. ``room``: rows that there may be. ``help``: what the
    columns are.
    """

    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    keys: tuple[int, ...]
    room: int
    help: str = ""


class Comparison(NamedTuple):
    """What is measured over what is expected, as a story shows it in a corner of its picture.

    measured (n, 2), expected (m, 2): places along the axis below, values. names: of both. unit: of the
    values. over, over_unit: name and unit of the axis below; "" for a mark, one value of each and no places.
    single: each measured value stands for itself and no line leads from one to the next. limit: a value that
    is ruled across both, by its name; the axis then begins near the least value and not at nothing.
    """

    measured: Floats
    expected: Floats
    names: tuple[str, str]
    unit: str = ""
    over: str = ""
    over_unit: str = ""
    single: bool = False
    limit: tuple[str, float] | None = None


class Strip(NamedTuple):
    """A strip chart over the last ten seconds: title, unit, and the readouts (by name) that it draws."""

    title: str
    unit: str
    series: tuple[str, ...]
    exact: tuple[str, ...] = ()  # of these, the ones drawn dashed as a reference
    sometimes: tuple[str, ...] = ()  # of these, the ones that are not always measured
    colors: tuple[str, ...] = ()  # of the series, by their names in the theme; none: the charts' own


class StartLine(NamedTuple):
    """A line of the card that a game is begun with: a parameter, and which of its values can be chosen there.

    options: (value, words). default: the value chosen first. idle: (parameter, value) of another line with
    which this one means nothing; only: that without which it means nothing. instead: the parameter of a
    line in whose place this one stands while that one means nothing.
    """

    parameter: str
    label: str
    about: str
    options: tuple[tuple[str, str], ...]
    default: str
    idle: tuple[str, str] = ("", "")
    instead: str = ""
    only: tuple[str, str] = ("", "")


class Equation(NamedTuple):
    """A line of the help page: what it says, the formula (markup: ui/text/formula.py), its source."""

    title: str
    formula: str
    source: str = ""


class Hint(NamedTuple):
    """Keys or gestures and what they do, for hint bar and help page."""

    keys: tuple[str, ...]
    text: str


class SceneAction(NamedTuple):
    """A named action of a scene, its words, and the key it has unless the settings say otherwise."""

    name: str
    label: str
    key: str


class ToolButton(NamedTuple):
    """A button on the stage: the action that it posts, its sign (see ui/look/icons.py), words, and key.

    chosen: it is the tool in the hand. apart: another group begins with it.
    """

    action: str
    icon: str
    label: str
    key: str = ""
    chosen: bool = False
    apart: bool = False


class Inspected(NamedTuple):
    """A single thing that was clicked: its title, and the parameters that say and set what is its own.

    close: the action that puts its card away. told: a value that is measured all the time, beside the title.
    """

    title: str
    parameters: tuple[str, ...]
    close: str
    told: str = ""


class Sound(NamedTuple):
    """One sound: when (s), its kind (see ui/sound.py), speed of the impact m/s, pan -1 (left) to 1."""

    time: float
    kind: str
    speed: float
    pan: float = 0.0


class Steady(NamedTuple):
    """A sound that goes on: its kind (see ui/steady.py), loudness 0 to 1, brightness 0 to 1, pan -1 to 1."""

    kind: str
    level: float
    bright: float = 0.5
    pan: float = 0.0


class Hearing(NamedTuple):
    """A line of sounds and a place in it: another ``key`` is another line; ``time`` s runs on by itself.

    steady: what goes on at that moment, each kind and brightness at most once.
    """

    key: object
    time: float
    sounds: Sequence[Sound]
    steady: Sequence[Steady] = ()


class Frame(NamedTuple):
    """The part of the world that a scene wants in view, m (or its own unit)."""

    left: float
    bottom: float
    right: float
    top: float


class WarmUp(NamedTuple):
    """One kernel to compile before a scene opens, and the call that does it."""

    name: str
    call: Callable[[], Any]
