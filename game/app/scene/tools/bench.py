"""The instruments that lie over the picture, and the card from which they are taken."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import pygame

from game.app.scene.in_play import InPlay
from game.app.scene.tools.instrument import Instrument, Point
from game.app.scene.tools.protractor import Protractor
from game.app.scene.tools.ruler import Ruler
from game.app.scene.tools.stopwatch import StopWatch
from game.app.screens.host import Host
from game.app.stagehand.view import StageView
from game.ui.widgets.list_row import ListRow

Act = Callable[[], object]
Then = Callable[[Act], object]
KINDS: tuple[tuple[str, str, str], ...] = (
    ("ruler", "Ruler", "Distances in the scene's own unit"),
    ("protractor", "Protractor", "The angle between two directions"),
    ("stop-watch", "Stop-watch", "Simulated time, also in slow motion and step by step"),
)


class Bench:
    """Takes presses on its instruments before the scene does; nothing of it is told to the scene."""

    def __init__(self, host: Host, record: InPlay, view: StageView) -> None:
        self._host, self._record, self._view = host, record, view
        self.instruments: list[Instrument] = []
        self.watch: StopWatch | None = None
        self._held: Instrument | StopWatch | None = None
        self._grip = 0
        self._last: Point = (0.0, 0.0)

    def rows(self) -> list[ListRow]:
        """What can be taken or put away."""
        return [
            ListRow(title, about, "put away" if self.has(name) else "", value=name)
            for name, title, about in KINDS
        ]

    def has(self, name: str) -> bool:
        """Whether that instrument lies over the picture."""
        return any(one.name == name for one in self.instruments) or (
            name == StopWatch.name and self.watch is not None
        )

    def toggle(self, name: str) -> None:
        """Take an instrument, into the middle of what is seen, or put it away."""
        if name == StopWatch.name:
            self.watch = StopWatch() if self.watch is None else None
        elif self.has(name):
            self.instruments = [one for one in self.instruments if one.name != name]
        else:
            self.instruments.append(self._make(name))
        self._held = None

    def _make(self, name: str) -> Instrument:
        place, to_world = self._view.rect, self._view.camera.to_world
        x, wide, high = place.centerx, 0.18 * place.w, 0.2 * place.h
        if name == Ruler.name:
            y = place.y + 0.38 * place.h
            return Ruler([to_world(x - wide, y), to_world(x + wide, y)])
        y = place.y + 0.74 * place.h
        ends = ((x - wide, y), (x + wide, y), (x + 0.4 * wide, y - high))
        return Protractor([to_world(*end) for end in ends])

    # -- events -------------------------------------------------------------------------------------

    def handle(self, event: pygame.Event, stage: pygame.Rect) -> bool:
        """Follow a mouse event; True if an instrument has it."""
        if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1 and stage.collidepoint(event.pos):
            return self._press(event.pos)
        if self._held is None:
            return False
        if event.type == pygame.MOUSEMOTION:
            self._drag(event.pos, stage)
            return True
        if event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            self._held = None
            return True
        return False

    def cancel(self) -> None:
        """Let go what is held."""
        self._held = None

    def _press(self, position: tuple[int, int]) -> bool:
        camera, look = self._view.camera, self._host.look
        watch = self.watch
        if watch is not None and watch.rect.collidepoint(position):
            if watch.cross.collidepoint(position):
                self.watch = None
            elif not watch.press(position, self._record.stage.time_s):
                self._held = watch
            return True
        for one in reversed(self.instruments):
            if one.cross.collidepoint(position):
                self.toggle(one.name)
                return True
            grip = one.hit(position, camera, look)
            if grip is not None:
                self._held, self._grip, self._last = one, grip, camera.to_world(*position)
                return True
        return False

    def _drag(self, position: tuple[int, int], stage: pygame.Rect) -> None:
        held = self._held
        if isinstance(held, StopWatch):
            held.place_at = (
                (position[0] - stage.x) / max(stage.w, 1), (position[1] - stage.y) / max(stage.h, 1)
            )  # fmt: skip
        elif held is not None:
            x, y = self._view.camera.to_world(*position)
            by = (x - self._last[0], y - self._last[1])
            held.drag(self._grip, (x, y), by, bool(pygame.key.get_mods() & pygame.KMOD_SHIFT))
            self._last = (x, y)

    # -- picture ------------------------------------------------------------------------------------

    def update(self) -> None:
        """The stop-watch begins anew with the scene."""
        if self.watch is not None:
            stage = self._record.stage
            self.watch.follow(stage.session_number, stage.time_s)

    def draw(self, surface: pygame.Surface, stage: pygame.Rect) -> None:
        """All that lies over the picture."""
        clip, look = surface.get_clip(), self._host.look
        surface.set_clip(stage)
        for one in self.instruments:
            one.draw(surface, look, self._view.camera, self._record.stage.scene_type.unit, stage)
        if self.watch is not None:
            self.watch.draw(surface, look, stage, self._record.stage.time_s)
        surface.set_clip(clip)


class ToolsCard:
    """Offers everything that one measures and shows with."""

    def __init__(
        self, host: Host, bench: Bench, more: Sequence[tuple[str, str, str, Act]], then: Then
    ) -> None:
        """``more``: title, words, what stands at the right, and what is done, of the other rows.

        ``then``: has something done when the card has gone.
        """
        self._host, self._bench, self._more, self._then = host, bench, more, then

    def open(self) -> None:
        """Show the card."""
        rows = [row._replace(value=("instrument", row.value)) for row in self._bench.rows()]
        rows += [
            ListRow(title, about, chip, value=("more", i))
            for i, (title, about, chip, _) in enumerate(self._more)
        ]
        self._host.cards.open_choices("Tools", rows, lambda value: self._do(*value))

    def _do(self, kind: str, value: str | int) -> None:
        if kind == "instrument":
            self._bench.toggle(str(value))
        else:
            self._then(self._more[int(value)][3])
