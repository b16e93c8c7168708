"""Joints between two bodies, each kind a file: `layout` says what they are made of, `lines` how they are read."""
