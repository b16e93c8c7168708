"""How far an aim may be off, and how often a hand pots: both are what strokes of the exact table do."""

import math

import numpy as np
import pytest

from game.billiards import simulate
from game.billiards.game.arrangement import Stroke
from game.billiards.game.summary import summarize
from game.billiards.search.chances import DRAWS, SEED
from game.billiards.search.strokes import Board, draw_noise, with_noise
from game.billiards.table.rack import BALL_RADIUS
from game.scenes.billiards.view.instruments import odds_numbers
from game.scenes.billiards.view.words import aim_words
from game.scenes.shared.tables.odds import (
    FIRST_SAMPLES,
    HAND,
    OFFSETS,
    Asked,
    Odds,
    OddsMeter,
    measure,
)
from tests.billiards.search.search_tables import POOL
from tests.scenes.billiards.billiards_stages import AT_THE_CORNER, level_of, straight_pot

pytestmark = pytest.mark.compiled

FAR = (
    'game = "practice"\nballs = [{ number = 0, position = [0.9, 1.9] },'
    " { number = 3, position = [0.4, 0.7] }, { number = 5, position = [0.9, 2.2] }]"
)
TO_POCKET = math.atan2(-0.7, -0.4)
GHOST = 0.4 - 2.0 * BALL_RADIUS * math.cos(TO_POCKET), 0.7 - 2.0 * BALL_RADIUS * math.sin(TO_POCKET)
LINE = math.atan2(GHOST[1] - 1.9, GHOST[0] - 0.9)


def potted(frame, stroke: Stroke, ball: int, pocket: int | None = None) -> bool:
    """Whether an exact stroke pots a ball (into that pocket) and no cue ball, as the referee sees it."""
    summary = summarize(simulate(frame.layout.shot(POOL, frame.physics, stroke)))
    fallen = summary.pocketing(ball)
    return fallen is not None and pocket in (None, fallen.pocket) and not summary.cue_lost


def aimed_at_pot(frame, ball: int) -> Stroke:
    """The middle of the aims that pot the 3 of FAR in the corner, by trying."""
    aims = (LINE + np.radians(np.arange(-0.6, 0.6, 0.01))).tolist()
    runs: list[list[float]] = [[]]
    for aim in aims:  # the jaws let some in from farther off as well
        if potted(frame, Stroke(2.0, aim), ball):
            runs[-1].append(aim)
        elif runs[-1]:
            runs.append([])
    longest = max(runs, key=len)
    return Stroke(2.0, 0.5 * (longest[0] + longest[-1]))


def all_of(frame, stroke: Stroke, ball: int) -> Odds:
    """Everything that can be known."""
    return list(measure(Board(frame.layout, POOL, frame.physics), stroke, Asked(ball)))[-1]


@pytest.mark.parametrize("off", [0.0, 0.35, -0.35])
def test_within_the_margin_the_ball_goes_down_and_a_little_beyond_it_on_one_side_no_more(off):
    frame = level_of(FAR).scene.model.frame
    middle = aimed_at_pot(frame, 3)
    whole = min(all_of(frame, middle, 3).margin)
    stroke = middle._replace(azimuth=middle.azimuth + off * whole)
    sides = all_of(frame, stroke, 3).margin
    assert sides == pytest.approx(((1.0 - off) * whole, (1.0 + off) * whole), rel=0.15)
    margin = min(sides)

    def turned(angle: float) -> bool:
        return potted(frame, stroke._replace(azimuth=stroke.azimuth + angle), 3)

    assert all(turned(share * margin) for share in (-1.0, -0.5, 0.5, 1.0))
    assert not (turned(1.05 * margin) and turned(-1.05 * margin))
    assert turned(0.95 * sides[0]) and not turned(1.05 * sides[0])
    assert turned(-0.95 * sides[1]) and not turned(-1.05 * sides[1])


def test_the_chance_is_the_share_of_the_hands_strokes_that_pot():
    frame = level_of(FAR).scene.model.frame
    stroke = aimed_at_pot(frame, 3)
    odds = all_of(frame, stroke, 3)
    noisy = with_noise(np.array([stroke]), draw_noise(SEED, DRAWS), HAND, BALL_RADIUS)
    down = sum(potted(frame, Stroke(*row), 3, 0) for row in noisy.tolist())
    assert odds.chance == pytest.approx(down / DRAWS, abs=1e-12) and 0.1 < odds.chance < 0.95


