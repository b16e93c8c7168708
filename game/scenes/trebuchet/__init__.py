"""A trebuchet before a wall."""

from game.stage.catalogue import Entry

TREBUCHET = Entry(
    name="trebuchet",
    task="S01",
    title="The Trebuchet",
    fact="a story of a lever",
    category="Stories",
    module="game.scenes.trebuchet.scene",
    class_name="Trebuchet",
    keywords="trebuchet counterweight sling lever ballistics range efficiency wall blocks siege",
    roomy=True,
    card="draw_machine",
)
ENTRIES = (TREBUCHET,)
