"""The names that other programs call: where they are, how they are called, and what comes back.

Each is called once as a program outside would, with the promised arguments; the answers are known by hand.
"""

from __future__ import annotations

import importlib
import inspect
import math
from pathlib import Path

import numpy as np
import pytest

import game.billiards
from game.lab import run_study
from game.lab.studies.particles import free_flight_study
from game.physics import (
    animation,
    bounds,
    broadphase,
    constraints,
    integrators,
    narrowphase,
    particles,
    rigid,
)
from game.stage import FixedStep

SHOT = Path(__file__).parent / "reference" / "shots" / "c01-mirror-45.json"
SQUARE = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
FAR, NEAR = np.array([3.0, 0.0]), np.array([0.75, 0.0])
BOXES = "add_box remove_box update_box add_boxes update_boxes pairs"

# where, name, first arguments; then the methods and attributes that it has
PROMISED = [
    ("stage", "FixedStep", "dt max_steps", "advance alpha"),
    ("physics.integrators", "integrate", "method acceleration position velocity dt steps", ""),
    ("physics.broadphase", "NaiveBroadPhase", "", BOXES),
    ("physics.broadphase", "UniformGrid", "lower upper cell", BOXES),
    ("physics.broadphase", "HierarchicalGrid", "", BOXES),
    ("physics.broadphase", "SweepAndPrune", "", BOXES),
    ("physics.broadphase", "MatrixPairs", "capacity", "add remove pairs __contains__ __len__"),
    ("physics.broadphase", "HashedPairs", "", "add remove pairs __contains__ __len__"),
    ("physics.bounds", "fit_obb", "points step_degrees", ""),
    ("physics.bounds", "fit_capsule", "points step_degrees", ""),
    ("physics.bounds", "minimal_obb", "points", ""),
    ("physics.bounds", "build_tree", "polyline kind leaf_size", ""),
    ("physics.bounds", "tandem", "tree_a tree_b offset_b", ""),
    ("physics.narrowphase", "vclip", "a b", ""),
    ("physics.narrowphase", "gjk", "a b", ""),
    ("physics.narrowphase", "gjk_batch", "a b", ""),
    (
        "physics.narrowphase",
        "Proximity",
        "distance point_a point_b feature_a feature_b iterations",
        "distance point_a point_b feature_a feature_b iterations",
    ),
    ("physics.rigid", "mass_properties", "positions radii density", ""),
    ("physics.rigid", "RigidBody", "mass inertia", "step"),
    ("physics.constraints", "PositionBasedDynamics", "positions inverse_masses links stiffness", "step"),
    ("physics.particles", "ParticleSystem", "", "step positions velocities"),
    ("physics.animation", "Keyframes", "times values", "sample"),
    ("physics.animation", "CubicBezier", "points", "point"),
    ("physics.animation", "CatmullRom", "points", "point"),
    ("physics.animation", "Skeleton", "parents lengths", ""),
    ("physics.animation", "bind_weights", "skeleton points", ""),
    ("physics.animation", "skin", "skeleton binding", ""),
    ("physics.animation", "solve_ik", "skeleton chain target method", ""),
    ("billiards", "Ball", "x y radius colour mass", "position velocity handle_collision draw"),
    ("billiards", "Table", "", "pool bare"),
    ("billiards", "load_shot", "path", ""),
    ("billiards", "simulate", "shot model", ""),
    ("billiards", "Trajectory", "", "events state_at final"),
    ("billiards", "find_shots", "layout table", ""),
    ("lab", "Study", "", ""),
    ("lab", "run_study", "study", ""),
]


@pytest.mark.parametrize(("where", "name", "arguments", "has"), PROMISED, ids=lambda value: value)
def test_where_it_is_and_how_it_is_called(where: str, name: str, arguments: str, has: str) -> None:
    thing = getattr(importlib.import_module(f"game.{where}"), name)
    parameters = list(inspect.signature(thing).parameters.values())
    wanted = arguments.split()
    assert [parameter.name for parameter in parameters[: len(wanted)]] == wanted
    if wanted or has.startswith(BOXES):
        others = [p for p in parameters[len(wanted) :] if p.kind is not p.VAR_KEYWORD]
        assert [p.name for p in others if p.default is p.empty] == [], "all else may be left out"
    assert [part for part in has.split() if not hasattr(thing, part)] == []
    assert (thing.__doc__ or "").strip()


