"""pygame_gui's manager, as the panel needs it: themed, in the panel's own coordinates, moved by events alone.

The stock manager reads the real mouse each frame. This one believes only what it is told, so that a posted
event and a hand do the same, with or without a screen.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import pygame
import pygame_gui
from pygame_gui import UIManager, ui_manager
from pygame_gui.core.resource_loaders import BlockingThreadedResourceLoader
from pygame_gui.core.surface_cache import SurfaceCache
from pygame_gui.core.ui_appearance_theme import UIAppearanceTheme
from pygame_gui.elements import UIDropDownMenu, UISelectionList

from game.ui.look.assets import asset
from game.ui.look.look import Look
from game.ui.look.theme import gui_theme

QUEUED = (
    pygame_gui.UI_BUTTON_START_PRESS, pygame_gui.UI_BUTTON_PRESSED, pygame_gui.UI_BUTTON_DOUBLE_CLICKED,
    pygame_gui.UI_BUTTON_ON_HOVERED, pygame_gui.UI_BUTTON_ON_UNHOVERED, pygame_gui.UI_DROP_DOWN_MENU_CHANGED,
    pygame_gui.UI_SELECTION_LIST_NEW_SELECTION, pygame_gui.UI_SELECTION_LIST_DROPPED_SELECTION,
    pygame_gui.UI_TEXT_ENTRY_CHANGED, pygame_gui.UI_TEXT_ENTRY_FINISHED,
)  # fmt: skip
CORNERS = 6  # px
MOST_ROUNDS = 6  # of events that answer events
LOCALE = "en"
MOST_THEMES = 4  # kept: dark and light, a window as it is and as it was

_themes: dict[tuple[str, float], UIAppearanceTheme] = {}  # the one used last at the end


@lru_cache(maxsize=1)
def _loader() -> BlockingThreadedResourceLoader:
    """Loads fonts at once; one for all managers, for each begins with five threads."""
    loader = BlockingThreadedResourceLoader()
    loader.start()
    loader.update()
    return loader


def _font_files() -> list[str]:
    return [
        str(asset("fonts", f"CaromSans-{face}.otf")) for face in ("Medium", "SemiBold", "Italic", "SemiBold")
    ]


class ShapeStore(SurfaceCache):
    """Pictures of one manager's elements by what they look like.

    The stock one copies each, in a later frame, into one of three sheets of 4 MB, and has no place for
    what is higher than these.
    """

    def __init__(self) -> None:
        self._kept: dict[str, pygame.Surface] = {}

    def add_surface_to_cache(self, surface: pygame.Surface, string_id: str) -> None:
        self._kept[string_id] = surface.copy()

    def find_surface_in_cache(self, lookup_id: str) -> pygame.Surface | None:
        return self._kept.get(lookup_id)

    def update(self) -> None:
        """Nothing is to be moved."""

    def remove_user_from_cache_item(self, string_id: str) -> None:
        """A picture is kept as long as its manager."""

    def remove_user_and_request_clean_up_of_cached_item(self, string_id: str) -> None:
        self._kept.pop(string_id, None)


class PanelTheme(UIAppearanceTheme):
    """The stock theme with short keys: its own are woven of all ids, megabytes long, and kept."""

    unique_theming_ids: dict[str, list[str]]

    def build_all_combined_ids(self, *ids: Any) -> list[str]:
        key = repr(ids)
        found = self.unique_theming_ids.get(key)
        if found is None:
            before = dict(self.unique_theming_ids)
            found = super().build_all_combined_ids(*ids)
            self.unique_theming_ids = {**before, key: found}
        return found


def prepared_theme(look: Look) -> UIAppearanceTheme:
    """The theme of a look, read and checked once; any thread may ask for it beforehand."""
    key = look.theme.name, look.k
    theme = _themes.pop(key, None)
    if theme is None:
        theme = PanelTheme(_loader(), LOCALE)
        theme.get_font_dictionary().add_font_path("carom_sans", *_font_files())
        theme.load_theme(gui_theme(look.theme, look.k))
    _themes[key] = theme
    for old in list(_themes)[:-MOST_THEMES]:
        _themes.pop(old, None)
    return theme


class PanelManager(UIManager):
    """A manager for a sheet of so many window px."""

    def __init__(self, size: tuple[int, int], look: Look) -> None:
        self._look = look
        paths = ui_manager.i18n.load_path
        before = list(paths)
        super().__init__(size, enable_live_theme_updates=False, resource_loader=_loader())
        paths[:] = list(dict.fromkeys([*before, *paths]))  # else there is one more with each manager
        self.mouse_position = (-1, -1)

    def create_new_theme(self, theme_path: Any = None) -> UIAppearanceTheme:
        """The theme of the look, with no pictures of another manager's."""
        theme = prepared_theme(self._look)
        theme._shape_cache = ShapeStore()
        return theme

    def _update_mouse_position(self) -> None:
        """The position is set by ``point``."""

    def point(self, position: tuple[int, int]) -> None:
        """The pointer is here now, px of the sheet."""
        self.mouse_position = position

    def tell(self, event: pygame.event.Event) -> None:
        """Let an event act, and what elements post in answer, until nothing more is said."""
        self.process_events(event)
        if event.type == pygame.MOUSEMOTION:
            return
        for _ in range(MOST_ROUNDS):
            self.update(0.0)
            answers = pygame.event.get(QUEUED)
            if not answers:
                return
            for answer in answers:
                self.process_events(answer)

    def pictures(self) -> list[tuple[object, tuple[int, ...]]]:
        """The picture and place of every visible element: if they are the same, so is the sheet."""
        return [(data[0], tuple(data[1])) for data in self.ui_group.visible]


