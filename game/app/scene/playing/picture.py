"""The picture of a scene in play: scene, shell and signs; the last one while a thread works in the scene."""

from __future__ import annotations

from typing import Any

import pygame

from game.app.scene.playing.standstill import Standstill, draw_signs


class PlayPicture:
    """Draws what the parts of a scene in play show. play: a `ScenePlay`, which makes this one."""

    def __init__(self, play: Any) -> None:
        self._play = play
        self.standstill = Standstill()

    def draw(self, surface: pygame.Surface) -> None:
        """The scene and its shell; as they were while a thread is at work in the scene."""
        play, errands = self._play, self._play.record.errands
        if errands.inside:
            self.standstill.show(surface)
        else:
            self.standstill.end()
            self._draw(surface)
            errands.shown()
        if play.story is not None:
            play.story.draw_bar(surface)
        if play.story is None or play.story.journey.share is None:  # its bar says how far a jump has come
            self.standstill.tell(surface, play.host.look, play.view.rect, errands.seconds)

    def _draw(self, surface: pygame.Surface) -> None:
        play = self._play
        play.steps.seen = True
        layout, story = play.shell.layout, play.story
        pictureless = play.stopping.hides(play.stage)
        if pictureless or layout.free_stage != layout.stage:  # else the scene's picture covers it
            surface.fill(play.host.look.theme.stage, layout.stage)
        if not pictureless:
            play.view.draw(surface, play.shell.beat.fresh)
            if story is not None:
                story.draw_words(surface)
        if story is None:
            play.caption.draw(surface)
        if not pictureless:
            play.bench.draw(surface, layout.free_stage)
        play.films.see(surface, layout.free_stage)
        draw_signs(surface, play.host.look, layout, self._signs(pictureless))
        play.shell.bare = play.stopped or not play.view.teaching
        play.shell.draw(surface, play.stage, () if play.shell.bare else play.stage.scene.legend())
        play.banner.draw(surface)

    def _signs(self, pictureless: bool) -> tuple[str, str, str]:
        """What is watched, what is filmed, and the way home of a view that has lost the scene."""
        play = self._play
        watched = f"{play.record.watched} · a touch takes over" if play.record.watched else ""
        lost = play.story is None and not pictureless and play.view.lost
        home = f"Out of view · {play.host.keys.label('view')} shows all of it" if lost else ""
        return watched, play.films.words, home
