"""The sheet of a teaching level at the left of the stage: the task, its questions, and what came of answers.

It takes its own part of the window, so it covers nothing; folded it is a narrow edge with a button. What is
right is not known here: a press of "Check" is a wish, and the verdict comes back.
"""

from __future__ import annotations

from typing import NamedTuple

import pygame

from game.teaching import ChoiceQuestion, GoalQuestion, NumberQuestion, Teaching
from game.ui.look.icons import icon
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box, draw_disc
from game.ui.widgets.buttons import draw_button
from game.ui.widgets.hotspots import Hotspot, Hotspots
from game.ui.widgets.line_field import LineField
from game.ui.widgets.wishes import Wish

WIDTH, FOLDED = 300, 40  # design px
UNFOLDED_FROM = 640  # design px of stage width
PADDING, LINE, FIELD, BUTTON = 16, 20, 34, 84  # design px
LONGEST_ANSWER = 24
WHEEL = 40


class Verdict(NamedTuple):
    """What came of an answer: whether it is right, and words about it."""

    right: bool
    words: str


class LessonSheet:
    """Shows one `Teaching`; ``wish`` "answer" asks for the verdict on a question, by its number."""

    def __init__(self, look: Look) -> None:
        self.look = look
        self.rect = pygame.Rect(0, 0, 0, 0)
        self.teaching: Teaching | None = None
        self.folded: bool | None = None  # None: as the window has space
        self.answers: dict[int, str] = {}  # by question: what is typed, or the number of the option
        self.verdicts: dict[int, Verdict] = {}
        self.focus: int | None = None  # question whose number is being typed
        self.spots = Hotspots()
        self.locked = ""  # names of what is locked
        self._fields: dict[int, LineField] = {}
        self._scroll = 0
        self._height = 0
        self._picture: pygame.Surface | None = None
        self._drawn: object = None

    def show(self, teaching: Teaching | None, locked: str = "") -> None:
        """Another level's task from now on, nothing of it answered; None: no task."""
        self.teaching, self.locked = teaching, locked
        self.answers, self.verdicts, self.focus = {}, {}, None
        self._scroll, self.folded, self._picture = 0, None, None
        questions = teaching.questions if teaching is not None else []
        self._fields = {
            i: LineField("", "number", LONGEST_ANSWER)
            for i, one in enumerate(questions)
            if isinstance(one, NumberQuestion)
        }

    def width_in(self, stage: pygame.Rect, look: Look) -> int:
        """Window px that it takes of a stage."""
        if self.teaching is None:
            return 0
        folded = self.folded if self.folded is not None else stage.w < look.px(UNFOLDED_FROM)
        return min(look.px(FOLDED) if folded else look.px(WIDTH), max(stage.w // 2, 1))

    @property
    def is_folded(self) -> bool:
        """Whether only its edge is shown."""
        return self.rect.w <= self.look.px(FOLDED)

    @property
    def right(self) -> int:
        """How many questions are answered rightly."""
        return sum(verdict.right for verdict in self.verdicts.values())

    @property
    def typing(self) -> bool:
        """Whether a number is being typed."""
        return self.focus is not None and not self.is_folded and self.teaching is not None

    def place(self, rect: pygame.Rect, look: Look) -> None:
        """Take a place in the window and an appearance."""
        self.rect, self.look, self._picture = pygame.Rect(rect), look, None
        self._lay_out()

    # -- what comes in ------------------------------------------------------------------------------

    def handle(self, event: pygame.event.Event) -> list[Wish]:
        """Follow an event; what it asks for."""
        if self.teaching is None or self.rect.w < 1:
            return []
        if event.type in (pygame.KEYDOWN, pygame.TEXTINPUT):
            return self._type(event) if self.typing else []
        if event.type == pygame.MOUSEWHEEL:
            if self.rect.collidepoint(pygame.mouse.get_pos()) or self.rect.collidepoint(
                getattr(event, "pos", (-1, -1))
            ):
                self._scroll_to(self._scroll - round(event.y * WHEEL * self.look.k))
            return []
        if event.type == pygame.MOUSEBUTTONDOWN and not self.rect.collidepoint(event.pos):
            self.focus = None
        name = self.spots.handle(event)
        return self._pressed(name) if name is not None else []

    def _pressed(self, name: str) -> list[Wish]:
        kind, _, rest = name.partition("-")
        if kind == "fold":
            self.folded = not self.is_folded
            return [Wish("lesson-fold")]
        number, _, option = rest.partition("-")
        i = int(number)
        self.focus = i if kind == "field" else None
        if kind == "option":
            self.answers[i] = option
            self.verdicts.pop(i, None)
            self._lay_out()
        return [Wish("answer", i)] if kind == "check" else []

    def _type(self, event: pygame.event.Event) -> list[Wish]:
        """A key or a letter for the number that is being typed."""
        assert self.focus is not None
        i = self.focus
        if event.type == pygame.KEYDOWN and event.key in (pygame.K_ESCAPE, pygame.K_TAB):
            order = sorted(self._fields)
            after = [one for one in order if one > i]
            self.focus = after[0] if event.key == pygame.K_TAB and after else None
            return []
        before = self._fields[i].text
        entered = self._fields[i].handle(event)
        self.answers[i] = self._fields[i].text
        if self._fields[i].text != before and self.verdicts.pop(i, None) is not None:
            self._lay_out()
        return [Wish("answer", i)] if entered else []

    def judge(self, i: int, verdict: Verdict) -> None:
        """What came of an answer."""
        self.verdicts[i] = verdict
        self._lay_out()

    def update(self, elapsed_s: float) -> None:
        """Let time pass."""
        self.spots.update(elapsed_s, self.look)
        for field in self._fields.values():
            field.update(elapsed_s)

    def tip(self) -> tuple[str, pygame.Rect] | None:
        """Tool tip of the place under the pointer."""
        spot = self.spots.find(self.spots.hovered) if self.spots.hovered else None
        return (spot.tip, spot.rect) if spot is not None and spot.tip else None

    # -- places -------------------------------------------------------------------------------------

    def _scroll_to(self, y: int) -> None:
        self._scroll = min(max(y, 0), max(0, self._height - self.rect.h))
        self._lay_out()

    def _lay_out(self) -> None:
        """Find all places; the sheet's height follows from its words."""
        spots: list[Hotspot] = []
        self._flow(None, spots)
        self._scroll = min(self._scroll, max(0, self._height - self.rect.h))
        self.spots.place([spot._replace(rect=spot.rect.clip(self.rect)) for spot in spots])
        self._picture = None

    def _wrap(self, words: str, size: float, weight: str, width: int) -> list[str]:
        return [
            line
            for part in words.split("\n")
            for line in self.look.fonts.wrap(part, size, weight, width) or [""]
        ]

    def _flow(self, picture: pygame.Surface | None, spots: list[Hotspot]) -> None:
        """Go through the sheet from its top, drawing if there is a picture, gathering places."""
        look, px, teaching = self.look, self.look.px, self.teaching
        if teaching is None or self.rect.w < 1:
            return
        fold = pygame.Rect(0, 0, px(28), px(28))
        fold.topright = (self.rect.right - px(6), self.rect.y + px(8))
        spots.append(Hotspot("fold", fold, True, "Task and questions, shown or folded away"))
        if self.is_folded:
            return
        left, width = px(PADDING), self.rect.w - 2 * px(PADDING)
        y = px(22) - self._scroll
        if picture is not None:
            look.text(picture, "Task", (left, y), 13, "semibold", "accent")
        y += px(26)
        y = self._words(picture, teaching.task, y, left, width, ("medium", "text1"))
        if self.locked:
            y = self._words(picture, f"Locked: {self.locked}", y + px(6), left, width, ("medium", "text3"))
        for i in range(len(teaching.questions)):
            y = self._question(picture, spots, i, y + px(14), left, width)
        self._height = y + self._scroll + px(28)

    def _words(
        self,
        picture: pygame.Surface | None,
        words: str,
        y: int,
        left: int,
        width: int,
        style: tuple[str, str],
    ) -> int:
        """Lines of words from a height on; the height below them."""
        for line in self._wrap(words, 13, style[0], width):
            if picture is not None:
                self.look.text(picture, line, (left, y), 13, *style)
            y += self.look.px(LINE)
        return y

    def _question(
        self, picture: pygame.Surface | None, spots: list[Hotspot], i: int, y: int, left: int, width: int
    ) -> int:
        """One question with its answer; the height below it."""
        look, px = self.look, self.look.px
        assert self.teaching is not None
        question = self.teaching.questions[i]
        if picture is not None:
            picture.fill(look.theme.line, (left, y - px(8), width, look.border))
        y = self._words(picture, f"{i + 1}. {question.ask}", y + px(10), left, width, ("semibold", "text1"))
        if isinstance(question, ChoiceQuestion):
            for number, words in enumerate(question.options, start=1):
                y = self._option(picture, spots, (i, number), words, y, left, width)
        y += px(2)
        check = pygame.Rect(left, y, px(BUTTON), px(FIELD))
        if isinstance(question, NumberQuestion):
            check.right = left + width
            field = pygame.Rect(left, y, width - px(BUTTON + 8), px(FIELD))
            spots.append(Hotspot(f"field-{i}", field.move(self.rect.topleft), True))
            if picture is not None:
                self._draw_field(picture, i, field, question.unit)
        spots.append(Hotspot(f"check-{i}", check.move(self.rect.topleft), True))
        if picture is not None:
            name = f"check-{i}"
            draw_button(
                picture, look, check, "Check", lit=self.spots.hover(name), pressed=self.spots.pressed == name
            )
        if isinstance(question, GoalQuestion) and picture is not None:
            words = "when it is reached"
            look.text(picture, words, (check.right + px(10), check.centery), 12, "medium", "text3")
        return self._verdict(picture, i, y + px(FIELD + 6), left, width)

    def _option(
        self, picture: pygame.Surface | None, spots: list[Hotspot], which: tuple[int, int], words: str,
        y: int, left: int, width: int,
    ) -> int:  # fmt: skip
        """One option of a choice with its mark; the height below it."""
        look, px, (i, number) = self.look, self.look.px, which
        lines = self._wrap(words, 13, "medium", width - px(26))
        place = pygame.Rect(left, y - px(10), width, px(LINE) * len(lines))
        name = f"option-{i}-{number}"
        spots.append(Hotspot(name, place.move(self.rect.topleft), True))
        if picture is not None:
            chosen = self.answers.get(i) == str(number)
            center, lit = (left + px(8), y), self.spots.hover(name)
            draw_disc(
                picture,
                center,
                7.5 * look.k,
                None,
                look.theme.line2.lerp(look.theme.accent, lit),
                1.5 * look.k,
            )
            if chosen:
                draw_disc(picture, center, 4.5 * look.k, look.theme.accent)
            for n, line in enumerate(lines):
                look.text(picture, line, (left + px(26), y + n * px(LINE)), 13, "medium", "text1")
        return y + px(LINE) * len(lines) + px(4)

    def _draw_field(self, picture: pygame.Surface, i: int, rect: pygame.Rect, unit: str) -> None:
        """The field of a number, and its unit."""
        look, px = self.look, self.look.px
        if self.focus == i:
            self._fields[i].draw(picture, rect, look)
        else:
            draw_box(picture, rect, px(8), look.theme.inset, look.theme.line2, look.border)
            text = self._fields[i].text
            words, color = (text, "text1") if text else ("number", "text3")
            space = rect.w - px(24) - (look.fonts.size(unit, 12)[0] + px(8) if unit else 0)
            look.text(
                picture,
                look.fonts.fit(words, 14, "medium", space),
                (rect.x + px(12), rect.centery),
                14,
                "medium",
                color,
            )
        if unit:
            look.text(picture, unit, (rect.right - px(10), rect.centery), 12, "medium", "text2", "right")

    def _verdict(self, picture: pygame.Surface | None, i: int, y: int, left: int, width: int) -> int:
        """What came of an answer, if it has been checked."""
        look, px, verdict = self.look, self.look.px, self.verdicts.get(i)
        if verdict is None:
            return y
        color = "green" if verdict.right else "vermilion"
        lines = self._wrap(verdict.words, 13, "semibold", width - px(24))
        if picture is not None:
            sign = icon("check" if verdict.right else "close", px(16), look.color(color))
            picture.blit(sign, sign.get_rect(center=(left + px(8), y + px(6))))
            for n, line in enumerate(lines):
                look.text(picture, line, (left + px(24), y + px(6) + n * px(LINE)), 13, "semibold", color)
        return y + px(LINE) * len(lines) + px(4)

    # -- picture ------------------------------------------------------------------------------------

    def draw(self, surface: pygame.Surface) -> None:
        """Show the sheet; painted again only when something in it has changed."""
        if self.teaching is None or self.rect.w < 1 or self.rect.h < 1:
            return
        fields = tuple(
            field.state(self.look) if i == self.focus else None for i, field in self._fields.items()
        )
        state = (self.spots.state(), self.focus, fields, tuple(self.answers.items()), self._scroll)
        if self._picture is None or state != self._drawn:
            self._picture, self._drawn = self._paint(), state
        surface.blit(self._picture, self.rect)

    def _paint(self) -> pygame.Surface:
        look, px, theme = self.look, self.look.px, self.look.theme
        assert self.teaching is not None
        picture = pygame.Surface(self.rect.size, 0, 32)
        picture.fill(theme.panel)
        self._flow(picture, [])
        picture.fill(theme.line, (self.rect.w - look.border, 0, look.border, self.rect.h))
        fold = self.spots.find("fold")
        count = f"{self.right}/{len(self.teaching.questions)}"
        if fold is not None:
            place = fold.rect.move(-self.rect.x, -self.rect.y)
            draw_box(picture, place, px(7), theme.panel.lerp(theme.hover, self.spots.hover("fold")))
            sign = icon("chevron-right" if self.is_folded else "back", px(16), theme.text2)
            picture.blit(sign, sign.get_rect(center=place.center))
            if self.teaching.questions:
                if self.is_folded:
                    at, align = (self.rect.w / 2, place.bottom + px(16)), "center"
                else:
                    at, align = (place.x - px(8), place.centery), "right"
                look.text(picture, count, at, 12, "semibold", "text2", align)
        if self._height - self.rect.h > self._scroll and not self.is_folded:
            picture.fill(theme.line2, (0, self.rect.h - look.border, self.rect.w, look.border))
        return picture
