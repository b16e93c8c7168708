"""A rigid body of spheres in space (C12)."""

from game.stage.catalogue import Entry

C12 = Entry(
    name="c12",
    task="C12",
    title="Rigid body",
    fact="a hammer flips",
    category="Course",
    topic="Rigid bodies",
    module="game.scenes.rigid_body.scene",
    class_name="RigidBodyScene",
    keywords="rigid body inertia tensor quaternion euler midpoint runge kutta splitting "
    "gyroscopic jacobi angular momentum hammer dzhanibekov intermediate axis force torque density",
    card="draw_rigid_body",
)
ENTRIES = (C12,)
