"""What a story may look at in a fountain."""

from __future__ import annotations

from game.scenes.fountain.hand import rim_handle
from game.scenes.fountain.model import FountainModel


def story_targets(model: FountainModel) -> dict[str, tuple[float, float]]:
    """Nozzles and stones by number (the first one's name without it), the rim of a stone, the vortex; m."""
    found = {"vortex": model.vortex_centre}
    for i in range(len(model.content.nozzles)):
        found[_numbered("nozzle", i)] = model.nozzle_position(i)
    for i, (x, y, radius) in enumerate(model.system.solids.rows[:, :3].tolist()):
        found[_numbered("stone", i)] = (x, y)
        found[_numbered("rim", i)] = rim_handle(x, y, radius)
    return found


def _numbered(name: str, index: int) -> str:
    return f"{name} {index + 1}" if index else name


def story_names(model: FountainModel) -> list[tuple[tuple[float, float], str]]:
    """The stones by their numbers."""
    rows = model.system.solids.rows[:, :2].tolist()
    return [((x, y), _numbered("stone", i)) for i, (x, y) in enumerate(rows)]
