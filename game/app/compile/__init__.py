"""Compiling kernels before they are needed, in the background or in a second process."""
