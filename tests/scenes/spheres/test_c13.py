"""C13 by posted events: every point of the task, its levels and hard cases."""

from __future__ import annotations

import math

import msgspec
import numpy as np
import pygame
import pytest

from game.levels import Level, LevelError, level_files, load_level, save_level
from game.physics.spheres import ledger
from game.scenes.spheres import view as c13_view
from game.scenes.spheres.ledger import entry_of, momentum_lost
from game.scenes.spheres.level import CollisionContent
from game.scenes.spheres.scene import SphereCollisions
from game.scenes.spheres.view import places_and_tips
from game.stage import Action, ParameterError, Pointer, SetEffect, SetParameter, Stage
from game.stage.states.state import copy_state
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import theme_named
from tests.scenes.particle_stages import click, drag, move, open_level, press, readouts, release

HARD = [path.stem for path in level_files("c13") if path.stem.startswith("hard")]


def opened(name, **parameters):
    return open_level(SphereCollisions, name, **parameters)


def bodies_of(stage):
    return stage.scene.model.world.bodies


def beside(place, x, y):
    return place[0] + x, place[1] + y


def blank_canvas(stage, size=(1000, 600)):
    """A canvas on an empty picture that shows the scene's frame."""
    pygame.font.init()
    surface, camera = pygame.Surface(size, 0, 32), Camera()
    camera.fit(stage.scene.frame(), surface.get_rect(), 0)
    canvas = Canvas(Look(theme_named("dark"), 1.0))
    canvas.begin(surface, surface.get_rect(), camera)
    return canvas


def wait(stage, seconds):
    stage.run(round(seconds / stage.dt))


# -- the points of the task -----------------------------------------------------------------------------


def test_each_sphere_is_a_body_with_a_radius_line_that_turns():
    """C13.1, .3: ends of radius lines go round with the orientation; mass and inertia 1."""
    stage = opened("two-spheres")
    bodies = bodies_of(stage)
    assert bodies.composition.masses.tolist() == [1.0, 1.0]
    assert bodies.composition.inverse_inertias[:, :3].tolist() == [[1.0] * 3] * 2
    places, tips = places_and_tips(bodies.state, bodies.composition)
    assert np.allclose(tips - places, [(0.6, 0.0)] * 2)
    stage.run(30)
    places, tips = places_and_tips(bodies.state, bodies.composition)
    arm = tips[1] - places[1]
    assert math.hypot(*arm) < 0.6 and arm[1] > 0.2, "it turns in space, so its line is seen shortened"


def test_spheres_are_clicked_and_removed():
    """C13.2: the tool makes them, one by one, within the window; a right click removes one."""
    stage = opened("draw", radius=0.3)
    click(stage, (1.0, 2.0))
    click(stage, (-50.0, 2.0))
    composition, state = bodies_of(stage).composition, bodies_of(stage).state
    assert composition.radii.tolist() == [0.25, 0.3, 0.3]
    assert state.positions[2, 0] == pytest.approx(-4.2 + 0.3)
    stage.run(10)
    click(stage, bodies_of(stage).state.positions[1, :2], button=3)
    assert bodies_of(stage).composition.radii.tolist() == [0.25, 0.3]
    stage.post(Action("remove"))
    click(stage, bodies_of(stage).state.positions[0, :2])
    assert bodies_of(stage).composition.radii.tolist() == [0.3]
    click(stage, bodies_of(stage).state.positions[0, :2])
    assert bodies_of(stage).count == 1 and "The last body stays." in stage.scene.messages()


def test_real_masses():
    """C13.3: density times volume and 2/5 m r², live; a mass of its own is kept."""
    stage = opened("hard-05-mass-ratio")
    stage.post(SetParameter("density", 3.0))
    stage.post(SetParameter("real", True))
    composition = bodies_of(stage).composition
    mass = 3.0 * 4.0 / 3.0 * math.pi * 0.2**3
    assert composition.masses[0] == pytest.approx(mass)
    assert 1.0 / composition.inverse_inertias[0, 0] == pytest.approx(0.4 * mass * 0.04)
    assert composition.masses[1] == 1e6 and math.isinf(composition.masses[5])


