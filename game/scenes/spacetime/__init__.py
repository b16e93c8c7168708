"""P02: collision detection that can be interrupted, by space-time bounds and circle trees."""

from game.stage.catalogue import Entry

SPACETIME = Entry(
    name="p02",
    task="P02",
    title="Circle trees in time",
    fact="detection on a budget",
    category="Papers",
    module="game.scenes.spacetime.scene",
    class_name="SpaceTime",
    keywords="hubbard interactive interruptible collision detection sphere tree space-time bound horn budget",
    card="draw_tree",
)
ENTRIES = (SPACETIME,)
