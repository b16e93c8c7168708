"""Outlines that are drawn, dragged and edited by hand."""