def test_brute_force_or_any_broad_phase():
    """C13.4: every pair is tested; with a grid the run is the same, bit for bit."""
    digests = []
    for name in ("brute-force", "grid", "hierarchical", "sweep-and-prune"):
        stage = opened("default", broad_phase=name)
        stage.run(60)
        digests.append([part.tobytes() for part in bodies_of(stage).state])
        if name == "brute-force":
            assert readouts(stage)["pair tests per step"] >= 16 * 15 / 2
    assert all(digest == digests[0] for digest in digests)


def test_impulses_and_ledger():
    """C13.5, .7: impulses turn approaches round and are shown; momentum is kept, energy falls."""
    stage = opened("default")
    before = readouts(stage)
    wait(stage, 0.5)
    after = readouts(stage)
    assert after["collisions"] > 10
    assert after["P x"] == pytest.approx(before["P x"], abs=1e-12), "no wall was met so far"
    assert after["total energy"] < before["total energy"]
    entries = stage.scene.model.world.ledger()
    assert entries[:, ledger.LOST_MOMENTUM].max() < 1e-14
    assert entries[:, ledger.LOST_SPIN].max() < 1e-13
    assert np.allclose(entries[:, ledger.CHANGE], entries[:, ledger.EXPECTED], rtol=0, atol=1e-13)
    assert np.allclose(entries[:, ledger.AFTER], -0.95 * entries[:, ledger.BEFORE], rtol=0, atol=1e-13)


def test_the_ledger_says_what_a_wall_takes():
    """Between two spheres no momentum is lost; at a wall the spheres lose the impulse."""
    stage = opened("default")
    wait(stage, 2.5)
    table = stage.scene.panel_table()
    entries = stage.scene.model.world.ledger()[-table.room :][::-1]
    assert len(table.rows) == len(entries) == table.room
    assert {bool(entry[ledger.OTHER] < 0.0) for entry in entries} == {True, False}
    for row, key, entry in zip(table.rows, table.keys, entries, strict=True):
        pair, impulse, *_, lost = row
        assert len(row) == len(table.columns)
        if entry[ledger.OTHER] < 0.0:
            assert pair == f"{entry[ledger.ONE] + 1:.0f}, wall"
            assert lost == impulse
        else:
            assert pair == f"{entry[ledger.ONE] + 1:.0f}, {entry[ledger.OTHER] + 1:.0f}"
            assert lost == "0"
        assert np.array_equal(entry_of(stage.scene.model, key), entry)
    assert entry_of(stage.scene.model, 0) is None or stage.scene.model.world.collisions <= len(
        stage.scene.model.world.ring
    )
    assert entry_of(stage.scene.model, stage.scene.model.world.collisions + 1) is None


def test_the_momentum_lost_is_what_the_total_lost():
    """Of spheres that met nothing else since: what walls took is the change of P."""
    stage = opened("bouncing")
    stage.post(SetEffect("gravity", False))
    before, seen = readouts(stage), 0
    for _ in range(600):
        stage.run(1)
        after = readouts(stage)
        jump = math.hypot(after["P x"] - before["P x"], after["P y"] - before["P y"])
        if after["collisions"] == before["collisions"] + 1:
            lost = momentum_lost(stage.scene.model, stage.scene.model.world.ledger()[-1])
            assert lost == pytest.approx(jump, abs=1e-12)
            seen += lost > 0.0
        before = after
    assert seen > 3


