"""Carom billiards on the exact table, with the map of every stroke that scores."""

from game.stage.catalogue import Entry

CAROM = Entry(
    name="carom",
    task="A03",
    title="Carom",
    fact="every stroke that scores",
    category="Carom",
    module="game.scenes.carom.scene",
    class_name="CaromScene",
    keywords="billiards three-cushion one-cushion straight rail libre map strokes chance diamonds opponents",
    roomy=True,
    card="draw_carom",
    level_card="draw_level",
    start="START",
)
ENTRIES = (CAROM,)
