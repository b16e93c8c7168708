"""Joints between two bodies, each kind a file: see `layout` for what they are made of, `sweeps` for
their use.
"""