def test_a_sphere_that_nothing_moves_takes_momentum_like_a_wall():
    stage = opened("hourglass")
    assert stage.scene.panel_table() is None, "5,000 spheres have no ledger"
    content = msgspec.json.decode(
        b'{"spheres": [{"position": [0.0, 0.0], "velocity": [2.0, 0.0]}, {"position": [1.5, 0.0],'
        b' "fixed": true}]}',
        type=CollisionContent,
    )
    stage = Stage(SphereCollisions, level=Level(scene="c13", content=content))
    stage.post(SetEffect("gravity", False))
    wait(stage, 1.0)
    (entry,) = stage.scene.model.world.ledger()
    assert momentum_lost(stage.scene.model, entry) == pytest.approx(
        math.hypot(*entry[ledger.JX : ledger.JZ + 1])
    )


def test_pointing_at_a_row_lights_its_pair(monkeypatch):
    """In the picture alone: the state does not know of it. Spheres carry the numbers of the ledger."""
    stage = opened("default")
    wait(stage, 2.5)
    canvas, rings, words = blank_canvas(stage), [], []
    monkeypatch.setattr(Canvas, "circle", lambda _, centre, *rest, **more: rings.append(tuple(centre)))
    monkeypatch.setattr(Canvas, "label", lambda _, at, text, *rest, **more: words.append(text))
    stage.scene.draw(canvas, 1.0)
    assert words == [str(s) for s in range(1, 17)]
    assert not rings
    digest = stage.digest()
    table = stage.scene.panel_table()
    for row, key in zip(table.rows, table.keys, strict=True):
        rings.clear()
        stage.scene.point_at(key)
        stage.scene.draw(canvas, 1.0)
        named = [int(word) - 1 for word in row[0].split(", ") if word != "wall"]
        assert rings == [tuple(place[:2]) for place in bodies_of(stage).places()[named].tolist()]
    assert stage.digest() == digest
    stage.post(SetParameter("ledger", False))
    words.clear(), rings.clear()
    stage.scene.draw(canvas, 1.0)
    assert not words and not rings
    assert stage.scene.panel_table() is None


def test_a_force_by_click_and_drag_moves_and_turns():
    """C13.6: from where it is pressed to where it is let go, at that point of the body."""
    stage = opened("two-spheres")
    stage.post(SetEffect("window", False))
    start = bodies_of(stage).state.positions[0, :2].copy()
    stage.post(SetParameter("push_time", stage.dt))
    before = bodies_of(stage).state.momenta[0].copy()
    press(stage, beside(start, 0.0, 0.5))
    move(stage, beside(start, 1.0, 0.5))
    assert stage.scene.hand.pressed is not None
    release(stage, beside(start, 1.0, 0.5))
    stage.run(1)
    change = bodies_of(stage).state.momenta[0] - before
    assert change[0] == pytest.approx(40.0 * stage.dt, rel=1e-9)
    assert bodies_of(stage).turning[0, 2] == pytest.approx(-0.5 * 40.0 * stage.dt, rel=0.05)
    stage.run(1)
    assert not stage.scene.model.pushes


def test_a_force_is_taken_back_or_switched_off():
    stage = opened("two-spheres")
    at = bodies_of(stage).state.positions[1, :2]
    press(stage, at)
    stage.post(Pointer("cancel", 0.0, 0.0))
    release(stage, beside(at, 1.0, 0.0))
    assert not stage.scene.model.pushes
    stage.post(SetEffect("pushes", False))
    drag(stage, at, beside(at, 1.0, 0.0), run=0)
    assert not stage.scene.model.pushes
    assert "Pushes are switched off." in stage.scene.messages()


def test_kept_inside_the_window_and_mirrored():
    """C13.8."""
    stage = opened("two-spheres", restitution=1.0, friction=0.0)
    energy = readouts(stage)["total energy"]
    for _ in range(20):
        stage.run(60)
        places = bodies_of(stage).state.positions
        assert np.abs(places[:, 0]).max() < 4.2 - 0.6 + 0.03
        assert places[:, 1].min() > 0.57 and places[:, 1].max() < 4.5 - 0.57
    assert readouts(stage)["total energy"] == pytest.approx(energy, rel=1e-12)


