"""The time bar of a story: pause, clock, chapters, speed, buttons, a small picture of what one points at."""

from __future__ import annotations

from typing import NamedTuple

import pygame

from game.ui.look.icons import icon
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box, draw_disc
from game.ui.widgets.hotspots import Hotspot, Hotspots
from game.ui.widgets.wishes import Wish

HEIGHT = 44  # design px
SIDE, CLOCK, BUTTON = 16, 92, 108  # design px: to the edges; of the clock; of a button
PAUSE, CHAPTERS, SPEED, CONTROL_GAP = 32, 84, 52, 8  # design px, widths of the controls
SMALL = (160, 90)  # design px, of the small picture
SNAP = 7.0  # design px from a chapter's mark that still mean it


class TimeBarState(NamedTuple):
    """What the bar shows, s of film. chapters: (title, begins). length: what is known of it so far.

    taken_over: the scene is the viewer's. share: how far a jump has come, 0 to 1; None if there is none.
    free: the camera is in the viewer's hand. speed: that the viewer has set, in words. picture: of the moment
    that is pointed at, if there is one.
    """

    now_s: float = 0.0
    length_s: float = 60.0
    chapters: tuple[tuple[str, float], ...] = ()
    taken_over: bool = False
    ended: bool = False
    share: float | None = None
    free: bool = False
    paused: bool = False
    speed: str = "1×"
    picture: pygame.Surface | None = None


