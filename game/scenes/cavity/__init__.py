"""S08: the eddy in a cavity under a moving lid, and between a hot and a cold wall."""

from game.stage.catalogue import Entry

CAVITY = Entry(
    name="cavity",
    task="S08",
    title="Eddy in a cavity",
    fact="the fluid coder's yardstick",
    category="Playgrounds",
    module="game.scenes.cavity.scene",
    class_name="Cavity",
    keywords="lid driven fluid gas ghia reynolds vortex streamlines heated convection nusselt rayleigh",
    card="draw_eddy",
)
ENTRIES = (CAVITY,)
