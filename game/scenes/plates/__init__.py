"""Plates that fall in air: they flutter, tumble or neither."""

from game.stage.catalogue import Entry

FALLING = Entry(
    name="falling-plates",
    task="S07",
    title="Falling plates",
    fact="flutter, tumble, chaos",
    category="Playgrounds",
    module="game.scenes.plates.scene",
    class_name="FallingPlates",
    keywords="leaf leaves card paper flutter tumble chaos glide lift drag added mass air wind regime map",
    card="draw_fall",
)
ENTRIES = (FALLING,)
