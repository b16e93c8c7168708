"""P16: the air's forces on any outline, measured in a wind tunnel over the angle, fitted, and flown by."""

from game.stage.catalogue import Entry

WIND_TUNNEL = Entry(
    name="wind-tunnel",
    task="P16",
    title="Wind tunnel",
    fact="draw a shape, let it fly",
    category="Papers",
    module="game.scenes.wind_tunnel.scene",
    class_name="WindTunnel",
    keywords="aerodynamics drag lift torque moment polar attack omniad aerofoil strouhal vortex street",
    card="draw_tunnel",
)
ENTRIES = (WIND_TUNNEL,)
