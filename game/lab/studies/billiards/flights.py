"""What balls in the air cost: one stroke with the cue raised ever more, with the effect and without.

A level cue makes no ball leave the slate. The stroke is then played by the same kernel either way, and the
two must cost the same.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence

from game.billiards.shot.cue import strike
from game.billiards.shot.shot import Shot, make_shot
from game.billiards.shot_effects import AIRBORNE, EXACT_EFFECTS, GAME_EFFECTS, physics_of
from game.billiards.table.table import Table
from game.lab.studies.billiards.effects import effects_study, shot_without
from game.lab.study import Axes, Knob, Method, Setting, Study, Trial, Workload

SPEED = 3.0  # m/s, of the cue
PLACES = [[0.635, 0.5], [0.64, 0.75], [0.6, 1.3], [0.3, 2.0]]
LEVEL = 0.1  # degrees; so little makes no ball leave the slate
RAISED = (LEVEL, 5.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0)  # degrees


def stroke_at(elevation: float, airborne: bool) -> Shot:
    """The stroke with the butt raised by so many degrees: a ball is in its way."""
    physics = physics_of(GAME_EFFECTS if airborne else EXACT_EFFECTS)
    raised = math.radians(elevation)
    made = strike(SPEED, 0.5 * math.pi, raised)
    return make_shot(Table.pool(), PLACES, physics=physics).struck(0, made.pressed(raised), made.spin)


def _trial(setting: Setting) -> Trial:
    return shot_without(stroke_at(setting.knob, setting.method == "air"), stroke_at(setting.knob, True))


def _setting(elevation: float, airborne: bool) -> Setting:
    scene = {AIRBORNE.name: airborne, "elevation": elevation}
    return Setting("air" if airborne else "slate", elevation, {}, scene)


def _settings() -> Sequence[Setting]:
    return [_setting(elevation, airborne) for airborne in (True, False) for elevation in RAISED]


def _present(parameters: Mapping[str, object]) -> Setting:
    """Where a scene with this elevation and effect stands."""
    elevation = max(float(str(parameters["elevation"])), LEVEL)
    return _setting(elevation, bool(parameters[AIRBORNE.name]))


flights_study = Study(
    name="billiards-flights",
    title="Exact table: what balls in the air cost",
    error="farthest ball from where it is if balls may leave the slate, after 1.5 s",
    error_unit="m",
    counter="events",
    knob=Knob("elevation", "elevation of the cue", "°"),
    methods=(Method("air", "airborne balls"), Method("slate", "all stay on the slate")),
    settings=_settings,
    short="Flights",
    trial=_trial,
    present=_present,
    workload=Workload("a stroke at 3 m/s with a ball in its way"),
    reference="the exact table with balls that leave the slate.",
    expectation="A level cue costs nothing: what plays it is the same. A raised one pays for its bounces: "
    "each flight looks at every nose and jaw, and there are some eight bounces, the last ones ever shorter. "
    "Without the effect the ball in the way is hit, and from there on it is another shot.",
    axes=Axes("knob", "cpu"),
)
game_study = dataclasses.replace(
    effects_study, name="billiards-effects", related=(*effects_study.related, flights_study)
)
