"""Snooker: sight lines, a stroke as the referee sees it, the rules, and the frame."""
