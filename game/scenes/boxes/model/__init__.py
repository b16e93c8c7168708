"""What the broad-phase scenes compute: boxes that move, structures round them, and their pairs."""
