"""Rows of the panel: controls that live in pygame_gui's tree and paint themselves.

A row is as wide as the panel. It repaints only when what it shows has changed, and says what a person did by
sending a stage event or a command. It never changes a value itself, but follows the scene's.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import pygame
from pygame_gui import UIManager
from pygame_gui.core import UIElement

from game.stage import Choice, Parameter, Scene, SetParameter, StageEvent
from game.ui.look import motion
from game.ui.look.look import Look
from game.ui.look.numerals import quantity
from game.ui.look.shapes import draw_box, draw_disc
from game.ui.widgets.wishes import Wish

PADDING = 16  # design px
DOUBLE_CLICK_S = 0.35
LOCKED = "Locked by this level."
VEIL = 150  # of 255: the panel's colour over a row that changes nothing


def effect_key(name: str) -> str:
    """By which the row of an effect is known among those of parameters."""
    return f"effect {name}"


class Context(NamedTuple):
    """What rows share: manager, appearance, width in window px, and where wishes go."""

    manager: UIManager
    look: Look
    width: int
    send: Callable[[StageEvent | Wish], None]


class Source:
    """The scene that a panel shows; another scene of the same type may take its place."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene

    @property
    def values(self) -> dict[str, Any]:
        """Present values of the parameters."""
        return self.scene.values

    def base(self, parameter: Parameter[Any]) -> Any:
        """What a parameter goes back to: the level's value, or its default."""
        level = self.scene.level
        return parameter.default if level is None else level.parameters.get(parameter.name, parameter.default)

    def changed(self, parameter: Parameter[Any]) -> bool:
        """Whether a parameter is not at its base."""
        return bool(self.scene.values[parameter.name] != self.base(parameter))

    def idle(self) -> dict[str, str]:
        """Why parameters change nothing as the scene stands, by their names: those that do not act alone."""
        reasons = {name: self.scene.why_idle(name) for name in self.scene.values}
        level = self.scene.level
        if level is not None and level.teaching is not None:
            reasons |= dict.fromkeys(level.teaching.fixed, LOCKED)
            reasons |= {effect_key(name): LOCKED for name in level.teaching.locked_effects}
        return {name: reason for name, reason in reasons.items() if reason}


