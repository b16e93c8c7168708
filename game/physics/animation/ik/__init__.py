"""Inverse kinematics: one method a file."""
