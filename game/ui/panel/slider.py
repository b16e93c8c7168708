"""A number in the panel: dragged along a track, typed into a field, put back by a double click.

The track is linear or by decades, in whole numbers or in grains. What is typed goes through the parameter's
own check and is refused with its message, the old value staying.
"""

from __future__ import annotations

import math

import pygame

from game.stage import Param, ParameterError, SetParameter
from game.ui.look.look import Look
from game.ui.look.numerals import NARROW_SPACE, Quantity, format_number, quantity
from game.ui.look.shapes import draw_box, draw_disc
from game.ui.panel.rows import DOUBLE_CLICK_S, Context, Row, Source, draw_changed
from game.ui.widgets.wishes import Wish

_FACTORS = {"G": 1e9, "M": 1e6, "k": 1e3, "": 1.0, "m": 1e-3, "µ": 1e-6, "n": 1e-9, "p": 1e-12}
UNIT_INSET, NUMBER_GAP = 32, 10  # design px: the unit from the right edge, the number from the unit
_MANY = 272  # places on a track at scale 1


def value_at(parameter: Param, share: float, ends: tuple[float, float] | None = None) -> float:
    """The value ``share`` (0 to 1) along the track, rounded to the parameter's grain or to a neat number.

    ``ends``: the part of the range that the track spans, else all of it.
    """
    share = min(max(share, 0.0), 1.0)
    low, high = _ends(parameter, ends)
    if parameter.log:
        value = low * (high / low) ** share
        if parameter.step is None:
            value = float(f"{value:.2e}")
    else:
        value = low + share * (high - low)
        if parameter.step is None:
            grain = 10.0 ** math.floor(math.log10((high - low) / _MANY))
            value = float(f"{round(value / grain) * grain:.12g}")
    if parameter.step is not None:
        base = low if not parameter.log else 0.0
        value = float(f"{base + round((value - base) / parameter.step) * parameter.step:.12g}")
    return min(max(value, low), high)


def share_of(parameter: Param, value: float, ends: tuple[float, float] | None = None) -> float:
    """How far along the track a value is, 0 to 1; ``ends`` as in `value_at`."""
    low, high = _ends(parameter, ends)
    if parameter.log:
        share = math.log(max(value, low) / low) / math.log(high / low)
    else:
        share = (value - low) / (high - low)
    return min(max(share, 0.0), 1.0)


def _ends(parameter: Param, ends: tuple[float, float] | None) -> tuple[float, float]:
    """Both ends of a track within the parameter's range."""
    if ends is None:
        return parameter.minimum, parameter.maximum
    low, high = max(ends[0], parameter.minimum), min(ends[1], parameter.maximum)
    return (low, high) if low < high else (parameter.minimum, parameter.maximum)


def shown_value(parameter: Param, value: float) -> Quantity:
    """Number and unit as the panel writes them: whole, with the grain's decimals, or three digits.

    A linear parameter with a grain whose range reaches one of its unit keeps that unit all along its way.
    """
    if parameter.whole:
        return Quantity(format_number(int(value)), parameter.unit)
    number, unit = quantity(value, parameter.unit)
    if (
        parameter.step is not None
        and not parameter.log
        and parameter.step >= 1e-3
        and 1.0 <= parameter.maximum < 1e3
    ):
        unit = parameter.unit
    if parameter.step is not None and unit == parameter.unit and 1e-6 < parameter.step < 1e6:
        decimals = _decimals(parameter.step, parameter.minimum)
        sign = "−" if round(value, decimals) < 0 else ""
        whole, point, fraction = f"{abs(value):.{decimals}f}".partition(".")
        number = sign + f"{int(whole):,}".replace(",", NARROW_SPACE) + point + fraction
    return Quantity(number, unit)


def _decimals(step: float, minimum: float) -> int:
    """Decimals in which every place of a grain can be written, at most 6."""
    for decimals in range(6):
        if all(abs(round(x, decimals) - x) < 1e-9 for x in (step, minimum)):
            return decimals
    return 6


