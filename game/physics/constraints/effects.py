"""What a step of linked particles may compute besides gravity and the ground."""

from __future__ import annotations

from game.physics.effects import declare_effect
from game.physics.fields import GRAVITY, GROUND

LINKS = declare_effect("constraints", "links", 36, "Links", "Links between particles keep their length.")
AREAS = declare_effect(
    "constraints", "areas", 37, "Areas", "Closed outlines keep the area that they enclose."
)
ATTACHMENTS = declare_effect(
    "constraints", "attachments", 38, "Attachments", "Nobody is farther from a pin than the links reach."
)
TEARING = declare_effect("constraints", "tearing", 39, "Tearing", "A link that is stretched too far breaks.")
DAMPING = declare_effect("constraints", "damping", 40, "Damping", "A force -k v against each motion.")
CONTACTS = declare_effect("constraints", "contacts", 41, "Contacts", "Listed pairs bounce off each other.")

GRAVITY_BIT = GRAVITY.mask
GROUND_BIT = GROUND.mask
LINKS_BIT = LINKS.mask
AREAS_BIT = AREAS.mask
ATTACHMENTS_BIT = ATTACHMENTS.mask
TEARING_BIT = TEARING.mask
DAMPING_BIT = DAMPING.mask
CONTACTS_BIT = CONTACTS.mask
