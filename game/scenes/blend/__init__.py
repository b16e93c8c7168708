"""Splashes between recorded ones."""

from game.stage.catalogue import Entry

BLEND = Entry(
    name="splash-blend",
    task="P38",
    title="Splashes between splashes",
    fact="four recorded, nine shown",
    category="Playgrounds",
    module="game.scenes.blend.scene",
    class_name="SplashBlend",
    keywords="blend blending liquids mix interpolate morph splash drop dam wall recorded signed distance p38",
    card="draw_between",
)
ENTRIES = (BLEND,)
