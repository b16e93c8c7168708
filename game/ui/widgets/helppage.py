"""The help page of a scene, made from its declarations: what you see, equations, controls, what to try.

Three columns side by side, or fewer below each other in a narrow window; what does not fit scrolls.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Sequence

import pygame

from game.stage import Equation, Scene
from game.ui.canvas.pen import FIGURE, Pen
from game.ui.look.look import Look
from game.ui.look.shapes import box, draw_box, draw_disc
from game.ui.text.formula import FormulaError, render_formula
from game.ui.widgets import keycap
from game.ui.widgets.hotspots import Hotspots
from game.ui.widgets.overlay import Overlay, draw_close
from game.ui.widgets.wishes import Wish

HEIGHT, HEAD, PADDING = 624, 72, 32  # design px
COLUMNS = ((296, 0), (344, 336), (280, 712))  # width and left edge of the columns side by side
LINE, WHEEL = 20, 48
KeyRow = tuple[Sequence[str], str]


def paragraphs_of(scene_type: type[Scene]) -> list[str]:
    """The paragraphs of a scene's docstring, each in one line."""
    text = inspect.cleandoc(scene_type.__doc__ or "")
    return [" ".join(part.split()) for part in text.split("\n\n") if part.strip()]


class Column:
    """Writes blocks below each other; without a surface it only measures."""

    def __init__(self, look: Look, surface: pygame.Surface | None, left: int, top: int, width: int) -> None:
        self.look, self.surface = look, surface
        self.left, self.y, self.width = left, top, width

    def head(self, words: str) -> None:
        """A heading; its middle is 16 below the last block."""
        self._text(words, 0, 15, "semibold", "text1", 32)
        self.y += self.look.px(6)

    def paragraph(self, words: str, indent: int = 0, color: str = "text2", size: int = 13) -> None:
        """Lines of text and a gap."""
        px = self.look.px
        for line in self.look.fonts.wrap(words, size, "medium", self.width - px(indent)):
            self._text(line, indent, size, "medium", color, LINE)
        self.y += px(8)

    def equation(self, equation: Equation) -> None:
        """Title and source over the formula in a box; without a title the box follows the last one."""
        look, px = self.look, self.look.px
        if equation.title or equation.source:
            middle = self.y + px(10)
            if self.surface is not None:
                right = self.left + self.width
                taken = look.text(
                    self.surface, equation.source, (right, middle), 12, "medium", "text3", "right"
                ).w
                title = look.fonts.fit(equation.title, 13, "medium", self.width - taken - px(8))
                look.text(self.surface, title, (self.left, middle), 13, "medium", "text2")
            self.y += px(26)
        picture = self._formula(equation.formula)
        height = max(px(48), picture.get_height() + px(12))
        if self.surface is not None:
            ground = pygame.Rect(self.left, self.y, self.width, height)
            draw_box(self.surface, ground, px(8), look.theme.stage)
            self.surface.blit(picture, picture.get_rect(midleft=(self.left + px(14), ground.centery)))
        self.y += height + px(12)

    def figure(self, draw: Callable[[Pen], None]) -> None:
        """A drawing as wide as the column, in a box with round corners."""
        width = self.width
        height = round(width * FIGURE[1] / FIGURE[0])
        if self.surface is not None:
            pen = Pen((width, height), self.look, FIGURE)
            pen.fill("stage")
            draw(pen)
            rounded = pen.finished().convert_alpha()
            mask = box((width, height), self.look.px(8), pygame.Color(255, 255, 255))
            rounded.blit(mask, (0, 0), special_flags=pygame.BLEND_RGBA_MULT)
            self.surface.blit(rounded, (self.left, self.y))
        self.y += height + self.look.px(12)

    def control(self, keys: Sequence[str], words: str) -> None:
        """Key caps and what they do."""
        look, px = self.look, self.look.px
        taken = keycap.keys_width(look, keys)
        indent = max(px(64), taken + px(10))
        lines = look.fonts.wrap(words, 13, "medium", max(self.width - indent, px(60)))
        if self.surface is not None:
            keycap.draw_keys(self.surface, look, self.left, self.y + px(10), keys)
            for i, line in enumerate(lines):
                at = (self.left + indent, self.y + px(10) + i * px(LINE))
                look.text(self.surface, line, at, 13, "medium", "text2")
        self.y += px(28) + (len(lines) - 1) * px(LINE)

    def numbered(self, number: int, words: str) -> None:
        """A numbered thing to try."""
        look, px = self.look, self.look.px
        if self.surface is not None:
            center = (self.left + px(10), self.y + px(10))
            draw_disc(self.surface, center, 10 * look.k, look.theme.accent_soft)
            look.text(self.surface, str(number), center, 11, "semibold", "accent", "center")
        self.paragraph(words, 32)

    def named(self, name: str, words: str) -> None:
        """A name in strong letters and its explanation below."""
        self._text(name, 0, 13, "semibold", "text1", LINE)
        if words:
            self.paragraph(words)
        else:
            self.y += self.look.px(8)

    def space(self, design_px: float) -> None:
        """Leave space."""
        self.y += self.look.px(design_px)

    def _text(self, words: str, indent: int, size: int, weight: str, color: str, line: int) -> None:
        if self.surface is not None:
            at = (self.left + self.look.px(indent), self.y + self.look.px(line) / 2)
            self.look.text(self.surface, words, at, size, weight, color)
        self.y += self.look.px(line)

    def _formula(self, markup: str) -> pygame.Surface:
        """The formula, smaller if it is too wide; in its place what is wrong with it if it cannot be read."""
        look, space = self.look, self.width - self.look.px(24)
        try:
            for size in (20.0, 18.0, 16.0, 14.0, 12.0):
                picture = render_formula(look.fonts, markup, look.theme.text1, size)
                if picture.get_width() <= space:
                    break
            return picture
        except FormulaError as error:
            words = look.fonts.fit(str(error), 13, "medium", space)
            return look.fonts.render(words, 13, "medium", look.color("vermilion", words=True))


