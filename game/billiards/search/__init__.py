"""Searching for shots: geometry proposes, exact shots under noise decide.

`finding` is where others come in (`find_shots`); below it: `lanes` and `candidates` (geometry), `strokes` and
`outcomes` (many exact shots at once), `fans` and `rating`. Then `looking` and `deeper` (one stroke, and the
one after it), `placing` (a cue ball in hand), `safety` (when nothing can be potted).
"""
