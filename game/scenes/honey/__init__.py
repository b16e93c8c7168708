"""Fluids of particles: drops, honey, slime, a lava lamp, two liquids, boiling, trapped air."""

from game.stage.catalogue import Entry

HONEY = Entry(
    name="honey",
    task="S11",
    title="Honey and other liquids",
    fact="drops, slime, a lava lamp",
    category="Playgrounds",
    module="game.scenes.honey.scene",
    class_name="Honey",
    keywords="particle fluid sph water honey slime lava lamp oil boiling bubbles drop viscosity dfsph pbf",
    card="draw_drops",
)
ENTRIES = (HONEY,)
