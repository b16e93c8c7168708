"""The studies of a liquid: its period, and what it costs to keep its volume."""

from __future__ import annotations

import pytest

from game.lab.studies.water.liquid import liquid_study
from game.lab.studies.water.volume import CELLS, WAYS, volume_study
from game.physics.liquid import CARRIERS
from game.scenes.liquid.scene import LiquidScene
from game.stage import Stage


def error(method: str, cells: int) -> float:
    setting = next(
        one for one in volume_study.settings() if one.method == method and round(1.0 / one.knob) == cells
    )
    trial = volume_study.trial(setting)
    trial.reset()
    trial.run()
    return trial.outcome().error


@pytest.mark.parametrize("method", ["pic", "flip", "apic"])
def test_volume_is_lost_without_the_correction_alone(method):
    assert error(method, 16) < 0.004
    assert error(f"{method}, crowded", 16) > 0.08


def test_the_scene_offers_both_and_has_a_place_in_each():
    assert LiquidScene.study.family == (liquid_study, volume_study)
    stage = Stage(LiquidScene)
    for carrier in CARRIERS:
        for flip, name in ((0.0, "pic"), (0.95, "flip")):
            for keeping, more in ((1.0, ""), (0.0, ", crowded")):
                chosen = {**stage.scene.chosen(), "carrier": carrier, "flip": flip, "keeping": keeping}
                setting, _ = volume_study.place(chosen)
                assert (
                    setting is not None and setting.method == ("apic" if carrier == "apic" else name) + more
                )
                assert 1.0 / CELLS[-1] <= setting.knob <= 1.0 / CELLS[0]


def test_each_point_can_be_opened_in_the_scene():
    offered = Stage(LiquidScene).scene.chosen()
    for one in volume_study.settings():
        way, chosen = WAYS[one.method], one.scene
        assert (chosen["carrier"], chosen["flip"], chosen["keeping"]) == way[1:]
        assert set(chosen) <= set(offered)
