"""Text: the interface's fonts at one scale, rendered once and kept, measured before it is placed.

Letters are never scaled after they are rendered. Digits of the sans faces are of one width, so that a
changing number does not jitter. Sizes are design pixels and are multiplied by the interface scale.
"""

from __future__ import annotations

import math
from collections import OrderedDict
from collections.abc import Sequence

import pygame

from game.ui.look.assets import asset
from game.ui.look.numerals import Quantity, format_number, format_si, quantity

__all__ = ["FACES", "FontBook", "Quantity", "format_number", "format_si", "quantity"]

FACES = {
    "regular": "CaromSans-Regular.otf",
    "medium": "CaromSans-Medium.otf",
    "semibold": "CaromSans-SemiBold.otf",
    "bold": "CaromSans-Bold.otf",
    "italic": "CaromSans-Italic.otf",
    "display-medium": "CaromDisplay-Medium.otf",
    "display": "CaromDisplay-SemiBold.otf",
    "display-bold": "CaromDisplay-Bold.otf",
    "formula": "STIXGeneral-Regular.otf",
    "formula-italic": "STIXGeneral-Italic.otf",
    "formula-bold": "STIXGeneral-BoldItalic.otf",  # vectors
}
SMALLEST_PX = 6  # px; smaller letters are no letters
KEPT_SURFACES = 1024
KEPT_SIZES = 4096  # of measured texts
KEPT_PIXELS = 6_000_000  # about 24 MB


