"""The card shown while kernels compile, on the shell of the scene that is coming.

Nothing here needs a compiled kernel. A ball with the kernel's number on it rolls along the bar, turned by
the way it has gone; a diamond stands for each kernel.
"""

from __future__ import annotations

import math

import numpy as np
import pygame

from game.ui.look import theme as colors
from game.ui.look.layout import Layout
from game.ui.look.look import Look
from game.ui.look.numerals import format_number
from game.ui.look.shapes import draw_box, draw_polygon, draw_shadow

CARD = (480, 208)  # design px
BALL = 13.0  # design px, radius
GRID = 96
_LIGHT = np.array([-0.42, -0.62, 0.66])
_WIDTHS = (96, 72, 84, 60, 110, 90, 70, 88, 64)  # of the grey bars where labels will be


class LoadingCard:
    """What compiles, how many are done, and the time it has taken."""

    def __init__(self, look: Look) -> None:
        self.look = look
        self._shown = 0.0  # kernels done, eased
        self._texture: dict[tuple[str, int], np.ndarray] = {}

    def place(self, look: Look) -> None:
        """Take another appearance."""
        self.look = look
        self._texture.clear()

    def update(self, dt_s: float, done: int, total: int) -> None:
        """Let the ball roll towards the number of kernels done."""
        goal = min(max(done, 0), max(total, 1))
        if self.look.less_motion or goal < self._shown:
            self._shown = float(goal)
        else:
            self._shown += (goal - self._shown) * (1.0 - math.exp(-8.0 * max(dt_s, 0.0)))

    def draw(
        self,
        surface: pygame.Surface,
        stage: pygame.Rect,
        title: str,
        done: int,
        total: int,
        name: str,
        seconds: float,
    ) -> None:
        """The card in the middle of the stage."""
        look, px = self.look, self.look.px
        card = pygame.Rect(0, 0, min(px(CARD[0]), stage.w - px(16)), px(CARD[1]))
        if card.w < px(160) or stage.h < card.h:
            return
        card.center = stage.center
        draw_shadow(surface, card, 14.0 * look.k, 8.0 * look.k, 0.45 if look.theme.name == "dark" else 0.2)
        draw_box(surface, card, px(16), look.theme.panel, look.theme.line2, look.border)
        left, right = card.x + px(32), card.right - px(32)
        words = look.fonts.fit(f"Preparing {title[:1].lower()}{title[1:]}", 20, "display", right - left)
        look.text(surface, words, (left, card.y + px(40)), 20, "display")
        words = look.fonts.fit(
            "The first start compiles its kernels. The next one opens at once.", 13, "medium", right - left
        )
        look.text(surface, words, (left, card.y + px(68)), 13, "medium", "text2")
        self._draw_bar(surface, left, right, card.y, total, max(done, 1))
        count = f"{done} of {total}"
        x = left + look.text(surface, count, (left, card.y + px(168)), 13, "semibold").w + px(9)
        name = look.fonts.fit(name, 13, "medium", right - x - px(60))
        look.text(surface, name, (x, card.y + px(168)), 13, "medium", "text2")
        look.text(surface, f"{seconds:.1f} s", (right, card.y + px(168)), 13, "medium", "text3", "right")

    def _draw_bar(
        self, surface: pygame.Surface, left: int, right: int, top: int, total: int, number: int
    ) -> None:
        """The bar with its ball, and a diamond for each kernel."""
        look, px = self.look, self.look.px
        bar = pygame.Rect(left, top + px(113), right - left, px(6))
        share = self._shown / max(total, 1)
        draw_box(surface, bar, px(3), look.theme.hover)
        way = share * bar.w
        if way >= 1.0:
            draw_box(
                surface, pygame.Rect(bar.x, bar.y, max(round(way), bar.h), bar.h), px(3), look.theme.accent
            )
        marks = total + 1 if 0 < total <= 40 else 2
        for i in range(marks):
            x = left + px(4) + (bar.w - 2 * px(4)) * i / (marks - 1)
            d, y = 3.4 * look.k, top + px(134)
            lit = look.theme.accent if i <= self._shown + 1e-3 else look.theme.line2
            draw_polygon(surface, [(x, y - 1.2 * d), (x + d, y), (x, y + 1.2 * d), (x - d, y)], lit)
        radius = BALL * look.k
        x = min(max(left + way, left + radius), right - radius)
        ball = self.ball(number, radius, (x - left) / radius)
        surface.blit(
            ball, (round(x - ball.get_width() / 2), round(bar.bottom - radius - ball.get_height() / 2))
        )

    def ball(self, number: int, radius: float, roll: float) -> pygame.Surface:
        """A shaded ball that has rolled to the right by an angle (rad); its number faces us at 0."""
        n = 2 * math.ceil(radius) + 2
        axis = (np.arange(n) + 0.5 - 0.5 * n) / radius
        u, v = axis[:, None] + np.zeros(n), axis[None, :] + np.zeros((n, 1))
        s = np.sqrt(u * u + v * v)
        w = np.sqrt(np.maximum(1.0 - s * s, 0.0))
        cos, sin = math.cos(roll), math.sin(roll)
        p, q = cos * u - sin * w, sin * u + cos * w  # turned about the picture's vertical axis
        base = np.array(colors.BALL_COLORS[(number - 1) % 7 + 1][:3], dtype=np.float64)
        color = np.empty((n, n, 3))
        color[:] = base
        disc = np.clip((0.55 - np.sqrt(p * p + v * v)) * radius * np.maximum(np.abs(q), 0.35) + 0.5, 0.0, 1.0)
        color += disc[:, :, None] * (np.array(colors.BALL_WHITE[:3]) - color)
        digits = self._digits(str(number), max(8, round(2.2 * radius)))
        size = digits.shape[0]
        tx = np.clip(((p * np.sign(q)) / 0.55 * 0.54 + 0.5) * size, 0, size - 1).astype(int)
        ty = np.clip((v / 0.55 * 0.54 + 0.5) * size, 0, size - 1).astype(int)
        color *= 1.0 - (digits[tx, ty] * disc)[:, :, None] * 0.94
        lamp = np.maximum(u * _LIGHT[0] + v * _LIGHT[1] + w * _LIGHT[2], 0.0)
        color *= (0.34 + 0.22 * w + 0.62 * lamp)[:, :, None]
        gloss = np.clip((lamp - 0.93) * 14.0, 0.0, 1.0) * 0.75
        color += gloss[:, :, None] * (255.0 - color)
        picture = pygame.Surface((n, n), pygame.SRCALPHA, 32)
        pixels = pygame.surfarray.pixels3d(picture)
        pixels[:] = np.clip(color, 0.0, 255.0)
        del pixels
        alpha = pygame.surfarray.pixels_alpha(picture)
        alpha[:] = np.clip(0.5 + (1.0 - s) * radius, 0.0, 1.0) * 255.0
        del alpha
        return picture

    def _digits(self, text: str, size: int) -> np.ndarray:
        """Coverage of a number, (size, size), x first."""
        found = self._texture.get((text, size))
        if found is None:
            font = self.look.fonts.font(size * (0.8 if len(text) == 1 else 0.62) / self.look.k, "bold")
            letters = font.render(text, True, (255, 255, 255))
            sheet = pygame.Surface((size, size), pygame.SRCALPHA, 32)
            sheet.blit(letters, letters.get_rect(center=(size // 2, size // 2)))
            found = self._texture[text, size] = pygame.surfarray.array_alpha(sheet) / 255.0
        return found


def draw_shell(surface: pygame.Surface, layout: Layout, look: Look) -> None:
    """The scene's shell before there is a scene: grid, and grey bars where controls and charts will be."""
    theme, px = look.theme, look.px
    stage = layout.stage
    surface.fill(theme.stage, stage)
    for i in range(1, math.ceil(stage.w / px(GRID))):
        surface.fill(theme.grid, (stage.x + i * px(GRID), stage.y, 1, stage.h))
    for i in range(1, math.ceil(stage.h / px(GRID))):
        surface.fill(theme.grid, (stage.x, stage.y + i * px(GRID), stage.w, 1))
    if layout.strips.h:
        surface.fill(theme.panel, layout.strips)
        surface.fill(theme.line, (layout.strips.x, layout.strips.y, layout.strips.w, look.border))
        for chart in () if layout.values_only else layout.charts:
            draw_box(surface, pygame.Rect(chart.x, chart.y + px(14), px(72), px(8)), px(4), theme.inset)
            for y in (32, 68, 104):
                surface.fill(theme.inset, (chart.x, chart.y + px(y), chart.w - px(84), look.border))
    if layout.panel.w:
        _draw_panel_shell(surface, layout.panel, look)


def _draw_panel_shell(surface: pygame.Surface, panel: pygame.Rect, look: Look) -> None:
    theme, px = look.theme, look.px
    surface.fill(theme.panel, panel)
    surface.fill(theme.line, (panel.x, panel.y, look.border, panel.h))
    left, width = panel.x + px(16), panel.w - px(32)
    draw_box(surface, pygame.Rect(left, panel.y + px(16), width, px(32)), px(8), theme.inset)
    y = 72
    for group in (4, 5):
        draw_box(surface, pygame.Rect(left, panel.y + px(y), px(64), px(8)), px(4), theme.hover)
        y += 24
        for i in range(group):
            if panel.y + px(y + 22) > panel.bottom - px(60):
                return
            label = pygame.Rect(left, panel.y + px(y), px(_WIDTHS[(y // 24 + i) % 9]), px(8))
            draw_box(surface, label, px(4), theme.inset)
            value = pygame.Rect(0, label.y, px(56), px(8))
            value.right = left + width
            draw_box(surface, value, px(4), theme.inset)
            draw_box(surface, pygame.Rect(left, label.y + px(20), width, px(4)), px(2), theme.inset)
            y += 48
        y -= 16


def seconds_text(seconds: float) -> str:
    """Time for people: "9 s", "1 min 20 s"; a dash if it is not known."""
    if not math.isfinite(seconds) or seconds < 0.0:
        return format_number(math.nan)
    if seconds < 90.0:
        return f"{seconds:.0f} s"
    return f"{int(seconds) // 60} min {int(seconds) % 60} s"
