"""Where the picture of two trees is drawn: one pane, or two where that is asked for and can be."""

from __future__ import annotations

import itertools
from types import SimpleNamespace

import pytest

from game.physics.kernels.limits import LimitError
from game.scenes.bounds.panes import TITLES, Panes, SideBySide


def model_of(outlines: int = 2, fails: bool = False, asked: list[int] | None = None) -> SimpleNamespace:
    kinds = iter(TITLES)
    pair, beside = (
        SimpleNamespace(options=SimpleNamespace(kind=kind)) for kind in (next(kinds), next(kinds))
    )

    def ask() -> None:
        if asked is not None:
            asked.append(1)
        if fails:
            raise LimitError("too many pairs")

    view = SimpleNamespace(left=-3.0, right=5.0, bottom=1.0, top=4.0)
    return SimpleNamespace(
        pair=pair, beside=beside, outlines=[None] * outlines, ask_beside=ask,
        content=SimpleNamespace(view=view),
    )  # fmt: skip


def test_one_pane_is_the_whole_as_it_is():
    model = model_of()
    (pane,) = Panes(model)()
    assert pane.pair is model.pair and pane.point((0.3, -2.0)) == (0.3, -2.0)


@pytest.mark.parametrize(
    ("side_by_side", "walked", "outlines"),
    list(itertools.product((True, False), ("off", "a"), (1, 2, 3))),
)
def test_two_panes_only_if_asked_for_of_two_outlines_that_are_not_walked(side_by_side, walked, outlines):
    asked: list[int] = []
    model = model_of(outlines, asked=asked)
    panes = SideBySide(model, SimpleNamespace(side_by_side=side_by_side, walked=walked))()
    two = side_by_side and walked == "off" and outlines == 2
    assert len(panes) == len(asked) + 1 == (2 if two else 1) and panes[0].pair is model.pair


def test_where_there_are_too_many_pairs_these_trees_stand_alone():
    panes = SideBySide(model_of(fails=True), SimpleNamespace(side_by_side=True, walked="off"))()
    assert len(panes) == 1 and panes[0].scale == 1.0


def test_each_pane_has_half_the_size_in_its_half_of_the_view():
    """The view's middle comes to the middle of each half; titles say whose trees they are."""
    model = model_of()
    left, right = SideBySide(model, SimpleNamespace(side_by_side=True, walked="off"))()
    assert (left.pair, right.pair) == (model.pair, model.beside)
    assert left.point((1.0, 2.5)) == pytest.approx((-1.0, 2.5))
    assert right.point((1.0, 2.5)) == pytest.approx((3.0, 2.5))
    for pane in (left, right):
        assert pane.scale == 0.5 and pane.world(pane.point((0.7, 3.3))) == pytest.approx((0.7, 3.3))
        x, y = pane.point((-3.0, 1.0))
        assert (pane.point((5.0, 4.0))[0] - x, pane.point((5.0, 4.0))[1] - y) == pytest.approx((4.0, 1.5))
        assert pane.title == TITLES[pane.pair.options.kind]
