"""A liquid with a free surface in a tank, and one dam by several methods."""

from game.stage.catalogue import Entry

LIQUID = Entry(
    name="liquid",
    task="S10",
    title="Liquid",
    fact="pour, stir, float",
    category="Playgrounds",
    module="game.scenes.liquid.scene",
    class_name="LiquidScene",
    keywords="water pour splash float flip apic pic free surface tank tap drain archimedes slosh drop",
    card="draw_glass",
)
DAM = Entry(
    name="dam",
    task="S11",
    title="One dam, several methods",
    fact="beside the experiment",
    category="Playgrounds",
    module="game.scenes.liquid.dam_scene",
    class_name="Dam",
    keywords="dam break martin moyce ritter shallow water liquid particles compare front price",
    card="draw_dams",
)
ENTRIES = (LIQUID, DAM)
