"""Fitting: tracked shots, the strokes that explain them, and the table they were played on."""
