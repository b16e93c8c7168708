"""Numbers only: methods as kernels on arrays. No window, no files, no wall clock."""
