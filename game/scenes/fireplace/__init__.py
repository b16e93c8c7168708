"""A fire in a hearth (A26)."""

from game.stage.catalogue import Entry

A26 = Entry(
    name="a26",
    task="A26",
    title="Fireplace",
    fact="from a match to the ember",
    category="Stories",
    module="game.scenes.fireplace.scene",
    class_name="Fireplace",
    keywords="fire fireplace hearth flame smoke match kindling log burn ember heat radiation gas flue damper",
    roomy=True,
    card="draw_hearth",
)
ENTRIES = (A26,)
