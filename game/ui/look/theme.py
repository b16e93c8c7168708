"""Colours of the interface: a dark and a light theme on one set of names.

One accent (chalk blue), one marker (amber: here, now, touched, changed), ivory or ink for what is measured.
Contrast of the text colours on every surface colour is at least 4.5 to 1. The data colours are Okabe and
Ito's hues (2008) with their lightness spread, so that they stay apart in all three dichromacies. Each also
has a marker shape, because colour never speaks alone.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, fields
from typing import Any, NamedTuple

import pygame

from game.ui.look.assets import asset
from game.ui.look.measures import Metrics, auto_scale, border_width, metrics

__all__ = [
    "BALL_COLORS",
    "BALL_WHITE",
    "CAROM_COLORS",
    "CAROM_SPOT",
    "CUE_BALL",
    "CUE_BALL_SPOT",
    "CUE_CHALK",
    "DARK",
    "FELT",
    "FELT_BLUE",
    "FELT_COOL",
    "FELT_GREEN",
    "FELT_LINE",
    "FELT_OLIVE",
    "FELT_SLATE",
    "FELT_WARM",
    "INLAY",
    "LIGHT",
    "POCKET_RING",
    "SERIES",
    "SNOOKER_COLORS",
    "THEMES",
    "WOOD_DARK",
    "WOOD_LIGHT",
    "DataColor",
    "Metrics",
    "Series",
    "Theme",
    "auto_scale",
    "gui_theme",
    "metrics",
    "mix",
    "theme_named",
]

Color = pygame.Color


class DataColor(NamedTuple):
    """A colour of data: for marks and lines, and (lighter or darker) for words about them."""

    mark: pygame.Color
    text: pygame.Color


class Series(NamedTuple):
    """How the n-th series of a plot is told from the others."""

    color: str  # name of a DataColor of Theme
    marker: str  # disc, triangle-down, square, diamond, triangle-up, plus, ring


SERIES = (
    Series("chalk", "disc"),
    Series("pink", "triangle-down"),
    Series("green", "square"),
    Series("violet", "diamond"),
    Series("vermilion", "triangle-up"),
    Series("yellow", "plus"),
    Series("amber", "ring"),
)


@dataclass(frozen=True, eq=False)
class Theme:
    """Every colour of the interface by its role."""

    name: str
    bg: Color  # window, hint bar
    stage: Color  # world, plots, formula boxes
    panel: Color  # top bar, panel, strips, cards, overlays
    inset: Color  # fields, buttons, segment tray
    hover: Color  # hovered, empty track, switch off
    line: Color  # dividers
    line2: Color  # outlines of controls
    grid: Color  # grid of the stage
    grid2: Color  # decades of a plot
    text1: Color  # values, titles
    text2: Color  # labels
    text3: Color  # captions
    accent: Color  # interactive, focus
    on_accent: Color  # text on accent
    accent_soft: Color  # selected row, id chip, active player
    body: Color  # fill of bodies
    ghost: Color  # unimportant geometry
    scrim: Color  # under overlays, with its alpha
    knob: Color  # slider and switch knobs
    slow: Color  # particles at rest
    fast: Color  # particles at top speed
    chalk: DataColor
    amber: DataColor
    green: DataColor
    vermilion: DataColor
    pink: DataColor
    violet: DataColor
    yellow: DataColor
    ink_on_amber: Color  # text on an amber chip

    @property
    def ink(self) -> Color:
        """What is measured: ivory on dark, ink on light."""
        return self.text1

    def data(self, name: str) -> DataColor:
        """A data colour by name; ValueError if there is none."""
        found = getattr(self, name, None)
        if not isinstance(found, DataColor):
            raise ValueError(f"theme: no data colour {name!r}")
        return found

    def series(self, i: int) -> tuple[DataColor, str]:
        """Colour and marker of the i-th series; they repeat after seven."""
        row = SERIES[i % len(SERIES)]
        return self.data(row.color), row.marker


def _pair(mark: str, text: str | None = None) -> DataColor:
    return DataColor(Color("#" + mark), Color("#" + (text or mark)))


DARK = Theme(
    name="dark",
    bg=Color("#0E1317"),
    stage=Color("#11181D"),
    panel=Color("#171E24"),
    inset=Color("#1F2830"),
    hover=Color("#2A353F"),
    line=Color("#2B3640"),
    line2=Color("#5C6C79"),
    grid=Color("#1A2329"),
    grid2=Color("#222D34"),
    text1=Color("#ECE8DE"),
    text2=Color("#B8BFC4"),
    text3=Color("#96A1AA"),
    accent=Color("#5FBAF9"),
    on_accent=Color("#0B1216"),
    accent_soft=Color("#1C3547"),
    body=Color("#25323B"),
    ghost=Color("#6F7B84"),
    scrim=Color(0x06, 0x09, 0x0B, round(0.62 * 255)),
    knob=Color("#F4EDE0"),
    slow=Color("#E8F3FB"),
    fast=Color("#2788DC"),
    chalk=_pair("5FBAF9"),
    amber=_pair("FB9F17"),
    green=_pair("1AAF93", "2DB99E"),
    vermilion=_pair("E2601A", "F0793B"),
    pink=_pair("F9B3CE"),
    violet=_pair("8B7BE8", "A295F0"),
    yellow=_pair("F1EE92"),
    ink_on_amber=Color("#14100A"),
)

LIGHT = Theme(
    name="light",
    bg=Color("#E9E5DC"),
    stage=Color("#FBFAF6"),
    panel=Color("#F3F0E9"),
    inset=Color("#E6E1D7"),
    hover=Color("#DAD4C8"),
    line=Color("#D8D2C5"),
    line2=Color("#868A89"),
    grid=Color("#F0EDE6"),
    grid2=Color("#E5E1D8"),
    text1=Color("#1A232A"),
    text2=Color("#3A4650"),
    text3=Color("#515C65"),
    accent=Color("#085F9F"),
    on_accent=Color("#FFFFFF"),
    accent_soft=Color("#CFE3F2"),
    body=Color("#E3E7E8"),
    ghost=Color("#8B8F8E"),
    scrim=Color(0x2B, 0x2A, 0x26, round(0.42 * 255)),
    knob=Color("#FFFFFF"),
    slow=Color("#A9CDEB"),
    fast=Color("#0A4A82"),
    chalk=_pair("0285DA", "085F9F"),
    amber=_pair("C77C00", "8A5600"),
    green=_pair("0D7153"),
    vermilion=_pair("B44D09", "A84607"),
    pink=_pair("AE5A85", "9A4873"),
    violet=_pair("553B97"),
    yellow=_pair("483C04"),
    ink_on_amber=Color("#14100A"),
)

THEMES = {theme.name: theme for theme in (DARK, LIGHT)}

# The billiard table keeps its colours in both themes.
FELT = Color("#1E6E66")
FELT_GREEN = Color("#1F6444")  # of snooker
FELT_BLUE = Color("#1F4F80")  # of carom; the three inks are legible on it too
FELT_OLIVE, FELT_SLATE = Color("#4F5A2A"), Color("#4A4F57")  # cloths that a career unlocks
FELT_LINE = Color("#F4EDE0")  # on felt only these three are legible: 5.2 to 1,
FELT_WARM = Color("#FFC05A")  # 3.7,
FELT_COOL = Color("#8CBBFF")  # 3.1
WOOD_DARK = Color("#4B2E21")
WOOD_LIGHT = Color("#6B4430")
INLAY = Color("#E9E2D2")
POCKET_RING = Color("#C2A878")
CUE_CHALK = Color("#3E8FD0")
BALL_WHITE = Color("#F7F1E4")  # ground of the stripes and of the number disc
CUE_BALL = Color("#F5EEE1")
CUE_BALL_SPOT = Color("#9E2112")
_SOLIDS = ("FBD662", "2A7BEE", "D2290F", "4B1F88", "F2700F", "35A57A", "700C14")
BALL_COLORS = (
    CUE_BALL,
    *(Color("#" + c) for c in _SOLIDS),
    Color("#15191E"),
    *(Color("#" + c) for c in _SOLIDS),
)  # by number: 0 the cue ball, 1 to 7 solid, 8 black, 9 to 15 striped


CAROM_COLORS = (CUE_BALL, Color("#F3BE2C"), Color("#BE1E16"))  # white, yellow, red
SNOOKER_COLORS = tuple(
    Color("#" + c) for c in ("BE1A1C", "F4C62F", "12924E", "7A431F", "1F63CC", "F193AB", "17191D")
)  # red, yellow, green, brown, blue, pink, black
CAROM_SPOT = Color("#F1DCC8")  # of the red ball; the others have those of a cue ball


def theme_named(name: str) -> Theme:
    """The theme called ``dark`` or ``light``; ValueError for any other name."""
    try:
        return THEMES[name]
    except KeyError:
        raise ValueError(f"theme: {name!r} is not one of {', '.join(THEMES)}") from None


def color_names(theme: Theme) -> list[str]:
    """What `Look.color` and a scene's canvas take as the name of a colour."""
    found = ((field.name, getattr(theme, field.name)) for field in fields(theme))
    return [name for name, value in found if isinstance(value, Color | DataColor)]