class HelpPage:
    """The page as an overlay.

    ``controls``: rows of keys and words that every scene has. ``level``: title and words of the level in
    play, which come first.
    """

    def __init__(
        self,
        look: Look,
        scene_type: type[Scene],
        controls: Sequence[KeyRow] = (),
        level: tuple[str, str] = ("", ""),
    ) -> None:
        self.look = look
        self.scene_type = scene_type
        self.level = level
        self.controls = tuple(controls)
        self.overlay = Overlay(look, HEIGHT)
        self.spots = Hotspots()
        self.scroll = 0
        self._sheet: pygame.Surface | None = None
        self._card: pygame.Surface | None = None
        self._drawn: object = None

    def place(self, window: pygame.Rect, look: Look) -> None:
        """Take a window and an appearance."""
        self.look = look
        self.overlay.place(window, look)
        self.spots.place([self.overlay.close_spot()])
        self._sheet = self._card = None

    def leave(self) -> None:
        """Start to fade out."""
        self.overlay.leave()

    def update(self, dt_s: float) -> bool:
        """Let time pass; False when the page has gone."""
        self.spots.update(dt_s, self.look)
        return self.overlay.update(dt_s)

    def handle(self, event: pygame.event.Event) -> Wish | None:
        """Scrolling stays here; the command is ``close``: the cross, or a press beside the card."""
        step = {
            pygame.K_DOWN: WHEEL, pygame.K_UP: -WHEEL, pygame.K_PAGEDOWN: 400, pygame.K_PAGEUP: -400,
            pygame.K_HOME: -100_000, pygame.K_END: 100_000,
        }  # fmt: skip
        if event.type == pygame.MOUSEWHEEL:
            self._scroll_by(-event.y * WHEEL)
        elif event.type == pygame.KEYDOWN and event.key in step:
            self._scroll_by(step[event.key])
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            if not self.overlay.card.collidepoint(event.pos):
                return Wish("close")
            self.spots.handle(event)
        elif self.spots.handle(event) == "close":
            return Wish("close")
        return None

    def draw(self, surface: pygame.Surface) -> None:
        """Draw veil and card; the card's picture is kept while nothing changes."""
        self.overlay.draw_veil(surface)
        state = (self.spots.state(), self.scroll)
        if self._card is None or state != self._drawn:
            self._drawn = state
            self._card = self._paint()
        self.overlay.draw_card(surface, self._card)

    # -- picture ------------------------------------------------------------------------------------

    def _view(self) -> pygame.Rect:
        """The part of the card below its head, on the card."""
        card, px = self.overlay.card, self.look.px
        return pygame.Rect(0, px(HEAD) + 1, card.w, max(0, card.h - px(HEAD) - px(12)))

    def _scroll_by(self, design_px: float) -> None:
        if self._sheet is not None:
            most = max(0, self._sheet.get_height() - self._view().h)
            self.scroll = min(max(self.scroll + self.look.px(design_px), 0), most)

    def _paint(self) -> pygame.Surface:
        look, px, scene = self.look, self.look.px, self.scene_type
        card = self.overlay.background()
        if self._sheet is None:
            self._sheet = self._paint_sheet()
            self._scroll_by(0)
        view = self._view()
        inside = view.inflate(-2 * look.border, 0)
        card.blit(self._sheet, inside, pygame.Rect(look.border, self.scroll, inside.w, inside.h))
        card.fill(look.theme.line, (look.border, px(HEAD), card.get_width() - 2 * look.border, look.border))
        self._paint_thumb(card, view)
        x, y = px(PADDING), px(36)
        if scene.task:
            chip = pygame.Rect(x, 0, look.fonts.size(scene.task, 12, "semibold")[0] + 2 * px(8), px(24))
            chip.centery = y
            draw_box(card, chip, px(6), look.theme.accent_soft)
            look.text(card, scene.task, chip.center, 12, "semibold", "accent", "center")
            x = chip.right + px(12)
        title = look.fonts.fit(scene.title, 22, "display", card.get_width() - x - px(64))
        look.text(card, title, (x, y), 22, "display")
        spot = self.spots.spots[0]
        place = spot.rect.move(-self.overlay.card.x, -self.overlay.card.y)
        draw_close(card, look, place, self.spots.hover("close"))
        return card

    def _paint_thumb(self, card: pygame.Surface, view: pygame.Rect) -> None:
        assert self._sheet is not None
        total = self._sheet.get_height()
        if total <= view.h or view.h < self.look.px(40):
            return
        height = max(self.look.px(24), view.h * view.h // total)
        y = view.y + (view.h - height) * self.scroll // max(total - view.h, 1)
        thumb = pygame.Rect(view.right - self.look.px(12), y, self.look.px(5), height)
        draw_box(card, thumb, thumb.w / 2, self.look.theme.line2)

    def _paint_sheet(self) -> pygame.Surface:
        """All that lies below the head, as high as it needs to be."""
        width = self.overlay.card.w
        height = max(self._write(None), self._view().h)
        sheet = pygame.Surface((width, height), 0, 32)
        sheet.fill(self.look.theme.panel)
        self._write(sheet)
        return sheet

    def _write(self, sheet: pygame.Surface | None) -> int:
        """Write the sections into columns; the height they need."""
        look, px, top = self.look, self.look.px, self.look.px(16)
        sections = (self._write_seen, self._write_equations, self._write_controls)
        width = self.overlay.card.w / look.k
        if width >= 1056 - 8:
            columns = [Column(look, sheet, px(PADDING + left), top, px(wide)) for wide, left in COLUMNS]
            return max(
                _written(section, column) for section, column in zip(sections, columns, strict=True)
            ) + px(16)
        if width >= 640:
            half = (width - 2 * PADDING - 40) / 2
            left = Column(look, sheet, px(PADDING), top, px(half))
            right = Column(look, sheet, px(PADDING + half + 40), top, px(half))
            self._write_seen(left)
            return max(_written(self._write_controls, left), _written(self._write_equations, right)) + px(16)
        column = Column(look, sheet, px(PADDING), top, px(max(width - 2 * PADDING, 40)))
        return max(_written(section, column) for section in sections) + px(16)

    def _write_seen(self, column: Column) -> None:
        title, about = self.level
        if title and about:
            column.head(title)
            column.paragraph(about, color="text1")
            column.space(8)
        column.head("What you see")
        for i, words in enumerate(paragraphs_of(self.scene_type)):
            column.paragraph(words)
            if i == 0 and self.scene_type.figure is not None:
                column.figure(self.scene_type.figure)
        effects = tuple(self.scene_type.effects)
        if effects:
            column.space(8)
            column.head("Effects")
            for effect in effects:
                column.named(effect.label, effect.help)

    def _write_equations(self, column: Column) -> None:
        if self.scene_type.equations:
            column.head("Equations")
            for equation in self.scene_type.equations:
                column.equation(equation)

    def _write_controls(self, column: Column) -> None:
        if self.scene_type.try_this:
            column.head("Try this")
            for i, words in enumerate(self.scene_type.try_this):
                column.numbered(i + 1, words)
            column.space(8)
        column.head("Controls")
        for hint in self.scene_type.hints:
            column.control(hint.keys, hint.text)
        hinted = {keys for hint in self.scene_type.hints for keys in hint.keys}
        for action in self.scene_type.actions:
            if keycap.key_name(action.key) in hinted:
                continue
            column.control((keycap.key_name(action.key),), action.label)
        for keys, words in self.controls:
            column.control(keys, words)


def _written(section: Callable[[Column], None], column: Column) -> int:
    section(column)
    return column.y
