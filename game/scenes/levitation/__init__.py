"""P28: grains that float in the sound of a phased array and are moved about."""

from game.stage.catalogue import Entry

LEVITATION = Entry(
    name="p28",
    task="P28",
    title="Levitation by sound",
    fact="figures drawn by grains",
    category="Papers",
    module="game.scenes.levitation.scene",
    class_name="Levitation",
    keywords="acoustic ultrasound phased array standing wave trap gorkov potential pixie dust grains node",
    card="draw_nodes",
)
ENTRIES = (LEVITATION,)
