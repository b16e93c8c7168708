"""The compiler: the kernel decorator, its cache on disk, and small helpers for kernels."""
