"""What a scene keeps of its picture is what it would paint anew."""

from __future__ import annotations

import numpy as np
import pygame
import pytest

from game.app.stagehand.view import StageView
from game.scenes import CATALOGUE
from game.stage import Action, Stage
from game.ui.look.look import Look
from game.ui.look.theme import DARK, LIGHT

RECT = pygame.Rect(0, 0, 320, 200)
QUICK = {
    "a08": {}, "a10": {"tier": "own", "meshes": 16}, "a18": {}, "a26": {},
    "wind-tunnel": {"shape": "plate", "cells": 5, "height": 5.0, "reynolds": 40.0, "settle": 0.5,
                    "window": 0.5, "angles": 4, "checks": 1, "pace": 8, "order": 2},
}  # fmt: skip


def placed(stage, look):
    view = StageView(stage, look)
    view.place(RECT, look)
    return view


def picture(view):
    surface = pygame.Surface(RECT.size, 0, 32)
    view.draw(surface)
    return pygame.surfarray.array2d(surface)


def anew(stage, view):
    """The picture by a view of the scene that has kept nothing."""
    scene = stage.scene
    kept, scene.view = scene.view, type(scene.view)(scene.model, scene.hand)
    try:
        fresh = StageView(stage, view.look)
        fresh.place(RECT, view.look)
        fresh.camera = view.camera
        return picture(fresh)
    finally:
        scene.view = kept


@pytest.mark.parametrize("name", list(QUICK))
def test_a_kept_picture_is_the_one_it_would_paint(name):
    stage = Stage(CATALOGUE[name].load(), parameters=QUICK[name])
    for look in (Look(DARK), Look(LIGHT)):
        view = placed(stage, look)
        for move in (0.0, 0.0, 0.0, 17.0, 0.0, 0.0):
            view.camera.pan(move, 0.0)
            stage.run(1)
            assert (picture(view) == anew(stage, view)).all()


def test_the_tunnels_charts_follow_the_sweep():
    stage = Stage(CATALOGUE["wind-tunnel"].load(), parameters=QUICK["wind-tunnel"])
    view = placed(stage, Look(DARK))
    stage.post(Action("sweep"))
    done = []
    for _ in range(400):
        stage.run(1)
        sweep = stage.scene.model.sweep
        if len(sweep.measured()) != len(done):
            done = sweep.measured()
            for _ in range(3):
                assert (picture(view) == anew(stage, view)).all()
        if not sweep.running and len(done):
            break
    assert len(done) > 1 and sweep.complete
    assert np.count_nonzero(picture(view) != anew(stage, view)) == 0


def test_nothing_is_measured_for_captions_that_there_are_not(monkeypatch):
    stage = Stage(CATALOGUE["a08"].load())
    view = placed(stage, Look(DARK))
    before = picture(view)

    def refuse():
        raise AssertionError("asked for readouts")

    monkeypatch.setattr(stage.scene, "readouts", refuse)
    assert not stage.scene.model.content.expected
    assert (picture(view) == before).all()