def read_value(parameter: Param, text: str, shown_unit: str) -> float:
    """The value of typed words; a unit may follow the number, else the one shown is meant.

    Raises ParameterError for what is no number or outside the parameter's range.
    """
    words = text.strip().replace(NARROW_SPACE, "").replace(" ", "").replace("−", "-").replace("μ", "µ")
    for prefix, factor in _FACTORS.items():
        unit = prefix + parameter.unit
        if parameter.unit and words.endswith(unit) and words[: -len(unit)][-1:].isdigit():
            return _checked(parameter, _number(parameter, words[: -len(unit)]), factor, unit)
    factor = _FACTORS.get(shown_unit.removesuffix(parameter.unit), 1.0) if parameter.unit else 1.0
    return _checked(parameter, _number(parameter, words), factor, shown_unit)


def _checked(parameter: Param, number: float, factor: float, unit: str) -> float:
    """A number that was typed in a unit worth so many of the parameter's; what is refused is told in it."""
    value = number * factor
    if math.isfinite(value) and not parameter.minimum <= value <= parameter.maximum:
        low, high = parameter.minimum / factor, parameter.maximum / factor
        typed = f"{number:.6g} {unit}".rstrip()
        words = f"{parameter.label}: {typed} is outside {low:.6g} to {high:.6g} {unit}"
        raise ParameterError(words.rstrip().replace("-", "−"))
    return parameter.check(value)


def _number(parameter: Param, words: str) -> float:
    try:
        number = float(words.replace(",", "."))
    except ValueError:
        raise ParameterError(f"{parameter.label}: {words!r} is not a number") from None
    return (
        int(number) if parameter.whole and number == math.floor(number) and math.isfinite(number) else number
    )


