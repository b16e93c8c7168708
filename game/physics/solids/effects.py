"""What a step of solids may compute."""

from __future__ import annotations

from game.physics.effects import Room, declare_effect
from game.physics.fields import DRAG, GRAVITY, WIND

CONTACTS = declare_effect("solid-contacts", "Contacts", "Solids hit and carry each other.")
FRICTION = declare_effect("solid-friction", "Friction", "Contacts resist sliding (Coulomb).")
RESTITUTION = declare_effect("restitution", "Restitution", "What hits fast enough bounces.")
CONTINUOUS = declare_effect(
    "continuous", "Continuous", "What is fast or thin is stopped where it meets something."
)
SLEEP = declare_effect("sleep", "Sleep", "Groups of solids that have come to rest are not computed.")
JOINTS = declare_effect("solid-joints", "Joints", "Pins, rods, ropes and motors hold solids together.")

SOLIDS = Room(
    "solids", GRAVITY | DRAG | WIND | CONTACTS | FRICTION | RESTITUTION | CONTINUOUS | SLEEP | JOINTS
)
USUAL = GRAVITY | CONTACTS | FRICTION | RESTITUTION | CONTINUOUS | SLEEP | JOINTS
GRAVITY_BIT = SOLIDS.bit(GRAVITY)
DRAG_BIT = SOLIDS.bit(DRAG)
WIND_BIT = SOLIDS.bit(WIND)
CONTACTS_BIT = SOLIDS.bit(CONTACTS)
FRICTION_BIT = SOLIDS.bit(FRICTION)
RESTITUTION_BIT = SOLIDS.bit(RESTITUTION)
CONTINUOUS_BIT = SOLIDS.bit(CONTINUOUS)
SLEEP_BIT = SOLIDS.bit(SLEEP)
JOINTS_BIT = SOLIDS.bit(JOINTS)
