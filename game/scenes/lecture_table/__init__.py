"""The lecture's pool table."""

from game.stage.catalogue import Entry

LECTURE_TABLE = Entry(
    name="lecture-table",
    task="L",
    title="Lecture table",
    fact="pool by simple laws",
    category="Lecture",
    module="game.scenes.lecture_table.scene",
    class_name="LectureTable",
    keywords="billiards pool cue pockets break rack tunnelling substeps friction bounce",
    card="draw_lecture_table",
)
ENTRIES = (LECTURE_TABLE,)