def test_modules_say_what_they_give() -> None:
    for where in sorted({row[0] for row in PROMISED}):
        module = importlib.import_module(f"game.{where}")
        named = getattr(module, "__all__", dir(module))
        assert [name for name in named if not hasattr(module, name)] == []
        assert {row[1] for row in PROMISED if row[0] == where} <= set(named)
        with pytest.raises(AttributeError):
            module.nothing_of_this_name  # noqa: B018


def test_a_name_that_is_loaded_later_is_listed_at_once() -> None:
    assert {"Ball", "find_shots", "simulate"} <= set(dir(game.billiards))


def test_the_clock_makes_whole_steps() -> None:
    clock = FixedStep(0.25, 3)
    assert clock.advance(0.625) == 2
    assert clock.alpha == 0.5
    assert clock.advance(10.0) == 3
    assert clock.dropped_s > 9.0


def test_every_integrator_falls() -> None:
    assert integrators.METHODS == ("explicit-euler", "semi-implicit-euler", "midpoint", "verlet", "rk4")
    for method in integrators.METHODS:
        x, v = integrators.integrate(method, lambda x, v, t: -10.0, [0.0], [3.0], 1e-3, 1000)
        assert v == pytest.approx([-7.0], abs=1e-9)
        assert x == pytest.approx([-2.0], abs=6e-3 if "euler" in method else 1e-9)


def test_every_broad_phase_finds_closed_boxes() -> None:
    for phase in (
        broadphase.NaiveBroadPhase(),
        broadphase.UniformGrid((-10.0, -10.0), (10.0, 10.0), 1.0),
        broadphase.HierarchicalGrid(),
        broadphase.SweepAndPrune(),
    ):
        first = phase.add_box((0.0, 0.0), (1.0, 1.0))
        touching, apart = phase.add_boxes([(1.0, 1.0), (5.0, 5.0)], [(2.0, 2.0), (6.0, 6.0)])
        found = phase.pairs()
        assert found.dtype.kind == "i" and found.tolist() == [[first, touching]]
        phase.update_box(apart, (0.5, 0.5), (0.6, 0.6))
        assert phase.pairs().tolist() == [[first, touching], [first, apart]]
        phase.update_boxes([first, touching], [(7.0, 7.0), (0.6, 0.6)], [(8.0, 8.0), (0.7, 0.7)])
        assert phase.pairs().tolist() == [[touching, apart]]
        phase.remove_box(apart)
        assert phase.pairs().shape == (0, 2)


def test_pair_managers() -> None:
    for pairs in (broadphase.MatrixPairs(8), broadphase.HashedPairs()):
        pairs.add(5, 2)
        pairs.add(1, 3)
        assert (2, 5) in pairs and (5, 2) in pairs and (1, 2) not in pairs
        assert pairs.pairs().tolist() == [[1, 3], [2, 5]]
        pairs.remove(3, 1)
        assert len(pairs) == 1


def test_bounds() -> None:
    diamond = SQUARE @ np.array([[1.0, 1.0], [-1.0, 1.0]])  # a square of side sqrt 2, on its corner
    for box in (bounds.fit_obb(diamond, 1.0), bounds.minimal_obb(diamond)):
        assert 4.0 * box.half[0] * box.half[1] == pytest.approx(2.0)
    capsule = bounds.fit_capsule([(0.0, 0.0), (3.0, 4.0)], 1.0)
    assert capsule.radius == pytest.approx(0.0, abs=0.05)
    line = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)]
    other = [(0.5, 1.0), (0.5, -1.0)]
    for kind in ("obb", "capsule"):
        trees = bounds.build_tree(line, kind, 1), bounds.build_tree(other, kind, 1)
        assert bounds.tandem(*trees, (0.0, 0.0)).crossings.tolist() == [[0, 0]]
        assert bounds.tandem(*trees, (5.0, 0.0)).crossings.tolist() == []


