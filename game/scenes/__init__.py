"""The catalogue: a row for each scene, in the order of the menu; a row names a module and imports nothing."""

from game.stage.catalogue import Catalogue, Entry

CATALOGUE = Catalogue(
    (
        Entry(
            name="lecture-balls",
            task="L",
            title="Two balls",
            fact="one collision, step by step",
            category="Billiards",
            module="game.scenes.lecture_balls",
            class_name="LectureBalls",
            keywords="lecture collision overlap line of centres overshoot momentum energy as printed",
        ),
        Entry(
            name="lecture-table",
            task="L",
            title="Lecture table",
            fact="pool by the lecture's laws",
            category="Billiards",
            module="game.scenes.lecture_table",
            class_name="LectureTable",
            keywords="billiards pool cue pockets break rack tunnelling substeps friction bounce",
        ),
        Entry(
            name="three-tables",
            task="L",
            title="Three tables",
            fact="lecture, stepped, exact",
            category="Billiards",
            module="game.scenes.three_tables",
            class_name="ThreeTables",
            keywords="billiards exact event driven stepped chaos accuracy spin draw masse",
        ),
        Entry(
            name="c04",
            task="C04",
            title="Particle fountain",
            fact="100 000 particles",
            category="Particles and springs",
            module="game.scenes.c04_fountain",
            class_name="Fountain",
            keywords="particles fountain emitter euler midpoint verlet runge kutta drag wind impact envelope",
        ),
    )
)
