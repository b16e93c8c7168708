"""World of Domino (A01)."""

from game.stage.catalogue import Entry

A01 = Entry(
    name="a01",
    task="A01",
    title="World of Domino",
    fact="a story of 300",
    category="Stories",
    module="game.scenes.domino.scene",
    class_name="Domino",
    keywords="domino dominoes wave speed van leeuwen balls slide friction stopping distance toppling chain",
    roomy=True,
    card="draw_dominoes",
)
ENTRIES = (A01,)
