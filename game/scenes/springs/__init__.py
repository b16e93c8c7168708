"""Position based dynamics: rigid links (C14) and soft springs (C15)."""

from game.stage.catalogue import Entry

C14 = Entry(
    name="c14",
    task="C14",
    title="Rigid links",
    fact="ropes and cloth",
    category="Course",
    topic="Particles and springs",
    module="game.scenes.springs.rigid_links",
    class_name="RigidLinks",
    keywords="mass spring position based dynamics pbd xpbd rope bridge cloth pendulum cradle tearing",
    card="draw_cloth",
)
C15 = Entry(
    name="c15",
    task="C15",
    title="Soft springs",
    fact="jellies, balloons",
    category="Course",
    topic="Particles and springs",
    module="game.scenes.springs.soft_springs",
    class_name="Springs",
    keywords="mass spring stiffness compliance jelly cloth ring area bungee trampoline",
    card="draw_jelly",
)
ENTRIES = (
    C14,
    C15,
)
