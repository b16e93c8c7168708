"""What kernels of all rooms call: elementary functions, sums in a fixed order, lanes, and tests of arrays."""
