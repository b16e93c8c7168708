r"""The markup of formulas: a small part of TeX, read into a tree.

======================  =====================================================================
written                 meaning
======================  =====================================================================
``a``, ``2``            a variable (italic), a number (upright)
``\v{x}``               a vector or matrix, bold italic
``x_n``, ``x^{n+1}``    sub- and superscript, both allowed; braces group
``\frac{a}{b}``         a fraction
``\sqrt{a}``            a root
``\dot{x} \hat{x} ..``  accents: dot, ddot, hat, bar, tilde
``\matrix{a&b\\c&d}``   rows in square brackets; ``\cases{..}`` with one brace at the left
``\abs{a} \norm{a}``    bars as high as their content; ``\left(..\right)`` likewise brackets
``\text{if}``           upright words
``\alpha``, ``\sum``    Greek letters, signs and named functions (``\sin``)
``\,`` ``\quad``        spaces
======================  =====================================================================

A node is a plain tuple whose first member is its kind: ("symbol", text, face, class), ("row", nodes),
("fraction", above, below), ("root", node), ("script", base, below, above), ("accent", sign, node), ("fence",
left, node, right). Also ("matrix", rows), ("space", em).
"""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches

from game.ui.text.markup_signs import ACCENTS, Node, known_signs, named_sign, sign_of

DEEPEST = 24  # nested braces; more is a mistake, and would only exhaust the stack
LONGEST = 2000  # characters
STRUCTURES = frozenset(("v", "text", "frac", "sqrt", "matrix", "cases", "left", "abs", "norm")) | ACCENTS


class FormulaError(ValueError):
    """A formula that cannot be read; the message says where and why."""


