"""Skeletons and skin (C02), inverse kinematics (C03)."""

from game.stage.catalogue import Entry

C02 = Entry(
    name="c02",
    task="C02",
    title="Skeleton and skinning",
    fact="a person, a dragon",
    category="Course",
    topic="Animation",
    module="game.scenes.skeletons.skinning",
    class_name="Skinning",
    keywords="bones skeleton skin forward kinematics weights matrix palette linear blend rotor dual complex",
    card="draw_skeleton",
)
C03 = Entry(
    name="c03",
    task="C03",
    title="Inverse kinematics",
    fact="six methods race",
    category="Course",
    topic="Animation",
    module="game.scenes.skeletons.inverse_kinematics",
    class_name="InverseKinematics",
    keywords="bones skeleton chain inverse kinematics gradient "
    "jacobian damped least squares ccd fabrik limits",
    card="draw_reaching",
)
ENTRIES = (
    C02,
    C03,
)
