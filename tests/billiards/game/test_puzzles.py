"""Trick shots and drills: each can be solved, with all its stars, by the stroke that is kept with it."""

from __future__ import annotations

import numpy as np
import pytest

from game.billiards.game.frame import Frame
from game.billiards.game.goals import described, missed
from game.billiards.shot.physics import Physics
from game.billiards.table.table import POCKET_NAMES, Table
from game.levels import level_files, load_level
from game.scenes.billiards.level import BilliardsContent, ball_set, game_of, layout_for

TABLE = Table.pool()
FILES = [path for path in level_files("billiards") if path.stem.startswith(("trick-", "drill-"))]


def opened(path):
    """Level, and the frame that it begins with."""
    level = load_level(path, "billiards", BilliardsContent)
    game = game_of(level.content)
    layout = layout_for(level.content, game, TABLE, ball_set(0.0, 0.0, 0), 0)
    return level, Frame(game, layout, TABLE, Physics(airborne="airborne" not in level.effects_off))


def test_there_are_enough():
    assert sum(path.stem.startswith("trick-") for path in FILES) >= 12
    assert sum(path.stem.startswith("drill-") for path in FILES) >= 5
    titles = {opened(path)[0].title for path in FILES}
    assert len(titles) == len(FILES)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_the_kept_stroke_wins_all_stars(path):
    level, frame = opened(path)
    assert level.about and frame.game.more
    played = frame.play(level.content.solution.stroke())
    assert frame.game.stars(played.summary) == 1 + len(frame.game.more)
    assert played.verdict.words[0].startswith("★") and "☆" not in played.verdict.words[0]
    assert played.frame.layout is frame.layout and played.frame.game.best == 1 + len(frame.game.more)


def test_around_the_corner_goes_by_a_bend_and_no_cushion():
    """The cue ball runs round the row of balls in a curve, as the level's words say."""
    level, frame = opened(next(path for path in FILES if path.stem.startswith("trick-08")))
    trajectory = frame.play(level.content.solution.stroke()).trajectory
    first = next(event for event in trajectory.events if event.type.startswith("ball-"))
    assert first.type == "ball-ball" and set(first.ids) == {"0", "1"}
    way = np.array([trajectory.state_at(t).positions[0] for t in np.linspace(0.0, first.time, 50)])
    chord = way[-1] - way[0]
    off = (way - way[0]) @ np.array([-chord[1], chord[0]]) / np.linalg.norm(chord)
    assert np.abs(off).max() > 0.12
    # by no straight way: the row is in it
    straight = level.content.solution.stroke()._replace(elevation=0.0)
    assert frame.game.stars(frame.play(straight).summary) == 0


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_each_star_asks_for_more(path):
    """Every goal says something, in words, and no goal is met by balls that lie still."""
    level, frame = opened(path)
    goals = (frame.game.goal, *frame.game.more)
    assert all(described(goal, POCKET_NAMES) for goal in goals)
    still = frame.play(level.content.solution.stroke()._replace(cue_speed=0.05, tip_left=0.0, tip_up=0.0))
    assert frame.game.stars(still.summary) == 0 and missed(frame.game.goal, still.summary)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_star_can_be_had_without_all_of_them(path):
    """Strokes a little off the kept one win the first star, and not always the last."""
    level, frame = opened(path)
    kept = level.content.solution.stroke()
    stars = set()
    for k in range(-12, 13):
        for tip in (-0.06, 0.0, 0.06):
            near = kept._replace(cue_speed=kept.cue_speed * (1.0 + 0.02 * k), tip_up=kept.tip_up + tip)
            stars.add(frame.game.stars(frame.play(near).summary))
    assert len(stars) >= 2 and max(stars) == 1 + len(frame.game.more)
