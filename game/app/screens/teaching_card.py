"""The card on which a level for teaching is made of what is in play: task, locks, hiding, questions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

import pygame

from game.app.screens.card import HEAD, CardScreen
from game.app.screens.host import Host
from game.app.screens.question import Question
from game.app.stagehand.teaching_draft import FREE, SHOWN, Draft, suggestion
from game.stage import Readout
from game.teaching import TeachingError
from game.ui.look.shapes import draw_box
from game.ui.widgets.hotspots import Hotspot
from game.ui.widgets.line_field import LineField
from game.ui.widgets.list_row import ListRow

FIELD, ROW, GAP, BUTTON, FOOT = 38, 30, 12, 36, 72  # design px
LABELS = {"title": "Title", "task": "Task"}
LONGEST = {"title": 60, "task": 600}
LONGEST_QUESTION = 400
KINDS = {
    "number": ("Ask for a number", "the words | how far off it may be (5 %, or a number)"),
    "choice": ("Ask to choose", "the words | the right answer | another | another"),
    "goal": ("Set a goal", "the words | least | most"),
}
WHEEL_ROWS = 3


class TeachingCard(CardScreen):
    """``taken`` is called with the draft when it is to be saved; it says why it cannot be, or nothing."""

    called: ClassVar[str] = "The card of a teaching level"
    width: ClassVar[float] = 880.0
    height: ClassVar[float] = 620.0

    def __init__(self, host: Host, draft: Draft, taken: Callable[[Draft], str]):
        super().__init__(host)
        self.draft = draft
        self._taken = taken
        self.fields = {
            name: LineField(getattr(draft, name), prompt, LONGEST[name])
            for name, prompt in (("title", "what it is called"), ("task", "what is to be done"))
        }
        self.typed = "task" if draft.title else "title"
        self.first = 0  # row at the top of the left list
        self.trouble = ""
        self._later: list[Callable[[], object]] = []
        self.restyle()

    @property
    def heading(self) -> str:
        return "A level for teaching, of what is in play"

    # -- places -------------------------------------------------------------------------------------

    def _lists(self) -> tuple[pygame.Rect, pygame.Rect]:
        """Where the rows to lock and hide lie, and the questions; window px."""
        px, card = self.host.look.px, self.veil.card
        top = card.y + px(HEAD + 2 * (FIELD + GAP) + 28)
        height = max(card.bottom - px(FOOT) - top, px(ROW))
        left = pygame.Rect(card.x + px(32), top, (card.w - px(64 + 24)) // 2, height)
        return left, pygame.Rect(left.right + px(24), top, left.w, height)

    def _field(self, name: str) -> pygame.Rect:
        px, card = self.host.look.px, self.veil.card
        y = card.y + px(HEAD - 6) + list(LABELS).index(name) * px(FIELD + GAP)
        return pygame.Rect(card.x + px(88), y, card.w - px(88 + 32), px(FIELD))

    @property
    def _fits(self) -> int:
        return max(self._lists()[0].h // self.host.look.px(ROW), 1)

    def places(self) -> list[Hotspot]:
        px, card = self.host.look.px, self.veil.card
        left, right = self._lists()
        spots = [Hotspot(f"field-{name}", self._field(name)) for name in LABELS]
        shown = range(self.first, min(self.first + self._fits, len(self.draft.rows)))
        tops = [left.y + (i - self.first) * px(ROW) for i in shown]
        spots += [
            Hotspot(f"row-{i}", pygame.Rect(left.x, y, left.w, px(ROW)))
            for i, y in zip(shown, tops, strict=True)
        ]
        y = right.y
        for kind in KINDS:
            spots.append(Hotspot(f"add-{kind}", pygame.Rect(right.x, y, right.w, px(BUTTON - 4))))
            y += px(BUTTON + 2)
        for i in range(len(self.draft.questions)):
            place = pygame.Rect(right.x, y + px(8) + i * px(ROW), right.w, px(ROW))
            if place.bottom <= right.bottom:
                spots.append(Hotspot(f"drop-{i}", place))
        save = pygame.Rect(0, 0, px(128), px(BUTTON))
        save.bottomright = (card.right - px(32), card.bottom - px(20))
        return [*spots, Hotspot("save", save)]

    def state(self) -> object:
        fields = tuple(field.state(self.host.look) for field in self.fields.values())
        return (
            fields,
            self.typed,
            self.first,
            tuple(self.draft.states.items()),
            len(self.draft.questions),
            self.trouble,
        )

    # -- events -------------------------------------------------------------------------------------

    def wants_key(self, event: pygame.Event) -> bool:
        return not self.leaving and LineField.wants(event)

    def handle(self, event: pygame.Event) -> None:
        if self.leaving:
            return
        field = self.fields[self.typed]
        if event.type == pygame.MOUSEWHEEL:
            self.first -= WHEEL_ROWS * event.y
            self.first = min(max(self.first, 0), max(len(self.draft.rows) - self._fits, 0))
            self.refresh()
        elif event.type == pygame.TEXTINPUT or (event.type == pygame.KEYDOWN and field.wants(event)):
            focused = self.spots.focused
            if event.type == pygame.KEYDOWN and focused and event.key in (pygame.K_RETURN, pygame.K_KP_ENTER):
                self.pressed(focused)
            elif field.handle(event):
                self.typed = "task"
            self._take_fields()
        else:
            super().handle(event)

    def _take_fields(self) -> None:
        self.draft.title, self.draft.task = (self.fields[name].text for name in ("title", "task"))

    def pressed(self, name: str) -> None:
        kind, _, rest = name.partition("-")
        if kind == "field":
            self.typed = rest
        elif kind == "row":
            self.draft.turn(self.draft.rows[int(rest)])
        elif kind == "drop":
            del self.draft.questions[int(rest)]
            self.refresh()
        elif kind == "add":
            self._ask(rest)
        elif kind == "save":
            self._take_fields()
            self.trouble = self._taken(self.draft)
            if not self.trouble:
                self.close()

    def _ask(self, kind: str) -> None:
        """A question: of which readout, then its words."""
        if kind == "choice":
            self._ask_words(kind, None)
            return
        rows = [
            ListRow(one.name[:1].upper() + one.name[1:], one.unit, value=one) for one in self.draft.readouts
        ]
        self.host.cards.open_choices(
            "Of which readout", rows, lambda one: self._later.append(lambda: self._ask_words(kind, one))
        )

    def _ask_words(self, kind: str, readout: Readout | None) -> None:
        heading, about = KINDS[kind]
        question = Question(heading, about, "Add", suggestion(kind, readout), "", LONGEST_QUESTION)
        self.host.cards.open_name(question, lambda words: self._add(kind, readout, words))

    def _add(self, kind: str, readout: Readout | None, words: str) -> None:
        try:
            self.draft.add(kind, readout, words)
            self.trouble = ""
        except TeachingError as error:
            self.trouble = str(error)
        self.refresh()

    def update(self, elapsed_s: float) -> None:
        while self._later:
            self._later.pop(0)()
        self.fields[self.typed].update(elapsed_s)
        super().update(elapsed_s)

    # -- picture ------------------------------------------------------------------------------------

    def paint(self, picture: pygame.Surface) -> None:
        look, px = self.host.look, self.host.look.px
        for name, label in LABELS.items():
            rect = self.inner(self._field(name))
            look.text(picture, label, (px(32), rect.centery), 13, "semibold", "text2")
            if self.typed == name:
                self.fields[name].draw(picture, rect, look)
            else:
                self._paint_still(picture, rect, self.fields[name])
        left, right = (self.inner(rect) for rect in self._lists())
        for rect, words in ((left, "Press to lock or hide"), (right, "Questions; press one to leave it out")):
            look.text(picture, words, (rect.x, rect.y - px(14)), 12, "semibold", "text2")
        for spot in self.spots.spots:
            self._paint_spot(picture, spot)
        if len(self.draft.rows) > self._fits:
            self._paint_thumb(picture, left)
        self.draw_button(picture, "save", "Save", primary=True)
        words = look.fonts.fit(self.trouble, 13, "semibold", picture.get_width() - px(64 + 128 + 16))
        look.text(picture, words, (px(32), picture.get_height() - px(38)), 13, "semibold", "vermilion")

    def _paint_still(self, picture: pygame.Surface, rect: pygame.Rect, field: LineField) -> None:
        """A field in which nothing is being typed."""
        look, px = self.host.look, self.host.look.px
        draw_box(picture, rect, px(8), look.theme.inset, look.theme.line2, look.border)
        words, color = (field.text, "text1") if field.text else (field.prompt, "text3")
        words = look.fonts.fit(words, 14, "medium", rect.w - px(24))
        look.text(picture, words, (rect.x + px(12), rect.centery), 14, "medium", color)

    def _paint_spot(self, picture: pygame.Surface, spot: Hotspot) -> None:
        look, px = self.host.look, self.host.look.px
        kind, _, rest = spot.name.partition("-")
        rect = self.inner(spot.rect)
        if kind == "add":
            self.draw_button(picture, spot.name, KINDS[rest][0])
        if kind not in ("row", "drop"):
            return
        lit = self.spots.hover(spot.name)
        if lit > 0.0 or self.spots.focused == spot.name:
            draw_box(picture, rect, px(6), look.theme.accent_soft)
        if kind == "drop":
            words = f"{int(rest) + 1}. {self.draft.questions[int(rest)].ask}"
            words = look.fonts.fit(words, 13, "medium", rect.w - px(16))
            look.text(picture, words, (rect.x + px(8), rect.centery), 13, "medium", "text1")
            return
        row = self.draft.rows[int(rest)]
        state = self.draft.state(row)
        color: Any = "text3" if state in (FREE, SHOWN) else "accent"
        taken = look.text(
            picture, state, (rect.right - px(14), rect.centery), 12, "semibold", color, "right"
        ).w
        section = "" if row.section == "Parameters" else f" · {row.section.lower()}"
        words = look.fonts.fit(f"{row.label}{section}", 13, "medium", rect.w - taken - px(36))
        look.text(picture, words, (rect.x + px(8), rect.centery), 13, "medium", "text1")

    def _paint_thumb(self, picture: pygame.Surface, left: pygame.Rect) -> None:
        """Where in the list one is."""
        look, px, count = self.host.look, self.host.look.px, len(self.draft.rows)
        track = pygame.Rect(left.right - px(4), left.y, px(4), self._fits * px(ROW))
        thumb = track.copy()
        thumb.h = max(px(16), track.h * self._fits // count)
        thumb.y += (track.h - thumb.h) * self.first // max(count - self._fits, 1)
        draw_box(picture, track, px(2), look.theme.inset)
        draw_box(picture, thumb, px(2), look.theme.line2)
