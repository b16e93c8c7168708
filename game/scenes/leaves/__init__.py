"""Leaves that a small wind takes from a lawn (A18)."""

from game.stage.catalogue import Entry

A18 = Entry(
    name="a18",
    task="A18",
    title="Leaves in a wind",
    fact="each falls as its shape asks",
    category="Stories",
    module="game.scenes.leaves.scene",
    class_name="Leaves",
    keywords="leaf leaves autumn park wind gust basket flutter tumble glide bend maple oak birch story",
    roomy=True,
    card="draw_leaves",
)
ENTRIES = (A18,)
