"""Strips over time, plots, and the page of what accuracy costs."""