class DropDown(UIDropDownMenu):
    """A drop-down of labelled values; ``taken`` gives a newly chosen one once."""

    def __init__(
        self,
        options: list[tuple[str, str]],
        chosen: str,
        rect: pygame.Rect,
        manager: PanelManager,
        tip: str = "",
    ) -> None:
        start = next((option for option in options if option[1] == chosen), options[0])
        super().__init__(list(options), start, rect, manager)
        self.options = options
        self.tip = tip
        self.idle = ""  # why it changes nothing now: grey, and it does not open
        self._known = start[1]

    def set_idle(self, reason: str) -> None:
        """Take no hand for a reason, or take it again ("")."""
        if bool(reason) != bool(self.idle):
            (self.disable if reason else self.enable)()
        self.idle = reason

    @property
    def is_open(self) -> bool:
        """Whether the list is shown."""
        return self.current_state is self.menu_states["expanded"]

    @property
    def foot(self) -> int:
        """Lower end of the list while it is open, else of the box; px of the sheet."""
        rows = getattr(self.menu_states["expanded"], "options_selection_list", None)
        return rows.rect.bottom if self.is_open and rows is not None else self.rect.bottom

    def update(self, time_delta: float) -> None:
        """Give a list that has just opened the width of its box, and space for its round lower corners."""
        super().update(time_delta)
        opened: Any = self.menu_states["expanded"]
        if not self.is_open or opened.options_selection_list.rect.w == self.rect.w:
            return
        opened.options_selection_list.kill()
        space = self.ui_container.get_container().get_relative_rect().h - opened.option_list_y_pos
        height = min(opened.options_list_height + CORNERS, space)
        rows = opened.options_selection_list = UISelectionList(
            pygame.Rect(self.relative_rect.x, opened.option_list_y_pos, self.relative_rect.w, height),
            opened.options_list, self.ui_manager, container=self.ui_container, starting_height=3,
            parent_element=self, object_id="#drop_down_options_list", default_selection=self.selected_option,
            allow_double_clicks=False,
        )  # fmt: skip
        self.join_focus_sets(rows)

    def process_event(self, event: pygame.event.Event) -> bool:
        """As ever; the value that stands, clicked again, closes the list as any other does."""
        opened: Any = self.menu_states["expanded"]
        if (
            self.is_open
            and event.type == pygame_gui.UI_SELECTION_LIST_DROPPED_SELECTION
            and event.ui_element is opened.options_selection_list
        ):
            opened.should_transition = True
        return bool(super().process_event(event))

    def taken(self) -> str | None:
        """The value chosen since the last look, if there is a new one."""
        value = str(self.selected_option[1])
        if value == self._known:
            return None
        self._known = value
        return value

    def follow(self, value: str) -> bool:
        """True if a value was set elsewhere, so that the box must be made again."""
        return value != self._known
