"""Three whole scenes of one small file each, to learn from and to begin with."""

from game.stage.catalogue import Entry

PENDULUM = Entry(
    name="pendulum",
    task="E1",
    title="Pendulum",
    fact="one file, five methods",
    category="Examples",
    module="game.scenes.examples.pendulum",
    class_name="Pendulum",
    keywords="example small scene pendulum euler verlet runge kutta jacobi elliptic exact",
    card="draw_pendulum",
)
BOUNCING_BALL = Entry(
    name="bouncing-ball",
    task="E2",
    title="Bouncing ball",
    fact="one file, one root",
    category="Examples",
    module="game.scenes.examples.bouncing_ball",
    class_name="BouncingBall",
    keywords="example small scene ball bounce restitution impact root",
    card="draw_bounces",
)
SPRING_CHAIN = Entry(
    name="spring-chain",
    task="E3",
    title="Spring chain",
    fact="one file, all modes",
    category="Examples",
    module="game.scenes.examples.spring_chain",
    class_name="SpringChain",
    keywords="example small scene chain string beads springs normal modes wave",
    card="draw_chain",
)
ENTRIES = (PENDULUM, BOUNCING_BALL, SPRING_CHAIN)
