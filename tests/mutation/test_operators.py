"""The faults that can be sown: each changes the text it names, and what comes of it is still Python."""

import ast

from tests.mutation.operators import find_faults, sow

SOURCE = '''
"""Says 1 + 2."""
LIMIT = 3.0


def step(state, dt):
    """Moves by a - b."""
    state[0] += state[1] * dt - 0.5 * dt
    if state[0] < LIMIT and not state[2]:
        state[1] = -state[1]
        note("é", state)
    return state[0] + state[1]
'''


def test_every_fault_is_another_program():
    faults = find_faults(SOURCE)
    texts = [sow(SOURCE, fault) for fault in faults]
    assert all(ast.dump(ast.parse(text)) != ast.dump(ast.parse(SOURCE)) for text in texts)
    assert len(set(texts)) == len(texts)


def test_signs_comparisons_dropped_terms_and_forgotten_writes_are_sown():
    texts = {sow(SOURCE, fault).split("def step")[1] for fault in find_faults(SOURCE)}

    def sown(old: str, new: str) -> bool:
        return SOURCE.split("def step")[1].replace(old, new) in texts

    assert sown("state[0] < LIMIT", "(state[0] <= LIMIT)")
    assert sown("state[0] + state[1]", "(state[0])")
    assert sown("-state[1]", "(state[1])")
    assert sown("state[1] = -state[1]", "pass")
    assert sown('note("é", state)', "pass")
    assert sown("state[0] += state[1] * dt - 0.5 * dt", "pass")


def test_documentation_is_left_alone():
    assert not [fault for fault in find_faults(SOURCE) if "Says" in fault.old or "Moves" in fault.old]
