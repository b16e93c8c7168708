"""The playground of solids: bodies of any shape, joints, machines made of them; and a race of solvers."""

from game.stage.catalogue import Entry

SOLIDS = Entry(
    name="solids",
    task="S01",
    title="Solids",
    fact="draw, pin, cut, throw",
    category="Playgrounds",
    module="game.scenes.solids.scene",
    class_name="Solids",
    keywords="rigid bodies stack pyramid arch domino catapult cradle galton joint rope motor solver",
    card="draw_arch",
)
RACE = Entry(
    name="solver-race",
    task="S03",
    title="Solver race",
    fact="one set-up, all solvers",
    category="Playgrounds",
    module="game.scenes.solids.race.scene",
    class_name="SolverRace",
    keywords="rigid bodies solvers compared stack pyramid arch chain mass ratio sinking leaning overlap",
    card="draw_columns",
)
ENTRIES = (SOLIDS, RACE)
