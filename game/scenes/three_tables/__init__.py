"""One stroke on three tables: lecture, stepped, exact."""

from game.stage.catalogue import Entry

THREE_TABLES = Entry(
    name="three-tables",
    task="L",
    title="Three tables",
    fact="lecture, stepped, exact",
    category="Lecture",
    module="game.scenes.three_tables.scene",
    class_name="ThreeTables",
    keywords="billiards exact event driven stepped chaos accuracy spin draw masse",
    card="draw_three_tables",
)
ENTRIES = (THREE_TABLES,)
