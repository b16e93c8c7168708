"""The real table: tracked shots over what the models compute for them."""

from game.stage.catalogue import Entry

REAL_TABLE = Entry(
    name="real-table",
    task="T01",
    title="The real table",
    fact="tracks and five models",
    category="Carom",
    module="game.scenes.real_table.scene",
    class_name="RealTable",
    keywords="billiards carom three cushion track fit residual filmed measured Han Mathavan Stronge stroke",
    card="draw_real_table",
)
ENTRIES = (REAL_TABLE,)
