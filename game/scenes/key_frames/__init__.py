"""Key-frames on a timeline (C01)."""

from game.stage.catalogue import Entry

C01 = Entry(
    name="c01",
    task="C01",
    title="Key-frames",
    fact="twelve curves",
    category="Course",
    topic="Animation",
    module="game.scenes.key_frames.scene",
    class_name="KeyFraming",
    keywords="keyframes interpolation nearest linear bezier catmull rom spline easing onion skin",
    card="draw_key_frames",
)
ENTRIES = (C01,)
