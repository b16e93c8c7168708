"""Penetration depth: closed forms, what always holds, and brute force by another library's polygons."""

from __future__ import annotations

import math

import numpy as np
import pytest
from shapely.affinity import rotate, translate
from shapely.geometry import Polygon
from shapely.ops import unary_union

from game.physics.narrowphase.depth import PRESETS, Escape, Shape, ShapePair, preset

TOLERANCE = 1e-4


def box(width: float, height: float) -> list[tuple[float, float]]:
    w, h = 0.5 * width, 0.5 * height
    return [(-w, -h), (w, -h), (w, h), (-w, h)]


def area_of(shape: Shape, place: tuple[float, float, float]) -> Polygon:
    return unary_union([Polygon(part) for part in shape.placed(*place)])


def still_common(pair: ShapePair, found: Escape) -> float:
    """m² that A and B share after a motion, by shapely."""
    return float(area_of(pair.a, pair.moved(found)).intersection(area_of(pair.b, pair.place_b)).area)


def random_pairs(count: int, seed: int) -> list[tuple[str, ShapePair]]:
    generator = np.random.default_rng(seed)
    pairs = []
    for _ in range(count):
        names = [PRESETS[k] for k in generator.integers(0, len(PRESETS) - 1, 2)]  # the gear takes long
        a, b = (preset(name, generator.uniform(0.5, 1.5), generator.uniform(0.5, 1.2)) for name in names)
        places = generator.uniform(-0.6, 0.6, (2, 3)) * (1.0, 1.0, 5.0)
        pairs.append(("/".join(names), ShapePair(a, b, tuple(places[0]), tuple(places[1]))))
    return pairs


RANDOM = random_pairs(24, 32)


@pytest.mark.parametrize(("name", "pair"), RANDOM, ids=[f"{k}-{name}" for k, (name, _) in enumerate(RANDOM)])
def test_what_holds_of_any_pair(name, pair):
    slide, found = pair.translational(), pair.generalised(TOLERANCE)
    assert 0.0 <= found.certain <= found.sigma <= slide.sigma
    assert found.sigma - found.certain <= TOLERANCE
    assert found.sigma == pytest.approx(pair.a.norm(found.x, found.y, found.angle), abs=1e-12)
    for one in (slide, found):
        assert pair.overlap(one.x, one.y, one.angle) < 1e-9
        assert still_common(pair, one) < 1e-9
    if slide.sigma > 0.0:  # no less is enough
        assert still_common(pair, Escape(0.0, 0.0, 0.0, 0.0, 0.0, 1)) > 0.0
        assert pair.overlap() > 0.0
    coarse = pair.by_grid(17, 17)
    assert coarse.sigma >= found.sigma - TOLERANCE
    assert pair.overlap(coarse.x, coarse.y, coarse.angle) < 1e-9


def test_no_turn_of_many_is_shorter_than_what_branch_and_bound_finds():
    angles = np.linspace(-math.pi, math.pi, 721)
    for _, pair in RANDOM[:12]:
        found = pair.generalised(TOLERANCE)
        assert float(np.min(pair.sigmas(angles))) >= found.sigma - TOLERANCE


def test_no_displacement_shorter_than_the_translational_depth_separates():
    """By areas of another library's unions, round circles a little smaller."""
    for _, pair in RANDOM[:8]:
        depth = pair.translational().sigma
        still = area_of(pair.b, pair.place_b)
        moved = area_of(pair.a, pair.place_a)
        for part in (0.3, 0.7, 0.98):
            for turn in np.linspace(0.0, 2.0 * math.pi, 48, endpoint=False).tolist():
                x, y = part * depth * math.cos(turn), part * depth * math.sin(turn)
                assert depth == 0.0 or translate(moved, x, y).intersection(still).area > 0.0


