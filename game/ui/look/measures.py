"""Measures of the layout at an interface scale k; a design unit is k window pixels."""

from __future__ import annotations

import math
from dataclasses import dataclass


def auto_scale(window_height: int) -> float:
    """Interface scale for a window of that many pixels of height: 1, 1.25, 1.5 or 2."""
    for least, k in ((1600, 2.0), (1200, 1.5), (900, 1.25)):
        if window_height >= least:
            return k
    return 1.0


@dataclass(frozen=True)
class Metrics:
    """Measures of the layout in window pixels at scale k; ``px(x)`` scales any other design measure."""

    k: float
    border: int  # width of outlines: 1 px until k = 1.5
    unit: int  # 8 design px
    top_bar: int
    panel: int
    panel_padding: int
    panel_content: int
    strip: int
    gutter: int
    hint_bar: int
    button: int
    play_button: int
    icon: int
    readout: int  # width of one readout column in the top bar
    slider_row: int
    slider_track_y: int  # centre of the track in its row
    slider_track: int
    knob: int
    effect_row: int
    switch_width: int
    switch_height: int
    key_cap: int
    toast: int
    menu_margin: int
    menu_header: int
    menu_row: int
    menu_footer: int
    card: int
    card_gap: int
    overlay: int
    overlay_padding: int
    overlay_clearance: int
    table_margin_y: int
    table_margin_x: int
    stage_margin: int
    radius_key: int
    radius_field: int
    radius_button: int
    radius_toast: int
    radius_card: int
    radius_overlay: int

    def px(self, x: float) -> int:
        """A design measure in whole window pixels."""
        return round(x * self.k)


def metrics(k: float) -> Metrics:
    """The layout's measures at interface scale k (0.5 to 4); ValueError outside."""
    if not (math.isfinite(k) and 0.5 <= k <= 4.0):
        raise ValueError(f"metrics: scale {k!r} is not between 0.5 and 4")
    design = {
        "unit": 8, "top_bar": 48, "panel": 320, "panel_padding": 16, "panel_content": 288, "strip": 128,
        "gutter": 16, "hint_bar": 32, "button": 32, "play_button": 36, "icon": 32, "readout": 76,
        "slider_row": 40, "slider_track_y": 28, "slider_track": 4, "knob": 16, "effect_row": 32,
        "switch_width": 32, "switch_height": 18, "key_cap": 20, "toast": 40, "menu_margin": 32,
        "menu_header": 80, "menu_row": 200, "menu_footer": 40, "card": 160, "card_gap": 16, "overlay": 1056,
        "overlay_padding": 32, "overlay_clearance": 48, "table_margin_y": 56, "table_margin_x": 80,
        "stage_margin": 20, "radius_key": 4, "radius_field": 6, "radius_button": 8, "radius_toast": 10,
        "radius_card": 12, "radius_overlay": 16,
    }  # fmt: skip
    return Metrics(k=k, border=border_width(k), **{name: round(x * k) for name, x in design.items()})


def border_width(k: float) -> int:
    """Width of an outline: hairlines stay 1 px until k = 1.5."""
    return max(1, math.floor(k + 0.5))
