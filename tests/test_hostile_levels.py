"""Levels that say what no scene can be made of: refused in one line, or played without harm."""

import warnings

import pytest

from game.levels import LevelError, level_files, parse_level
from game.physics.kernels.limits import LimitError
from game.scenes import CATALOGUE
from game.stage import ParameterError, SetParameter, Stage

REFUSED = {
    "links of no size": ("solids", "content.links[0].load_radius", """
[[content.links]]
start = [1.0, 3.0]
end = [2.5, 3.0]
links = 4
load = 2.0
load_radius = 3e-162
"""),
    "a gauge of no ball": ("tracks", "there are 0", """
[[content.gauges]]
name = "first"
measure = "arrives"
of = 0
level = 2.0
"""),
    "a strip of no width": ("p04", "content.bodies[0].size[1]", """
[[content.bodies]]
shape = "strip"
size = [0.5, 3e-324]
"""),
    "a floor that ends where it begins": ("a01", "leads to the right", """
[[content.floors]]
start = [-4.0, 0.0]
pieces = [{ run = -2.0 }]

[[content.rows]]
floor = 0
x = -5.0
count = 3
"""),
}  # fmt: skip


@pytest.mark.parametrize("what", REFUSED)
def test_what_cannot_be_built_is_said_in_one_line(what):
    scene, field, content = REFUSED[what]
    scene_type = CATALOGUE[scene].load()
    with warnings.catch_warnings(), pytest.raises(LevelError) as caught:
        warnings.simplefilter("error")
        text = f'scene = "{scene}"\n[content]\n{content}'
        Stage(scene_type, level=parse_level(text, scene, scene_type.content_type))
    assert field in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize("radius", [0.5, 0.6, 2.0])
def test_a_ball_that_has_no_room_in_its_loop_has_no_exact_angle(radius):
    scene_type = CATALOGUE["a22"].load()
    text = f"""
scene = "a22"
[content]
[[content.tracks]]
form = "loop"
size = [0.5, 2.0]
count = 40
[[content.balls]]
name = "one"
at = [-2.0, 1.5]
radius = {radius}
seated = true
[[content.gauges]]
name = "leaves"
measure = "leaves"
of = "one"
[[content.gauges]]
name = "drop"
measure = "drop"
of = "one"
"""
    stage = Stage(scene_type, level=parse_level(text, "a22", scene_type.content_type))
    stage.run(2)
    values = {readout.name: readout.value for readout in stage.scene.readouts()}
    assert stage.fault is None
    assert values["leaves exact"] != values["leaves exact"] and values["drop exact"] != values["drop exact"]


@pytest.mark.parametrize("scene", ["a08", "a01", "a22"])
def test_a_solver_that_cannot_take_what_touches_says_so_when_it_is_chosen(scene):
    scene_type = CATALOGUE[scene].load()
    file = next(file for file in level_files(scene) if file.stem == "default")
    level = parse_level(file.read_text(encoding="utf-8"), scene, scene_type.content_type)
    with pytest.raises(LimitError, match="takes at most 60"):
        Stage(scene_type, level=level, parameters={"solver": "complementarity"})
    stage = Stage(scene_type, level=level)
    stage.run(2)
    before = stage.digest()
    with pytest.raises(ParameterError, match="takes at most 60"):
        stage.post(SetParameter("solver", "complementarity"))
    assert stage.digest() == before and stage.scene.parameters.solver == "soft-step"
    stage.run(2)
    assert stage.fault is None
