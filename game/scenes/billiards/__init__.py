"""The billiard game on the exact table."""

from game.stage.catalogue import Entry, StoryCard

BILLIARDS = Entry(
    name="billiards",
    task="L.10",
    title="Billiards",
    fact="8-ball, 9-ball, trick shots",
    category="Play",
    module="game.scenes.billiards.scene",
    class_name="Billiards",
    keywords="pool eight-ball nine-ball combination match trick shots puzzles drills opponents A02 exact cue",
    roomy=True,
    card="draw_billiards",
    level_card="draw_level",
    start="START",
    story=StoryCard("A02", "A billiard match", "fifteen rounds, 8 : 7"),
)
ENTRIES = (BILLIARDS,)
