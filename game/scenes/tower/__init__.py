"""The controlled fall (A08)."""

from game.stage.catalogue import Entry

A08 = Entry(
    name="a08",
    task="A08",
    title="The controlled fall",
    fact="floor upon floor",
    category="Stories",
    module="game.scenes.tower.scene",
    class_name="Tower",
    keywords="tower demolition collapse accretion floors columns debris dust charges momentum breaking",
    roomy=True,
    card="draw_tower",
)
ENTRIES = (A08,)
