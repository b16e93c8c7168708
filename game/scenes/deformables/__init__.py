"""P04: soft bodies whose contacts, with each other and with themselves, are found by spatial hashing."""

from game.stage.catalogue import Entry

DEFORMABLES = Entry(
    name="p04",
    task="P04",
    title="Soft bodies in a hash table",
    fact="20 000 triangles, hashed",
    category="Papers",
    module="game.scenes.deformables.scene",
    class_name="Deformables",
    keywords="spatial hashing deformable soft body triangle mesh self collision penetration depth grid table",
    card="draw_pile",
)
ENTRIES = (DEFORMABLES,)
