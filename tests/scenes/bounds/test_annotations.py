"""Marks of a query between two hierarchies, counted on a canvas that only notes what it is told."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from game.scenes.bounds.annotations import Annotations
from game.scenes.bounds.pair import Place

HERE = [Place(0.0, 0.0, 0.0), Place(0.0, 0.0, 0.0)]


@pytest.mark.parametrize("count", [1, 2, 5])
def test_every_crossing_has_a_mark_where_the_segments_meet(count):
    upright = np.array([(float(k), -1.0, float(k), 1.0 + k) for k in range(count)])
    level = np.array([(-1.0, 0.25, 10.0, 0.25)])
    trees = (SimpleNamespace(ends=upright), SimpleNamespace(ends=level))
    query = SimpleNamespace(crossings=np.array([(k, 0) for k in range(count)]), crossing_count=count)
    marks = []
    canvas = SimpleNamespace(contact=lambda point: marks.append(tuple(point)))
    Annotations().draw_crossings(canvas, None, SimpleNamespace(query=query, trees=trees), HERE, words=False)
    assert np.array(marks) == pytest.approx(np.array([(k, 0.25) for k in range(count)]))
