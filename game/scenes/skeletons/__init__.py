"""Skeletons and skin (C02), inverse kinematics (C03)."""