class SliderRow(Row):
    """Label, value, unit and track of one Param."""

    height = 40

    def __init__(self, context: Context, top: int, parameter: Param, source: Source) -> None:
        self.parameter = parameter
        self.source = source
        low, high = (
            " ".join(shown_value(parameter, v)).strip() for v in (parameter.minimum, parameter.maximum)
        )
        self.tip = (f"{parameter.help}\n" if parameter.help else "") + f"{low} to {high}"
        self.typed = False  # the panel's text field is over the value
        self.wants_field = False
        self._pending: float | None = None  # dragged to, not yet sent: the scene would be built again
        self._dragging = False
        self._click_age_s, self._click_at = math.inf, (0.0, 0.0)
        self._over_value = False
        super().__init__(context, top, parameter.name)

    @property
    def value(self) -> float:
        """The value shown."""
        return self._pending if self._pending is not None else self.source.values[self.parameter.name]

    def _range(self) -> tuple[float, float] | None:
        """What the track spans now, if not the whole range."""
        return self.source.scene.slider_range(self.parameter.name)

    def _unit_x(self) -> int:
        """Where the unit begins: 32 design px from the edge, or more for a long one."""
        unit = shown_value(self.parameter, self.value).unit
        width = self.look.fonts.size(unit, 13)[0] if unit else 0
        return self.right - max(self.look.px(UNIT_INSET), width)

    def _number_right(self) -> int:
        return self._unit_x() - self.look.px(NUMBER_GAP)

    def value_rect(self) -> pygame.Rect:
        """Where the number stands, window px in the row."""
        px = self.look.px
        width = max(
            self.look.fonts.size(shown_value(self.parameter, self.value).number, 13, "semibold")[0], px(24)
        )
        rect = pygame.Rect(0, px(-2), width + 2 * px(6), px(24))
        rect.right = self._number_right() + px(6)
        return rect

    def field_rect(self) -> pygame.Rect:
        """Where the text field goes, window px in the panel's sheet."""
        px = self.look.px
        return pygame.Rect(self._number_right() - px(84), self.rect.y - px(2), px(92), px(25))

    def advance(self, dt_s: float) -> bool:
        self._click_age_s += dt_s
        was_over, self._over_value = self._over_value, False
        if self.hovered:
            x, y = self.context.manager.get_mouse_position()
            self._over_value = self.value_rect().collidepoint(x - self.rect.x, y - self.rect.y)
        waits = self._click_age_s < DOUBLE_CLICK_S  # for a second click
        return waits or self._over_value != was_over

    def shows(self) -> tuple[object, ...]:
        return (self.value, self._range(), self.typed, self._over_value, self._dragging)

    def press(self, x: float, y: float) -> None:
        near = max(abs(x - self._click_at[0]), abs(y - self._click_at[1])) <= self.look.px(4)
        if near and self._click_age_s < DOUBLE_CLICK_S:
            self._click_age_s = math.inf
            self._pending = None
            self._send(self.source.base(self.parameter))
            return
        if self.value_rect().collidepoint(x, y):
            self.wants_field = True
            return
        self._click_age_s, self._click_at = 0.0, (x, y)
        if y >= self.look.px(18):
            self._dragging = True
            self.drag(x, y)

    def drag(self, x: float, y: float) -> None:
        if not self._dragging:
            return
        start, end = self.left + self.look.px(8), self.right - self.look.px(8)
        value = value_at(self.parameter, (x - start) / max(end - start, 1), self._range())
        if self.parameter.rebuild:
            self._pending = value
        elif value != self.source.values[self.parameter.name]:
            self._send(value)

    def release(self, x: float, y: float) -> None:
        self._dragging = False
        if self._pending is not None:
            pending, self._pending = self._pending, None
            if pending != self.source.values[self.parameter.name]:
                self._send(pending)

    def cancel(self) -> None:
        """Forget a drag that has not been sent."""
        self._dragging = self.held = False
        self._pending = None

    def key(self, key: int) -> None:
        if key in (pygame.K_RETURN, pygame.K_KP_ENTER):
            self.wants_field = True
            return
        direction = {pygame.K_LEFT: -1, pygame.K_RIGHT: 1}.get(key, 0)
        if direction:
            here, ends = self.source.values[self.parameter.name], self._range()
            if ends is not None and not ends[0] <= here <= ends[1]:
                ends = None  # a value that was typed goes on from where it is
            for places in (1, 2, 4, 8, 16, 32, 64, 128, 256):  # until a coarse grain moves
                share = share_of(self.parameter, here, ends) + direction * places / _MANY
                value = value_at(self.parameter, share, ends)
                if value != here:
                    self._send(value)
                    return

    def type(self, text: str) -> None:
        """Take over what was typed, or say why not."""
        try:
            value = read_value(self.parameter, text, shown_value(self.parameter, self.value).unit)
        except ParameterError as error:
            self.context.send(Wish("refused", str(error)))
            return
        if value != self.source.values[self.parameter.name]:
            self._send(value)

    def _send(self, value: float) -> None:
        self.context.send(SetParameter(self.parameter.name, int(value) if self.parameter.whole else value))

    def paint(self, surface: pygame.Surface) -> None:
        look, px, y = self.look, self.look.px, self.look.px(10)
        number, unit = shown_value(self.parameter, self.value)
        if self._over_value and not self.typed:
            draw_box(surface, self.value_rect(), px(6), look.theme.inset, look.theme.line, look.border)
        if not self.typed:
            look.text(surface, number, (self._number_right(), y), 13, "semibold", "text1", "right")
        look.text(surface, unit, (self._unit_x(), y), 13, "medium", "text3")
        space = self.value_rect().x - self.left
        look.text(
            surface,
            look.fonts.fit(self.parameter.label, 13, "medium", space),
            (self.left, y),
            13,
            "medium",
            "text2",
        )
        if self.value != self.source.base(self.parameter):
            draw_changed(surface, look, y)
        share = share_of(self.parameter, self.value, self._range())
        draw_track(surface, look, self.left, self.right, px(30), share, self._grip())

    def _grip(self) -> float:
        return 1.0 if self._dragging else self._lit.amount * (0.0 if self._over_value else 1.0)


def draw_track(
    surface: pygame.Surface, look: Look, left: int, right: int, y: int, share: float, lit: float
) -> None:
    """A track filled to ``share`` with its ivory parameter."""
    theme, px = look.theme, look.px
    track = pygame.Rect(left, 0, right - left, px(4))
    track.centery = y
    draw_box(surface, track, track.h / 2, theme.hover)
    x = left + px(8) + share * (right - left - 2 * px(8))
    filled = track.copy()
    filled.w = max(round(x - left), 1)
    draw_box(surface, filled, track.h / 2, theme.accent)
    ring = (theme.bg if theme.name == "dark" else theme.line2).lerp(theme.accent, lit)
    center = (x, track.y + track.h / 2)
    draw_disc(surface, center, 8.0 * look.k, theme.knob, ring, max(1.0, look.k))
