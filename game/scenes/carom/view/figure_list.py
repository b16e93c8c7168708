"""The list of the figures of artistic billiards, in the place of the map."""

from __future__ import annotations

from game.billiards.game.games.artistic import Artistic
from game.billiards.game.games.artistic_figures import FIGURES
from game.scenes.carom import layout
from game.scenes.shared.tables.boxes import rect_of
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box


def draw_figures(canvas: Canvas, look: Look, game: Artistic) -> None:
    """Name and points of each figure; those that are over are faint, the one that is played is lit."""
    rect, px = rect_of(canvas, layout.LIST), look.px
    draw_box(canvas.surface, rect, px(8), look.theme.panel, look.theme.line, look.border)
    head = (rect.x + px(12), rect.y + px(14))
    look.text(canvas.surface, "Figures", head, 14, "semibold", "text1")
    pitch = (rect.h - px(30)) / len(FIGURES)
    for row, figure in enumerate(FIGURES):
        y = rect.y + px(28) + (row + 0.5) * pitch
        lit = row == game.figure and not game.over
        color = "text1" if lit else "text3" if row < game.figure or game.over else "text2"
        if lit:
            box = rect.inflate(-px(12), 0)
            box.update(box.x, round(y - 0.5 * pitch), box.w, round(pitch))
            draw_box(canvas.surface, box, px(6), look.theme.accent_soft, look.theme.accent, look.border)
        name = look.fonts.fit(f"{row + 1}  {figure.name}", 12, "semibold", rect.w - px(60))
        look.text(canvas.surface, name, (rect.x + px(14), y), 12, "semibold", color)
        look.text(
            canvas.surface, str(figure.points), (rect.right - px(16), y), 12, "semibold", color, "right"
        )
