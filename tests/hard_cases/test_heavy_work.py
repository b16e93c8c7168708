"""Work that grows with the square of what a level lists, or faster: mended, or refused in one line."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from game.folders import data_folder
from game.levels import LevelError, parse_level
from game.physics.bounds import build_tree
from game.physics.bounds.query import Query
from game.physics.broadphase import SweepAndPrune
from game.physics.broadphase.sweep_and_prune import MOST_SWAPS
from game.physics.broadphase.workloads import make_boxes
from game.physics.kernels.limits import LimitError
from game.physics.particles import OBSTACLES, PARTICLES, contacts
from game.physics.particles.flight import METHODS
from game.scenes import CATALOGUE
from game.scenes.bounds import pair as bounds_pair
from game.stage import ParameterError, SetEffect, SetParameter, Stage

WORLD = (11.2, 8.0)


def opened(text: str) -> Stage:
    """The stage of a level's text."""
    name = text.split('"')[1]
    scene_type = CATALOGUE[name].load()
    return Stage(scene_type, level=parse_level(text, name, scene_type.content_type))


class TestStonesInEachOther:
    """A particle within a heap of stones is pushed out of one into the next."""

    def looked_at(self, monkeypatch: pytest.MonkeyPatch, solids: np.ndarray, mode: int) -> tuple[int, float]:
        """How often a step of a particle at rest in the middle looks at a solid, and the time it drops, s."""
        for name, function in list(vars(contacts).items()):
            monkeypatch.setattr(contacts, name, getattr(function, "py_func", function))
        looks, look = [], contacts.surface

        def counted(*arguments: Any) -> Any:
            looks.append(1)
            return look(*arguments)

        monkeypatch.setattr(contacts, "surface", counted)
        monkeypatch.setattr(contacts, "fly_alone", lambda *a: a[3:7])
        monkeypatch.setattr(contacts, "acceleration", lambda *a: (0.0, 0.0))
        rules = contacts.Rules(mode, METHODS.index("verlet"), PARTICLES.mask(OBSTACLES), 0.0, 0.5, 0.01)
        impulses = np.zeros((len(solids), 2))
        *_, lost = contacts.fly_among_solids(rules, None, solids, (0.0, 0.0, 0.0, 0.0), 0.0, 0.01, impulses)
        return len(looks), lost

    @pytest.fixture
    def heap(self) -> np.ndarray:
        """Four stones of radius 1 m, each 0.8 m off the middle: each pushes who is there into the others."""
        solids = np.zeros((4, 6))
        solids[:, 0], solids[:, 1] = (0.8, 0.0, -0.8, 0.0), (0.0, 0.8, 0.0, -0.8)
        solids[:, 2], solids[:, 5] = 1.0, 1.0
        return solids

    @pytest.mark.parametrize("mode", [contacts.CHORD, contacts.ROOT])
    def test_who_has_no_way_out_stays(
        self, monkeypatch: pytest.MonkeyPatch, heap: np.ndarray, mode: int
    ) -> None:
        looks, lost = self.looked_at(monkeypatch, heap, mode)
        assert lost == 0.01
        assert looks <= 10 * len(heap)  # eight times eight rounds were more than 64 times as many

    @pytest.mark.parametrize("count", [1, 2])
    def test_who_has_a_way_out_takes_it(
        self, monkeypatch: pytest.MonkeyPatch, heap: np.ndarray, count: int
    ) -> None:
        looks, lost = self.looked_at(monkeypatch, heap[:count], contacts.CHORD)
        assert lost == 0.0
        assert looks > 0


class TestPlacesAndSubsteps:
    """Places in the pool times substeps times solids."""

    HEAVY = 'scene = "c04"\n[parameters]\nplaces = 1000000.0\ndrag = 500.0\nstep_length = 0.1\n'

    def test_a_level_is_refused(self) -> None:
        with pytest.raises(
            LevelError, match=r"^level: parameters: places: 1000000 are too many for 64 substeps"
        ):
            opened(self.HEAVY)
        opened(self.HEAVY.replace("500.0", "1.0"))

    def test_so_is_what_would_lead_there(self) -> None:
        stage = opened(self.HEAVY + '[effects]\noff = ["drag"]\n')
        for event in (SetEffect("drag", True), SetParameter("fast_drag", 10.0)):
            with pytest.raises(ParameterError, match="too many for"):
                stage.post(event)
            assert stage.fault is None
        assert "drag" not in stage.scene.active.names
        assert stage.scene.parameters.fast_drag == 0.05
        stage.post(SetParameter("places", 1000.0))
        stage.post(SetEffect("drag", True))
        assert stage.run(2) == 2


