"""A valley full of water behind a dam."""

from game.stage.catalogue import Entry

VALLEY = Entry(
    name="valley",
    task="A13",
    title="Breaking Dam",
    fact="a story of a flood",
    category="Stories",
    module="game.scenes.valley.scene",
    class_name="Valley",
    keywords="dam break valley water flood rocket explosion concrete rubble ritter martin moyce front",
    roomy=True,
    card="draw_dam",
)
ENTRIES = (VALLEY,)
