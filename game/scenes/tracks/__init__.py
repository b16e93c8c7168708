"""Balls on tracks: loops, races, bowls, and tracks drawn by hand."""

from game.stage.catalogue import Entry

TRACKS = Entry(
    name="tracks",
    task="S02",
    title="Tracks",
    fact="loops and races",
    category="Playgrounds",
    module="game.scenes.tracks.scene",
    class_name="Tracks",
    keywords="roller coaster loop brachistochrone tautochrone cycloid rolling ball disc sphere friction",
    card="draw_loop",
)
ENTRIES = (TRACKS,)
