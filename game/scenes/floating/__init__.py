"""A body that is drawn, and how it floats: by hydrostatics, and in a liquid."""

from game.stage.catalogue import Entry

FLOATING = Entry(
    name="floating",
    task="S13",
    title="How it floats",
    fact="draw a body, see it swim",
    category="Playgrounds",
    module="game.scenes.floating.scene",
    class_name="Floating",
    keywords="float ship hull stability metacentre righting arm archimedes buoyancy log ballast capsize",
    card="draw_hull",
)
ENTRIES = (FLOATING,)
