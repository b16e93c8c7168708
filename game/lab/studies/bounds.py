"""What bounding volumes cost: area against the angle step, tests against the gap that they prove."""

from __future__ import annotations

box_study = None
capsule_study = None