class FontBook:
    """The faces at interface scale ``k``; ``render`` keeps what it made (least recently used goes first).

    ``weight`` is a key of ``FACES``. Text may hold several lines. ``least``: px, of the smallest letters.
    ValueError for an absurd scale or a weight that there is not.
    """

    def __init__(self, k: float = 1.0, least: int = SMALLEST_PX) -> None:
        if not (math.isfinite(k) and 0.25 <= k <= 8.0):
            raise ValueError(f"fonts: scale {k!r} is not between 0.25 and 8")
        if not pygame.font.get_init():
            pygame.font.init()
        self.k = k
        self.least = least
        self._fonts: dict[tuple[str, int], pygame.font.Font] = {}
        self._kept: OrderedDict[tuple[object, ...], pygame.Surface] = OrderedDict()
        self._pixels = 0
        self._sizes: dict[tuple[str, float, str], tuple[int, int]] = {}

    def font(self, size: float, weight: str = "medium") -> pygame.font.Font:
        """The pygame font of a design size."""
        px = max(self.least, round(size * self.k))
        found = self._fonts.get((weight, px))
        if found is None:
            if weight not in FACES:
                raise ValueError(f"fonts: weight {weight!r} is not one of {', '.join(FACES)}")
            found = self._fonts[weight, px] = pygame.font.Font(asset("fonts", FACES[weight]), px)
        return found

    def size(self, text: str, size: float, weight: str = "medium") -> tuple[int, int]:
        """Width and height in window px of one line."""
        key = (text, size, weight)
        found = self._sizes.get(key)
        if found is None:
            if len(self._sizes) >= KEPT_SIZES:
                self._sizes.clear()
            found = self._sizes[key] = self.font(size, weight).size(_clean(text))
        return found

    def line_height(self, size: float, weight: str = "medium") -> int:
        """Height in window px of a line."""
        return self.font(size, weight).get_linesize()

    def ascent(self, size: float, weight: str = "medium") -> int:
        """Window px from the top of a rendered line to its baseline."""
        return self.font(size, weight).get_ascent()

    def render(self, text: str, size: float, weight: str, color: pygame.Color) -> pygame.Surface:
        """Text on a transparent surface; kept, so do not draw on it."""
        key = (text, round(size * self.k), weight, tuple(color))
        found = self._find(key)
        if found is None:
            found = self.font(size, weight).render(_clean(text), True, color)
            if color.a < 255:
                found.set_alpha(color.a)
            self._keep(key, found)
        return found

    def render_on_halo(
        self, text: str, size: float, weight: str, color: pygame.Color, halo: pygame.Color, width: float = 2.0
    ) -> pygame.Surface:
        """Text on a halo of the background, ``width`` design px wide, for labels over a picture."""
        reach = max(1, round(width * self.k))
        key = (text, round(size * self.k), weight, tuple(color), tuple(halo), reach)
        found = self._find(key)
        if found is None:
            letters = self.font(size, weight).render(_clean(text), True, color)
            shade = self.font(size, weight).render(_clean(text), True, halo)
            found = pygame.Surface(
                (letters.get_width() + 2 * reach, letters.get_height() + 2 * reach), pygame.SRCALPHA, 32
            )
            found.fill((halo.r, halo.g, halo.b, 0))
            for dy in range(-reach, reach + 1):
                for dx in range(-reach, reach + 1):
                    if dx * dx + dy * dy <= reach * reach + 1:
                        found.blit(shade, (reach + dx, reach + dy))
            found.blit(letters, (reach, reach))
            self._keep(key, found)
        return found

    def draw(
        self,
        surface: pygame.Surface,
        text: str,
        at: tuple[float, float],
        size: float,
        weight: str,
        color: pygame.Color,
        align: str = "left",
        halo: pygame.Color | None = None,
    ) -> pygame.Rect:
        """Place text with ``at`` at the left, centre or right of its line's middle; the rectangle covered.

        ``align`` is "left", "center" or "right"; vertically the line is centred on ``at``.
        """
        if halo is None:
            picture = self.render(text, size, weight, color)
        else:
            picture = self.render_on_halo(text, size, weight, color, halo)
        x, y = at
        if not (math.isfinite(x) and math.isfinite(y)):
            return pygame.Rect(0, 0, 0, 0)
        share = {"left": 0.0, "center": 0.5, "right": 1.0}[align]
        limit = 30_000.0  # a surface takes 16 bit places
        left = min(limit, max(-limit, x - share * picture.get_width()))
        top = min(limit, max(-limit, y - 0.5 * picture.get_height()))
        return surface.blit(picture, (round(left), round(top)))

    def largest(self, text: str, sizes: Sequence[float], weight: str, width: int) -> float:
        """The first of ``sizes`` (largest first) at which the text is no wider than ``width`` window px, or
        else the last."""
        return next((size for size in sizes if self.size(text, size, weight)[0] <= width), sizes[-1])

    def fit(self, text: str, size: float, weight: str, width: int) -> str:
        """Text cut with an ellipsis so that it is no wider than ``width`` window px."""
        if self.size(text, size, weight)[0] <= width:
            return _clean(text)
        font = self.font(size, weight)
        text = _clean(text)
        low, high = 0, len(text)
        while low < high:
            middle = (low + high + 1) // 2
            if font.size(text[:middle].rstrip() + "…")[0] <= width:
                low = middle
            else:
                high = middle - 1
        return text[:low].rstrip() + "…" if low else ""

    def wrap(self, text: str, size: float, weight: str, width: int) -> list[str]:
        """Lines of at most ``width`` window px, broken at spaces; a longer word stands alone."""
        font = self.font(size, weight)
        lines: list[str] = []
        for paragraph in _clean(text).split("\n"):
            line = ""
            for word in paragraph.split(" "):
                longer = f"{line} {word}" if line else word
                if line and font.size(longer)[0] > width:
                    lines.append(line)
                    line = word
                else:
                    line = longer
            lines.append(line)
        return lines

    def _find(self, key: tuple[object, ...]) -> pygame.Surface | None:
        found = self._kept.get(key)
        if found is not None:
            self._kept.move_to_end(key)
        return found

    def _keep(self, key: tuple[object, ...], picture: pygame.Surface) -> None:
        self._kept[key] = picture
        self._pixels += picture.get_width() * picture.get_height()
        while len(self._kept) > 1 and (len(self._kept) > KEPT_SURFACES or self._pixels > KEPT_PIXELS):
            _, old = self._kept.popitem(last=False)
            self._pixels -= old.get_width() * old.get_height()


def _clean(text: str) -> str:
    """Text without the characters that a font cannot render."""
    return text.replace("\x00", "").encode("utf-8", "replace").decode("utf-8")
