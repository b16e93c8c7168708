"""Studies of solids: solver, substeps and sweeps against laws with known answers."""
