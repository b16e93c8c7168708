"""A sailing boat on the ocean."""

from game.stage.catalogue import Entry

OCEAN = Entry(
    name="a15",
    task="A15",
    title="Sailing the Ocean",
    fact="a story of wind and waves",
    category="Stories",
    module="game.scenes.ocean.scene",
    class_name="Ocean",
    keywords="ocean sea sail boat wind waves dispersion spectrum heel capsize rain spray ballast hull",
    roomy=True,
    card="draw_boat",
)
ENTRIES = (OCEAN,)
