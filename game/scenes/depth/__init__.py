"""P32: how deep two shapes overlap, by translation alone and with rotation."""

from game.stage.catalogue import Entry

DEPTH = Entry(
    name="p32",
    task="P32",
    title="Depth with rotation",
    fact="the shortest way out",
    category="Papers",
    module="game.scenes.depth.scene",
    class_name="Depth",
    keywords="penetration depth generalised object norm minkowski branch and bound overlap",
    card="draw_way_out",
)
ENTRIES = (DEPTH,)
