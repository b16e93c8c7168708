"""Shallow water in a channel: dams, bores, jumps, shores."""

from game.stage.catalogue import Entry

WAVES = Entry(
    name="waves",
    task="S09",
    title="Water in a channel",
    fact="dams, bores, shores",
    category="Playgrounds",
    module="game.scenes.waves.scene",
    class_name="Waves",
    keywords="shallow water dam break ritter stoker bore jump tsunami beach lake thacker flood river",
    card="draw_dam",
)
ENTRIES = (WAVES,)
