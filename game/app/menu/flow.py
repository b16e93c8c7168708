"""Where the menu's cards lie: categories packed into rows, cards large enough to be looked at.

Design measures: margins 32, header 80, bar of categories 40, footer 40, gap 16, a card's picture 160:104 with
56 for its words, 28 for a group's name above.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import pygame

MARGIN, HEADER, BAR, FOOTER, GAP, ROW_GAP, HEAD, WORDS = 32, 80, 40, 40, 16, 12, 28, 56  # design px
NARROWEST, WIDEST = 208, 400  # design px of a card
PICTURE = 104 / 160  # height of a picture to its width
STAR = 40  # design px of a card's corner
LIST_ROW, LIST_COLUMN = 44, 360  # design px


class Card(NamedTuple):
    """A place for a scene's card, window px; ``picture`` is its upper part (a wide one's whole)."""

    name: str
    rect: pygame.Rect
    picture: pygame.Rect
    wide: bool
    category: str = ""


class Head(NamedTuple):
    """A group's name over its first card: words, how many, left end and middle in window px."""

    text: str
    number: int
    at: tuple[int, int]
    category: str = ""  # beside the words, where these name a part of it


class Flow(NamedTuple):
    """All cards and heads, and the height they take from the top of the content, window px."""

    cards: tuple[Card, ...]
    heads: tuple[Head, ...]
    height: int


class Group(NamedTuple):
    """Scenes under one heading: a category, or one of its topics.

    ``again``: these stand in a category of their own as well. ``one_row``: only what the row has space for.
    """

    title: str
    names: tuple[str, ...]
    category: str = ""
    again: bool = False
    one_row: bool = False


def arrange_cards(groups: Sequence[Group], wide: str, width: int, height: int, k: float) -> Flow:
    """Cards for a content ``width`` x ``height`` window px (without header and footer), at scale k.

    Categories follow one another in their order, each beginning with its first group; the others of a
    category come as they fill the rows best. The fewest columns are taken, and so the largest cards, with
    which nothing needs scrolling. If that cannot be, the columns are as many as there is space for. ``wide``
    names the scene that takes two columns.
    """
    most = max(1, int((width / k - 2 * MARGIN + GAP) // (NARROWEST + GAP)))
    least = 1
    while least < most and _share(least, width / k) > WIDEST:
        least += 1
    flow = _arrange(groups, wide, most, width, k)
    for columns in range(least, most):
        larger = _arrange(groups, wide, columns, width, k)
        if larger.height <= height:
            return larger
    return flow


def _share(columns: int, width: float) -> float:
    """Width of a card of so many beside each other, design px."""
    return (width - 2 * MARGIN - (columns - 1) * GAP) / columns


def _arrange(groups: Sequence[Group], wide: str, columns: int, width: int, k: float) -> Flow:
    card = max(min(_share(columns, width / k), WIDEST), 40.0) * k
    picture_height = round(card * PICTURE)
    card_height = picture_height + round(WORDS * k)
    pitch = round(HEAD * k) + card_height + round(ROW_GAP * k)
    cards: list[Card] = []
    heads: list[Head] = []
    row = column = 0
    left_over = list(groups)
    begun = left_over[0].category if left_over else ""
    while left_over:
        same = [group for group in left_over if group.category == begun]
        group = _best_fit(same or left_over[:1], wide, columns - column, columns)
        if group is None:
            row, column = row + 1, 0
            continue
        left_over.remove(group)
        begun = group.category
        names = group.names[: columns - column] if group.one_row else group.names
        for i, name in enumerate(names):
            span = _span(group, name, wide, columns)
            if column + span > columns:
                row, column = row + 1, 0
            left = round(MARGIN * k + column * (card + GAP * k))
            right = round(MARGIN * k + (column + span) * (card + GAP * k) - GAP * k)
            top = row * pitch + round(HEAD * k)
            if i == 0:
                heads.append(_head(group, len(names), left, row * pitch + round(12 * k)))
            rect = pygame.Rect(left, top, right - left, card_height)
            picture = rect if span == 2 else pygame.Rect(left, top, rect.w, picture_height)
            cards.append(Card(name, rect, pygame.Rect(picture), span == 2, group.category))
            column += span
    return Flow(tuple(cards), tuple(heads), (row + 1) * pitch if cards else 0)


def _head(group: Group, number: int, left: int, middle: int) -> Head:
    return Head(group.title, number, (left, middle), group.category)


def _span(group: Group, name: str, wide: str, columns: int) -> int:
    return 2 if name == wide and not group.again and columns >= 2 else 1


def _best_fit(groups: Sequence[Group], wide: str, space: int, columns: int) -> Group | None:
    """What comes next in a row with so many columns left: at its beginning the first group, however long;
    else the one that leaves the least space, the first of equals; None if none has place."""
    if space == columns:
        return groups[0]
    lengths = [_length(group, wide, space, columns) for group in groups]
    fitting = [(space - length, i) for i, length in enumerate(lengths) if length <= space]
    return groups[min(fitting)[1]] if fitting else None


def _length(group: Group, wide: str, space: int, columns: int) -> int:
    """Columns that a group takes in a row with so much space left; one that may be cut off wants two."""
    length = sum(_span(group, name, wide, columns) for name in group.names)
    return min(length, max(space, 2)) if group.one_row else length


def star_of(card: pygame.Rect, k: float) -> pygame.Rect:
    """Where a card's star is pressed: its right upper corner, window px."""
    side = round(STAR * k)
    return pygame.Rect(card.right - side, card.top, side, side)


def arrange_rows(count: int, top: int, width: int, k: float) -> tuple[pygame.Rect, ...]:
    """Places of list rows in as many columns as fit, line by line, window px."""
    content = width - 2 * round(MARGIN * k)
    columns = max(1, int(content // (LIST_COLUMN * k)))
    column_width = (content - (columns - 1) * GAP * k) / columns
    places = []
    for i in range(count):
        line, column = divmod(i, columns)
        left = round(MARGIN * k + column * (column_width + GAP * k))
        places.append(
            pygame.Rect(
                left, top + round(line * LIST_ROW * k), round(column_width), round((LIST_ROW - 4) * k)
            )
        )
    return tuple(places)


def nearest_in_direction(rects: Sequence[pygame.Rect], start: int, dx: int, dy: int) -> int:
    """Index of the place that an arrow key leads to from ``start``; ``start`` itself if there is none.

    Left and right stay in the row. Up and down take the nearest, counting what is sideways double.
    """
    here = rects[start]
    best, best_way = start, float("inf")
    for i, rect in enumerate(rects):
        along, aside, offset = _way(here, rect, dx, dy)
        if i == start or along < 0 or (dx and aside > 0):
            continue
        way = along + 2.0 * aside + 0.1 * offset
        if way < best_way:
            best, best_way = i, way
    return best


def _way(here: pygame.Rect, there: pygame.Rect, dx: int, dy: int) -> tuple[int, int, int]:
    """Gap the arrow's way (below 0: not that way), gap across it, and offset of the middles across it."""
    right, left = there.left - here.right, here.left - there.right
    below, above = there.top - here.bottom, here.top - there.bottom
    if dx:
        return (right if dx > 0 else left), max(below, above, 0), abs(there.centery - here.centery)
    return (below if dy > 0 else above), max(right, left, 0), abs(there.centerx - here.centerx)
