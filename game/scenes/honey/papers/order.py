"""The paper on neighbour search for particle fluids (P13)."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from game.arrays import Floats, Longs
from game.lab.timing import least_time
from game.physics.kernels import linear
from game.physics.particle_fluids import SEARCHES, NeighbourSearch
from game.physics.particle_fluids.search import Pairs
from game.scenes.honey.papers.plots import Plot, placed
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

MANY, FEW, NEIGHBOURS = 20_000, 400, 12
LINE, CACHE = 4, 128  # places of 16 bytes in a line; lines of a cache of 8 kB
NAMES = {"grid": "row by row", "z-order": "Z-order", "hash": "hash table"}


def scattered(count: int) -> tuple[Floats, float]:
    """Places (n, 2) in a unit square in no order, and a support of about twelve neighbours."""
    random = np.random.default_rng(7)
    return linear.uniform(random, np.zeros((count, 2)), 1.0), float(np.sqrt(NEIGHBOURS / (np.pi * count)))


def misses(first: Sequence[int], second: Sequence[int], line: int = LINE, cache: int = CACHE) -> int:
    """Lines that a cache must fetch as the places of pairs are read one pair after the other.

    A model: the line that was used the longest ago gives way to another.
    """
    held: OrderedDict[int, None] = OrderedDict()
    fetched = 0
    for pair in zip(first, second, strict=True):
        for place in pair:
            number = place // line
            if number in held:
                held.move_to_end(number)
                continue
            fetched += 1
            held[number] = None
            if len(held) > cache:
                held.popitem(last=False)
    return fetched


def pairs_in_order(method: str, count: int) -> tuple[list[int], list[int]]:
    """Numbers of both particles of each pair as a search finds them, its particles sorted its own way."""
    places, support = scattered(count)
    search = NeighbourSearch(support, method)
    pairs = search.find(places)
    return _rows(pairs), pairs.other[: int(pairs.start[-1])].tolist()


def _rows(pairs: Pairs) -> list[int]:
    return np.repeat(np.arange(len(pairs.start) - 1), np.diff(pairs.start)).tolist()


def cells_looked_up(count: int) -> tuple[int, int]:
    """Cells asked for by each particle, and once for each cell that is not empty: four, one side only."""
    places, support = scattered(count)
    cells = np.floor(places / support).astype(np.int64)
    return 4 * count, 4 * len(np.unique(cells, axis=0))


def order_of(method: str, count: int) -> tuple[Floats, Longs]:
    """Places in the order in which a search keeps them, and their numbers before."""
    places, support = scattered(count)
    search = NeighbourSearch(support, method)
    search.find(places)
    return search.place.copy(), search.order.copy()


def _draw_orders(pen: Pen) -> None:
    """The way through the cells of a pool, row by row and along the curve, as the searches go it."""
    side = 8
    middles = (np.arange(side) + 0.5) / side
    places = np.stack([np.repeat(middles, side), np.tile(middles, side)], axis=1)
    for left, method in ((12.0, "grid"), (156.0, "z-order")):
        search = NeighbourSearch(0.999 / side, method)
        search.find(places)
        box = (left, 30.0, left + 128.0, 158.0)
        points = [placed(box, ((0.0, 1.0), (0.0, 1.0)), x, y) for x, y in search.place.tolist()]
        pen.line(points, "chalk" if method == "grid" else "amber", 2.0)
        pen.words(NAMES[method], left + 64.0, 178.0, "text1")


def _draw_key(pen: Pen) -> None:
    """Bits of column 5 and row 3 and the key that they make."""
    x, y = 5, 3
    for k in range(3):
        for row, value, color in ((40.0, x, "accent"), (84.0, y, "amber")):
            pen.box(100.0 + 40.0 * k, row, 28.0, 28.0, color, ring=1.6)
            pen.words(str(value >> (2 - k) & 1), 114.0 + 40.0 * k, row + 14.0, color)
        for shift, value, color in ((34.0, x, "accent"), (0.0, y, "amber")):
            left = 30.0 + 80.0 * k + shift
            pen.box(left, 140.0, 28.0, 28.0, color, ring=1.6)
            pen.words(str(value >> (2 - k) & 1), left + 14.0, 154.0, color)
    pen.words("column 5", 50.0, 54.0, "accent")
    pen.words("row 3", 50.0, 98.0, "amber")
    pen.words(f"key {_key(x, y)}", 148.0, 190.0, "text1")


def _key(x: int, y: int) -> int:
    return sum(((x >> k & 1) << 2 * k) | ((y >> k & 1) << 2 * k + 1) for k in range(3))


def _draw_sorted(pen: Pen) -> None:
    """Particles coloured by where they stand in memory, before and after the sort."""
    places, order = order_of("z-order", FEW)
    for left, rank, words in ((10.0, order, "as they came"), (154.0, np.arange(FEW), "sorted by key")):
        for (x, y), number in zip(places.tolist(), rank.tolist(), strict=True):
            at = placed((left, 24.0, left + 132.0, 156.0), ((0.0, 1.0), (0.0, 1.0)), x, y)
            pen.disc(*at, 3.0, pen.look.color("amber").lerp(pen.look.color("chalk"), number / FEW))
        pen.words(words, left + 66.0, 178.0, "text1")


def _draw_closed(pen: Pen) -> None:
    """Cells about one that is not empty: looked up once, then shared by all of its particles."""
    places, support = scattered(FEW)
    cells = np.floor(places / support).astype(np.int64)
    at = max(((3, 3), (4, 4), (5, 3), (6, 5)), key=lambda cell: int(np.sum((cells == cell).all(axis=1))))
    x, y = at
    frame = ((x - 2.0, x + 3.0), (y - 1.5, y + 2.2))
    box = (8.0, 6.0, 280.0, 6.0 + 272.0 * 3.7 / 5.0)
    for k in range(3):
        for m in range(3):
            a, b = (
                placed(box, frame, x + k - 1.0, y + m - 1.0),
                placed(box, frame, float(x + k), float(y + m)),
            )
            later = m == 2 or (m == 1 and k == 2)
            if later:
                pen.area((a, (b[0], a[1]), b, (a[0], b[1])), "amber", 0.75)
            pen.line((a, (b[0], a[1]), b, (a[0], b[1]), a), "text3", 1.0)
    near = np.max(np.abs(cells - np.array(at)), axis=1) <= 1
    for place, cell in zip((places[near] / support).tolist(), cells[near].tolist(), strict=True):
        pen.disc(*placed(box, frame, *place), 4.0, "accent" if tuple(cell) == at else "text1")


def _draw_misses(pen: Pen) -> None:
    """Lines fetched for a thousand pairs, over the size of the cache, by both orders."""
    sizes = np.array([16, 32, 64, 128, 256, 512])
    plot = Plot(pen, (36.0, 20.0, 280.0, 168.0), (4.0, 9.0), (0.0, 160.0))
    for k, (method, color) in enumerate((("grid", "chalk"), ("z-order", "amber"))):
        first, second = pairs_in_order(method, 4000)
        found = np.array([1000.0 * misses(first, second, LINE, int(size)) / len(first) for size in sizes])
        plot.curve(np.log2(sizes), found, color)
        plot.points(np.log2(sizes), found, color)
        pen.words(NAMES[method], 236.0, 30.0 + 18.0 * k, color)
    for size in (16, 64, 256):
        pen.words(str(size), plot.at(float(np.log2(size)), 0.0)[0], 180.0, "text3", size=11)
    pen.words("lines of the cache", 158.0, 196.0, "text2", size=11)


def _measure() -> Iterator[Comparison]:
    places, support = scattered(MANY)
    times, sets = {}, {}
    for method in SEARCHES:
        search = NeighbourSearch(support, method)
        search.find(places)
        arranged = search.place.copy()  # as they stand a step later
        times[method] = least_time(partial(search.find, arranged), 5)
        pairs = int(search.pairs.start[-1])
        few = NeighbourSearch(support, method)
        few.find(places[:2000])
        sets[method] = few.sets()
    each = ", ".join(f"{NAMES[method]} {1e9 * times[method] / pairs:.1f}" for method in SEARCHES)
    yield Comparison(f"{MANY} particles: a pair found, sort and all", "", f"{each} ns")
    differ = max(len(sets["grid"] ^ other) for other in sets.values())
    yield Comparison("pairs that differ between the searches", "none", f"{differ} of {len(sets['grid'])}")
    apart, together = cells_looked_up(MANY)
    yield Comparison("cells looked up: by each particle, once for each cell", "once for each cell",
                     f"{apart}, {together}")  # fmt: skip
    random = np.random.default_rng(5).permutation(MANY)
    found = {method: pairs_in_order(method, MANY) for method in ("grid", "z-order")}
    lost = {NAMES[method]: misses(*both) / len(both[0]) for method, both in found.items()}
    first, second = found["grid"]
    lost["unsorted"] = misses(random[first].tolist(), random[second].tolist()) / len(first)
    yield Comparison(
        f"lines fetched for a pair, a cache of {CACHE} lines (model)", "fewer along the curve",
        ", ".join(f"{name} {share:.2f}" for name, share in lost.items()),
    )  # fmt: skip
    cells = round(1.0 / support) * round(1.0 / support)
    search = NeighbourSearch(support, "z-order")
    spread = places * 40.0
    sparse = least_time(lambda: search.find(spread), 3)
    grid = NeighbourSearch(support)
    dense = least_time(lambda: grid.find(spread), 3)
    yield Comparison(
        f"the same particles strewn over 1600 times the area ({1600 * cells / 1e6:.1f} million cells)",
        "memory by particles, not by cells",
        f"Z-order {1e3 * sparse:.1f} ms, row by row {1e3 * dense:.1f} ms",
    )  # fmt: skip


ORDER = Paper(
    problem=(
        "A fluid of particles spends most of its time looking for neighbours. A table of cells is fast, "
        "but needs a bounded world. A hash table needs none, but what is near in space lies far apart in "
        "memory. Memory is what one waits for.",
    ),
    idea=(
        "Number the cells along a curve that stays near where it is, and sort the particles by that "
        "number. Then cells that are not empty form one short sorted list, and neighbours in space are "
        "mostly neighbours in memory.",
    ),
    steps=(
        Step("The curve: row by row the next row is far away, along Z it often is near.", _draw_orders),
        Step(
            "A cell's number takes turns with the bits of its column and its row.",
            _draw_key,
            r"k = \text{bits } x_0 y_0 x_1 y_1 ...",
        ),
        Step("Numbers are sorted digit by digit, in a time that grows as their count.", _draw_sorted),
        Step(
            "Closed search: the cells about one are looked up once for all of its particles. Only "
            "those on one side (shaded) count, so each pair is met once.",
            _draw_closed,
        ),
        Step("What a cache has to fetch for a thousand pairs, by a model of it.", _draw_misses),
    ),
    showed=(
        "A search by sorted numbers of cells for fluids in space, beside searches by cells and by hashing. "
        "Its memory grows with the particles and not with the world.",
    ),
    measure=_measure,
    limits=(
        "In the plane the neighbours are two short stretches of a row: the counting sort beside it is hard "
        "to beat as long as the world is small. The curve gains where cells are many and the cache is "
        "small, and in space. Its numbers have 32 bits here: 65,536 cells either way.",
    ),
    after=(
        "Sorting by Z-numbers with compact hashing (Ihmsen and others 2011) and sorting on graphics hardware "
        "(Green 2008) are what large fluids use. Between sorts, particles move little: so an insertion "
        "sort suffices.",
    ),
)
