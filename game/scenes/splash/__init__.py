"""A drop falls into a pool: crown, crater, jet."""

from game.stage.catalogue import Entry

SPLASH = Entry(
    name="splash",
    task="A16",
    title="Splash",
    fact="a story of a drop",
    category="Stories",
    module="game.scenes.splash.scene",
    class_name="Splash",
    keywords="splash drop pool crown crater cavity jet worthington ripples dispersion slow motion water",
    roomy=True,
    card="draw_crown",
)
ENTRIES = (SPLASH,)
