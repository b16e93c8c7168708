"""Rails of tracks: what is in sight is drawn along its line, and casts its shadow beside it."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np

from game.worlds.painting.rails import Rail, draw_rail_shadows, draw_rails

SEEN = SimpleNamespace(left=0.0, right=4.0, bottom=0.0, top=3.0)


class Sheet:
    """A canvas of 100 px a metre that keeps what it is asked to draw."""

    pixels_per_unit, k = 100.0, 1.0
    camera = SimpleNamespace(visible=lambda: SEEN)

    def __init__(self) -> None:
        self.lines, self.others = [], []

    def polyline(self, points, color, width, alpha=1.0):
        self.lines.append((np.array(points), width, alpha))

    def discs(self, places, *_):
        self.others.append(np.array(places))

    def segments(self, starts, ends, *_):
        self.others.append(np.array(starts))


def rail(x: float, y: float) -> Rail:
    line = np.array([(x, y), (x + 0.5, y - 0.1), (x + 1.0, y)])
    return Rail(line, line[:1], line[1:2], line.min(axis=0), line.max(axis=0))


HERE, EDGE, AWAY, BELOW = rail(1.0, 1.0), rail(3.5, 2.0), rail(5.0, 1.0), rail(1.0, -2.0)
RAILS = [HERE, AWAY, EDGE, BELOW]


def test_each_rail_in_sight_casts_one_shadow_moved_by_the_light():
    sheet, by = Sheet(), np.array((0.07, -0.11))
    draw_rail_shadows(sheet, RAILS, by, 0.3)
    assert [alpha for _, _, alpha in sheet.lines] == [0.3, 0.3]
    for (points, _, _), one in zip(sheet.lines, (HERE, EDGE), strict=True):
        np.testing.assert_allclose(points - one.line, np.broadcast_to(by, one.line.shape), atol=1e-12)


def test_a_rail_lies_on_its_line_and_its_shadow_is_broader():
    sheet, shade = Sheet(), Sheet()
    draw_rails(sheet, RAILS, True)
    draw_rail_shadows(shade, RAILS, np.zeros(2), 1.0)
    for one, (_, broad, _) in zip((HERE, EDGE), shade.lines, strict=True):
        on_line = [width for points, width, _ in sheet.lines if np.array_equal(points, one.line)]
        assert len(on_line) == 2 and on_line[0] > on_line[1]  # its edge, then its steel
        assert broad > on_line[1]
    assert all(abs(place[:, 0]).max() < 4.6 for place in sheet.others) and sheet.others
