"""The order of solving: colours share no particle, runs lie side by side, every link comes once."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.constraints import shapes
from game.physics.constraints.colours import MAX_COLOURS, SHORTEST_RUN, arrange_links, colour_links

graphs = st.integers(2, 30).flatmap(
    lambda n: st.tuples(
        st.just(n),
        st.lists(
            st.tuples(st.integers(0, n - 1), st.integers(0, n - 1)).filter(lambda p: p[0] < p[1]), max_size=80
        ),
    )
)


@settings(max_examples=40)
@given(graphs)
def test_neighbours_differ_in_colour(graph):
    count, pairs = graph
    links = np.array(pairs, dtype=np.int64).reshape(-1, 2)
    colours = np.zeros(len(links), dtype=np.int64)
    colour_links(links, np.zeros(count, dtype=np.int64), colours)
    for colour in np.unique(colours):
        ends = links[colours == colour].ravel()
        assert colour == MAX_COLOURS or len(np.unique(ends)) == len(ends)


@settings(max_examples=40)
@given(graphs, st.sampled_from(("coloured", "natural", "reversed")))
def test_every_link_is_solved_once(graph, order):
    count, pairs = graph
    links = np.array(pairs, dtype=np.int64).reshape(-1, 2)
    places, runs = arrange_links(links, count, order)
    assert sorted(places.tolist()) == list(range(len(links)))
    ends = np.cumsum(runs[:, 1]) if len(runs) else np.zeros(0, dtype=int)
    assert np.array_equal(runs[1:, 0], ends[:-1])
    assert (ends[-1] if len(ends) else 0) == len(links)
    for start, length, together in runs.tolist():
        run = links[places][start : start + length]
        if together:
            assert length >= SHORTEST_RUN
            assert np.all(np.diff(run, axis=0) == 1)
            assert len(np.unique(run)) == 2 * length


def test_a_hub_of_more_links_than_colours_still_works():
    links = np.array([(0, i) for i in range(1, 200)], dtype=np.int64)
    places, runs = arrange_links(links, 200, "coloured")
    assert sorted(places.tolist()) == list(range(199))
    assert not runs[:, 2].any()


@pytest.mark.parametrize(("columns", "rows", "shear"), [(100, 100, False), (33, 20, False), (20, 33, True)])
def test_a_cloth_falls_into_long_runs(columns, rows, shear):
    """Nearly all of its links are solved several at once."""
    net = shapes.cloth((0, 0), columns, rows, 0.1, shear=shear)
    _, runs = arrange_links(net.links, len(net.positions), "coloured")
    together = runs[:, 2] == 1
    assert runs[together, 1].sum() > 0.9 * len(net.links)
    assert runs[together, 1].mean() > columns / 3


def test_empty():
    places, runs = arrange_links(np.zeros((0, 2), dtype=np.int64), 5, "coloured")
    assert places.shape == (0,)
    assert runs.shape == (0, 3)