def test_newtons_cradle_behaves_like_one():
    """Beyond: one comes, one leaves; the others stay where they are."""
    stage = opened("cradle")
    highest = np.zeros(5)
    for _ in range(60):
        stage.run(8)
        highest = np.maximum(highest, bodies_of(stage).state.positions[:, 1] - 1.1)
    drop = 3.0 * (1.0 - math.cos(math.radians(40.0)))
    assert highest[4] == pytest.approx(drop, rel=0.01)
    assert highest[1:4].max() < 1e-4
    assert readouts(stage)["collisions"] >= 8


def test_a_pile_comes_to_rest():
    """Beyond: a thousand discs by way of the grid, overlap below 0.03 at r 0.43."""
    stage = opened("pile")
    wait(stage, 6.0)
    found = readouts(stage)
    assert found["spheres"] == 1000.0
    assert found["maximum penetration"] < 0.03
    assert found["translational energy"] < 20.0
    assert stage.scene.model.world.planar()


def test_an_hourglass_runs():
    """Beyond: discs go through the neck, and none through the glass."""
    stage = opened("hourglass")
    assert readouts(stage)["spheres"] > 4900
    wait(stage, 4.0)
    places = bodies_of(stage).state.positions
    below = places[:, 1] < 58.0
    assert below.sum() > 20
    assert np.abs(places[:, 0]).max() < 56.0
    neck = (places[:, 1] > 50.0) & (places[:, 1] < 66.0)
    room = 4.0 + np.abs(places[neck, 1] - 58.0) * 2.6
    assert (np.abs(places[neck, 0]) < room).all()


def test_materials_have_pairs():
    """Beyond: restitution per pair, from the level."""
    tables = opened("materials").scene.model.world.tables
    assert tables.restitution[0, 1] == tables.restitution[1, 0] == 0.8
    assert tables.restitution[2, 3] == 0.0 and tables.friction[0, 0] == 0.9


def test_what_only_rests_or_rolls_does_not_divide_steps():
    stage = opened("materials")
    wait(stage, 4.0)
    parts = []
    for _ in range(120):
        stage.run(1)
        parts.append(stage.scene.model.world.parts)
    assert len(stage.scene.model.world.contacts[0]) > 45
    assert np.median(parts) <= 4


def test_beside_the_event_driven_run():
    stage = opened("bouncing")
    wait(stage, 4.0)
    assert readouts(stage)["distance to exact"] < 1e-9
    assert readouts(stage)["collisions"] > 8
    stage.post(SetEffect("impact-times", False))
    wait(stage, 1.0)
    assert readouts(stage)["distance to exact"] > 1e-3
    stage.post(SetParameter("restitution", 0.5))
    assert stage.scene.model.exact is None


@pytest.mark.parametrize("alpha", [0.0, 0.4, 0.99])
def test_the_event_driven_run_is_drawn_at_the_instant_of_the_spheres(monkeypatch, alpha):
    """Two runs that agree to rounding must cover each other in every picture, also between two steps."""
    stage = opened("bouncing")
    stage.run(20)
    canvas, dashed, discs = blank_canvas(stage), [], []

    def note_discs(pixels, clip, points, *rest):
        discs.extend(points.tolist())

    def note_circle(_, centre, *rest, **more):
        dashed.append(canvas.place(centre))

    monkeypatch.setattr(c13_view, "draw_rimmed_discs", note_discs)
    monkeypatch.setattr(Canvas, "circle", note_circle)
    stage.scene.draw(canvas, alpha)
    assert len(discs) == 3
    assert np.allclose(discs, dashed, rtol=0, atol=1e-6)


