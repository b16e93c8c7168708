"""Broad phases: uniform grid (C05), hierarchical grids (C06), sweep and prune (C07), and their race."""