def mix(a: Color, b: Color, t: float) -> Color:
    """Colour on the way from a (t = 0) to b (t = 1), channel by channel, alpha too."""
    return a.lerp(b, min(1.0, max(0.0, t)))


# Entries of pygame_gui's "misc" blocks that are lengths in design pixels; "padding" is a pair of them.
_LENGTHS = frozenset(
    {
        "list_item_height",
        "open_button_width",
        "rect_width",
        "shadow_width",
        "shape_corner_radius",
        "sliding_button_width",
        "text_horiz_alignment_padding",
        "title_bar_height",
    }
)


def gui_theme(theme: Theme, k: float) -> dict[str, Any]:
    """pygame_gui's theme dictionary with its sizes, widths, radii and paddings multiplied by k."""
    blocks: dict[str, Any] = json.loads(asset("theme", f"{theme.name}.json").read_text(encoding="utf-8"))
    for block in blocks.values():
        if "font" in block:
            block["font"]["size"] = str(round(int(block["font"]["size"]) * k))
        misc = block.get("misc", {})
        for key, value in misc.items():
            if key in _LENGTHS:
                misc[key] = str(round(int(value) * k))
            elif key == "padding":
                misc[key] = ",".join(str(round(int(part) * k)) for part in value.split(","))
            elif key == "border_width":
                width = int(value)
                misc[key] = str(border_width(k) if width == 1 else round(width * k))
    return blocks
