"""The leaves' model, hand and readouts: each number against one computed apart from it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import parse_level
from game.physics.plates import Gust
from game.physics.plates.law import CURL, DRAG, DRAG_TURN, HALF, THETA, UNIT, VX, VY, X, Y
from game.physics.plates.regimes import BORDERS
from game.physics.plates.watch import FLUTTER, GLIDE, NOTHING, TUMBLE
from game.scenes.leaves.basket import WIRE
from game.scenes.leaves.foliage import cut_outlines
from game.scenes.leaves.hand import FARTHEST, leaves_hand
from game.scenes.leaves.level import LeavesContent
from game.scenes.leaves.model import DEPTH, FLIP, GROWN, KIND, NAMES, SHADE, YAW, LeavesModel
from game.scenes.leaves.scene import Leaves
from game.scenes.leaves.sounds import LANDING, RUBBING, WIND
from game.scenes.leaves.species import SPECIES, half_of, outline_of
from game.scenes.leaves.told import readouts
from game.scenes.leaves.ways import ACROSS, CHANGES, DOWN, TOOK, TURNED
from game.stage import Pointer
from game.worlds.hands.hand import Hand
from game.worlds.hearing import REMEMBERED_S

DT = 1.0 / 120.0


def made(words: str, seed: int = 3, **parameters) -> LeavesModel:
    content = parse_level(f'scene = "a18"\n[content]\n{words}', "a18", LeavesContent).content
    scene = Leaves()
    for name, value in parameters.items():
        scene.values[name] = value
    return LeavesModel(content, scene.parameters, scene.active, seed)


def measured(model: LeavesModel) -> dict[str, float]:
    return {readout.name: readout.value for readout in readouts(model)}


BED = 'beds = [{ kinds = ["maple", "oak"], count = 7, left = -2.0, right = 1.5 }]\n'


def test_a_bed_lies_evenly_from_left_to_right_each_kind_by_turns():
    model = made(BED)
    x, y, theta = model.plates.rows[[X, Y, THETA]]
    assert np.abs(x - (-2.0 + 3.5 * (np.arange(7) + 0.5) / 7)).max() <= 0.02
    assert y == pytest.approx(0.02 + 0.02 * (np.arange(7) % 2))
    assert model.own[:, KIND].tolist() == [NAMES.index(("maple", "oak")[k % 2]) for k in range(7)]
    flat = np.minimum(np.abs(theta), np.abs(theta - math.pi))
    assert flat.max() <= 0.1 and len(set(np.round(theta / math.pi))) == 2  # rims up and rims down
    assert len(model.airborne) == len(model.ways) == len(model.plates) == 7
    other = made(BED, seed=4)
    assert not np.array_equal(other.own, model.own) and np.array_equal(made(BED).own, model.own)


def test_leaves_from_above_lie_at_any_angle_and_alike_at_one():
    high = (
        'beds = [{{ kinds = ["ash"], count = 40, left = 0.0, right = 1.0, height = {0}, spread = {1}{2} }}]\n'
    )
    model = made(high.format(2.0, 0.5, ""))
    assert np.ptp(model.plates.rows[THETA]) > 4.0
    assert model.plates.rows[Y].min() >= 2.0 and 2.4 < model.plates.rows[Y].max() <= 2.54
    assert np.ptp(made(high.format(0.1, 0.0, "")).plates.rows[THETA] % math.pi) < math.pi
    low = made(high.format(0.1, 0.0, "")).plates.rows[THETA]
    assert np.minimum(np.abs(low), np.abs(low - math.pi)).max() <= 0.1  # no higher than a bed
    same = made(high.format(2.0, 0.0, ", alike = true"))
    assert np.all(same.plates.rows[THETA] == 0.2) and np.all(same.own[:, GROWN] == 1.0)
    assert same.plates.rows[X] == pytest.approx((np.arange(40) + 0.5) / 40)


def test_each_leaf_is_its_own_within_its_bounds():
    own = made(BED.replace("count = 7", "count = 300")).own
    for row, low, high in ((SHADE, 0.0, 1.0), (DEPTH, -1.0, 1.0), (GROWN, 0.85, 1.15)):
        assert low <= own[:, row].min() < low + 0.05 * (high - low)
        assert high - 0.05 * (high - low) < own[:, row].max() <= high
    assert set(own[:, FLIP]) == {0.0, 1.0}
    yaw = own[:, YAW]
    turned = yaw > 1.5
    assert 0.3 < turned.mean() < 0.7
    assert np.abs(yaw - math.pi * turned).max() <= 0.5 and np.abs(yaw - math.pi * turned).max() > 0.45


@pytest.mark.parametrize("jitter", [0.0, 1.0])
def test_a_leafs_law_is_its_kinds_by_its_own_shade_and_size_and_what_is_chosen(jitter):
    """What is alike has the law of its kind, whatever its shade."""
    model = made("", weight=2.0, curl=0.3, stiffness=3.0, balance=-0.1)
    model.add("ash", (0.0, 1.0), 0.4, np.random.default_rng(5), jitter)
    row, kind, law = model.own[0], SPECIES["ash"].plate, model._plate(0)
    assert (row[GROWN] == 1.0) == (jitter == 0.0) and row[SHADE] != 0.4
    assert law.half_chord == pytest.approx(0.032 * row[GROWN])
    assert law.inertia == pytest.approx(1.0 * 2.0 * (1.0 + jitter * 0.2 * (row[SHADE] - 0.4)))
    assert law.curl == pytest.approx(jitter * 0.05 * (row[SHADE] - 0.4) + 0.3)
    assert law.bend_hz == pytest.approx(60.0) and law.balance == pytest.approx(0.55)
    assert law[2] == kind[2]
    laws = model.plates.laws[:, 0]
    assert laws[HALF] == pytest.approx(law.half_chord) and laws[CURL] == pytest.approx(law.curl)
    for name, value, field, bound in (
        ("curl", 5.0, "curl", 1.1), ("curl", -5.0, "curl", -1.1),
        ("balance", 2.0, "balance", 0.8), ("balance", -2.0, "balance", -0.8),
    ):  # fmt: skip
        limits = made("")
        limits.add("ash", (0.0, 1.0), 0.4, np.random.default_rng(5), jitter)
        object.__setattr__(limits, "parameters", _Chosen(limits.parameters, name, value))
        assert getattr(limits._plate(0), field) == bound


class _Chosen:
    """Parameters of which one is beyond its range, as only a programmer could set it."""

    def __init__(self, parameters, name: str, value: float):
        self._parameters, self._one = parameters, {name: value}

    def __getattr__(self, name: str):
        return self._one.get(name, getattr(self._parameters, name))


def test_the_wind_is_the_levels_slowed_by_the_lawn_and_sheltered_in_the_basket():
    model = made(
        "basket = { x = 1.0, half = 0.5, height = 0.8 }\n"
        "gusts = [{ place = [-1.0, 0.5], begins = 1.0, lasts = 2.0, blows = [2.0, 0.0] }]\n",
        wind=3.0,
    )
    wind = model.wind
    assert (wind.wind, wind.layer, wind.floor, wind.count) == (3.0, 0.4, -0.35, 1)
    assert wind.shelters[0].tolist() == pytest.approx([0.5, 1.5, 0.8, 0.12, 0.15 * 0.5 / 0.8])
    free, inside = wind.sample([(-0.9, 0.4), (1.0, 0.4)])
    even = 3.0 * (1.0 - math.exp(-(0.4 + 0.35) / 0.4))
    assert free == pytest.approx((even, 0.0)) and inside[0] == pytest.approx(even * math.exp(-0.4 / 0.12))
    foot = 0.85 * 0.5  # the basket is narrower below
    assert model.plates.walls.tolist() == [
        [1.0 - foot, 0.0, 0.5, 0.8, 0.006, 0.4],
        [1.0 + foot, 0.0, 1.5, 0.8, 0.006, 0.4],
    ]


def test_a_gust_blows_by_the_length_of_what_is_drawn_and_rises_a_little():
    model = made("", gusts=2.0, size=0.9)
    for way, speed in (((0.3, 0.4), 3.0), ((6.0, 8.0), 12.0), ((-2.0, 0.0), 12.0), ((0.0, 0.05), 0.3)):
        model.wind.count = 0
        model.blow((0.1, 0.2), way)
        length = math.hypot(*way)
        along = way[0] / length, way[1] / length
        expected = Gust(
            (0.1, 0.2), 0.0, 2.5, (0.45 * speed * along[0], 0.45 * speed * along[1]), 0.9,
            (speed * along[0], speed * along[1] + 0.3 * speed),
        )  # fmt: skip
        assert model.wind.count == 1 and model.wind.gusts[0] == pytest.approx(expected.row())
    model.blow((0.0, 0.0), (0.0, 0.0499))
    assert model.wind.count == 1


@pytest.mark.parametrize(
    ("name", "value", "changed"),
    [("wind", 2.0, "wind"), ("method", "midpoint", "method"), ("gravity", 5.0, "settings"),
     ("friction", 1.5, "settings"), ("weight", 3.0, "laws"), ("curl", 0.5, "laws"),
     ("stiffness", 4.0, "laws"), ("balance", 0.2, "laws")],
)  # fmt: skip
def test_a_parameter_changes_what_it_names_and_nothing_else(name, value, changed):
    def seen(model: LeavesModel) -> dict[str, object]:
        return {
            "wind": (model.wind.wind, model.wind.layer), "method": model.plates._method,
            "settings": tuple(model.plates.settings), "laws": model.plates.laws.tobytes(),
        }  # fmt: skip

    model = made(BED)
    before = seen(model)
    setattr(model.parameters, name, value)
    model.change_parameter(name)
    after = seen(model)
    assert {key for key in before if before[key] != after[key]} == {changed}
    assert model.wind.layer == 0.4
    fresh = made(BED, **{name: value})
    assert seen(fresh) == after


class TestStep:
    def free(self, **parameters) -> LeavesModel:
        words = (
            'beds = [{ kinds = ["oak"], count = 3, left = -1.0, right = 1.0, height = 3.0, alike = true }]\n'
        )
        return made(words, **{"wind": 0.0, **parameters})

    def test_time_in_the_air_counts_from_the_last_touch(self):
        model = self.free()
        for k in range(1, 34):
            model.advance(DT)
            assert model.airborne == pytest.approx(np.full(3, k * DT))
            assert model.flying().all() == (k * DT > 0.1)
            assert model.tally[0] == (3 if k * DT > 0.25 else 0)
        assert model.tally[1] == pytest.approx(3.04, abs=0.01)

    def test_a_landing_is_heard_by_its_speed_before_and_where(self):
        model = self.free()
        model.airborne[:] = 0.3, 0.25, 0.3
        model.plates.rows[Y] = 0.004, 0.004, 2.0
        model.plates.rows[VX], model.plates.rows[VY] = 0.6, -0.8
        model.advance(DT)
        assert (model.plates.touched > 0.0).tolist() == [True, True, False]
        assert model.heard.rows.shape == (1, 4) and model.airborne[:2].tolist() == [0.0, 0.0]
        assert model.heard.rows[0] == pytest.approx([DT, LANDING, 0.125, model.plates.rows[X, 0]])
        model.heard.rows = np.tile((0.0, RUBBING, 0.5, 0.0), (24, 1))
        model.heard.rows[0, 0] = -REMEMBERED_S
        model.airborne[:] = 0.3, 0.3, 0.3
        model.plates.rows[Y, :2], model.plates.rows[VY, :2] = 0.004, -1.0
        model.advance(DT)
        assert (
            len(model.heard.rows) == 24 and model.heard.rows[:, 1].tolist() == [RUBBING] * 22 + [LANDING] * 2
        )

    def test_what_slides_and_the_wind_are_heard_now_and_then(self):
        model = self.free(wind=4.0)
        model.plates.rows[Y, :2], model.plates.rows[Y, 2] = 0.004, 2.0
        model.plates.rows[VX, :2] = 1.0, 0.1
        while not (model.heard.rows[:, 1] == WIND).any():
            model.advance(DT)
        blown = model.heard.rows[model.heard.rows[:, 1] == WIND][0]
        assert blown[0] == pytest.approx(0.2, abs=DT) and 0.0 < blown[2] < 0.16 * 4.0
        rubbed = model.heard.rows[model.heard.rows[:, 1] == RUBBING]
        assert len(rubbed) and rubbed[:, 2].min() > 0.06 * 0.15 and rubbed[:, 2].max() < 0.06 * 4.0
        assert (rubbed[:, 3] < 0.5).all()  # the third is high up, at 0.67

    def test_the_camera_comes_after_the_middle_of_those_that_fly(self):
        model = self.free()
        model.tally[2:] = -2.0, 1.0
        model.airborne[:] = 1.0, 0.0, 1.0
        model.advance(DT)
        x, y = model.plates.rows[[X, Y]]
        share = DT / (1.5 + DT)
        assert model.cloud() == pytest.approx((x[[0, 2]].mean(), y[[0, 2]].mean()))
        assert model.tally[2:] == pytest.approx(
            [-2.0 + share * (x[[0, 2]].mean() + 2.0), 1.0 + share * (y[[0, 2]].mean() - 1.0)]
        )
        model.airborne[:] = 0.0
        assert model.cloud() == pytest.approx((x.mean(), y.mean()))
        model.plates.rows[Y] = 0.02
        model.tally[3] = 1.0
        model.advance(DT)
        assert model.tally[3] == pytest.approx(1.0 + share * (0.7 - 1.0))

    def test_without_leaves_nothing_moves(self):
        model = made("")
        model.advance(DT)
        assert model.cloud() == (0.0, 0.5) and model.tally.tolist() == [0.0, 0.0, -0.6, 0.6]
        assert model.gusts_now() == 0.0
        found = measured(model)
        assert [found[name] for name in ("leaves", "share in the basket", "fastest")] == [0, 0.0, 0.0]
        assert math.isnan(found["descent"]) and math.isnan(found["broadside"])

    def test_a_gust_that_is_over_is_forgotten(self):
        model = self.free()
        model.wind.add(Gust((50.0, 0.0), 0.0, 2.0 * DT))
        for left in (1, 1, 0):
            model.advance(DT)
            assert model.wind.count == left


def test_a_state_brings_every_number_back():
    model = made(BED + "gusts = [{ place = [0.0, 0.3], begins = 0.0, lasts = 3.0, blows = [4.0, 3.0] }]\n")
    for _ in range(60):
        model.advance(DT)
    model.heard.rows = np.array([[0.5, 0.0, 0.2, 0.3]])
    kept = copied(model.state())
    for _ in range(20):
        model.advance(DT)
    then = copied(model.state())
    model.drop("birch", (0.0, 2.0))
    model.wind.add(Gust((0.0, 1.0), 0.2, 3.0, blows=(1.0, 1.0)))
    model.advance(DT)
    model.restore(kept)
    assert same(model.state(), kept)
    assert not model.wind.gusts[model.wind.count :].any() and len(model.plates) == 7
    for _ in range(20):
        model.advance(DT)
    assert same(model.state(), then)
    assert same(kept, copied(kept))  # what was given is not written to


def copied(state):
    return type(state)(*(copied(part) if hasattr(part, "_fields") else np.array(part) for part in state))


def same(one, other) -> bool:
    for a, b in zip(one, other, strict=True):
        if not (same(a, b) if hasattr(a, "_fields") else np.array_equal(a, b, equal_nan=True)):
            return False
    return True


def test_readouts_say_what_is_counted_by_hand():
    model = made(
        "basket = { x = 1.0, half = 0.5, height = 0.8 }\n"
        'beds = [{ kinds = ["maple", "ash"], count = 6, left = -1.0, right = 1.0, height = 4.0 }]\n'
    )
    for _ in range(30):
        model.advance(DT)
    rows = model.plates.rows
    half = 0.5 * (0.85 + 0.15 * 0.3 / 0.8)  # between the slanted walls at 0.3 m
    half -= WIRE
    rows[X] = 1.0 - half, 1.0001 - half, 1.5749, 0.9999 + half, 1.0, 1.0
    rows[Y] = 0.3, 0.3, 0.12, 0.3, 0.8, 0.7999
    model.ways[:, CHANGES] = 5.0  # all of them swing, but
    model.ways[0, TURNED], model.ways[5, TURNED] = -6.3, 6.28  # one has turned over, one not yet
    model.ways[3, ACROSS : DOWN + 1] = -0.7, 1.0
    model.ways[4, TOOK] = 1.6
    model.airborne[:] = 1.0, 0.1, 1.0, 1.0, 1.0, 0.1001
    rows[VY] = -1.0, -1.0, -1.0, 1.0, -2.0, -0.5
    assert model.inside().tolist() == [False, True, False, True, False, True]
    assert model.flying().tolist() == [True, False, False, True, True, True]
    model.tally[:2] = 5.0, 3.25
    found = measured(model)
    wy = model.plates.air[1]
    falling = [0, 4, 5]
    laws = model.plates.laws[:, falling]
    terminal = laws[UNIT] / np.sqrt((laws[DRAG] + laws[DRAG_TURN]) * laws[HALF])
    assert (found["leaves"], found["in the basket"], found["in the air"], found["took off"]) == (6, 3, 4, 5)
    seen = [TUMBLE, NOTHING, NOTHING, GLIDE, NOTHING, FLUTTER]
    assert model.seen().tolist() == seen
    assert (found["fluttering"], found["tumbling"], found["gliding"]) == (1, 1, 1)
    assert found["share in the basket"] == 50.0 and found["highest"] == 3.25
    assert found["descent"] == pytest.approx(np.mean(wy[falling] - rows[VY, falling]))
    assert found["fastest"] == pytest.approx(np.hypot(*model.plates.velocities.T).max())
    assert found["wind at leaves"] == pytest.approx(np.hypot(*model.plates.air[:2]).max())
    assert found["broadside"] == pytest.approx(terminal.mean())
    assert found["time"] == pytest.approx(30 * DT)
    assert found["step error"] == model.plates.step_error(model.parameters.step_length)


class TestHand:
    @staticmethod
    def held() -> tuple[Hand, list]:
        model, blown = made(""), []
        model.blow = lambda place, way: blown.append((place, way))
        return leaves_hand(model), blown

    def test_a_drag_is_a_gust_from_where_it_began_to_where_it_ends_within_the_park(self):
        hand, blown = self.held()
        assert hand.take(Pointer("move", 1.0, 1.0, button=1)) == "" and hand.start is None
        hand.take(Pointer("down", -40.0, -3.0, button=1))
        assert hand.start == hand.at == (-FARTHEST, 0.05)
        hand.take(Pointer("move", 2.0, 50.0, button=1))
        assert hand.at == (2.0, FARTHEST) and hand.start == (-FARTHEST, 0.05)
        hand.take(Pointer("up", 1.0, 2.05, button=1))
        assert blown == [((-FARTHEST, 0.05), (1.0 + FARTHEST, 2.05 - 0.05))] and hand.start is None
        hand.take(Pointer("up", 0.0, 0.0, button=1))
        assert len(blown) == 1

    def test_a_drag_that_is_taken_back_blows_nothing(self):
        hand, blown = self.held()
        hand.take(Pointer("down", 0.0, 1.0, button=1))
        hand.take(Pointer("cancel", 1.0, 1.0))
        assert hand.start is None and not blown
        hand.take(Pointer("up", 1.0, 1.0, button=1))
        assert not blown

    def test_the_right_button_drops_the_chosen_leaf_until_there_are_too_many(self, monkeypatch):
        hand = leaves_hand(made("", leaf="birch"))
        monkeypatch.setattr("game.scenes.leaves.hand.MOST_LEAVES", 2)
        monkeypatch.setattr("game.scenes.leaves.model.MOST_LEAVES", 2)
        for x in (0.5, -0.5):
            assert hand.take(Pointer("down", x, 1.5, button=3)) == ""
        model = hand.model
        assert model.own[:, KIND].tolist() == [NAMES.index("birch")] * 2 and model.added == 2
        assert model.plates.positions == pytest.approx(np.array([(0.5, 1.5), (-0.5, 1.5)]))
        assert model.own[0, SHADE] != model.own[1, SHADE]
        assert hand.take(Pointer("down", 0.0, 1.0, button=3)) == "At most 2 leaves." and hand.start is None
        assert len(model.plates) == 2
        with pytest.raises(ValueError, match=r"leaves: at most 2"):
            model.add("oak", (0.0, 0.0), 0.0, np.random.default_rng(1))


def test_kinds_differ_by_what_makes_them_come_down_differently():
    """Light curled ones, flat ones whose inertia is that of plates that tumble, one with its weight at one
    end; a maple is the broadest and gives way most easily.
    """
    laws = {name: kind.plate for name, kind in SPECIES.items()}
    flat = {name for name, law in laws.items() if law.curl == 0.0}
    assert flat == {"oak", "birch", "ash"}
    tumbling = {name for name, law in laws.items() if BORDERS[0] < law.inertia < BORDERS[1]}
    assert tumbling == {"oak", "birch"} and all(SPECIES[name].varies < 0.1 for name in tumbling)
    assert all(laws[name].inertia < BORDERS[0] for name in ("maple", "linden", "ash"))
    assert {name for name, law in laws.items() if law.balance != 0.0} == {"ash"} and laws["ash"].balance > 0.0
    assert max(laws, key=lambda name: laws[name].curl) == "maple"
    assert sorted(laws, key=lambda name: -laws[name].half_chord) == ["maple", "linden", "ash", "oak", "birch"]
    assert min(laws, key=lambda name: laws[name].bend_hz) == "maple"
    wide = {name: kind.wide for name, kind in SPECIES.items()}
    assert sorted(wide, key=lambda name: wide[name]) == ["ash", "oak", "birch", "linden", "maple"]
    assert all(len(set(kind.colors)) == 4 for kind in SPECIES.values())


class TestOutlines:
    @pytest.mark.parametrize("name", ["birch", "linden", "ash", "oak"])
    def test_an_outline_follows_its_formula(self, name):
        wide = SPECIES[name].wide
        points = outline_of(name)
        assert points.shape == (28, 2) and points.flags.c_contiguous
        for k, (x, y) in enumerate(points.tolist()):
            turn = math.tau * k / 28
            s, c = math.sin(turn), math.cos(turn)
            assert x == pytest.approx(c, abs=1e-12)
            side = math.copysign(1.0, s)
            expected = {
                "oak": abs(s) ** 0.8 * (0.72 + 0.28 * math.cos(9.0 * c + 0.6)),
                "linden": abs(s) ** 0.75 * (1.0 - 0.25 * c),
            }.get(name, abs(s) ** 1.25 * (1.0 - 0.2 * c))
            assert y == pytest.approx(wide * expected * side, abs=1e-9)

    def test_a_maple_has_five_lobes_with_notches_between_and_is_mirrored_along_its_middle(self):
        points = outline_of("maple")
        far = np.hypot(*points.T)
        assert points.shape == (30, 2)
        assert far[2::6] == pytest.approx([1.0, 0.95, 0.66, 0.66, 0.95])
        assert far[5::6] == pytest.approx([0.34, 0.34, 0.22, 0.34, 0.34])
        for lobe, reach in enumerate((1.0, 0.95, 0.66, 0.66, 0.95)):
            assert far[6 * lobe : 6 * lobe + 5] == pytest.approx(
                reach * np.array((0.62, 0.76, 1.0, 0.76, 0.62))
            )
        turn = np.unwrap(np.arctan2(points[:, 1], points[:, 0]))
        assert np.all(np.diff(turn) > 0.0)
        assert turn[:5] == pytest.approx([-0.20, -0.09, 0.0, 0.09, 0.20])
        assert turn[2::6] == pytest.approx([0.0, 0.95, 2.05, 4.23, 5.33])
        assert turn[5::6] == pytest.approx([0.475, 1.5, 3.14, 4.78, 0.5 * (5.33 + math.tau)])

    def test_a_half_keeps_its_side_and_the_line_between(self):
        square = np.array([(-1.0, -1.0), (1.0, -1.0), (3.0, 1.0), (-1.0, 1.0)])
        assert half_of(square, 1.0).tolist() == [[0.0, -1.0], [1.0, -1.0], [3.0, 1.0], [0.0, 1.0]]
        assert half_of(square, -1.0).tolist() == [[-1.0, -1.0], [0.0, -1.0], [0.0, 1.0], [-1.0, 1.0]]
        assert half_of(square + 5.0, -1.0).shape == (0, 2)


def test_a_leaf_is_cut_as_it_is_turned_and_mirrored():
    """Corners and midrib turn by the leaf's yaw; what is mirrored goes to the other side of its midrib."""
    own = np.array(
        [[2.0, 0.7, 0.5, 0.0, 0.0, 1.0], [2.0, 0.7, 0.5, 0.3, 1.0, 1.0], [0.0, 0.0, 0.5, 0.0, 0.0, 1.0]]
    )
    cut = cut_outlines(own)
    turn = np.array(((math.cos(0.7), math.sin(0.7)), (-math.sin(0.7), math.cos(0.7))))
    birch = outline_of("birch")
    for leaf, shape in ((0, birch @ turn), (1, birch * (1.0, -1.0) @ turn), (2, outline_of("maple"))):
        for half, side in enumerate((-1.0, 1.0)):
            k = 2 * leaf + half
            part = cut.points[cut.starts[k] : cut.starts[k + 1]]
            assert part == pytest.approx(half_of(shape, side), abs=1e-12)
            assert np.all(cut.leaves[cut.starts[k] : cut.starts[k + 1]] == leaf)
    ends = np.array([(-1.35, 0.0), (0.92, 0.0)])
    assert cut.ribs == pytest.approx(np.array([ends @ turn, ends @ turn, ends]))
    assert len(cut.starts) == 7 and cut.starts[0] == 0


def test_a_scenes_actions_are_a_gust_from_below_and_calm():
    scene = Leaves()
    blown = []
    scene.model.blow = lambda place, way: blown.append((place, way))
    scene.action("whirl")
    assert blown == [((scene.model.cloud()[0], 0.35), (0.02, 0.9))]
    scene.model.wind.add(Gust((0.0, 1.0), 0.0, 3.0))
    scene.action("calm")
    assert scene.model.wind.count == 0 and not scene.model.wind.gusts.any()


def test_a_landing_sounds_by_its_speed_from_where_it_is():
    scene = Leaves()
    scene.model.heard.rows = np.array(
        [(0.5, LANDING, 0.5, 1.5), (0.6, RUBBING, 0.2, -9.0), (0.7, WIND, 0.1, 9.0)]
    )
    hearing = scene.hearing()
    assert [(s.time, s.kind, s.speed, s.pan) for s in hearing.sounds] == [
        (0.5, "rustle", 0.5, 0.5), (0.6, "rustle", 0.2, -1.0), (0.7, "wind", 0.1, 1.0)
    ]  # fmt: skip
