"""How long things take beside what else a Python programmer can install, as ratios of one run."""

from game.lab.benchmarks.scenario import Measured, Peer, Scenario, measure_scenario

__all__ = ["Measured", "Peer", "Scenario", "all_scenarios", "measure_scenario"]


def all_scenarios() -> tuple[Scenario, ...]:
    """Every scenario, by room of physics."""
    from game.lab.benchmarks import (
        animation,
        billiards,
        bounds,
        broadphase,
        constraints,
        narrowphase,
        particles,
        plates,
        rigid,
        solids,
    )

    rooms = (
        billiards,
        broadphase,
        bounds,
        narrowphase,
        rigid,
        solids,
        constraints,
        particles,
        plates,
        animation,
    )
    return tuple(scenario for room in rooms for scenario in room.SCENARIOS)
