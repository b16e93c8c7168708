"""The tunnel's sums on fields of given numbers: book of momentum, wall, streaks, averages, each by a twin."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from game.physics.tunnel import Tunnel, TunnelSettings, outline_of, shape_named
from game.physics.tunnel.averages import STEADY, Average, Mean
from game.physics.tunnel.balance import held, outflow
from game.physics.tunnel.outlines import PlacedOutline, TunnelOutline, outline_distances
from game.physics.tunnel.sticking import stick
from game.physics.tunnel.streaks import PARKED, Rake, drift
from game.physics.tunnel.sweep import (
    ANGLE,
    BOOK,
    CHECK,
    COLUMNS,
    DONE,
    DRAG,
    DRIFT,
    SPREAD,
    STROUHAL,
    Sweep,
    SweepPlan,
)
from game.physics.tunnel.wall_force import sum_wall

NY, NX, H = 9, 11, 0.25
BOX = np.array([2, 7, 3, 6], dtype=np.int64)
SMALL = TunnelSettings(cells=4.0, width=7.0, height=5.0, reynolds=40.0)


def bilinear(field: np.ndarray, x: float, y: float) -> float:
    """Twin of the kernels' reading: points of the field are whole numbers, as at the rim beyond it."""
    x, y = np.clip(x, 0.0, field.shape[1] - 1.0), np.clip(y, 0.0, field.shape[0] - 1.0)
    columns = [np.interp(x, np.arange(field.shape[1]), row) for row in field]
    return float(np.interp(y, np.arange(field.shape[0]), columns))


