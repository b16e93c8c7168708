"""All solvers on one set-up, side by side."""
