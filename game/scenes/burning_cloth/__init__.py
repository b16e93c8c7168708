"""A cloth on which letters burn through (A10)."""

from game.stage.catalogue import Entry

A10 = Entry(
    name="a10",
    task="A10",
    title="The Game of Fire",
    fact="letters burn into cloth",
    category="Stories",
    module="game.scenes.burning_cloth.scene",
    class_name="BurningCloth",
    keywords="fire cloth burn letters match saltpetre retardant char ember front fisher wind flame smoke",
    roomy=True,
    card="draw_cloth",
)
ENTRIES = (A10,)
