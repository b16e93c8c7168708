"""The menu's places: nothing overlaps, everything is in the window, arrows lead somewhere sensible."""

import pygame
from hypothesis import given
from hypothesis import strategies as st

from game.app.menu.flow import NARROWEST, Group, arrange_cards, arrange_rows, nearest_in_direction

EIGHTEEN = [
    Group("Billiards", ("billiards", "lecture-table", "three-tables")),
    Group("Animation", ("c01", "c02", "c03")),
    Group("Particles", ("c04", "c14", "c15")),
    Group("Rigid", ("c12", "c13")),
    Group("Collision", tuple(f"c{n:02d}" for n in range(5, 12))),
]


def test_cards_are_large_and_rows_full():
    flow = arrange_cards(EIGHTEEN, "billiards", 1280, 560, 1.0)
    places = {card.name: card.rect for card in flow.cards}
    assert places["billiards"] == pygame.Rect(32, 28, 477, 206)
    assert places["c01"] == pygame.Rect(32, 274, 230, 206)
    assert places["c12"].topleft == (771, 274)
    assert min(card.rect.w for card in flow.cards) >= NARROWEST
    heads = [head.text for head in flow.heads]
    assert heads == ["Billiards", "Animation", "Rigid", "Particles", "Collision"]


def test_on_a_finer_screen_everything_is_as_much_larger():
    plain = arrange_cards(EIGHTEEN, "billiards", 1280, 560, 1.0)
    fine = arrange_cards(EIGHTEEN, "billiards", 2560, 1120, 2.0)
    assert abs(fine.height - 2 * plain.height) <= 4
    for small, large in zip(plain.cards, fine.cards, strict=True):
        assert small.name == large.name
        pairs = zip((*small.rect, *small.picture), (*large.rect, *large.picture), strict=True)
        assert max(abs(b - 2 * a) for a, b in pairs) <= 4
    for small, large in zip(plain.heads, fine.heads, strict=True):
        assert max(abs(b - 2 * a) for a, b in zip(small[2], large[2], strict=True)) <= 4


def test_categories_keep_their_order_and_begin_with_their_first_topic():
    groups = [
        Group("Play", ("billiards",), "Play"),
        Group("Animation", ("c01", "c02"), "Course"),
        Group("Broad phase", ("c05", "c06", "c07"), "Course"),
        Group("Rigid", ("c12", "c13"), "Course"),
        Group("Stories", tuple(f"s{i}" for i in range(7)), "Stories"),
        Group("Papers", ("p0", "p1", "p2"), "Papers"),
    ]
    flow = arrange_cards(groups, "billiards", 1280, 560, 1.0)
    names = [card.name for card in flow.cards]
    assert names == [
        "billiards",
        "c01",
        "c02",
        "c05",
        "c06",
        "c07",
        "c12",
        "c13",
        "s0",
        "s1",
        "s2",
        "s3",
        "s4",
        "s5",
        "s6",
        "p0",
        "p1",
        "p2",
    ]
    assert [card.category for card in flow.cards if card.name in ("c13", "s0")] == ["Course", "Stories"]
    tops = {card.name: card.rect.top for card in flow.cards}
    assert tops["c02"] == tops["billiards"] and tops["s6"] == tops["p2"] > tops["s4"] > tops["c13"]


def test_recent_ones_take_what_the_row_has_left():
    recent = Group("Recent", tuple(f"r{i}" for i in range(9)), "Recent", again=True, one_row=True)

    def number(favourites: int) -> tuple[int, int]:
        starred = Group("Favourites", tuple(f"f{i}" for i in range(favourites)), "Favourites", again=True)
        flow = arrange_cards([starred, recent] if favourites else [recent], "f0", 1280, 100, 1.0)
        shown = [card for card in flow.cards if card.category == "Recent"]
        assert flow.heads[-1].number == len(shown) and not any(card.wide for card in flow.cards)
        return len(shown), len({card.rect.top for card in flow.cards})

    assert [number(n) for n in (0, 1, 3, 4, 5)] == [(5, 1), (4, 1), (2, 1), (5, 2), (5, 2)]


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
    flow = arrange_cards(EIGHTEEN, "billiards", 1280 + 2 * 224, 600, 1.0)  # seven columns
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