class TimeBar:
    """A widget at the foot of the stage; ``handle`` gives wishes: seek (s of film), pause, story-..."""

    def __init__(self, look: Look) -> None:
        self.look = look
        self.rect = pygame.Rect(0, 0, 0, 0)
        self.spots = Hotspots()
        self.controls = Hotspots()
        self.state = TimeBarState()
        self.pointed: float | None = None  # s of film under the pointer
        self._dragging = False

    def place(self, stage: pygame.Rect, look: Look) -> None:
        """Take the foot of the stage."""
        self.look = look
        height = min(look.px(HEIGHT), stage.h)
        self.rect = pygame.Rect(stage.x, stage.bottom - height, stage.w, height)
        self._place_spots()

    @property
    def track(self) -> pygame.Rect:
        """Where the time runs from left to right."""
        px, rect = self.look.px, self.rect
        left, right = self._clock_left + px(CLOCK), rect.right - px(SIDE)
        places = [spot.rect.x for spot in (*self.spots.spots, *self.controls.spots) if spot.name != "pause"]
        right = min([place - px(CONTROL_GAP) for place in places], default=right)
        return pygame.Rect(left, rect.centery - px(3), max(right - left, 1), px(6))

    @property
    def _clock_left(self) -> int:
        return self.rect.x + self.look.px(SIDE + (PAUSE + CONTROL_GAP if self.controls.spots else 0))

    @property
    def _small(self) -> tuple[int, int]:
        """Size of the small picture, px."""
        return self.look.px(SMALL[0]), self.look.px(SMALL[1])

    def _place_controls(self, right: int) -> None:
        """Pause at the left; speed and chapters left of the buttons, if there is space for all of them."""
        px, rect = self.look.px, self.rect
        room = right - px(PAUSE + CHAPTERS + SPEED + 3 * CONTROL_GAP + SIDE + CLOCK + 120) - rect.x
        spots = []
        if room >= 0:
            ready = self.state.share is None
            pause = pygame.Rect(rect.x + px(SIDE), rect.centery - px(16), px(PAUSE), px(32))
            spots.append(Hotspot("pause", pause, ready, "Pause or go on"))
            for name, width, tip in (
                ("story-speed", SPEED, "How fast it goes"),
                ("story-chapters", CHAPTERS, "Chapters"),
            ):
                place = pygame.Rect(right - px(width), rect.centery - px(14), px(width), px(28))
                spots.append(Hotspot(name, place, ready, tip))
                right = place.x - px(CONTROL_GAP)
        self.controls.place(spots)

    def _place_spots(self) -> None:
        px, rect, state = self.look.px, self.rect, self.state
        names = []
        if state.free:
            names.append(("story-camera", "Camera back"))
        if state.taken_over:
            names += [("story-here", "On from here"), ("story-go-on", "Go on")]
        elif not state.ended:
            names.append(("story-take-over", "Take over"))
        spots, right = [], rect.right - px(SIDE)
        if rect.w >= px(SIDE + CLOCK + 120 + len(names) * (BUTTON + 8)):
            for name, words in reversed(names):
                place = pygame.Rect(right - px(BUTTON), rect.centery - px(14), px(BUTTON), px(28))
                spots.append(Hotspot(name, place, state.share is None, words))
                right = place.x - px(8)
        self.spots.place(spots)
        self._place_controls(right)

    def update(self, elapsed_s: float, state: TimeBarState) -> None:
        """Let time pass; what the bar shows now."""
        other = (state.free, state.taken_over, state.ended, state.share is None)
        before = (self.state.free, self.state.taken_over, self.state.ended, self.state.share is None)
        self.state = state
        if other != before:
            self._place_spots()
        self.spots.update(elapsed_s, self.look)
        self.controls.update(elapsed_s, self.look)

    def handle(self, event: pygame.Event) -> tuple[bool, Wish | None]:
        """Whether the bar took the event, and what it asks for."""
        name = None
        if event.type != pygame.KEYDOWN:
            name = self.spots.handle(event) or self.controls.handle(event)
        if name is not None:
            return True, Wish(name)
        position = getattr(event, "pos", None)
        if position is None:
            return False, None
        inside = self.rect.collidepoint(position)
        if event.type == pygame.MOUSEMOTION:
            self.pointed = self._time_at(position[0]) if inside or self._dragging else None
            return inside or self._dragging, None
        if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1 and inside:
            held = self.spots.pressed is not None or self.controls.pressed is not None
            self._dragging = not held and self.state.share is None
            return True, None
        if event.type == pygame.MOUSEBUTTONUP and event.button == 1 and self._dragging:
            self._dragging = False
            return True, Wish("seek", self._time_at(position[0]))
        return inside, None

    def _time_at(self, x: int) -> float:
        """The moment at a pixel; near a chapter's mark its beginning."""
        track, length = self.track, self.state.length_s
        for _, begins in self.state.chapters:
            if abs(self._x_of(begins) - x) <= SNAP * self.look.k:
                return begins
        return min(max((x - track.x) / track.w, 0.0), 1.0) * length

    def _x_of(self, time_s: float) -> float:
        track = self.track
        return track.x + track.w * min(max(time_s / max(self.state.length_s, 1e-9), 0.0), 1.0)

    # -- picture ------------------------------------------------------------------------------------

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the bar over the foot of the stage."""
        look, state, theme, px = self.look, self.state, self.look.theme, self.look.px
        if self.rect.w < px(SIDE + CLOCK + 60) or self.rect.h < px(HEIGHT) // 2:
            return
        surface.fill(theme.panel, self.rect)  # hints may lie below it
        self._draw_controls(surface)
        self._draw_clock(surface)
        track, now = self.track, self._x_of(state.now_s)
        draw_box(surface, track, px(3), theme.inset)
        done = pygame.Rect(track.x, track.y, max(round(now) - track.x, 1), track.h)
        draw_box(surface, done, px(3), theme.text3 if state.taken_over else theme.accent)
        for _, begins in state.chapters:
            mark = pygame.Rect(0, 0, max(px(2), 2), px(12))
            mark.center = (round(self._x_of(begins)), track.centery)
            surface.fill(theme.text2 if begins > state.now_s else theme.text1, mark)
        draw_disc(surface, (now, track.centery), px(6), theme.text1)
        self._draw_words(surface, track)
        for spot in self.spots.spots:
            lit = self.spots.hover(spot.name)
            first = spot.name in ("story-go-on", "story-take-over")
            fill = theme.accent if first else theme.inset
            draw_box(surface, spot.rect, px(8), fill.lerp(theme.text1, 0.15 * lit))
            color = theme.on_accent if first else theme.text1
            words = look.fonts.fit(spot.tip, 13, "semibold", spot.rect.w - px(8))
            look.text(surface, words, spot.rect.center, 13, "semibold", color, "center")

    def _draw_controls(self, surface: pygame.Surface) -> None:
        look, theme, px = self.look, self.look.theme, self.look.px
        for spot in self.controls.spots:
            lit = self.controls.hover(spot.name)
            draw_box(surface, spot.rect, px(8), theme.inset.lerp(theme.text1, 0.15 * lit))
            if spot.name == "pause":
                sign = icon("play" if self.state.paused else "pause", px(20), theme.text1)
                surface.blit(sign, sign.get_rect(center=spot.rect.center))
            else:
                words = self.state.speed if spot.name == "story-speed" else "Chapters"
                look.text(surface, words, spot.rect.center, 13, "semibold", theme.text1, "center")

    def _draw_clock(self, surface: pygame.Surface) -> None:
        words = f"{clock(self.state.now_s)} / {clock(self.state.length_s)}"
        left = self._clock_left
        self.look.text(surface, words, (left, self.rect.centery), 12, "medium", "text2")

    def _draw_words(self, surface: pygame.Surface, track: pygame.Rect) -> None:
        """The chapter under the pointer, or how far a jump has come."""
        look, state = self.look, self.state
        if state.share is not None:
            words, x = f"Simulating {100.0 * state.share:.0f} %", float(track.centerx)
        elif self.pointed is not None:
            title = next((t for t, begins in reversed(state.chapters) if begins <= self.pointed), "")
            words, x = f"{clock(self.pointed)}  {title}".rstrip(), self._x_of(self.pointed)
        else:
            return
        half = look.fonts.size(words, 12, "semibold")[0] // 2 + look.px(8)
        picture = state.picture if state.share is None else None
        if picture is not None:
            half = max(half, self._small[0] // 2)
        x = min(max(x, self.rect.x + half), self.rect.right - half)
        place = pygame.Rect(round(x) - half, self.rect.y - look.px(28), 2 * half, look.px(24))
        if picture is not None:
            frame = pygame.Rect(
                round(x) - self._small[0] // 2, place.y - self._small[1] - look.px(4), *self._small
            )
            surface.blit(pygame.transform.smoothscale(picture, frame.size), frame)
            draw_box(surface, frame, 0, None, look.theme.line, look.border)
        draw_box(surface, place, look.px(6), look.theme.panel, look.theme.line, look.border)
        look.text(surface, words, place.center, 12, "semibold", "text1", "center")
        if state.share is not None:
            done = pygame.Rect(place.x, place.bottom - look.px(3), round(place.w * state.share), look.px(3))
            surface.fill(look.theme.accent, done)


def clock(seconds: float) -> str:
    """Minutes and seconds."""
    whole = int(max(seconds, 0.0))
    return f"{whole // 60}:{whole % 60:02d}"
