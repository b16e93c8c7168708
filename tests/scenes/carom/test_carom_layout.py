"""Where the carom's buttons and options stand."""

from itertools import pairwise

import pytest

from game.scenes.carom.layout import FOOT, option_box


@pytest.mark.parametrize("count", [1, 2, 5])
def test_options_share_the_foot_side_by_side(count):
    boxes = [option_box(row, count) for row in range(count)]
    assert boxes[0].left == pytest.approx(FOOT.left)
    assert boxes[-1].right == pytest.approx(FOOT.right, abs=0.0301)
    for left, right in pairwise(boxes):
        assert right.left == pytest.approx(left.right + 0.03)
        assert right.right - right.left == pytest.approx(left.right - left.left)
    assert all(box.left < box.right for box in boxes)