class Row(UIElement):
    """A row at a height of the panel; subclasses say what they show and how it is painted."""

    height = 24  # design px
    tip = ""

    def __init__(self, context: Context, top: int, follows: str = "") -> None:
        """``follows``: name of the parameter that it shows, if any."""
        self.context = context
        self.follows = follows
        self.idle = ""  # why it changes nothing now: shown grey, and taking no hand
        self.look = context.look
        self.held = False
        self.has_keys = False  # the keyboard focus, which a press of the mouse never gives
        self._lit = motion.Fade(0.0 if self.look.less_motion else motion.HOVER_S)
        self._shown: tuple[object, ...] | None = None
        self.stale = True  # what it shows may have changed
        self.moves = True  # something on it slides or fades
        super().__init__(
            pygame.Rect(0, top, context.width, self.look.px(self.height)), context.manager, None,
            starting_height=1, layer_thickness=1, element_id=["row"],
        )  # fmt: skip

    # -- for subclasses -----------------------------------------------------------------------------

    def shows(self) -> tuple[object, ...]:
        """All that the picture depends on."""
        return ()

    def paint(self, surface: pygame.Surface) -> None:
        """Paint on a surface filled with the panel's colour."""
        raise NotImplementedError

    def press(self, x: float, y: float) -> None:
        """The pointer went down here (window px in the row)."""

    def drag(self, x: float, y: float) -> None:
        """It moved while down."""

    def release(self, x: float, y: float) -> None:
        """It came up."""

    def cancel(self) -> None:
        """Forget what is being dragged."""

    def key(self, key: int) -> None:
        """A key while the row has the keyboard focus."""

    def advance(self, dt_s: float) -> bool:
        """Let time pass; True while something moves by itself."""
        return False

    # -- pygame_gui ---------------------------------------------------------------------------------

    def process_event(self, event: pygame.event.Event) -> bool:
        """Follow the pointer from press to release."""
        if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1 and self.rect.collidepoint(event.pos):
            if self.idle:
                return True
            self.held = True
            self.press(event.pos[0] - self.rect.x, event.pos[1] - self.rect.y)
            return True
        if self.held and event.type == pygame.MOUSEMOTION:
            self.drag(event.pos[0] - self.rect.x, event.pos[1] - self.rect.y)
            return True
        if self.held and event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            self.held = False
            self.release(event.pos[0] - self.rect.x, event.pos[1] - self.rect.y)
            return True
        return False

    def update(self, time_delta: float) -> None:
        """Let hover light and slides move on, and repaint if anything shown has changed."""
        lights = self._lit.update(time_delta, self.hovered and not self.idle)
        self.moves = self.advance(time_delta) or lights
        if not (self.moves or self.stale or self.hovered or self.held):
            return
        self.stale = False
        wanted = (*self.shows(), self._lit.amount, self.has_keys, bool(self.idle))
        if wanted != self._shown:
            self._shown = wanted
            surface = pygame.Surface(self.rect.size, pygame.SRCALPHA, 32)
            surface.fill(self.look.theme.panel)
            self.paint(surface)
            if self.idle:
                veil = pygame.Surface(surface.get_size(), pygame.SRCALPHA, 32)
                veil.fill((*self.look.theme.panel[:3], VEIL))
                surface.blit(veil, (0, 0))
            if self.has_keys:
                inside = surface.get_rect().inflate(-2 * self.look.px(6), 0)
                draw_box(
                    surface, inside, self.look.px(6), None, self.look.theme.accent, max(1, self.look.px(1))
                )
            self._set_image(surface)

    @property
    def left(self) -> int:
        """Left edge of the content, window px."""
        return self.look.px(PADDING)

    @property
    def right(self) -> int:
        """Right edge of the content."""
        return self.rect.w - self.look.px(PADDING)


class Heading(Row):
    """A section's name, and a word about it at the right."""

    height = 32

    def __init__(self, context: Context, top: int, title: str) -> None:
        self.title = title
        self.note = ""
        super().__init__(context, top)

    def shows(self) -> tuple[object, ...]:
        return (self.title, self.note)

    def paint(self, surface: pygame.Surface) -> None:
        y = self.look.px(17)
        self.look.text(surface, self.title, (self.left, y), 12, "semibold")
        if self.note:
            self.look.text(surface, self.note, (self.right, y), 12, "medium", "text3", "right")


class Caption(Row):
    """The name of a choice that stands below it."""

    height = 24

    def __init__(self, context: Context, top: int, parameter: Parameter[Any], source: Source) -> None:
        self.parameter = parameter
        self.tip = parameter.help
        self.source = source
        super().__init__(context, top, parameter.name)

    def shows(self) -> tuple[object, ...]:
        return (self.source.changed(self.parameter),)

    def paint(self, surface: pygame.Surface) -> None:
        y = self.look.px(10)
        self.look.text(surface, self.parameter.label, (self.left, y), 13, "medium", "text2")
        if self.source.changed(self.parameter):
            draw_changed(surface, self.look, y)


class Measure(Row):
    """A measured value that the top bar has no space for."""

    def __init__(self, context: Context, top: int, name: str) -> None:
        self.name = name
        self.value: float = 0.0  # an int is a count and shown whole
        self.unit = ""
        super().__init__(context, top)

    def shows(self) -> tuple[object, ...]:
        return tuple(quantity(self.value, self.unit))

    def paint(self, surface: pygame.Surface) -> None:
        y = self.look.px(10)
        number, unit = quantity(self.value, self.unit)
        words = number if unit in ("", "°") else f"{number} {unit}"
        words += unit if unit == "°" else ""
        taken = self.look.text(surface, words, (self.right, y), 13, "semibold", "text1", "right").w
        space = self.right - taken - self.look.px(12) - self.left
        name = self.look.fonts.fit(self.name[:1].upper() + self.name[1:], 13, "medium", max(space, 0))
        self.look.text(surface, name, (self.left, y), 13, "medium", "text2")