def test_brute_force_over_all_three_by_another_library_comes_no_lower():
    a, b = preset("L"), preset("comb")
    pair = ShapePair(a, b, (0.2, 0.1, 0.4), (0.0, 0.0, 0.0))
    found = pair.generalised(TOLERANCE)
    start, still = area_of(a, pair.place_a), area_of(b, pair.place_b)
    best = math.inf
    reach = found.sigma * 1.15
    for angle in np.linspace(-1.0, 1.0, 21).tolist():
        turned = rotate(start, angle, origin=pair.place_a[:2], use_radians=True)
        for x in np.linspace(-reach, reach, 23).tolist():
            for y in np.linspace(-reach, reach, 23).tolist():
                sigma = a.norm(x, y, angle)
                if sigma < best and not translate(turned, x, y).intersection(still).area > 1e-9:
                    best = sigma
    assert found.sigma - TOLERANCE <= best <= found.sigma + 0.1


# -- closed forms ------------------------------------------------------------------------------------------


def test_two_squares_side_by_side_move_apart_by_their_overlap():
    pair = ShapePair(Shape([box(1.0, 1.0)]), Shape([box(1.0, 1.0)]), (0.9, 0.05, 0.0))
    found = pair.generalised(1e-6)
    assert (found.sigma, found.x, found.y) == pytest.approx((0.1, 0.1, 0.0), abs=1e-6)
    assert pair.translational().sigma == pytest.approx(0.1, abs=1e-12)


@pytest.mark.parametrize(("deep", "helps"), [(0.15, False), (0.23, False), (0.24, True), (0.6, True)])
def test_the_corner_of_a_turned_square_in_the_side_of_another(deep, helps):
    """With u = 1 - cos theta, sigma² = (deep - sqrt(1/2) u)² + 2 k² u falls at first where deep > sqrt(2) k²,
    which is 0.2357 for a unit square, up to u = 1 - sqrt(1/2) where it lies flat."""
    pair = ShapePair(
        Shape([box(1.0, 1.0)]), Shape([box(6.0, 4.0)]), (0.0, 2.0 + math.sqrt(0.5) - deep, math.pi / 4)
    )
    assert pair.translational().sigma == pytest.approx(deep, abs=1e-12)
    half = math.sqrt(0.5)
    u = np.linspace(0.0, 1.0 - half, 200_001)
    exact = float(np.min(np.sqrt((deep - half * u) ** 2 + u / 3.0)))
    found = pair.generalised(1e-6)
    assert found.sigma == pytest.approx(exact, abs=2e-6) and (found.sigma < deep - 1e-6) == helps


def test_turning_does_not_help_a_disc():
    """A regular polygon of n corners gains no more than its sagitta R (1 - cos(pi/n))."""
    for count in (16, 64):
        ring = [
            (math.cos(2.0 * math.pi * k / count), math.sin(2.0 * math.pi * k / count)) for k in range(count)
        ]
        pair = ShapePair(Shape([ring]), Shape([box(8.0, 2.0)]), (0.0, 1.7, math.pi / count))
        slide, found = pair.translational(), pair.generalised(1e-6)
        sagitta = 1.0 - math.cos(math.pi / count)
        assert slide.sigma == pytest.approx(0.3 - sagitta, abs=1e-12)
        assert found.sigma == pytest.approx(slide.sigma, abs=1e-6)


def test_the_end_of_a_long_bar_turns_away():
    """A bar 4 m long on the corner of a wall 1.9 m from its middle: a lift t and a small turn with
    t + 1.9 theta = d cost least where t² + k² theta² does, which is d / sqrt(1 + (1.9 / k)²)."""
    pair = ShapePair(Shape([box(4.0, 1e-3)]), Shape([box(1.0, 2.0)]), (2.4, 0.95, 0.0))
    slide, found = pair.translational(), pair.generalised(1e-6)
    assert slide.sigma == pytest.approx(1.0 - 0.95 + 0.5e-3, abs=1e-12)
    exact = slide.sigma / math.sqrt(1.0 + 1.9**2 / (16.0 / 12.0))
    assert found.sigma == pytest.approx(exact, rel=1e-3) and found.angle < 0.0


