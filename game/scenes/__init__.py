"""The catalogue: a row for each scene, in the order of the menu.

Each scene or family of scenes is a folder; the rows of its scenes stand in the ``__init__.py`` there, which
imports nothing of the scenes.
"""

from game.scenes import (
    beat,
    billiards,
    bounds,
    boxes,
    carom,
    convex,
    deformables,
    depth,
    domino,
    examples,
    fireworks,
    fountain,
    key_frames,
    lecture_table,
    levitation,
    metal,
    real_table,
    rigid_body,
    skeletons,
    snooker,
    solids,
    spacetime,
    spheres,
    springs,
    three_tables,
    tower,
    tracks,
    two_balls,
)
from game.stage.catalogue import Catalogue

CATALOGUE = Catalogue(
    (
        *billiards.ENTRIES,
        *carom.ENTRIES,
        *snooker.ENTRIES,
        *two_balls.ENTRIES,
        *lecture_table.ENTRIES,
        *three_tables.ENTRIES,
        *real_table.ENTRIES,
        *key_frames.ENTRIES,
        *skeletons.ENTRIES,
        *fountain.ENTRIES,
        *springs.ENTRIES,
        *boxes.ENTRIES,
        *bounds.ENTRIES,
        *convex.ENTRIES,
        *rigid_body.ENTRIES,
        *spheres.ENTRIES,
        *examples.ENTRIES,
        *fireworks.ENTRIES,
        *solids.ENTRIES,
        *tracks.ENTRIES,
        *beat.ENTRIES,
        *spacetime.ENTRIES,
        *levitation.ENTRIES,
        *depth.ENTRIES,
        *deformables.ENTRIES,
        *domino.ENTRIES,
        *metal.ENTRIES,
        *tower.ENTRIES,
    )
)
