"""Faults sown one at a time, to see whether the tests notice. Not part of the test run: `python -m tests.mutation`."""
