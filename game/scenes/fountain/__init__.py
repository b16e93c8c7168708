"""A fountain of particles over stones (C04)."""

from game.stage.catalogue import Entry

C04 = Entry(
    name="c04",
    task="C04",
    title="Particle fountain",
    fact="100 000 particles",
    category="Course",
    topic="Particles and springs",
    module="game.scenes.fountain.scene",
    class_name="Fountain",
    keywords="particles fountain emitter euler midpoint verlet runge kutta drag wind impact envelope",
    card="draw_fountain",
)
ENTRIES = (C04,)
