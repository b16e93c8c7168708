"""P22: a beat that is tapped, and a stroke whose impacts meet it."""

from game.stage.catalogue import Entry

BEAT = Entry(
    name="p22",
    task="P22",
    title="On the beat",
    fact="impacts that meet a rhythm",
    category="Papers",
    module="game.scenes.beat.scene",
    class_name="Beat",
    keywords="rhythm music tap synchronised sound billiards search beam evolution inverse",
    card="draw_beat",
)
ENTRIES = (BEAT,)
