"""The playground of solids: bodies of any shape, joints, and machines made of them."""

from game.stage.catalogue import Entry

SOLIDS = Entry(
    name="solids",
    task="S01",
    title="Solids",
    fact="draw, pin, cut, throw",
    category="Playgrounds",
    module="game.scenes.solids.scene",
    class_name="Solids",
    keywords="rigid bodies stack pyramid arch domino catapult cradle galton joint rope motor solver",
    card="draw_arch",
)
ENTRIES = (SOLIDS,)
