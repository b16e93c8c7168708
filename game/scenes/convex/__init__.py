"""Two convex polygons: V-Clip (C10) and GJK (C11)."""
