"""A cubic piece that crosses itself, against a search over pairs of points on it."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.animation.crossings import crosses_itself
from game.physics.animation.curves import CatmullRom

corner = st.tuples(st.floats(-4.0, 4.0), st.floats(-4.0, 4.0))


def crossed_by_chords(controls, chords=160):
    """Whether two chords of a fine polyline, not neighbours, cross."""
    t = np.linspace(0.0, 1.0, chords + 1)[:, None]
    p0, p1, p2, p3 = controls
    points = (1 - t) ** 3 * p0 + 3 * t * (1 - t) ** 2 * p1 + 3 * t * t * (1 - t) * p2 + t**3 * p3
    a, b = points[:-1], points[1:]

    def side(p, q, r):
        return (q[..., 0] - p[..., 0]) * (r[..., 1] - p[..., 1]) - (q[..., 1] - p[..., 1]) * (
            r[..., 0] - p[..., 0]
        )

    i, j = np.triu_indices(len(a), 2)
    one = side(a[i], b[i], a[j]) * side(a[i], b[i], b[j])
    two = side(a[j], b[j], a[i]) * side(a[j], b[j], b[i])
    long = np.hypot(*(b - a).T)
    least = 1e-9 * (long[i] * long[j]) ** 2  # what rounding makes on a line is less
    return bool(np.any((one < -least) & (two < -least)))


@given(st.tuples(corner, corner, corner, corner))
@settings(max_examples=60, deadline=None)
def test_a_crossing_that_a_fine_polyline_shows_is_found(points):
    controls = np.array(points)
    if crossed_by_chords(controls):
        assert crosses_itself(controls[None])[0]


def test_a_crossing_is_no_invention():
    rng = np.random.default_rng(3)
    controls = rng.uniform(-1.0, 1.0, (400, 4, 2))
    seen = np.array([crossed_by_chords(piece) for piece in controls])
    found = crosses_itself(controls)
    assert 20 < found.sum() < 200
    assert not np.any(seen & ~found)
    small = controls[found & ~seen]  # loops smaller than the polyline's pieces
    assert len(small) < 10 and all(crossed_by_chords(piece, 2000) for piece in small)


def test_a_loop_a_cusp_and_an_arch():
    loop = [(0.0, 0.0), (3.0, 2.0), (-2.0, 2.0), (1.0, 0.0)]
    cusp = [(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)]
    arch = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)]
    assert crosses_itself(np.array([loop, cusp, arch])).tolist() == [True, False, False]


def test_only_uniform_and_chordal_pieces_between_uneven_points_cross_themselves():
    rng = np.random.default_rng(5)
    points = np.cumsum(rng.standard_normal((4000, 2)) * 10.0 ** rng.uniform(-1.5, 0.5, (4000, 1)), axis=0)
    crossed = {
        kind: crosses_itself(CatmullRom(points, kind).controls[1:-1]).mean()
        for kind in ("uniform", "centripetal", "chordal")
    }
    assert (
        0.02 < crossed["uniform"] < 0.05
        and 0.0 < crossed["chordal"] < 0.002
        and crossed["centripetal"] == 0.0
    )
