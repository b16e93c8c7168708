"""P14: gas that one stirs, paints and sets on fire."""

from game.stage.catalogue import Entry

SMOKE = Entry(
    name="smoke",
    task="P14",
    title="Smoke to stir",
    fact="stable fluids, then and now",
    category="Papers",
    module="game.scenes.smoke.scene",
    class_name="Smoke",
    keywords="fluid gas smoke dye fire stam stable fluids semi-lagrangian pressure vorticity schlieren",
    card="draw_whirls",
)
ENTRIES = (SMOKE,)