@pytest.mark.parametrize("event", [SetParameter("gravity", 3.0), SetEffect("gravity", False)])
def test_the_exact_run_ends_with_its_gravity(event):
    """Else it would go on with the old one, but with the new one after a step back."""
    stage = opened("bouncing")
    wait(stage, 1.0)
    stage.post(event)
    stage.run(2)
    assert stage.scene.model.exact is None and "exact run ends" in stage.scene.model.messages.unread[-1]
    later = stage.digest()
    assert stage.step_back() and stage.step_back()
    stage.run(2)
    assert stage.digest() == later


def test_a_state_of_other_spheres_of_the_same_sizes_is_put_back_whole():
    stage = opened("cradle", radius=0.3)
    before, digest = copy_state(stage.scene.state()), stage.digest()
    last = bodies_of(stage).places()[-1]
    click(stage, (float(last[0]), float(last[1])), button=3)
    stage.post(Action("sphere"))
    click(stage, (0.3, 3.2))
    assert np.array_equal(bodies_of(stage).composition.radii, before.radii)
    assert len(stage.scene.model.world.surroundings.hung) == len(before.hung) - 1
    stage.scene.restore(before)
    assert stage.digest() == digest
    stage.scene.model.world.check()


# -- hard cases -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", HARD)
def test_hard_levels_stay_sane(name):
    stage = opened(name)
    stage.run(60)
    assert stage.fault is None
    stage.scene.model.world.check()
    assert load_level(stage.level.path, "c13", CollisionContent).hard_case.startswith("C13 H")


def test_every_hard_case_has_a_level():
    numbers = {name.split("-")[1] for name in HARD}
    assert numbers == {f"{i:02d}" for i in range(1, 12)}


def test_what_hard_levels_show():
    def after(name, seconds, **parameters):
        stage = opened(name, **parameters)
        wait(stage, seconds)
        return stage, bodies_of(stage), readouts(stage)

    _, bodies, found = after("hard-01-same-place", 1.0)
    assert (
        found["translational energy"] == 0.0
        and bodies.state.positions[1, 0] - bodies.state.positions[0, 0] > 1.19
    )
    assert after("hard-02-separating", 1.0)[2]["collisions"] == 0.0
    stage, _, found = after("hard-03-two-touches", 1.2)
    start = readouts(opened("hard-03-two-touches"))
    assert found["collisions"] >= 2 and found["total energy"] == pytest.approx(
        start["total energy"], rel=0.02
    )
    assert after("hard-04-cradle-in-turn", 2.0)[1].velocities[:, 0].tolist() == [0.0, 0.0, 0.0, 1.5]
    assert (np.abs(after("hard-04-cradle-at-once", 2.0)[1].velocities[:, 0]) > 0.1).all()
    v = after("hard-05-mass-ratio", 1.4)[1].velocities[:, 0]
    assert v[0] == pytest.approx(-2.0, rel=1e-5) and v[4] == -2.0 and v[5] == 0.0
    bodies = after("hard-06-grazing", 0.5)[1]
    assert np.abs(bodies.turning).max() < 1e-3 and np.abs(bodies.turning[2:]).max() == 0.0
    stage, bodies, found = after("hard-07-stack", 5.0)
    assert (
        found["translational energy"] + found["rotational energy"] < 1e-6
        and found["maximum penetration"] <= 0.0041
    )
    _, _, found = after("hard-08-deep-overlap", 1.0)
    assert found["total energy"] == 0.0 and found["maximum penetration"] < 0.01
    assert after("hard-08-deep-overlap", 1.0, correction="baumgarte")[2]["total energy"] > 1.0
    assert after("hard-09-fast-and-small", 0.1)[2]["collisions"] > 0.0
    stage = opened("hard-09-fast-and-small")
    stage.post(SetEffect("impact-times", False))
    stage.run(3)
    assert readouts(stage)["collisions"] <= 1.0, "only a wall"
    bodies = after("hard-10-spin", 1.0)[1]
    assert np.abs(bodies.state.momenta[:2, 1]).min() > 0.01, "thrown apart by their rims"
    assert np.abs(bodies.state.momenta[2:, 1]).max() < 1e-12
    v = after("hard-11-restitution", 2.0)[1].velocities[:, 0]
    assert v.tolist() == pytest.approx([0.75, 0.75, 0.0, 1.5])


