"""The card that a game is begun with: a few choices, one large button, and the way to its levels."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, ClassVar, NamedTuple

import pygame

from game.app.screens.card import HEAD, CardScreen
from game.app.screens.host import Host
from game.app.stagehand.level_index import lessons_of, next_lesson
from game.app.stagehand.opening import Opening
from game.app.stagehand.start_choices import keep_own, locked_for, remembered
from game.app.window.commands import Actions
from game.stage.catalogue import Entry
from game.stage.declarations import StartLine
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box
from game.ui.widgets.hotspots import Hotspot

if TYPE_CHECKING:
    from game.billiards.career.career import Player

ROW, LEAST_ROW, LABELS, FEW_LABELS, ROOMY = 56, 36, 240, 108, 640  # design px
SEGMENT, BUTTON, PLAY_WIDTH, FOOT = 34, 48, 232, 100  # design px
MARGIN, GAP, AROUND = 32, 12, 6  # design px; the last: of a segment beside its words


class Below(NamedTuple):
    """The scene that is opened under the card. wait: lets it go on loading for so long, s; kept: there is a
    game to go on with.
    """

    wait: Callable[[float], object]
    kept: Callable[[], bool]


def _player() -> Player | None:
    """Who plays the career. Imported here, since ratings bring the compiler with them."""
    from game.app.stagehand.career_file import load_career

    return load_career()[0].player


class StartCard(CardScreen):
    """Segments, remembered as the next choice; Enter plays, Esc leads back to the menu."""

    called: ClassVar[str] = "The card before the game"
    width = 840.0

    def __init__(self, host: Host, entry: Entry, below: Below):
        self.entry = entry
        self.below = below
        self.lines = entry.start_lines()
        player = _player()
        self.locked = locked_for(player, entry.name)
        self.chosen = remembered(entry, host.settings.start, player)
        self._kept = below.kept()
        self.lessons = lessons_of(entry.name)
        super().__init__(host)
        self.veil.size = (self.width, HEAD + ROW * len(self.rows) + FOOT)
        self.restyle()

    @property
    def heading(self) -> str:
        return self.entry.title

    # -- what can be done ---------------------------------------------------------------------------

    @property
    def actions(self) -> Actions:
        return {"back": self._leave, "menu": self._leave, "levels": self._open_levels}

    def _leave(self) -> None:
        self.host.open_menu(self.entry.name)

    def begin(self) -> None:
        """Begin, and remember what was chosen."""
        self._remember()
        self.host.open_scene(self.entry.name, opening=Opening(parameters=dict(self.chosen)))

    def _remember(self) -> None:
        self.host.settings.start = {**self.host.settings.start, self.entry.name: dict(self.chosen)}
        self.host.save_settings()
        if complaint := keep_own(self.entry.name, self.chosen):
            self.host.tell("Not all that was chosen is kept.", complaint, "warning")

    def _open_career(self) -> None:
        """The career, whose matches keep to what was chosen here."""
        self._remember()
        self.host.cards.open_career()

    def _go_on(self) -> None:
        self.host.tell("Your game goes on.", "N begins a new one.")
        self.close()

    def _open_lesson(self) -> None:
        self.host.open_scene(self.entry.name, level=next_lesson(self.lessons).path)

    def _open_levels(self) -> None:
        self.host.cards.open_levels(
            self.entry, lambda path: self.host.open_scene(self.entry.name, level=path)
        )

    def pressed(self, name: str) -> None:
        if name == "play":
            self.begin()
        elif name == "go-on":
            self._go_on()
        elif name == "levels":
            self._open_levels()
        elif name == "lessons":
            self._open_lesson()
        elif name == "career":
            self._open_career()
        else:
            parameter, _, value = name.partition("=")
            if (prize := self.locked.get((parameter, value))) is not None:
                self.host.tell(f"{prize.title} is locked.", f"In the career {prize.words}.")
                return
            self.chosen[parameter] = value
            self.refresh()

    def handle(self, event: pygame.Event) -> None:
        if event.type == pygame.KEYDOWN and not self.leaving:
            if event.key in (pygame.K_RETURN, pygame.K_KP_ENTER) and self.spots.focused is None:
                self.begin()
                return
            if event.key in (pygame.K_LEFT, pygame.K_RIGHT):
                self.spots.focus_next(event.key == pygame.K_LEFT)
                return
        if event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            spot = self.spots.at(event.pos)
            if spot is not None and spot.name == "close" and self.spots.pressed == "close":
                self._leave()
                return
        super().handle(event)

    def update(self, elapsed_s: float) -> None:
        self.below.wait(elapsed_s)
        if self._kept != self.below.kept():
            self._kept = self.below.kept()
            self.refresh()
        super().update(elapsed_s)

    # -- places -------------------------------------------------------------------------------------

    @property
    def rows(self) -> list[StartLine]:
        """The lines that are shown: of two that share a place the one that means something."""
        other = {line.instead: line for line in self.lines if line.instead}
        return [
            other[line.parameter] if line.parameter in other and self.is_idle(line) else line
            for line in self.lines
            if not line.instead
        ]

    def is_idle(self, line: StartLine) -> bool:
        """Whether a line means nothing beside what another one says."""
        parameter, value = line.idle
        if line.only[0] and self.chosen.get(line.only[0]) != line.only[1]:
            return True
        return bool(parameter) and self.chosen.get(parameter) == value

    @property
    def _roomy(self) -> bool:
        return self.veil.card.w >= self.host.look.px(ROOMY)

    @property
    def _row(self) -> int:
        """Height of a line, window px: less in a low window."""
        px = self.host.look.px
        fits = (self.veil.card.h - px(HEAD) - px(FOOT)) // len(self.rows)
        return min(px(ROW), max(px(LEAST_ROW), fits))

    def places(self) -> list[Hotspot]:
        px, card = self.host.look.px, self.veil.card
        spots = []
        left = card.x + px(LABELS if self._roomy else FEW_LABELS)
        space = max(card.right - px(MARGIN) - left, 1)
        for i, line in enumerate(self.rows):
            y = card.y + px(HEAD) + i * self._row + (self._row - px(SEGMENT)) // 2 - px(4)
            enabled = not self.is_idle(line)
            ends = self._ends(line, space)
            for (value, _), x0, x1 in zip(line.options, ends, ends[1:], strict=False):
                place = pygame.Rect(left + x0, y, max(x1 - x0, 1), px(SEGMENT))
                spots.append(Hotspot(f"{line.parameter}={value}", place, enabled))
        return [*spots, *self._buttons()]

    def _ends(self, line: StartLine, space: int) -> list[int]:
        """Where segments of a line begin and end, window px: alike, or by their words if those need it."""
        px, fonts, count = self.host.look.px, self.host.look.fonts, len(line.options)
        wide = [fonts.size(words, 13, "semibold")[0] + px(AROUND) for _, words in line.options]
        over = space - sum(wide)
        if over < 0 or max(wide) <= space // count:
            return [space * n // count for n in range(count + 1)]
        return [sum(wide[:n]) + over * n // count for n in range(count + 1)]

    def _buttons(self) -> list[Hotspot]:
        """The large one at the right, the others beside it."""
        px, card = self.host.look.px, self.veil.card
        names = ["play", *(["go-on"] if self._kept else []), "levels"]
        names += [*(["lessons"] if self.lessons else []), "career"]
        right, bottom = card.right - px(MARGIN), card.bottom - px(28)
        widths = [min(px(PLAY_WIDTH), (card.w - 2 * px(MARGIN)) // len(names) - px(GAP))] * len(names)
        spots = []
        for name, width in zip(names, widths, strict=True):
            high = px(BUTTON) if name == "play" else px(SEGMENT)
            place = pygame.Rect(right - width, bottom - (px(BUTTON) + high) // 2, width, high)
            spots.append(Hotspot(name, place))
            right = place.x - px(GAP)
        return spots

    # -- picture ------------------------------------------------------------------------------------

    def state(self) -> object:
        return tuple(sorted(self.chosen.items())), self._kept

    def paint(self, picture: pygame.Surface) -> None:
        look, px = self.host.look, self.host.look.px
        for i, line in enumerate(self.rows):
            y = px(HEAD) + i * self._row + self._row // 2 - px(4)
            up = px(9) if self._roomy else 0
            color = "text3" if self.is_idle(line) else "text1"
            look.text(picture, line.label, (px(MARGIN), y - up), 13, "semibold", color)
            if self._roomy:
                look.text(picture, line.about, (px(MARGIN), y + up), 12, "medium", "text3")
            self._paint_segments(picture, line)
        self._paint_play(picture)
        self.draw_button(picture, "go-on", "Go on with your game")
        many = self._kept and bool(self.lessons)
        self.draw_button(picture, "levels", "Levels" if many else "Puzzles and drills")
        self.draw_button(picture, "career", "Career, cups")
        if self.lessons:
            done = sum(bool(head.stars) for head in self.lessons)
            of = f": {done} of {len(self.lessons)}" if done else ""
            self.draw_button(picture, "lessons", f"{'Lessons' if many else 'First ten minutes'}{of}")

    def _paint_play(self, picture: pygame.Surface) -> None:
        spot = self.spots.find("play")
        if spot is None:
            return
        look, px, theme = self.host.look, self.host.look.px, self.host.look.theme
        rect = self.inner(spot.rect)
        draw_box(picture, rect, px(10), theme.accent.lerp(theme.text1, 0.15 * self.spots.hover("play")))
        look.text(
            picture, "Play", (rect.centerx, rect.centery - px(1)), 18, "display", theme.on_accent, "center"
        )
        if self.spots.focused == "play":
            draw_box(picture, rect.inflate(px(6), px(6)), px(13), None, theme.accent, max(2, px(2)))

    def _paint_segments(self, picture: pygame.Surface, line: StartLine) -> None:
        look, px, theme = self.host.look, self.host.look.px, self.host.look.theme
        idle = self.is_idle(line)
        spots = [self.spots.find(f"{line.parameter}={value}") for value, _ in line.options]
        rects = [self.inner(spot.rect) for spot in spots if spot is not None]
        draw_box(picture, rects[0].unionall(rects[1:]), px(8), theme.inset)
        for (value, words), rect in zip(line.options, rects, strict=True):
            name = f"{line.parameter}={value}"
            on = self.chosen[line.parameter] == value and not idle
            inner, lit = rect.inflate(-px(4), -px(4)), self.spots.hover(name)
            if on:
                draw_box(picture, inner, px(6), theme.accent)
            elif lit:
                draw_box(picture, inner, px(6), theme.inset.lerp(theme.hover, lit))
            weight = "semibold" if on else "medium"
            shut = idle or (line.parameter, value) in self.locked
            color = theme.on_accent if on else theme.text3 if shut else theme.text2
            fitted = look.fonts.fit(words, 13, weight, inner.w)
            look.text(picture, fitted, rect.center, 13, weight, color, "center")
            if (line.parameter, value) in self.locked:
                _strike_out(picture, look, rect, fitted)
            if self.spots.focused == name:
                draw_box(picture, rect.inflate(px(4), px(4)), px(10), None, theme.accent, max(2, px(2)))


def _strike_out(picture: pygame.Surface, look: Look, rect: pygame.Rect, words: str) -> None:
    """A line through the words of an option that is locked: it is seen without its colour."""
    half = look.fonts.size(words, 13, "medium")[0] // 2
    left, right = (rect.centerx - half, rect.centery), (rect.centerx + half, rect.centery)
    pygame.draw.line(picture, look.theme.text3, left, right, max(1, look.px(1)))
