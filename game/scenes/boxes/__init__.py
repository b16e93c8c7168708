"""Broad phases: uniform grid (C05), hierarchical grids (C06), sweep and prune (C07), and their race."""

from game.stage.catalogue import Entry

C05 = Entry(
    name="c05",
    task="C05",
    title="Uniform grid and pairs",
    fact="100 000 boxes",
    category="Course",
    topic="Broad phase",
    module="game.scenes.boxes.uniform_grid",
    class_name="UniformGridScene",
    keywords="broad phase uniform grid pair manager matrix hash table boxes aabb overlap cells",
    card="draw_grid",
)
C06 = Entry(
    name="c06",
    task="C06",
    title="Hierarchical grids",
    fact="a grid for every size",
    category="Course",
    topic="Broad phase",
    module="game.scenes.boxes.hierarchical_grids",
    class_name="HierarchicalGridScene",
    keywords="broad phase hierarchical grid spatial hashing levels boxes aabb overlap naive",
    card="draw_grids_of_sizes",
)
C07 = Entry(
    name="c07",
    task="C07",
    title="Sweep and prune",
    fact="swaps, not tests",
    category="Course",
    topic="Broad phase",
    module="game.scenes.boxes.sweep_and_prune",
    class_name="SweepAndPruneScene",
    keywords="broad phase sweep and prune sort end points swaps incremental boxes aabb overlap naive",
    card="draw_sweep",
)
BROAD_PHASE_RACE = Entry(
    name="broad-phase-race",
    task="C05–C07",
    title="Broad-phase race",
    fact="five methods",
    category="Course",
    topic="Broad phase",
    module="game.scenes.boxes.race",
    class_name="BroadPhaseRace",
    keywords="broad phase race compare naive grid hierarchical sweep and prune pair manager workload",
    card="draw_race",
)
ENTRIES = (
    C05,
    C06,
    C07,
    BROAD_PHASE_RACE,
)