def fields(seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """p padded by one, u and v on the faces."""
    random = np.random.default_rng(seed)
    return (
        random.standard_normal((NY + 2, NX + 2)),
        random.standard_normal((NY, NX + 1)),
        random.standard_normal((NY + 1, NX)),
    )


@pytest.mark.parametrize("seed", range(3))
def test_what_leaves_the_box_is_flow_pressure_and_viscosity_through_its_four_sides(seed):
    """Stress at the middles of faces for what is normal, at nodes (ends count half) for what is along."""
    p, u, v = fields(seed)
    nu, x0, y0 = 0.3, -1.2, -0.7
    out = np.full(3, 99.0)
    outflow(p, u, v, BOX, np.array([H, nu, x0, y0]), out)
    expected = np.zeros(3)

    def add(x: float, y: float, fx: float, fy: float) -> None:
        expected[:] += fx, fy, x * fy - y * fx

    left, right, low, high = BOX.tolist()
    for i, sign in ((left, -1.0), (right, 1.0)):
        for j in range(low, high):
            pressure = 0.5 * (p[j + 1, i] + p[j + 1, i + 1])
            stretch = (u[j, i + 1] - u[j, i - 1]) / (2.0 * H)
            part = u[j, i] ** 2 + pressure - 2.0 * nu * stretch
            add(x0 + i * H, y0 + (j + 0.5) * H, sign * H * part, 0.0)
        for j in range(low, high + 1):
            add(x0 + i * H, 0.0, 0.0, sign * along_at(u, v, j, i, nu) * ends(j, low, high))
    for j, sign in ((low, -1.0), (high, 1.0)):
        for i in range(left, right):
            pressure = 0.5 * (p[j, i + 1] + p[j + 1, i + 1])
            stretch = (v[j + 1, i] - v[j - 1, i]) / (2.0 * H)
            part = v[j, i] ** 2 + pressure - 2.0 * nu * stretch
            add(x0 + (i + 0.5) * H, y0 + j * H, 0.0, sign * H * part)
        for i in range(left, right + 1):
            add(0.0, y0 + j * H, sign * along_at(u, v, j, i, nu) * ends(i, left, right), 0.0)
    assert out == pytest.approx(expected, rel=1e-12)


def along_at(u: np.ndarray, v: np.ndarray, j: int, i: int, nu: float) -> float:
    """u v - nu (du/dy + dv/dx) at a node."""
    shear = (u[j, i] - u[j - 1, i]) / H + (v[j, i] - v[j, i - 1]) / H
    return float(np.mean(u[j - 1 : j + 1, i]) * np.mean(v[j, i - 1 : i + 1]) - nu * shear)


def ends(k: int, first: int, last: int) -> float:
    return 0.5 * H if k in (first, last) else H


@pytest.mark.parametrize("seed", range(3))
def test_what_the_box_holds_is_the_momentum_of_its_open_faces_those_on_its_sides_by_half(seed):
    _, u, v = fields(seed)
    random = np.random.default_rng(seed + 30)
    ax, ay, x0, y0 = random.random(u.shape), random.random(v.shape), -1.2, -0.7
    out = np.full(3, 99.0)
    held(u, v, ax, ay, BOX, np.array([H, 0.0, x0, y0]), out)
    left, right, low, high = BOX.tolist()
    expected = np.zeros(3)
    for j in range(low, high):
        for i in range(left, right + 1):
            part = H * ends(i, left, right) * ax[j, i] * u[j, i]
            expected += part, 0.0, -(y0 + (j + 0.5) * H) * part
    for j in range(low, high + 1):
        for i in range(left, right):
            part = H * ends(j, low, high) * ay[j, i] * v[j, i]
            expected += 0.0, part, (x0 + (i + 0.5) * H) * part
    assert out == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(("share", "bend"), [(1.0, 0.0), (0.5, 0.0), (2.0 / 3.0, 1.0)])
def test_pressure_goes_on_straight_to_the_wall_and_the_slip_is_a_parabola(share, bend):
    """p = 2 + 3 x - y and a flow along the wall of 4 (s + bend s²): read at points of the grid where it
    bends, so all is exact; moments are about a given point.
    """
    h, nu, corner, about, floor = 0.1, 0.2, (-1.0, -1.0), (0.3, -0.4), 0.05
    x_of = corner[0] + h * (np.arange(22)[None] - 0.5)
    y_of = corner[1] + h * (np.arange(22)[:, None] - 0.5)
    p = 2.0 + 3.0 * x_of - y_of
    above = corner[1] + h * (np.arange(20) + 0.5) - floor  # of the points of u
    u = np.repeat(((above + bend * above**2) * 4.0)[:, None], 21, axis=1)
    v = np.zeros((21, 20))
    wall = np.array([[0.05, floor, 0.0, 1.0, 0.02, share]])
    out = np.full(6, 99.0)
    sum_wall(p, u, v, wall, np.array([h, nu, *corner, *about]), out)
    push, rub = -(2.0 + 3.0 * 0.05 - floor) * 0.02, nu * 4.0 * 0.02
    rx, ry = 0.05 - about[0], floor - about[1]
    # towards -x is along the wall, anticlockwise; the gas drags it the way it goes
    assert out == pytest.approx([0.0, push, rub, 0.0, rx * push, -ry * rub], rel=1e-9, abs=1e-12)
    out_of_two = np.zeros(6)
    sum_wall(p, u, v, np.repeat(wall, 2, axis=0), np.array([h, nu, *corner, *about]), out_of_two)
    assert out_of_two == pytest.approx(2.0 * out)
    turned = np.array([[floor, 0.05, 1.0, 0.0, 0.02, share]])  # all of it mirrored in x = y
    sum_wall(p.T.copy(), v.T.copy(), u.T.copy(), turned, np.array([h, nu, *corner, *about[::-1]]), out)
    assert out == pytest.approx([push, 0.0, 0.0, rub, -rx * push, ry * rub], rel=1e-9, abs=1e-12)


def test_faces_that_stick_take_both_their_places_with_their_factors_all_read_before_any_is_written():
    _, u, v = fields(5)
    faces = np.array([[0, 2, 3], [0, 2, 4], [1, 5, 6]], dtype=np.int64)
    rows = np.array(
        [
            (3.4, 2.2, 0.7, 4.0, 2.0, -0.2),  # reads what the second face had
            (-2.0, 3.5, 0.5, 99.0, 99.0, 0.25),  # both beyond the rim
            (6.3, 5.1, 1.5, 0.0, 9.0, 0.5),
        ]
    )
    expected = []
    for face, row in zip(faces, rows, strict=True):
        field = (u, v)[face[0]]
        expected.append(row[2] * bilinear(field, *row[:2]) + row[5] * bilinear(field, *row[3:5]))
    before = u.copy(), v.copy()
    stick(u, v, faces, rows, np.zeros(3))
    assert [u[2, 3], u[2, 4], v[5, 6]] == pytest.approx(expected, rel=1e-12)
    before[0][2, 3:5], before[1][5, 6] = u[2, 3:5], v[5, 6]
    assert np.array_equal(u, before[0]) and np.array_equal(v, before[1])


class TestStreaks:
    NUMBERS = np.array([H, -1.0, -0.5, NX * H, NY * H])

    def test_specks_drift_by_the_midpoint_rule_and_are_parked_beyond_the_end(self):
        _, u, v = fields(1)
        u, v = 0.3 * u + 0.4, 0.3 * v
        dt = 0.2
        random = np.random.default_rng(2)
        places = np.array((-1.0, -0.5)) + random.random((3, 20, 2)) * (NX * H, NY * H)
        places[0, 0, 0] = PARKED
        places[0, 1] = -1.0, 0.3  # just let go, on the corner's side
        places[0, 2] = -1.0 + NX * H - 1e-3, 0.3  # about to leave
        specks = places.copy()
        drift(specks, u, v, self.NUMBERS, dt)
        parked = 0
        for was, now in zip(places.reshape(-1, 2), specks.reshape(-1, 2), strict=True):
            if was[0] == PARKED:
                assert np.array_equal(was, now)
                continue
            x, y = (was - (-1.0, -0.5)) / H
            mx = x + 0.5 * dt / H * bilinear(u, x, y - 0.5)
            my = y + 0.5 * dt / H * bilinear(v, x - 0.5, y)
            end_x = x + dt / H * bilinear(u, mx, my - 0.5)
            end_y = y + dt / H * bilinear(v, mx - 0.5, my)
            inside = 0.0 <= end_x <= NX and 0.0 <= end_y <= NY
            parked += not inside
            assert now[0] == pytest.approx(-1.0 + H * end_x if inside else PARKED, rel=1e-12)
            assert now[1] == pytest.approx(-0.5 + H * end_y, rel=1e-12)
        assert 0 < parked < 20

    def test_specks_are_let_go_a_spacing_apart_the_newest_first(self):
        tunnel = Tunnel(shape_named("square", 0.5), SMALL)
        tunnel.gas.u[:], tunnel.gas.v[:] = 2.0, 0.0
        rake = Rake(3, 4, 1.0, 4.0, 0.5)
        assert rake.heights.tolist() == [1.5, 2.5, 3.5]
        assert np.all(rake.specks[..., 0] == PARKED) and np.isnan(rake.lines()).all()
        for _ in range(3):  # 2 m/s: a spacing in two steps of 1/8 s
            rake.step(tunnel.gas, 0.125, 2.0)
        assert rake.specks[:, 0, 0] == pytest.approx([0.25] * 3)
        assert rake.since[0] == pytest.approx(0.125)
        rake.step(tunnel.gas, 0.125, 2.0)
        assert rake.specks[1, :2, 0] == pytest.approx([0.0, 0.5]) and rake.since[0] == 0.0
        assert rake.specks[:, 0, 1].tolist() == rake.heights.tolist()
        assert np.all(rake.specks[:, 2:, 0] == PARKED)
        lines = rake.lines()
        assert np.array_equal(lines[:, :2], rake.specks[:, :2]) and np.isnan(lines[:, 2:]).all()

    def test_a_line_is_torn_where_specks_are_more_than_four_spacings_apart(self):
        rake = Rake(1, 4, 0.0, 1.0, 0.25)
        rake.specks[0] = (0.0, 0.5), (1.0, 0.5), (2.0 + 1e-9, 0.5), (2.25, 0.5)
        assert np.isnan(rake.lines()[0, :, 0]).tolist() == [False, False, True, False]
        rake.specks[0, 2:] = (1.0, 1.5), (PARKED, 1.5)
        assert np.isnan(rake.lines()[0, :, 1]).tolist() == [False, False, False, True]


class TestAverages:
    @staticmethod
    def reading(k: int) -> np.ndarray:
        return np.array([1.0 + k, 2.0, 0.1 * k, 0.5, 0.25 * k, 0.2, 7.0 + k, 3.0 * k, -1.0])

    def test_every_number_is_the_mean_of_the_steps_after_it_has_settled(self):
        average, dt = Average(1.0, 2.0), 0.25
        for k in range(12):
            assert average.settled == (k > 4)
            assert average.progress == pytest.approx(k * dt / 3.0)
            assert not average.done
            average.take(self.reading(k), dt)
            if k < 8:  # one half of the window has no other yet
                assert average.mean().drift == 0.0
        assert average.done and average.progress == 1.0
        mean = average.mean()
        taken = np.array([self.reading(k) for k in range(4, 12)])
        wall = taken[:, :3] + taken[:, 3:6]
        assert mean.wall == pytest.approx(wall.mean(axis=0)) and mean.book == pytest.approx(
            taken[:, 6:].mean(axis=0)
        )
        assert mean.spread == pytest.approx(wall.std(axis=0))
        assert mean.drift == pytest.approx(0.5 * abs(wall[:4, 0].mean() - wall[4:, 0].mean()))
        assert mean.seconds == pytest.approx(2.0)
        average.clear()
        assert not average.row.any() and average.mean() == Mean((0.0,) * 3, (0.0,) * 3, (0.0,) * 3, 0, 0, 0)

    @pytest.mark.parametrize(("swing", "beats"), [(0.5, True), (1.3 * STEADY, False)])
    def test_beats_are_counted_where_the_lift_rises_through_its_level(self, swing, beats):
        """The level is the mean of the second half of settling: a first half that differs says nothing."""
        average, dt, period = Average(2.0, 4.2), 0.0125, 1.0
        for k in range(1, round(6.2 / dt) + 1):
            lift = 0.3 + swing * math.sin(2.0 * math.pi * k * dt / period)
            average.take(np.array([0.0, lift if k * dt > 1.0 else 40.0, 0, 0, 0, 0, 0, 0, 0.0]), dt)
        assert average.mean(0.25).strouhal == pytest.approx(0.25 / period if beats else 0.0, rel=1e-3)

    def test_two_whole_beats_are_needed(self):
        for seconds, seen in ((4.1, False), (4.4, True)):
            average, dt = Average(2.0, 9.0), 0.0125
            for k in range(1, round(seconds / dt) + 1):
                lift = math.sin(2.0 * math.pi * (k * dt - 0.25))
                average.take(np.array([0.0, lift, 0, 0, 0, 0, 0, 0, 0.0]), dt)
            assert (average.mean().strouhal > 0.9) == seen


class TestSweeps:
    def test_every_field_of_a_mean_is_kept_in_its_column(self):
        sweep = Sweep()
        assert not sweep.complete and not sweep.running
        first = sweep.begin(shape_named("square"), SweepPlan(8, 1))
        assert (sweep.table.shape, sweep.table[-1, CHECK]) == ((4, COLUMNS), 1.0) and first == 0.0
        means = []
        for k in range(4):
            mean = Mean(
                (k, k + 0.1, k + 0.2), (k + 0.3, 0.4, 0.5), (k + 0.6, 0.7, 0.8), k + 0.9, k + 1.1, 5.0
            )
            means.append(mean)
            assert sweep.running and sweep.complete == (k == 3)
            angle = sweep.keep(mean)
            assert angle == (sweep.table[k + 1, ANGLE] if k < 3 else None)
        assert not sweep.running
        for row, mean in zip(sweep.table, means, strict=True):
            assert row[DRAG:SPREAD].tolist() == list(mean.wall)
            assert row[SPREAD:BOOK].tolist() == list(mean.spread)
            assert row[BOOK:DRIFT].tolist() == list(mean.book)
            assert [row[DRIFT], row[STROUHAL], row[DONE]] == [mean.drift, mean.strouhal, 1.0]
        assert len(sweep.measured()) == 3 and sweep.measured(checks=True)[0, DRAG] == 3.0
        sweep.clear()
        assert sweep.table.shape == (0, COLUMNS) and not sweep.complete and not sweep.running


class TestOutlines:
    ESS = outline_of([(-0.5, -0.1), (0.4, -0.3), (0.5, 0.1), (-0.4, 0.3)])  # turned, not mirrored
    WEDGE = outline_of([(-0.5, 0.0), (0.5, -0.2), (0.5, 0.2)])  # mirrored, not turned

    @pytest.mark.parametrize("made", [ESS, WEDGE], ids=["turned", "mirrored"])
    def test_a_state_brings_its_outline_back_with_every_number(self, made: TunnelOutline):
        tunnel = Tunnel(made, replace(SMALL, cells=6.0), 0.2)
        tunnel.step()
        state = tunnel.state()
        kept = state._replace(pose=state.pose.copy(), held=state.held.copy(), reading=state.reading.copy())
        faces, points = tunnel._near.faces.copy(), tunnel._wall.copy()
        tunnel.change_outline(shape_named("disc", 0.7), 0.1)
        other = tunnel.viscosity
        tunnel.restore(kept)
        found = tunnel.outline
        assert np.array_equal(found.corners, made.corners)
        assert found[1:] == made[1:] and tunnel.attack == 0.2
        assert np.array_equal(tunnel._near.faces, faces) and np.array_equal(tunnel._wall, points)
        assert tunnel.viscosity == pytest.approx(made.chord / 40.0) != other
        assert tunnel.gas.settings.viscosity == tunnel.viscosity
        assert np.array_equal(tunnel.held, kept.held) and np.array_equal(tunnel.reading, kept.reading)
        tunnel.turn(1.0)
        tunnel.restore(kept)  # the same outline at another angle
        assert np.array_equal(tunnel._near.faces, faces) and np.array_equal(tunnel._wall, points)

    def test_distances_and_normals_are_those_of_the_nearest_side(self):
        corners = np.array([(-1.0, -0.5), (1.0, -0.5), (1.0, 0.5), (-1.0, 0.5)])
        points = np.array(
            [
                (0.0, 0.9),
                (1.3, 0.9),
                (0.0, 0.1),
                (-0.9, 0.0),
                (0.5, 0.5),
                (1.0, 0.0),
                (-3.0, -0.2),
                (0.0, -2.0),
            ]
        )
        found = np.empty((len(points), 3))
        outline_distances(corners, points, found)
        expected = [
            (0.4, 0.0, 1.0), (0.5, 0.6, 0.8), (-0.4, 0.0, 1.0), (-0.1, -1.0, 0.0),
            (0.0, 0.0, 1.0), (0.0, 1.0, 0.0), (2.0, -1.0, 0.0), (1.5, 0.0, -1.0),
        ]  # fmt: skip
        assert found == pytest.approx(np.array(expected), abs=1e-12)
        sample = PlacedOutline(corners).sample(points)
        assert np.array_equal(sample.distance, found[:, 0]) and np.array_equal(sample.normal, found[:, 1:])

    def test_settings_stand_at_both_ends_of_their_ranges_and_not_beyond(self):
        for name, low, high in (
            ("cells", 2.0, 150.0), ("width", 0.1, 1e3), ("height", 0.1, 1e3), ("wind", 0.0, 1e3),
            ("reynolds", 0.1, 1e5), ("courant", 0.05, 20.0), ("tolerance", 0.0, 1.0), ("nudge", 0.0, 1.0),
        ):  # fmt: skip
            for value in (low, high):
                assert getattr(replace(SMALL, **{name: value}), name) == value
            beyond = 400.1 if name == "cells" else high * 1.0001
            for value in (low - 1e-4, beyond, math.nan):
                with pytest.raises(ValueError, match=f"^{name} = .*: expected {low:g} to"):
                    replace(SMALL, **{name: value})
        assert SMALL.place == pytest.approx((2.1, 2.5)) and replace(SMALL, at=(3.0, 2.0)).place == (3.0, 2.0)
        assert (replace(SMALL, wind=0.0).pace, replace(SMALL, wind=2.0).pace) == (1.0, 2.0)

    def test_what_is_turned_or_another_lies_in_the_grid_as_if_it_had_always_been_there(self):
        tunnel = Tunnel(shape_named("plate"), replace(SMALL, cells=6.0))
        for made, attack in ((shape_named("plate"), 1.1), (self.WEDGE, -0.4)):
            if made is self.WEDGE:
                tunnel.change_outline(made, attack)
            else:
                tunnel.turn(attack)
            fresh = Tunnel(made, tunnel.settings, attack)
            assert tunnel.pose.tolist() == [attack, 0.0]
            assert np.array_equal(tunnel.placed.corners, fresh.placed.corners)
            assert np.array_equal(tunnel._near.faces, fresh._near.faces)
            assert np.array_equal(tunnel._near.rows, fresh._near.rows)
            assert np.array_equal(tunnel._wall, fresh._wall) and np.array_equal(tunnel.box, fresh.box)
            drags = tunnel.gas.solids.drag, fresh.gas.solids.drag
            assert np.array_equal(drags[0].free_u, drags[1].free_u)
            assert np.array_equal(drags[0].free_v, drags[1].free_v)
            assert np.array_equal(tunnel.gas.faces.ax, fresh.gas.faces.ax)
            assert tunnel.gas.settings.viscosity == fresh.gas.settings.viscosity
            index = tunnel._near.faces[tunnel._near.faces[:, 0] == 0]
            assert len(index) and not drags[0].free_u[index[:, 1], index[:, 2]].any()
        before = tunnel.pose[1]
        tunnel.step()
        assert tunnel.pose[1] == pytest.approx(before + tunnel.step_length)

    def test_a_wind_begins_even_with_a_nudge_across_and_none_at_the_faces_inside(self):
        tunnel = Tunnel(shape_named("square", 0.5), replace(SMALL, wind=2.0, nudge=0.1))
        nx = tunnel.grid.nx
        wave = 0.1 * 2.0 * np.sin(2.0 * math.pi * (np.arange(nx) + 0.5) / nx)
        far = slice(nx - 4, nx)
        assert tunnel.gas.v[3, far] == pytest.approx(wave[far])
        assert np.all(tunnel.gas.u[:, -3:] == 2.0) and not tunnel.gas.v[[0, -1]].any()
        assert tunnel.held[0] > 0.0
        assert tunnel.step_length == pytest.approx(0.8 * 0.25 / 2.0)
        assert tunnel.blockage == pytest.approx(0.5 / 5.0)

    def test_a_step_measures_both_ways_in_coefficients_of_wind_and_chord(self, monkeypatch):
        """Of a gas that stands as it is: numbers of the sums alone, moments nose up."""
        chosen = replace(SMALL, wind=2.0, cells=6.0)
        tunnel = Tunnel(shape_named("leaf", 0.8), chosen, 0.3)
        random = np.random.default_rng(4)
        for speeds in (tunnel.gas.u, tunnel.gas.v):
            speeds += 0.3 * random.standard_normal(speeds.shape)
        monkeypatch.setattr(tunnel.gas, "step", lambda dt: None)
        tunnel._stick()
        held_before, dt = tunnel.held.copy(), tunnel.step_length
        tunnel.step()
        assert tunnel.pose.tolist() == [0.3, dt]
        state, (x, y), h, nu = tunnel.gas.state(), chosen.place, tunnel.grid.cell, tunnel.viscosity
        out, now, sums = np.zeros(3), np.zeros(3), np.zeros(6)
        numbers = np.array([h, nu, -x, -y])
        outflow(state.pressure, state.u, state.v, tunnel.box, numbers, out)
        faces = tunnel.gas.faces
        held(state.u, state.v, faces.ax, faces.ay, tunnel.box, numbers, now)
        sum_wall(state.pressure, state.u, state.v, tunnel._wall, np.array([h, nu, 0.0, 0.0, x, y]), sums)
        book = -out - (now - held_before) / dt
        per = 1.0 / (0.5 * 4.0 * 0.8)
        forces = tunnel.forces()
        assert forces.pressure == pytest.approx((per * sums[0], per * sums[1], -per / 0.8 * sums[4]))
        assert forces.friction == pytest.approx((per * sums[2], per * sums[3], -per / 0.8 * sums[5]))
        assert forces.book == pytest.approx((per * book[0], per * book[1], -per / 0.8 * book[2]))
        assert forces.wall == pytest.approx(np.add(forces.pressure, forces.friction))
        assert np.array_equal(tunnel.held, now) and np.any(tunnel.reading != 0.0)