def test_a_bar_in_a_slot_slips_out_once_it_is_turned():
    """Turned by 20 degrees against a slot 10 % wider than it is: straight it fits, and hardly moves."""
    bar, slot = Shape([box(0.2, 1.0)]), preset("slot")
    pair = ShapePair(bar, slot, (0.0, 0.3, math.radians(20.0)))
    slide, found = pair.translational(), pair.generalised(1e-5)
    assert found.sigma < 0.5 * slide.sigma
    assert -20.0 <= math.degrees(found.angle) < 0.0


@pytest.mark.parametrize("turn", [0.0, 0.3, 1.234])
def test_a_gap_that_fits_at_one_angle_only_is_found(turn):
    """A bar just as wide as its slot, turned against it: the depth jumps at that angle."""
    slot = Shape([
        [(-1.0, -1.0), (1.0, -1.0), (1.0, -0.5), (-1.0, -0.5)],
        [(-1.0, -0.5), (-0.25, -0.5), (-0.25, 1.0), (-1.0, 1.0)],
        [(0.25, -0.5), (1.0, -0.5), (1.0, 1.0), (0.25, 1.0)],
    ])  # fmt: skip
    x, y = (-slot.centroid).tolist()
    c, s = math.cos(turn), math.sin(turn)
    centre = (c * x - s * y, s * x + c * y)  # of the slot's own origin
    pair = ShapePair(Shape([box(0.5, 1.0)]), slot, (*centre, turn + 0.2), (0.0, 0.0, turn))
    found = pair.generalised(1e-4)
    alone = 2.0 * pair.a.gyration * math.sin(0.1)
    assert found.angle == pytest.approx(-0.2, abs=1e-9)
    assert found.sigma == pytest.approx(alone, abs=1e-9) and pair.translational().sigma > 1.5 * alone
    assert pair.overlap(found.x, found.y, found.angle) < 1e-9


def test_a_triangle_in_its_own_hole_is_found_at_the_one_angle():
    """No two of its edges are parallel, so that only edges that run against each other tell the angle."""
    inner = np.array([(-0.6, -0.4), (0.8, -0.4), (-0.1, 0.7)])
    inner -= inner.mean(axis=0)
    outer = 3.0 * inner @ np.array(((math.cos(0.3), math.sin(0.3)), (-math.sin(0.3), math.cos(0.3))))
    frame = Shape([
        [outer[k], outer[(k + 1) % 3], inner[(k + 1) % 3], inner[k]] for k in range(3)
    ])  # fmt: skip
    pair = ShapePair(Shape([inner]), frame, (0.0, 0.0, 0.2), (*frame.centroid.tolist(), 0.0))
    found = pair.generalised(1e-4)
    assert found.angle == pytest.approx(-0.2, abs=1e-9)
    assert found.sigma == pytest.approx(2.0 * pair.a.gyration * math.sin(0.1), abs=1e-9)


def test_exact_contact_and_distance_need_no_motion():
    square = Shape([box(1.0, 1.0)])
    for x in (1.0, 1.0 + 1e-13, 3.0):
        found = ShapePair(square, square, (x, 0.0, 0.0)).generalised()
        assert (found.sigma, found.x, found.y, found.angle) == (0.0, 0.0, 0.0, 0.0)
    inside = ShapePair(square, square, (1.0 - 1e-6, 0.0, 0.0)).translational()
    assert inside.sigma == pytest.approx(1e-6, rel=1e-6)


def test_symmetric_ties_are_all_as_short():
    """A square in the middle of a square: four sides to leave by."""
    pair = ShapePair(Shape([box(1.0, 1.0)]), Shape([box(3.0, 3.0)]))
    assert pair.translational().sigma == pytest.approx(2.0, abs=1e-12)
    found = pair.generalised(TOLERANCE)
    assert found.sigma == pytest.approx(2.0, abs=TOLERANCE)
    depths = pair.depths([0.3, -0.3, 0.3 + 0.5 * math.pi])[:, 0]
    assert depths == pytest.approx([depths[0]] * 3, abs=1e-12)


