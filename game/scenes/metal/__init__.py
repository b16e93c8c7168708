"""Metal balls (A22)."""

from game.stage.catalogue import Entry

A22 = Entry(
    name="a22",
    task="A22",
    title="Metal balls",
    fact="a story of steel",
    category="Stories",
    module="game.scenes.metal.scene",
    class_name="MetalBalls",
    keywords="marble run steel loop spiral brachistochrone race seesaw funnel newton cradle basin tracks",
    roomy=True,
    card="draw_balls",
)
ENTRIES = (A22,)
