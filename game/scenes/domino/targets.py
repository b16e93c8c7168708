"""What a story may look at among the dominoes."""

from __future__ import annotations

from game.physics.kernels import elementary
from game.scenes.domino.model import DominoModel
from game.scenes.domino.tables import FOOT_X, FOOT_Y, SLIDER_BODY, SLIDER_MU


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


def story_names(model: DominoModel) -> list[tuple[tuple[float, float], str]]:
    """Balls by name and speed; blocks by friction, and by weight beside the first one's."""
    places, rows = model.world.bodies.positions, model.world.bodies
    found = []
    for entry, body in zip(model.content.balls, model.ball_ids, strict=True):
        x, y = places[body].tolist()
        speed = elementary.hypot(*rows.velocities[body].tolist())
        found.append(((x, y), f"{entry.name or 'ball'}, {speed:.1f} m/s"))
    bodies = [int(row[SLIDER_BODY]) for row in model.sliders]
    for row, body in zip(model.sliders, bodies, strict=True):
        x, y = places[body].tolist()
        heavier = float(rows.inverse_masses[bodies[0]] / rows.inverse_masses[body])
        found.append(((x, y), f"μ = {float(row[SLIDER_MU]):.2f}, {heavier:.3g} m"))
    return found