def test_restitution_out_of_range_is_refused():
    stage = opened("default")
    for value in (-0.1, 1.1, math.nan):
        with pytest.raises(ParameterError, match="restitution"):
            stage.post(SetParameter("restitution", value))


# -- files, memory --------------------------------------------------------------------------------------

BROKEN = {
    'spheres = [{ position = [0.0, 1.0] }]\nexpected = [{ readout = "warmth", value = 0.0 }]': "warmth",
    "spheres": "expected 1 to 20000, got 0",
    "spheres = [{ position = [0.0, 1.0], radius = -1.0 }]": "radius",
    "spheres = [{ position = [0.0] }]": "position",
    'spheres = [{ position = [0.0, 1.0], material = "cheese" }]': "cheese",
    "spheres = [{ position = [0.0, 1.0], mass = 0.0 }]": "mass",
    "spheres = [{ position = [0.0, 1.0], fixed = true, velocity = [1.0, 0.0] }]": "infinite mass",
    "spheres = [{ position = [0.0, 1.0] }]\nstrings = [{ sphere = 4, tied = [0.0, 3.0] }]": "strings",
    'spheres = [{ position = [0.0, 1.0] }]\npairs = [{ of = ["a", "b"] }]': "pairs",
    "heaps = [{ corner = [0.0, 0.0], columns = 2, rows = 2, radius = 1.0, spacing = 1.0 }]": "spacing",
    "spheres = [{ position = [0.0, 1.0] }]\nledges = [[0.0, 0.0, 0.0, 0.0]]": "ledges",
}


@pytest.mark.parametrize("content", BROKEN)
def test_broken_files_are_named(tmp_path, content):
    path = tmp_path / "broken.toml"
    path.write_text('scene = "c13"\ntitle = "x"\n[content]\n' + ("" if content == "spheres" else content))
    with pytest.raises(LevelError, match=BROKEN[content]):
        Stage(SphereCollisions, level=load_level(path, "c13", CollisionContent))


@pytest.mark.parametrize("name", ["default", "cradle", "hard-03-two-touches", "materials"])
def test_saved_content_goes_on_alike(tmp_path, name):
    """A level saved in the middle has the same spheres, to rounding."""
    stage = opened(name)
    stage.run(20)
    level = msgspec.structs.replace(stage.level, content=stage.scene.save_content())
    path = tmp_path / "saved.toml"
    save_level(level, path)
    again = Stage(SphereCollisions, level=load_level(path, "c13", CollisionContent))
    mine, saved = bodies_of(stage), bodies_of(again)
    assert np.allclose(mine.places(), saved.places(), rtol=0, atol=1e-12)
    assert np.allclose(mine.velocities, saved.velocities, rtol=0, atol=1e-12)
    assert np.allclose(mine.composition.masses, saved.composition.masses, rtol=1e-12)
    assert np.array_equal(
        stage.scene.model.world.surroundings.strings, again.scene.model.world.surroundings.strings
    )


def test_two_runs_and_steps_back_are_alike():
    """Making, removing and pushing: digests equal on two runs, and after steps back."""

    def play(stage):
        stage.run(10)
        stage.post(Action("sphere"))
        click(stage, (0.5, 3.5))
        stage.run(10)
        stage.post(Action("push"))
        at = bodies_of(stage).state.positions[0, :2]
        drag(stage, at + 0.1, at + 1.0, steps=3)
        stage.run(10)
        click(stage, bodies_of(stage).state.positions[0, :2], button=3)
        stage.run(10)
        return stage.digest()

    first, second = opened("draw"), opened("draw")
    assert play(first) == play(second)
    now = first.digest()
    for _ in range(25):
        first.step_back()
    first.resume()
    first.run(25)
    assert first.digest() == now
