"""The lecture's two balls and their one collision."""

from game.stage.catalogue import Entry

LECTURE_BALLS = Entry(
    name="lecture-balls",
    task="L",
    title="Two balls",
    fact="one collision in steps",
    category="Lecture",
    module="game.scenes.two_balls.scene",
    class_name="LectureBalls",
    keywords="lecture collision overlap line of centres overshoot momentum energy as printed",
    card="draw_two_balls",
)
ENTRIES = (LECTURE_BALLS,)