def test_the_first_figure_is_the_share_of_the_first_strokes():
    frame = level_of(FAR).scene.model.frame
    stroke = aimed_at_pot(frame, 3)
    known = list(measure(Board(frame.layout, POOL, frame.physics), stroke, Asked(3)))
    chances = list(dict.fromkeys(odds.chance for odds in known if odds.chance is not None))
    noisy = with_noise(np.array([stroke]), draw_noise(SEED, DRAWS), HAND, BALL_RADIUS)[:FIRST_SAMPLES]
    down = sum(potted(frame, Stroke(*row), 3, 0) for row in noisy.tolist())
    assert chances[0] == pytest.approx(down / FIRST_SAMPLES) and len(chances) <= 2


def test_a_stroke_that_misses_has_no_margin_and_little_chance():
    frame = straight_pot().scene.model.frame
    missing = all_of(frame, Stroke(1.5, AT_THE_CORNER + 0.09), 3)
    assert missing.missed and missing.margin is None and missing.chance is not None and missing.chance < 0.3
    sure = all_of(frame, Stroke(1.5, AT_THE_CORNER, tip_up=-0.4), 3)  # the cue ball does not follow
    assert not sure.missed and sure.chance == 1.0


def test_a_picture_waits_for_a_slice_of_time_alone_and_what_is_known_is_kept():
    frame = straight_pot().scene.model.frame
    seconds = iter(0.0005 * k for k in range(100_000))
    asked = []

    def now() -> float:
        asked.append(next(seconds))
        return asked[-1]

    meter, stroke = OddsMeter(now), Stroke(1.5, AT_THE_CORNER)
    seen = []
    while not seen or seen[-1].chance is None or len(seen) < 40:
        before = len(asked)
        seen.append(meter.of(frame, stroke, Asked(3)))
        assert len(asked) - before <= 6  # 2 ms of this clock
    assert seen[0].margin is None and seen[0].chance is None
    assert next(odds.margin for odds in seen if odds.margin is not None) == seen[-1].margin
    before = len(asked)
    assert meter.of(frame, stroke, Asked(3)) is seen[-1] and len(asked) - before == 1
    other = meter.of(frame, stroke._replace(azimuth=AT_THE_CORNER + 0.01), Asked(3))
    assert other.margin is None and other.chance is None


def test_other_places_of_the_balls_are_measured_anew():
    """The ball to be potted lies elsewhere in the second frame: by the first one's odds it would go down."""
    stroke = Stroke(1.5, AT_THE_CORNER, tip_up=-0.4)
    moved = (
        'game = "practice"\nballs = [{ number = 0, position = [0.5, 0.5] },'
        " { number = 3, position = [0.3, 1.8] }, { number = 5, position = [0.9, 2.2] }]"
    )
    meter = OddsMeter(lambda: 0.0)  # no time passes, so that a picture waits for all
    assert meter.of(straight_pot().scene.model.frame, stroke, Asked(3)).chance == 1.0
    odds = meter.of(level_of(moved).scene.model.frame, stroke, Asked(3))
    assert odds.missed and odds.chance == 0.0


def test_the_figures_beside_the_aim():
    assert odds_numbers(None) == ()
    margin, pot = odds_numbers(Odds(10, margin=(math.radians(0.312), math.radians(0.309)), chance=0.84))
    assert (margin.title, margin.words) == ("Margin", "±0.31°")
    assert (pot.title, pot.words, pot.under) == ("Pot 10", "84 %", "hand ±0.24°")
    assert odds_numbers(Odds(10))[0].words == odds_numbers(Odds(10))[1].words == "…"
    assert odds_numbers(Odds(10, missed=True, chance=0.02))[0].words == "\N{EN DASH}"
    most = float(OFFSETS[-1])
    assert odds_numbers(Odds(1, margin=(most, most)))[0].words.startswith("≥")


def test_a_margin_that_differs_says_both_sides():
    """The greater side of the azimuth is the greater figure of the aim."""
    margin, _ = odds_numbers(Odds(10, margin=(math.radians(0.31), math.radians(0.12))))
    assert (margin.words, margin.small) == ("+0.31 −0.12°", True)
    assert float(aim_words(1.0 + 0.01)[:-1].replace("−", "-")) > float(aim_words(1.0)[:-1].replace("−", "-"))
    assert odds_numbers(Odds(1, margin=(float(OFFSETS[-1]), 0.001)))[0].words.startswith("≥2.99 −0.06")
