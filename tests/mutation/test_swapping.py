"""A fault put into living functions: what differs is found, and the functions compute by the new source."""

from tests.mutation.swapping import compare, functions_of, swap

SOURCE = '''
"""Says things."""
LIMIT = 3.0


class Counter:
    step = 2

    def add(self, number):
        """Adds."""
        return number + self.step


def scaled(factor):
    def times(number):
        return factor * number

    return times
'''


def test_what_differs_is_named_by_the_outermost_function():
    def changed(old: str, new: str):
        return compare(SOURCE, SOURCE.replace(old, new), "counter.py")

    assert changed("number + self.step", "number - self.step").function == "Counter.add"
    assert changed("factor * number", "factor / number").function == "scaled"
    assert not changed("factor * number", "factor / number").at_import
    assert changed("step = 2", "step = 1").at_import
    assert changed("LIMIT = 3.0", "LIMIT = 3.3").at_import
    assert changed("number + self.step", "(number + self.step)").function is None
    assert changed("return times", "return lambda number: 0") is None


def test_living_functions_and_closures_compute_by_the_new_source(tmp_path):
    file = str(tmp_path / "counter.py")
    space: dict = {"__name__": "counter"}
    exec(compile(SOURCE, file, "exec"), space)
    counter, doubled = space["Counter"](), space["scaled"](2)
    add = counter.add
    new = SOURCE.replace("number + self.step", "number - self.step\n").replace("factor * n", "factor + n")
    assert swap(functions_of(str(tmp_path))[file], compare(SOURCE, new, file))
    assert (add(5), counter.add(5), doubled(5), space["scaled"](3)(5)) == (3, 3, 7, 8)


def test_a_closure_that_would_lose_a_cell_is_refused(tmp_path):
    file = str(tmp_path / "counter.py")
    space: dict = {"__name__": "counter"}
    exec(compile(SOURCE, file, "exec"), space)
    space["kept"] = space["scaled"](2)
    change = compare(SOURCE, SOURCE.replace("factor * number", "number"), file)
    assert not swap(functions_of(str(tmp_path))[file], change)
