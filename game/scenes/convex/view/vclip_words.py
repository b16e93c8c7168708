"""What a step of V-Clip says: its case, the distance, the function that decided, and the border crossed."""

from __future__ import annotations

from game.arrays import Floats
from game.physics.bounds import segment_distance
from game.physics.narrowphase import Feature
from game.physics.narrowphase.queries import FeatureStep
from game.scenes.convex.view.polygons import feature_points
from game.ui.look.numerals import format_si

WORDS = {
    "closest": "each lies in the other's region: the closest features",
    "overlap": "they overlap",
    "repair A": "behind this edge of A, go to the one it is farthest in front of",
    "repair B": "behind this edge of B, go to the one it is farthest in front of",
    "moved A": "{} of A",
    "moved B": "{} of B",
    "circle": "ties lead in a circle: all features are looked at",
}


def case_of(step: FeatureStep) -> str:
    """VV, VE or EE: what kinds the two features are of."""
    return "".join(sorted((step.feature_a.kind[0] + step.feature_b.kind[0]).upper(), reverse=True))


def function_of(step: FeatureStep) -> str:
    """The function of vclip.py that has decided the step."""
    case = case_of(step)
    if step.verdict == "circle":
        return "closest_features"
    if step.verdict.startswith("repair") or (step.verdict == "overlap" and case == "VE"):
        return "edge_in_front"
    if case == "VV":
        return "clip_vertex"
    if case == "EE":
        return "end_of_edge" if step.verdict in ("moved B", "closest") else "clip_edge"
    if step.verdict == "closest":
        return "clip_vertex, clip_edge"
    moved = step.feature_a if step.verdict == "moved A" else step.feature_b
    # a vertex is tested against the edge's region, the edge against the vertex's
    return "clip_vertex" if moved.kind == "edge" else "clip_edge"


def distance_of(shapes: list[Floats], step: FeatureStep) -> float:
    """Distance of the two features in the level's unit."""
    ends = [feature_points(shapes[k], (step.feature_a, step.feature_b)[k]) for k in (0, 1)]
    return segment_distance(*(points[[0, -1]] for points in ends))


def border_of(before: Feature, then: Feature) -> str:
    """The border between a feature and the neighbour beyond it, and where the walk goes on."""
    return f"beyond the border of {before} and {then}: on to {then}"


def verdict_of(step: FeatureStep, following: FeatureStep | None) -> str:
    """What the step has found; ``following``: the next one."""
    words = WORDS[step.verdict]
    if not step.verdict.startswith("moved"):
        return words
    name = "feature_a" if step.verdict == "moved A" else "feature_b"
    here = getattr(step, name)
    if following is None:
        return words.format(f"beyond a border of {here}")
    return words.format(border_of(here, getattr(following, name)))


def caption_of(trace: list[FeatureStep], index: int, shapes: list[Floats], scale: float) -> tuple[str, str]:
    """Two lines on a step of a walk: case, features and distance; function and border. scale: m a unit."""
    step = trace[index]
    following = trace[index + 1] if index + 1 < len(trace) else None
    apart = format_si(distance_of(shapes, step) * scale, "m")
    first = (
        f"Step {index + 1} of {len(trace)}, {case_of(step)}: {step.feature_a} of A, {step.feature_b} of B, "
        f"{apart} apart"
    )
    return first, f"{function_of(step)}: {verdict_of(step, following)}"