def test_distances_and_depths() -> None:
    for query in (narrowphase.vclip, narrowphase.gjk):
        near = query(SQUARE, SQUARE + FAR)
        assert isinstance(near, narrowphase.Proximity)
        assert near.distance == pytest.approx(2.0)
        assert near.point_b[0] - near.point_a[0] == pytest.approx(2.0)
        assert query(SQUARE, SQUARE + NEAR).distance == pytest.approx(-0.25)
    many = narrowphase.gjk_batch([SQUARE, SQUARE], [SQUARE + FAR, SQUARE + NEAR])
    assert many.distance == pytest.approx([2.0, -0.25])


def test_rigid_bodies() -> None:
    mass, center, inertia = rigid.mass_properties([(0.0, 0.0, 0.0)], [1.0], 3.0)
    assert mass == pytest.approx(4.0 * math.pi)
    assert center == pytest.approx([0.0, 0.0, 0.0])
    assert inertia == pytest.approx(0.4 * mass * np.eye(3))
    turned = rigid.quaternion_rotate(
        rigid.quaternion_from_axis_angle((0.0, 0.0, 1.0), math.pi / 2.0), (1, 0, 0)
    )
    assert turned == pytest.approx([0.0, 1.0, 0.0], abs=1e-15)
    body = rigid.RigidBody(2.0, (1.0, 2.0, 3.0), velocity=(1.0, 0.0, 0.0), angular_velocity=(0.0, 0.0, 1.0))
    for _ in range(1000):
        body.step(0.5e-3)
    assert body.position == pytest.approx([0.5, 0.0, 0.0])
    assert body.orientation == pytest.approx([math.cos(0.25), 0.0, 0.0, math.sin(0.25)], abs=1e-6)


def test_a_link_keeps_its_length() -> None:
    world = constraints.PositionBasedDynamics(
        [(0.0, 0.0), (1.0, 0.0)], [0.0, 1.0], [(0, 1)], 1.0, iterations=50
    )
    for _ in range(20):
        world.step(1.0 / 60.0)
    x, y = world.positions[1]
    assert math.hypot(x, y) == pytest.approx(1.0, abs=1e-9)
    assert y < 0.0


def test_particles_without_an_emitter_are_none() -> None:
    system = particles.ParticleSystem(10)
    system.step(0.01)
    assert system.positions.shape == system.velocities.shape == (0, 2)


def test_animation() -> None:
    assert animation.Keyframes([0.0, 1.0], [[0.0], [2.0]]).sample(0.25) == pytest.approx([0.5])
    bezier = animation.CubicBezier([(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)])
    assert bezier.point(0.5) == pytest.approx([0.5, 0.75])
    assert animation.CatmullRom([(0.0, 0.0), (1.0, 2.0), (3.0, 0.0)]).point(1.0) == pytest.approx([1.0, 2.0])
    arm = animation.Skeleton([-1, 0], [1.0, 1.0])
    points = [(0.5, 0.0), (1.5, 0.25)]
    assert animation.skin(arm, animation.bind_weights(arm, points)) == pytest.approx(np.array(points))
    assert animation.solve_ik(arm, (0, 1), (1.0, 1.0), "ccd").error < 1e-6


def test_one_ball_off_one_rail() -> None:
    shot = game.billiards.load_shot(SHOT)
    for model in ("exact", "stepped", "lecture"):
        played = game.billiards.simulate(shot, model=model)
        assert "ball-cushion" in {event.type for event in played.events}
        assert list(played.final) == ["cue"]
        assert played.state_at(played.end_time).positions[0] == pytest.approx(played.final["cue"], abs=1e-9)


@pytest.mark.compiled
def test_a_study_is_a_table_of_cost_and_error() -> None:
    table = run_study(free_flight_study, repeats=1, stop=lambda: False)
    assert {(row.method, row.knob) for row in table} == {
        (setting.method, setting.knob) for setting in free_flight_study.settings()
    }
    assert all(row.cpu_s > 0.0 and (row.failed or row.error >= 0.0) for row in table)
