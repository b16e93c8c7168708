"""The few particles of a step that need care: near a solid, just born, or dying and to be reported.

`advance`, `births` and `deaths` write them to one list; here each is flown among the solids for its own part
of the step.

A row of the list: x, y, vx, vy at the beginning; when it begins (s into the step); how long it flies (s);
its identity. Its place in the pool is in ``who``; -1: it dies at the end of its flight.

Tuples of arrays: pool and listed as in `births`.
"""

from __future__ import annotations

from game.compiler.decorator import lean_kernel
from game.physics.particles.contacts import fly_among_solids
from game.physics.particles.effects import REPORTS_BIT
from game.physics.particles.forces import unpack_forces

START, DURATION, IDENTITY = 4, 5, 6
LIST_ROWS = 7

# counters of a system, in the int64 array ``tallies``
HEAD, COUNT, STEP, BORN, DIED, DROPPED, IMPACTS, CUT_SHORT, REPORTED, UNREPORTED = range(10)
TALLIES = 10

# a report: kind, identity, instant (s), x, y, vx, vy, impulse (m/s) or 0
REPORT_COLUMNS = 8
DEATH, IMPACT = 0.0, 1.0


@lean_kernel
def report(reports, tallies, kind, identity, instant, particle, amount):
    """Add a line to the reports of this step; what does not fit is counted."""
    line = tallies[REPORTED]
    if line >= reports.shape[0]:
        tallies[UNREPORTED] += 1
        return
    reports[line, 0] = kind
    reports[line, 1] = identity
    reports[line, 2] = instant
    for k in range(4):
        reports[line, 3 + k] = particle[k]
    reports[line, 7] = amount
    tallies[REPORTED] = line + 1


@lean_kernel
def resolve_encounters(rules, pool, listed, found, forces, solids, now, impulses, reports):
    """Fly the first ``found`` of the list among the solids and write what becomes of them.

    fields (>= 4, n): x, y, vx, vy are written. tags (2, n): identity; number of the step, from 1, of the last
    touch, negative for one of the floor; 0 if there was none: written.
    now: s at the beginning of the step. impulses (k, 2): added to.
    """
    fields, tags, tallies, _ = pool
    hits, who = listed
    law = unpack_forces(forces)
    reporting = rules.mask & REPORTS_BIT
    for entry in range(found):
        begin = hits[START, entry]
        left = hits[DURATION, entry]
        end = now + begin + left
        particle = hits[0, entry], hits[1, entry], hits[2, entry], hits[3, entry]
        x, y, vx, vy, impulse, met, lost = fly_among_solids(
            rules, law, solids, particle, begin, left, impulses
        )
        particle = x, y, vx, vy
        place = who[entry]
        tallies[CUT_SHORT] += lost > 0.0
        tallies[IMPACTS] += impulse > 0.0
        if place >= 0:
            fields[0, place] = x
            fields[1, place] = y
            fields[2, place] = vx
            fields[3, place] = vy
            if met >= 0:
                fresh = abs(tags[1, place]) < tallies[STEP] or tags[1, place] == 0
                number = tallies[STEP] + 1
                tags[1, place] = number if met < solids.shape[0] else -number
                if reporting and fresh and impulse > 0.0:
                    report(reports, tallies, IMPACT, float(tags[0, place]), end, particle, impulse)
        elif reporting:
            report(reports, tallies, DEATH, hits[IDENTITY, entry], end, particle, 0.0)
