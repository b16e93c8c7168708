"""A candle under a glass."""

from game.stage.catalogue import Entry

CANDLE = Entry(
    name="candle",
    task="S02",
    title="A Candle under a Glass",
    fact="a story of oxygen",
    category="Stories",
    module="game.scenes.candle.scene",
    class_name="Candle",
    keywords="candle flame glass oxygen combustion smoke wick starve limiting reactant",
    roomy=True,
    card="draw_candle",
)
ENTRIES = (CANDLE,)
