"""Carom's own compilation target: numba's for this processor, with short cuts for Carom's kernels.

Nothing here is registered with numba's own target, and no class of numba's is altered for long: a kernel of
another package is compiled as it would be without Carom. See dispatchers.py for how the two meet.
"""
