"""Studies of the distance between convex polygons."""
