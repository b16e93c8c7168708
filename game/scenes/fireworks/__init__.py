"""A night of fireworks (A09)."""

from game.stage.catalogue import Entry

A09 = Entry(
    name="a09",
    task="A09",
    title="Great fireworks",
    fact="60 000 stars alight",
    category="Stories",
    module="game.scenes.fireworks.scene",
    class_name="Fireworks",
    keywords="fireworks stars shells bursts sparks smoke wind drag ballistics sound thunder night story",
    roomy=True,
    card="draw_burst",
)
ENTRIES = (A09,)
