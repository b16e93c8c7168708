"""A column of a page: headings, paragraphs, equations, figures and rows written below each other."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import pygame

from game.stage import Equation
from game.ui.canvas.pen import FIGURE, Pen
from game.ui.look.look import Look
from game.ui.look.shapes import box, draw_box, draw_disc
from game.ui.text.formula import FormulaError, render_formula
from game.ui.widgets import keycap

LINE = 20  # design px


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
        self.formula(equation.formula)

    def formula(self, markup: str) -> None:
        """A formula in a box."""
        look, px = self.look, self.look.px
        picture = self._formula(markup)
        height = max(px(48), picture.get_height() + px(12))
        if self.surface is not None:
            ground = pygame.Rect(self.left, self.y, self.width, height)
            draw_box(self.surface, ground, px(8), look.theme.stage)
            self.surface.blit(picture, picture.get_rect(midleft=(self.left + px(14), ground.centery)))
        self.y += height + px(12)

    def comparison(self, what: str, theirs: str, ours: str) -> None:
        """What is compared, and below it ours, and theirs if there is such a figure."""
        look, px = self.look, self.look.px
        for line in look.fonts.wrap(what, 13, "medium", self.width):
            self._text(line, 0, 13, "medium", "text2", LINE)
        for name, value, color in (("here", ours, "accent"), ("authors", theirs, "text1")):
            if value:
                if self.surface is not None:
                    look.text(self.surface, name, (self.left, self.y + px(LINE // 2)), 12, "medium", "text3")
                for line in look.fonts.wrap(value, 13, "semibold", self.width - px(60)):
                    self._text(line, 60, 13, "semibold", color, LINE)
        self.y += px(10)

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
