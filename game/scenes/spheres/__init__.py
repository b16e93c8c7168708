"""Spheres that collide by impulses (C13)."""

from game.stage.catalogue import Entry

C13 = Entry(
    name="c13",
    task="C13",
    title="Sphere collisions",
    fact="cradle, pile, sand",
    category="Course",
    topic="Rigid bodies",
    module="game.scenes.spheres.scene",
    class_name="SphereCollisions",
    keywords="rigid body impulse collision restitution friction newton cradle pile stack hourglass "
    "time of impact split impulse baumgarte warm start break rack discs",
    card="draw_cradle",
)
ENTRIES = (C13,)
