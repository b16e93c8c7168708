"""The menu's places: nothing overlaps, everything is in the window, arrows lead somewhere sensible."""

import pygame
from hypothesis import given
from hypothesis import strategies as st

from game.app.menu.flow import Group, arrange_cards, arrange_rows, nearest_in_direction

EIGHTEEN = [
    Group("Billiards", ("billiards", "lecture-table", "three-tables")),
    Group("Animation", ("c01", "c02", "c03")),
    Group("Particles", ("c04", "c14", "c15")),
    Group("Rigid", ("c12", "c13")),
    Group("Collision", tuple(f"c{n:02d}" for n in range(5, 12))),
]


def test_eighteen_scenes_lie_as_in_the_drawing():
    flow = arrange_cards(EIGHTEEN, "billiards", 1280, 600, 1.0)
    places = {card.name: card.rect for card in flow.cards}
    assert places["billiards"] == pygame.Rect(32, 28, 336, 160)
    assert places["lecture-table"] == pygame.Rect(384, 28, 160, 160)
    assert places["c01"] == pygame.Rect(736, 28, 160, 160)
    assert places["c04"] == pygame.Rect(32, 228, 160, 160)
    assert places["c11"] == pygame.Rect(1088, 428, 160, 160)
    assert [head.text for head in flow.heads] == ["Billiards", "Animation", "Particles", "Rigid", "Collision"]
    assert flow.height == 600


def test_a_row_is_filled_with_the_category_that_fits_best():
    twenty = [
        Group("Billiards", ("billiards", "lecture-balls", "lecture-table", "three-tables")),
        Group("Animation", ("c01", "c02", "c03")),
        Group("Particles", ("c04", "c14", "c15")),
        Group("Broad phase", ("c05", "c06", "c07", "race")),
        Group("Bounds", ("c08", "c09", "c10", "c11")),
        Group("Rigid", ("c12", "c13")),
    ]
    flow = arrange_cards(twenty, "billiards", 1280, 600, 1.0)
    assert flow.height == 600 and {card.rect.w for card in flow.cards if not card.wide} == {160}
    assert [head.text for head in flow.heads] == [
        "Billiards", "Rigid", "Animation", "Broad phase", "Particles", "Bounds",
    ]  # fmt: skip


def test_few_scenes_get_larger_cards():
    flow = arrange_cards([Group("Billiards", ("a", "b"))], "a", 1280, 600, 1.0)
    assert flow.cards[0].wide
    assert flow.cards[1].rect.w > 300
    assert flow.cards[1].rect.right <= 1280 - 32


groups = st.lists(st.integers(1, 9), min_size=0, max_size=6).map(
    lambda counts: [Group(f"g{g}", tuple(f"s{g}-{i}" for i in range(n))) for g, n in enumerate(counts)]
)


@given(groups=groups, width=st.integers(1, 4000), height=st.integers(1, 2400), k=st.floats(0.5, 3.0))
def test_cards_never_overlap_and_stay_inside(groups: list[Group], width: int, height: int, k: float):
    flow = arrange_cards(groups, "s0-0", width, height, k)
    names = [card.name for card in flow.cards]
    assert sorted(names) == sorted(name for group in groups for name in group.names)
    for group in groups:  # the cards of a category stand together, in their order
        first = names.index(group.names[0])
        assert tuple(names[first : first + len(group.names)]) == group.names
    for i, card in enumerate(flow.cards):
        assert card.rect.w > 0 and card.rect.h > 0
        assert card.rect.contains(card.picture)
        assert card.rect.bottom <= flow.height
        assert card.rect.right <= max(width, round(64 * k) + round(90 * k))
        assert all(not card.rect.colliderect(other.rect) for other in flow.cards[:i])


@given(count=st.integers(0, 40), width=st.integers(1, 4000), k=st.floats(0.5, 3.0))
def test_rows_never_overlap(count: int, width: int, k: float):
    rects = arrange_rows(count, 10, width, k)
    assert len(rects) == count
    for i, rect in enumerate(rects):
        assert all(not rect.colliderect(other) for other in rects[:i])


def test_arrows_follow_rows_and_columns():
    flow = arrange_cards(EIGHTEEN, "billiards", 1280, 600, 1.0)
    names = [card.name for card in flow.cards]
    rects = [card.rect for card in flow.cards]

    def go(name: str, dx: int, dy: int) -> str:
        return names[nearest_in_direction(rects, names.index(name), dx, dy)]

    assert go("billiards", 1, 0) == "lecture-table"
    assert go("three-tables", 1, 0) == "c01"
    assert go("c03", 1, 0) == "c03"
    assert go("c01", 0, 1) == "c13"
    assert go("c13", 0, -1) == "c01"
    assert go("c04", 0, -1) == "billiards"
    assert go("c13", 1, 0) == "c13"


@given(
    groups=groups.filter(bool),
    width=st.integers(200, 3000),
    steps=st.lists(st.sampled_from([(1, 0), (-1, 0), (0, 1), (0, -1)])),
)
def test_arrows_always_lead_to_a_card(groups: list[Group], width: int, steps: list[tuple[int, int]]):
    rects = [card.rect for card in arrange_cards(groups, "", width, 700, 1.0).cards]
    at = 0
    for dx, dy in steps:
        to = nearest_in_direction(rects, at, dx, dy)
        moved = (rects[to].centerx - rects[at].centerx) * dx + (rects[to].centery - rects[at].centery) * dy
        assert to == at or moved > 0
        at = to


def test_every_card_can_be_reached():
    rects = [card.rect for card in arrange_cards(EIGHTEEN, "billiards", 1280, 600, 1.0).cards]
    reached, waiting = {0}, [0]
    while waiting:
        at = waiting.pop()
        for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)):
            to = nearest_in_direction(rects, at, dx, dy)
            if to not in reached:
                reached.add(to)
                waiting.append(to)
    assert len(reached) == len(rects)