class TestSwaps:
    """Sweep and prune where all boxes leap: n² swaps."""

    def leaps(self, resort: bool, count: int, steps: int) -> SweepAndPrune:
        random = np.random.default_rng(3)
        phase = SweepAndPrune(resort=resort)
        size = 0.3 / np.sqrt(count)
        ids = phase.add_boxes(*(2 * [random.random((count, 2))]))
        for _ in range(steps):
            lowers = random.random((count, 2))
            phase.update_boxes(ids, lowers, lowers + size)
        return phase

    def test_swaps_are_counted_but_not_all_made(self) -> None:
        swapping, sorting = self.leaps(False, 3000, 3), self.leaps(True, 3000, 3)
        assert swapping.swaps == sorting.swaps > 3 * MOST_SWAPS
        assert swapping.resorts == 3
        assert np.array_equal(swapping.pairs(), sorting.pairs())
        swapping.check()

    def test_few_swaps_are_made_one_by_one(self) -> None:
        assert self.leaps(False, 900, 3).resorts == 0

    def test_a_step_is_judged_by_all_its_swaps(self, monkeypatch: pytest.MonkeyPatch) -> None:
        """Those made before it was given up count as well: else each step tries them in vain again."""
        boxes = make_boxes("equal", 5000, np.random.default_rng(1), WORLD, 2.0, 0.25)
        phase = SweepAndPrune()
        ids = phase.add_boxes(boxes.lowers, boxes.uppers)
        tried, by_swaps = [], phase._sort_by_swaps
        monkeypatch.setattr(phase, "_sort_by_swaps", lambda: tried.append(1) or by_swaps())
        for step in range(1, 6):
            way = step * boxes.velocities / 12.0
            phase.update_boxes(ids, boxes.lowers + way, boxes.uppers + way)
        assert phase.resorts == 5
        assert len(tried) == 1


class TestOutlinesInEachOther:
    """Two polylines that cross everywhere: the product of their segments."""

    @staticmethod
    def level(points: np.ndarray, leaf: int = 1, more: str = "") -> str:
        entry = f'[[content.outlines]]\nshape = "points"\npoints = {points.tolist()}\n{more}'
        return f'scene = "c08"\n[parameters]\nleaf_size = {leaf}.0\n{entry}{entry}'

    def test_scattered_points(self) -> None:
        scattered = np.random.default_rng(1).uniform(-1.0, 1.0, (800, 2))
        with pytest.raises(LevelError) as refused:
            opened(self.level(scattered))
        assert str(refused.value).startswith(
            "level: content: the outlines lie in each other: more than 250000"
        )
        assert "\n" not in str(refused.value)

    def test_equal_points_in_large_leaves(self) -> None:
        with pytest.raises(LevelError, match="pairs of segments that meet"):
            opened(self.level(np.zeros((800, 2)), leaf=64))

    def test_as_many_points_in_order_are_none_too_many(self) -> None:
        angle = np.linspace(0.0, 2.0 * np.pi, 4000)
        stage = opened(self.level(np.stack([np.cos(angle), np.sin(angle)], axis=1)))
        assert stage.run(3) == 3

    def test_a_query_keeps_within_its_room(self) -> None:
        points = np.random.default_rng(2).uniform(-1.0, 1.0, (300, 2))
        tree = build_tree(points, leaf_size=1)
        roomy = Query(tree, tree)
        roomy.run((0.0, 0.0))
        need = max(roomy.row_count, roomy.crossing_count)
        just = Query(tree, tree, need)
        just.run((0.0, 0.0))
        assert np.array_equal(just.rows, roomy.rows)
        assert np.array_equal(just.crossings, roomy.crossings)
        assert len(just._rows) <= need
        tight = Query(tree, tree, need - 1)
        tight.run((9.0, 0.0))
        with pytest.raises(LimitError):
            tight.run((0.0, 0.0), coherent=True)
        assert len(tight._rows) < need
        tight.run((9.0, 0.0), coherent=True)
        assert tight.row_count == 1
        tight.check()

    def test_crossings_are_not_counted_to_the_end(self) -> None:
        """One leaf against one leaf, all crossings: the walk ends where there is no room for more."""
        tree = build_tree(np.zeros((900, 2)), leaf_size=8)
        query = Query(tree, tree, 10_000)
        with pytest.raises(LimitError):
            query.run((0.0, 0.0))
        assert len(query._crossings) <= 10_000

    def test_trees_beside_are_left_out_first(self, monkeypatch: pytest.MonkeyPatch) -> None:
        """Axis-aligned boxes over two arcs overlap more often than oriented ones: 715 pairs against 43."""
        monkeypatch.setattr(bounds_pair, "MOST_PAIRS", 300)
        text = (data_folder("levels") / "c08" / "arcs.toml").read_text(encoding="utf-8")
        stage = opened(text[text.index("scene") :])
        assert stage.scene.parameters.compare is False
        assert any("switched off" in said for said in stage.scene.messages())
        assert stage.run(3) == 3
        assert "axis-aligned" not in [readout.name for readout in stage.readouts()]


class TestNets:
    """Nets whose size is a few numbers in a file."""

    BLOCK = "[[content.blocks]]\ncorner = [0.0, 1.0]\ncolumns = 400\nrows = 400\nspacing = 0.01\n"

    def test_particles(self) -> None:
        with pytest.raises(LevelError, match=r"blocks\[1\]: .* there are 320000, 200000 at most"):
            opened('scene = "c15"\n' + 6 * self.BLOCK)

    def test_sweeps(self) -> None:
        text = 'scene = "c14"\n[parameters]\niterations = 500.0\nsubsteps = 200.0\n[content]\n'
        text += self.BLOCK.replace("400", "60")
        with pytest.raises(LevelError, match=r"^level: content: iterations, substeps: 500 x 200 sweeps over"):
            opened(text)
        stage = opened(text.replace("500.0", "10.0").replace("200.0", "1.0"))
        stage.post(SetParameter("substeps", 200.0))
        with pytest.raises(ParameterError, match="iterations, substeps"):
            stage.post(SetParameter("iterations", 500.0))
        assert stage.scene.parameters.iterations == 10 and stage.scene.model.system.settings.iterations == 10
        assert stage.fault is None