def test_the_depth_of_the_mirrored_pair_is_the_same():
    def mirrored(shape: Shape) -> Shape:
        return Shape([shape.part(k)[::-1] * (-1.0, 1.0) for k in range(len(shape))])

    a, b = preset("L"), preset("comb")
    pair = ShapePair(a, b, (0.2, 0.1, 0.4), (0.0, 0.0, -0.1))
    other = ShapePair(mirrored(a), mirrored(b), (-0.2, 0.1, -0.4), (0.0, 0.0, 0.1))
    assert other.translational().sigma == pytest.approx(pair.translational().sigma, abs=1e-12)
    assert other.generalised(1e-5).sigma == pytest.approx(pair.generalised(1e-5).sigma, abs=1e-5)


@pytest.mark.parametrize("scale", [1e-9, 1e6])
def test_scale_changes_nothing_but_lengths(scale):
    def at(size: float) -> ShapePair:
        return ShapePair(
            preset("L", size), preset("slot", size), (0.2 * size, 0.3 * size, 0.4), (0.0, 0.0, 0.0)
        )

    one, other = at(1.0), at(scale)
    assert other.translational().sigma == pytest.approx(scale * one.translational().sigma, rel=1e-9)
    there, here = other.generalised(1e-4 * scale), one.generalised(1e-4)
    assert there.sigma == pytest.approx(scale * here.sigma, rel=1e-6)


def test_far_from_the_origin_and_turned_together_all_is_the_same():
    a, b = preset("star"), preset("slot")
    near = ShapePair(a, b, (0.25, 0.5, 0.4), (0.0, 0.0, 0.0))
    far = ShapePair(a, b, (4_000_000.25, 0.5, 0.4), (4_000_000.0, 0.0, 0.0))
    assert far.generalised() == near.generalised()
    c, s = math.cos(1.0), math.sin(1.0)
    turned = ShapePair(a, b, (0.25 * c - 0.5 * s, 0.25 * s + 0.5 * c, 1.4), (0.0, 0.0, 1.0))
    assert turned.generalised().sigma == pytest.approx(near.generalised().sigma, abs=1e-9)


def test_a_finer_tolerance_tells_more_and_costs_more():
    pair = ShapePair(preset("L"), preset("comb"), (0.2, 0.1, 0.4))
    found = [pair.generalised(tolerance) for tolerance in (1e-1, 1e-3, 1e-5)]
    assert [one.sigma for one in found] == sorted((one.sigma for one in found), reverse=True)
    assert [one.evaluations for one in found] == sorted(one.evaluations for one in found)
    assert found[0].evaluations < found[2].evaluations


@pytest.mark.parametrize(
    ("a", "b", "x", "y"), [("L", "comb", 0.2, 0.1), ("star", "bar", 0.5, 0.7), ("gear", "L", 0.9, 0.6)]
)
def test_no_angle_of_an_interval_lies_below_its_bound(a, b, x, y):
    pair = ShapePair(preset(a), preset(b), (x, y, 0.4))
    found = pair.generalised(1e-2)
    assert found.sigma > 0.0 and len(pair.intervals) > 20
    for middle, half, _, bound, _ in pair.intervals.tolist():
        angles = middle + half * np.linspace(-1.0, 1.0, 5)
        assert float(np.min(pair.sigmas(angles))) >= bound - 1e-9


def test_what_makes_no_sense_is_refused():
    pair = ShapePair(preset("bar"), preset("bar"))
    for tolerance in (0.0, -1.0, math.inf, math.nan):
        with pytest.raises(ValueError, match="tolerance"):
            pair.generalised(tolerance)
    with pytest.raises(ValueError, match="finite"):
        pair.place((math.nan, 0.0, 0.0), (0.0, 0.0, 0.0))
    with pytest.raises(ValueError, match="grid"):
        pair.by_grid(2, 9)
