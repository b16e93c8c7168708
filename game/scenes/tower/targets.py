"""What a story may look at in the tower."""

from __future__ import annotations

from game.scenes.tower.building import floor_height
from game.scenes.tower.measures import front_of, roof_of
from game.scenes.tower.model import TowerModel

RUBBLE_M = 9.0  # so far above the ground a picture's middle has little of the ground in it


def story_targets(model: TowerModel) -> dict[str, tuple[float, float]]:
    """Where the floors meet, the roof as it was and as it is, the storey that is cut first, the rubble; m."""
    content = model.content
    return {
        "front": front_of(model),
        "roof": (0.0, roof_of(model)),
        "top": (0.0, floor_height(content, content.storeys)),
        "charges": (0.0, floor_height(content, model.first_storey()) - 0.5 * content.storey),
        "middle": (0.0, 0.5 * floor_height(content, content.storeys)),
        "rubble": (0.0, max(RUBBLE_M, 0.8 * front_of(model)[1])),
    }


def story_names(model: TowerModel) -> list[tuple[tuple[float, float], str]]:
    """The roof by its height, and where the floors meet."""
    roof, (x, y) = roof_of(model), front_of(model)
    found = [((0.0, roof), f"roof, {roof:.1f} m")]
    return found if roof - y < 0.5 * model.content.storey else [*found, ((x, y), f"front, {y:.1f} m")]
