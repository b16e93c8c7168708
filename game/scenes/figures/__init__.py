"""Figures of the help pages: what a scene's words and equations speak of, drawn with a pen."""
