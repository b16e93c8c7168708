"""A page of words and figures over a window: a head with a title, columns below it that scroll.

Three columns side by side, or fewer below each other in a narrow window; what does not fit scrolls.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import pygame

from game.ui.look.look import Look
from game.ui.look.shapes import draw_box
from game.ui.widgets.column import Column
from game.ui.widgets.hotspots import Hotspot, Hotspots
from game.ui.widgets.overlay import Overlay, draw_close
from game.ui.widgets.wishes import Wish

HEIGHT, HEAD, PADDING = 624, 72, 32  # design px
COLUMNS = ((296, 0), (344, 336), (280, 712))  # width and left edge of the columns side by side
WIDE, HALF_WIDE = 1056 - 8, 640  # of the card: for three columns, for two
GAP = 40  # between columns of one width
WHEEL = 48
CLOSE_SPACE, LINK_HEIGHT, LINK_GAP = 64, 28, 8
Section = Callable[[Column], None]
Link = tuple[str, str]  # name of the command that it asks for, words


class SheetPage:
    """An overlay whose subclasses say what stands in its head and its columns."""

    chip = ""  # a short id before the title
    title = ""

    def __init__(self, look: Look, links: Sequence[Link] = ()) -> None:
        """``links``: buttons in the head, from the right; pressed, each is a wish of its name."""
        self.look = look
        self.links = tuple(links)
        self.overlay = Overlay(look, HEIGHT)
        self.spots = Hotspots()
        self.scroll = 0
        self._sheet: pygame.Surface | None = None
        self._card: pygame.Surface | None = None
        self._drawn: object = None

    # -- for subclasses -----------------------------------------------------------------------------

    def sections(self) -> tuple[Section, Section, Section]:
        """What writes the three columns."""
        raise NotImplementedError

    def write(self, sheet: pygame.Surface | None) -> int:
        """Write the sections into columns; the height they need, px. Without a sheet it only measures."""
        look, px, top = self.look, self.look.px, self.look.px(16)
        first, second, third = sections = self.sections()
        width = self.overlay.card.w / look.k
        if width >= WIDE:
            columns = [Column(look, sheet, px(PADDING + left), top, px(wide)) for wide, left in COLUMNS]
            return max(
                _written(section, column) for section, column in zip(sections, columns, strict=True)
            ) + px(16)
        if width >= HALF_WIDE:
            left, right = self.even_columns(sheet)
            first(left)
            return max(_written(third, left), _written(second, right)) + px(16)
        (column,) = self.even_columns(sheet)
        return max(_written(section, column) for section in sections) + px(16)

    def even_columns(self, sheet: pygame.Surface | None) -> list[Column]:
        """As many columns of one width as the card takes: three, two or one."""
        look, px, top = self.look, self.look.px, self.look.px(16)
        width = self.overlay.card.w / look.k
        count = 3 if width >= WIDE else 2 if width >= HALF_WIDE else 1
        each = max((width - 2 * PADDING - (count - 1) * GAP) / count, 40)
        return [Column(look, sheet, px(PADDING + i * (each + GAP)), top, px(each)) for i in range(count)]

    # -- page ---------------------------------------------------------------------------------------

    def place(self, window: pygame.Rect, look: Look) -> None:
        """Take a window and an appearance."""
        self.look = look
        self.overlay.place(window, look)
        self.spots.place([self.overlay.close_spot(), *self._link_spots()])
        self._sheet = self._card = None

    def refresh(self) -> None:
        """Write the columns again, as what they say has changed."""
        self._sheet = self._card = None

    def leave(self) -> None:
        """Start to fade out."""
        self.overlay.leave()

    def update(self, dt_s: float) -> bool:
        """Let time pass; False when the page has gone."""
        self.spots.update(dt_s, self.look)
        return self.overlay.update(dt_s)

    def handle(self, event: pygame.event.Event) -> Wish | None:
        """Scrolling stays here; links ask for their commands, the cross and a press beside it for close."""
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
        else:
            name = self.spots.handle(event)
            return Wish(name) if name is not None else None
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

    def _link_spots(self) -> list[Hotspot]:
        """The links' places, window px; those that leave the title no space are left out."""
        look, px, card = self.look, self.look.px, self.overlay.card
        spots, right = [], card.right - px(CLOSE_SPACE)
        for name, words in self.links:
            wide = look.fonts.size(words, 13, "medium")[0] + 2 * px(12)
            place = pygame.Rect(right - wide, 0, wide, px(LINK_HEIGHT))
            place.centery = card.y + px(HEAD // 2)
            if place.x < card.x + card.w // 2:
                break
            spots.append(Hotspot(name, place))
            right = place.x - px(LINK_GAP)
        return spots

    def _scroll_by(self, design_px: float) -> None:
        if self._sheet is not None:
            most = max(0, self._sheet.get_height() - self._view().h)
            self.scroll = min(max(self.scroll + self.look.px(design_px), 0), most)

    def _paint(self) -> pygame.Surface:
        look, px = self.look, self.look.px
        card = self.overlay.background()
        if self._sheet is None:
            self._sheet = self._paint_sheet()
            self._scroll_by(0)
        view = self._view()
        inside = view.inflate(-2 * look.border, 0)
        card.blit(self._sheet, inside, pygame.Rect(look.border, self.scroll, inside.w, inside.h))
        card.fill(look.theme.line, (look.border, px(HEAD), card.get_width() - 2 * look.border, look.border))
        self._paint_thumb(card, view)
        self._paint_head(card)
        return card

    def _paint_head(self, card: pygame.Surface) -> None:
        look, px = self.look, self.look.px
        x, y = px(PADDING), px(HEAD // 2)
        if self.chip:
            chip = pygame.Rect(x, 0, look.fonts.size(self.chip, 12, "semibold")[0] + 2 * px(8), px(24))
            chip.centery = y
            draw_box(card, chip, px(6), look.theme.accent_soft)
            look.text(card, self.chip, chip.center, 12, "semibold", "accent", "center")
            x = chip.right + px(12)
        close, *links = (spot._replace(rect=spot.rect.move(-self.overlay.card.x, -self.overlay.card.y))
                         for spot in self.spots.spots)  # fmt: skip
        end = min((link.rect.x for link in links), default=card.get_width() - px(CLOSE_SPACE))
        title = look.fonts.fit(self.title, 22, "display", end - px(12) - x)
        look.text(card, title, (x, y), 22, "display")
        draw_close(card, look, close.rect, self.spots.hover("close"))
        words = dict(self.links)
        for link in links:
            lit = self.spots.hover(link.name)
            ground = look.theme.inset.lerp(look.theme.hover, lit)
            draw_box(card, link.rect, px(8), ground, look.theme.line2, look.border)
            look.text(card, words[link.name], link.rect.center, 13, "medium", "text1", "center")

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
        height = max(self.write(None), self._view().h)
        sheet = pygame.Surface((width, height), 0, 32)
        sheet.fill(self.look.theme.panel)
        self.write(sheet)
        return sheet


def _written(section: Section, column: Column) -> int:
    section(column)
    return column.y
