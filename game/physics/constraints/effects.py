"""What a step of linked particles may compute besides gravity and the ground."""

from __future__ import annotations

from game.physics.effects import Room, declare_effect
from game.physics.fields import GRAVITY, GROUND

LINKS = declare_effect("links", "Links", "Links between particles keep their length.")
AREAS = declare_effect("areas", "Areas", "Closed outlines keep the area that they enclose.")
ATTACHMENTS = declare_effect(
    "attachments", "Attachments", "No particle is farther from a pin than the links reach."
)
TEARING = declare_effect("tearing", "Tearing", "A link that is stretched too far breaks.")
DAMPING = declare_effect("damping", "Damping", "A force -k v against each motion.")
CONTACTS = declare_effect(
    "contacts", "Contacts", "Listed pairs bounce off each other, and bodies keep apart."
)

LINKED = Room(
    "linked particles",
    GRAVITY | GROUND | LINKS | AREAS | ATTACHMENTS | TEARING | DAMPING | CONTACTS,
)
GRAVITY_BIT = LINKED.bit(GRAVITY)
GROUND_BIT = LINKED.bit(GROUND)
LINKS_BIT = LINKED.bit(LINKS)
AREAS_BIT = LINKED.bit(AREAS)
ATTACHMENTS_BIT = LINKED.bit(ATTACHMENTS)
TEARING_BIT = LINKED.bit(TEARING)
DAMPING_BIT = LINKED.bit(DAMPING)
CONTACTS_BIT = LINKED.bit(CONTACTS)
