"""What a story may look at among the dominoes."""

from __future__ import annotations

from game.scenes.domino.model import DominoModel
from game.scenes.domino.tables import FOOT_X, FOOT_Y, SLIDER_BODY


def story_targets(model: DominoModel) -> dict[str, tuple[float, float]]:
    """The front, the first and the last domino, the balls by their names, the blocks by number, the first of
    them and their middle; m.
    """
    places = model.world.bodies.positions
    found = {"front": model.front()}
    if len(model.dominoes):
        for name, number in (("first", 0), ("end", -1)):
            x, y = model.dominoes[number, [FOOT_X, FOOT_Y]].tolist()
            found[name] = (x, y + 0.5)
    for k, (entry, body) in enumerate(zip(model.content.balls, model.ball_ids, strict=True)):
        x, y = places[body].tolist()
        found[entry.name or f"ball {k + 1}"] = (x, y)
    blocks = [places[int(row[SLIDER_BODY])].tolist() for row in model.sliders]
    for k, (x, y) in enumerate(blocks):
        found[f"block {k + 1}"] = (x, y)
    if blocks:
        found["blocks"] = (
            0.5 * (max(x for x, _ in blocks) + min(x for x, _ in blocks)),
            0.5 * (max(y for _, y in blocks) + min(y for _, y in blocks)),
        )
    return found
