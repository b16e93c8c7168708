"""P15: waves on a pond, carried by particles."""

from game.stage.catalogue import Entry

POND = Entry(
    name="p15",
    task="P15",
    title="Wave particles",
    fact="a pond, floats, a boat",
    category="Papers",
    module="game.scenes.pond.scene",
    class_name="Pond",
    keywords="water ripples pond lake boat wake wedge float buoy rain drop yuksel house keyser",
    card="draw_pond",
)
ENTRIES = (POND,)
