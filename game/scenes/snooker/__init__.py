"""Snooker on the exact twelve-foot table."""

from game.stage.catalogue import Entry

SNOOKER = Entry(
    name="snooker",
    task="A05",
    title="Snooker",
    fact="frames, six-red, line-up",
    category="Play",
    module="game.scenes.snooker.scene",
    class_name="SnookerScene",
    keywords="billiards reds colours break frame six-red free ball miss snookers twelve-foot opponents",
    roomy=True,
    card="draw_snooker",
    level_card="draw_level",
    start="START",
)
ENTRIES = (SNOOKER,)
