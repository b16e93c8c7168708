"""A field for one line of text: typed at its end, taken back letter by letter or whole."""

from __future__ import annotations

import pygame

from game.ui.look.look import Look
from game.ui.look.shapes import draw_box

BLINK_S = 1.06
CONTROL = pygame.KMOD_CTRL | pygame.KMOD_META
_SPECIAL = 1 << 30  # codes of keys that print nothing lie above
_ENTER = (pygame.K_RETURN, pygame.K_KP_ENTER)


class LineField:
    """``text``: what is typed, at most ``longest`` letters. ``prompt``: shown as long as there is none."""

    def __init__(self, text: str, prompt: str, longest: int):
        self.text, self.prompt, self.longest = text[:longest], prompt, longest
        self._age_s = 0.0

    @staticmethod
    def wants(event: pygame.Event) -> bool:
        """Whether a KEYDOWN is for the field: what prints, Enter and Backspace; no command and no Esc."""
        if event.key in (pygame.K_ESCAPE, pygame.K_TAB):
            return False
        if event.key in (*_ENTER, pygame.K_BACKSPACE):
            return True
        return event.key < _SPECIAL and not event.mod & CONTROL

    def handle(self, event: pygame.Event) -> bool:
        """Take what is typed; True if it was Enter."""
        if event.type == pygame.TEXTINPUT:
            typed = "".join(letter for letter in event.text if letter.isprintable())
            self.text = (self.text + typed).lstrip()[: self.longest]
            self._age_s = 0.0
        elif event.type == pygame.KEYDOWN and event.key == pygame.K_BACKSPACE:
            self.text = "" if event.mod & CONTROL else self.text[:-1]
            self._age_s = 0.0
        return event.type == pygame.KEYDOWN and event.key in _ENTER

    def update(self, elapsed_s: float) -> None:
        """Let the cursor blink."""
        self._age_s += elapsed_s

    def state(self, look: Look) -> tuple[str, bool]:
        """What the picture depends on: the text, and whether the cursor is seen."""
        return self.text, look.less_motion or self._age_s % BLINK_S < 0.5 * BLINK_S

    def draw(self, picture: pygame.Surface, rect: pygame.Rect, look: Look) -> None:
        """The field in its place; of a text that is too long, its end."""
        px = look.px
        draw_box(picture, rect, px(8), look.theme.inset, look.theme.accent, look.border)
        x, space = rect.x + px(12), rect.w - px(28)
        shown = self.text
        while shown and look.fonts.size(shown, 14, "medium")[0] > space:
            shown = shown[1:]
        end = x
        if shown:
            end += look.text(picture, shown, (x, rect.centery), 14, "medium", "text1").w
        else:
            prompt = look.fonts.fit(self.prompt, 14, "medium", space)
            look.text(picture, prompt, (x + px(5), rect.centery), 14, "medium", "text3")
        if self.state(look)[1]:
            picture.fill(look.theme.accent, (end + px(1), rect.centery - px(9), max(2, px(2)), px(18)))
