"""The compiler of kernels: the decorator, its cache on disk, and code that came prebuilt."""