class _Reader:
    """Reads one formula from left to right."""

    def __init__(self, text: str) -> None:
        if len(text) > LONGEST:
            raise FormulaError(f"formula: longer than {LONGEST} characters")
        self.text = text
        self.i = 0
        self.depth = 0

    def fail(self, reason: str) -> FormulaError:
        return FormulaError(f"formula {self.text!r}, character {self.i + 1}: {reason}")

    def peek(self) -> str:
        return self.text[self.i : self.i + 1]

    def skip_spaces(self) -> None:
        while self.peek().isspace():
            self.i += 1

    def row(self, stops: Sequence[str]) -> Node:
        """Nodes up to one of the stops, which is left unread."""
        self.depth += 1
        if self.depth > DEEPEST:
            raise self.fail("nested too deeply")
        nodes: list[Node] = []
        while True:
            self.skip_spaces()
            rest = self.text[self.i :]
            if not rest and "" not in stops:
                raise self.fail(f"{' or '.join(stops)} is missing")
            if not rest or any(stop and _begins(rest, stop) for stop in stops):
                break
            if rest[0] in "}&" or _begins(rest, "\\\\") or _begins(rest, "\\right"):
                raise self.fail(f"{rest[0]} without a beginning")
            nodes.append(self.scripted())
        self.depth -= 1
        return ("row", tuple(nodes))

    def scripted(self) -> Node:
        """A node with what hangs above and below it."""
        base = ("row", ()) if self.peek() in ("^", "_") else self.atom()
        below: Node | None = None
        above: Node | None = None
        while True:
            self.skip_spaces()
            sign = self.peek()
            if sign == "_" and below is None:
                self.i += 1
                below = self.argument()
            elif sign == "^" and above is None:
                self.i += 1
                above = self.argument()
            elif sign in ("^", "_") and sign:
                raise self.fail("a second script of one kind")
            else:
                break
        return base if below is None and above is None else ("script", base, below, above)

    def argument(self) -> Node:
        """A group in braces, or one node."""
        self.skip_spaces()
        if self.peek() == "{":
            self.i += 1
            inside = self.row(("}",))
            self.i += 1
            return inside
        if not self.peek() or self.peek() in "}&^_":
            raise self.fail("something is missing here")
        return self.atom()

    def atom(self) -> Node:
        c = self.peek()
        if c == "{":
            return self.argument()
        if c == "\\":
            return self.command()
        self.i += 1
        if c.isdigit() or c == ".":
            start = self.i - 1
            while self.peek().isdigit() or (
                self.peek() == "." and self.text[self.i + 1 : self.i + 2].isdigit()
            ):
                self.i += 1
            return ("symbol", self.text[start : self.i], "formula", "ordinary")
        return sign_of(c)

    def command(self) -> Node:
        """What follows a backslash."""
        self.i += 1
        start = self.i
        while self.peek().isalpha():
            self.i += 1
        if self.text[start : self.i] == "atan" and self.peek() == "2":
            self.i += 1
        if self.i == start:
            self.i += 1
        name = self.text[start : self.i]
        if name in STRUCTURES:
            return self.structure(name)
        found = named_sign(name)
        if found is None:
            self.i = start
            raise self.fail(f"\\{name} is not known; {_known(name)}")
        return found

    def structure(self, name: str) -> Node:
        """A command with arguments."""
        if name == "frac":
            above = self.argument()
            return ("fraction", above, self.argument())
        if name in ("matrix", "cases"):
            rows = self.rows()
            return ("fence", "[", rows, "]") if name == "matrix" else ("fence", "{", rows, "")
        if name == "left":
            return self.fence()
        if name == "text":
            return ("symbol", self.words(), "formula", "ordinary")
        inside = self.argument()
        if name == "v":
            return _bold(inside)
        if name == "sqrt":
            return ("root", inside)
        if name in ("abs", "norm"):
            bar = "|" if name == "abs" else "‖"
            return ("fence", bar, inside, bar)
        return ("accent", name, inside)

    def words(self) -> str:
        self.skip_spaces()
        end = self.text.find("}", self.i)
        if self.peek() != "{" or end < 0:
            raise self.fail("expected words in braces")
        words = self.text[self.i + 1 : end]
        self.i = end + 1
        return words

    def rows(self) -> Node:
        """Cells between & and \\\\ inside braces."""
        self.skip_spaces()
        if self.peek() != "{":
            raise self.fail("expected {")
        self.i += 1
        rows: list[list[Node]] = [[]]
        while True:
            rows[-1].append(self.row(("&", "\\\\", "}")))
            if self.peek() == "}":
                self.i += 1
                return ("matrix", tuple(tuple(row) for row in rows))
            if self.peek() == "&":
                self.i += 1
            else:
                self.i += 2
                rows.append([])

    def fence(self) -> Node:
        left = self.peek()
        self.i += 1
        inside = self.row(("\\right",))
        self.i += len("\\right")
        right = self.peek()
        self.i += 1
        return ("fence", left.replace(".", ""), inside, right.replace(".", ""))


def _known(name: str) -> str:
    """What may be written after a backslash, first what is most like a name that may not."""
    names = sorted(
        STRUCTURES | {"right"} | known_signs(), key=lambda word: (not word.isalpha(), word.lower())
    )
    alike = " or ".join("\\" + word for word in get_close_matches(name, names, 3, 0.6))
    meant = f"did you mean {alike}? " if alike else ""
    return f"{meant}known are " + " ".join("\\" + word for word in names)


def _begins(rest: str, stop: str) -> bool:
    """Whether a stop comes next: a word only if it ends there, for \\rightarrow is none of \\right."""
    return rest.startswith(stop) and not (stop[-1].isalpha() and rest[len(stop) : len(stop) + 1].isalpha())


def _bold(node: Node) -> Node:
    """The same with its letters in bold italic."""
    if node[0] == "symbol":
        return ("symbol", node[1], "formula-bold", node[3]) if node[1].isalpha() else node
    if node[0] == "row":
        return ("row", tuple(_bold(part) for part in node[1]))
    if node[0] == "script":
        return ("script", _bold(node[1]), node[2], node[3])
    return node


def parse(text: str) -> Node:
    """The tree of a formula; FormulaError says where it cannot be read."""
    reader = _Reader(text)
    return reader.row(("",))
