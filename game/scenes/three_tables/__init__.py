"""One stroke on three tables: lecture, stepped, exact."""
