"""The menu's header: mark and name, the search field, theme, settings, help and papers."""

from __future__ import annotations

import pygame

from game.app.screens.host import Host
from game.ui.look.icons import icon, logo
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box
from game.ui.widgets.hotspots import Hotspot, Hotspots

FIELD_WIDTH, FIELD_HEIGHT = 352, 40  # design px
BLINK_S = 1.06
BUTTONS = (
    ("help", "help"),
    ("settings", "gear"),
    ("theme", "contrast"),
    ("papers", "page"),
    ("career", "cup"),
    ("challenge", "target"),
)  # from the right


class Header:
    """Draws itself; ``handle`` names what was pressed: a button or clear."""

    def __init__(self, host: Host):
        self.host = host
        self.query = ""
        self.prompt = ""
        self.spots = Hotspots()
        self._age_s = 0.0
        self.rect = pygame.Rect(0, 0, 1, 1)
        self.field = pygame.Rect(0, 0, 1, 1)

    def place(self, rect: pygame.Rect, look: Look) -> None:
        """Take a place in the window."""
        px = look.px
        self.rect = rect
        middle = rect.y + rect.h // 2
        spots = []
        for i, (name, _) in enumerate(BUTTONS):
            place = pygame.Rect(0, 0, px(32), px(32))
            place.center = (rect.right - px(48) - i * px(40), middle)
            spots.append(Hotspot(name, place, True, name.capitalize()))
        left, right = px(196), rect.right - px(284)
        self.field = pygame.Rect(0, 0, max(1, min(px(FIELD_WIDTH), right - left)), px(FIELD_HEIGHT))
        self.field.center = (
            max(left + self.field.w // 2, min(rect.centerx, right - self.field.w // 2)),
            middle,
        )
        if self.query:
            cross = pygame.Rect(0, 0, px(32), px(32))
            cross.center = (self.field.right - px(22), middle)
            spots.append(Hotspot("clear", cross))
        self.spots.place(spots)

    def handle(self, event: pygame.Event) -> str | None:
        """What a press asks for."""
        if event.type in (pygame.TEXTINPUT, pygame.KEYDOWN):
            self._age_s = 0.0
        if event.type == pygame.KEYDOWN:
            return None
        return self.spots.handle(event)

    def update(self, elapsed_s: float) -> None:
        """Let the cursor blink."""
        self._age_s += elapsed_s
        self.spots.update(elapsed_s, self.host.look)
        if bool(self.query) != (self.spots.find("clear") is not None):
            self.place(self.rect, self.host.look)

    def draw(self, surface: pygame.Surface) -> None:
        """Mark, name, field and buttons."""
        look, px = self.host.look, self.host.look.px
        if self.rect.h < px(40):
            return
        mark = logo(px(44), look.theme)
        surface.blit(mark, (self.rect.x + px(30), self.rect.centery - mark.get_height() // 2))
        x = self.rect.x + px(84)
        look.text(surface, "Carom", (x, self.rect.y + px(32)), 26, "display-bold", "text1")
        look.text(surface, "a physics arcade", (x, self.rect.y + px(55)), 12, "medium", "text3")
        if self.field.w >= px(120):
            self._draw_field(surface)
        for name, sign in BUTTONS:
            spot = self.spots.find(name)
            if spot is None or spot.rect.x < self.rect.x + px(190):
                continue
            lit = self.spots.hover(name)
            if lit:
                draw_box(surface, spot.rect, px(8), look.theme.bg.lerp(look.theme.hover, lit))
            picture = icon(sign, px(20), look.theme.text2.lerp(look.theme.text1, lit))
            surface.blit(picture, picture.get_rect(center=spot.rect.center))

    def _draw_field(self, surface: pygame.Surface) -> None:
        look, px, field = self.host.look, self.host.look.px, self.field
        edge = look.theme.accent if self.query else look.theme.line2
        draw_box(surface, field, field.h / 2, look.theme.inset, edge, look.border)
        glass = icon("search", px(20), look.theme.text1)
        surface.blit(glass, glass.get_rect(center=(field.x + px(24), field.centery)))
        x, space = field.x + px(43), field.w - px(43 + 40)
        shown = self.query
        while shown and look.fonts.size(shown, 13, "medium")[0] > space:
            shown = shown[1:]
        end = x
        if shown:
            end += look.text(surface, shown, (x, field.centery), 13, "medium", "text1").w
        else:
            whole = look.fonts.size(self.prompt, 13, "medium")[0] <= space
            prompt = self.prompt if whole else look.fonts.fit("Search", 13, "medium", space)
            look.text(surface, prompt, (x + px(7), field.centery), 13, "medium", "text3")
        if look.less_motion or self._age_s % BLINK_S < 0.5 * BLINK_S:
            surface.fill(look.theme.accent, (end + px(1), field.centery - px(9), max(2, px(2)), px(18)))
        spot = self.spots.find("clear")
        if spot is not None:
            cross = icon("close", px(16), look.theme.text2)
            surface.blit(cross, cross.get_rect(center=spot.rect.center))
