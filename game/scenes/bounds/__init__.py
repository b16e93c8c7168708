"""Trees of oriented boxes (C08) and of capsules (C09)."""

from game.stage.catalogue import Entry

C08 = Entry(
    name="c08",
    task="C08",
    title="Oriented boxes",
    fact="trees that touch",
    category="Course",
    topic="Bounding volumes and distance",
    module="game.scenes.bounds.oriented_boxes",
    class_name="OrientedBoxes",
    keywords="obb tree oriented bounding boxes separating axis tandem traversal coastline gears hands",
    card="draw_oriented_boxes",
)
C09 = Entry(
    name="c09",
    task="C09",
    title="Capsules",
    fact="rounder trees",
    category="Course",
    topic="Bounding volumes and distance",
    module="game.scenes.bounds.capsules",
    class_name="Capsules",
    keywords="capsule tree swept sphere volumes line swept lss segment distance tandem traversal",
    card="draw_capsules",
)
ENTRIES = (
    C08,
    C09,
)
