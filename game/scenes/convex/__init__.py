"""Two convex polygons: V-Clip (C10) and GJK (C11)."""

from game.stage.catalogue import Entry

C10 = Entry(
    name="c10",
    task="C10",
    title="V-Clip",
    fact="closest features",
    category="Course",
    topic="Bounding volumes and distance",
    module="game.scenes.convex.vclip",
    class_name="VClip",
    keywords="narrow phase closest features distance voronoi mirtich penetration depth coherence",
    card="draw_voronoi_walk",
)
C11 = Entry(
    name="c11",
    task="C11",
    title="GJK",
    fact="simplex by simplex",
    category="Course",
    topic="Bounding volumes and distance",
    module="game.scenes.convex.gjk",
    class_name="Gjk",
    keywords="narrow phase minkowski difference simplex support hill climbing epa distance",
    card="draw_simplexes",
)
ENTRIES = (
    C10,
    C11,
)