class SegmentsRow(Row):
    """Up to three short options side by side; the chosen one filled."""

    height = 40

    def __init__(self, context: Context, top: int, parameter: Choice, source: Source) -> None:
        self.parameter = parameter
        self.tip = parameter.help
        self.source = source
        self._place = float(self._index())
        self._under = -1
        super().__init__(context, top, parameter.name)

    def _index(self) -> int:
        return self.parameter.options.index(self.source.values[self.parameter.name])

    def _tray(self) -> pygame.Rect:
        return pygame.Rect(self.left, 0, self.right - self.left, self.look.px(32))

    def _segment_at(self, x: float, y: float) -> int:
        tray = self._tray()
        if not tray.collidepoint(x, y):
            return -1
        return min(int((x - tray.x) / tray.w * len(self.parameter.options)), len(self.parameter.options) - 1)

    def advance(self, dt_s: float) -> bool:
        gap = self._index() - self._place
        under = self._under
        if self.look.less_motion or abs(gap) < 0.01:
            self._place = float(self._index())
        else:
            self._place += gap * min(1.0, dt_s * 4.0 / motion.SEGMENT_S)
        x, y = self.context.manager.get_mouse_position()
        self._under = self._segment_at(x - self.rect.x, y - self.rect.y) if self.hovered else -1
        return gap != 0.0 or under != self._under

    def shows(self) -> tuple[object, ...]:
        return (self._index(), self._place, self._under)

    def release(self, x: float, y: float) -> None:
        i = self._segment_at(x, y)
        if i >= 0 and i != self._index():
            self.context.send(SetParameter(self.parameter.name, self.parameter.options[i]))

    def key(self, key: int) -> None:
        i = self._index() + {pygame.K_LEFT: -1, pygame.K_RIGHT: 1}.get(key, 0)
        if i != self._index() and 0 <= i < len(self.parameter.options):
            self.context.send(SetParameter(self.parameter.name, self.parameter.options[i]))

    def paint(self, surface: pygame.Surface) -> None:
        look, theme, px = self.look, self.look.theme, self.look.px
        tray = self._tray()
        draw_box(surface, tray, px(8), theme.inset)
        inner = tray.inflate(-2 * px(2), -2 * px(2))
        width = inner.w / len(self.parameter.options)
        if self._under >= 0 and self._under != self._index():
            hovered = pygame.Rect(round(inner.x + self._under * width), inner.y, round(width), inner.h)
            draw_box(surface, hovered, px(6), theme.hover)
        chosen = pygame.Rect(round(inner.x + self._place * width), inner.y, round(width), inner.h)
        draw_box(surface, chosen, px(6), theme.accent)
        for i, label in enumerate(self.parameter.labels):
            center = (inner.x + (i + 0.5) * width, inner.centery)
            lit = abs(i - self._place) < 0.5
            color = theme.on_accent if lit else theme.text1 if i == self._under else theme.text2
            label = look.fonts.fit(label, 12, "medium", round(width) - px(4))
            look.text(surface, label, center, 12, "medium", color, "center")


def fits_in_segments(look: Look, parameter: Choice, width: int) -> bool:
    """Whether the options are few and short enough to stand side by side."""
    space = (width - 2 * look.px(PADDING)) / max(len(parameter.options), 1) - look.px(12)
    return 2 <= len(parameter.options) <= 3 and all(
        look.fonts.size(label, 12)[0] <= space for label in parameter.labels
    )


def draw_changed(surface: pygame.Surface, look: Look, y: float) -> None:
    """The amber dot of a value that is not its default."""
    draw_disc(surface, (look.px(8), y), 2.6 * look.k, look.color("amber"))
