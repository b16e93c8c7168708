"""What a step of soft bodies may compute beside what linked particles do."""

from __future__ import annotations

from game.physics.constraints.effects import AREAS, DAMPING, LINKS
from game.physics.effects import Room, declare_effect
from game.physics.fields import GRAVITY, GROUND

MESH_CONTACTS = declare_effect(
    "mesh-contacts", "Contacts", "Vertices of a mesh are looked for in triangles of others."
)
SELF_CONTACTS = declare_effect(
    "self-contacts", "Self-contacts", "Vertices of a mesh are looked for in its own triangles."
)
PUSHING = declare_effect(
    "pushing", "Pushing out", "What is inside another triangle is pushed out of the mesh."
)

SOFT = Room(
    "soft bodies", GRAVITY | GROUND | LINKS | AREAS | DAMPING | MESH_CONTACTS | SELF_CONTACTS | PUSHING
)
MESH_CONTACTS_BIT = SOFT.bit(MESH_CONTACTS)
SELF_CONTACTS_BIT = SOFT.bit(SELF_CONTACTS)
