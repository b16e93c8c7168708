"""Joints between two bodies, each kind a file: `layout` says what they are, `lines` how they are read."""
