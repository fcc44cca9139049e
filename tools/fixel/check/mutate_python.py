# SPDX-License-Identifier: MIT
"""Small mistakes in Python code: which there are in a file, found by its syntax tree.

The mistakes are those of mutate.py, in Python's words:
    a comparison that takes or leaves its limit, or is turned about (< to <=, == to !=, in to not in)
    + for -, - for +, // for *, << for >>, & for |, `and` for `or`, and so on
    a whole number one larger or one smaller, True for False, a `not` left out
    a statement left out: a call, an assignment to a part of something, +=
Code outside functions, assertions, texts, and the words of errors that are raised are left alone.
"""

import ast
import bisect
import re

from fixel.check.mutate import Mutant

SWAPS = {
    ast.Lt: ("<", "<=", ">="), ast.LtE: ("<=", "<", ">"), ast.Gt: (">", ">=", "<="), ast.GtE: (">=", ">", "<"),
    ast.Eq: ("==", "!="), ast.NotEq: ("!=", "=="), ast.In: ("in", "not in"), ast.NotIn: ("not in", "in"),
    ast.Is: ("is", "is not"), ast.IsNot: ("is not", "is"), ast.And: ("and", "or"), ast.Or: ("or", "and"),
    ast.Add: ("+", "-"), ast.Sub: ("-", "+"), ast.Mult: ("*", "+"), ast.FloorDiv: ("//", "*"), ast.Div: ("/", "*"),
    ast.Mod: ("%", "//"), ast.LShift: ("<<", ">>"), ast.RShift: (">>", "<<"), ast.BitAnd: ("&", "|"), ast.BitOr: ("|", "&"),
}
LEFT_OUT = "pass"
NOT = re.compile(r"not\s*")


class Places:
    """Places of a file's text by line and byte, as the syntax tree has them."""

    def __init__(self, text):
        self.text, self.lines = text, text.split("\n")
        self.starts = [0]
        for line in self.lines:
            self.starts.append(self.starts[-1] + len(line) + 1)

    def at(self, line, column):
        return self.starts[line - 1] + len(self.lines[line - 1].encode()[:column].decode())

    def begin(self, node):
        return self.at(node.lineno, node.col_offset)

    def end(self, node):
        return self.at(node.end_lineno, node.end_col_offset)

    def line(self, place):
        return bisect.bisect_right(self.starts, place)


class Finder(ast.NodeVisitor):
    """Collects (begin, end, what it becomes)."""

    def __init__(self, places):
        self.places, self.found, self.depth = places, [], 0

    def between(self, left, right, operator):
        """Mutants of an operator that stands between two nodes."""
        words, *others = SWAPS.get(type(operator), ("",))
        first, last = self.places.end(left), self.places.begin(right)
        place = self.places.text.find(words, first, last) if words else -1
        self.found += [(place, place + len(words), each) for each in others if place >= 0]

    def visit_function(self, node):
        self.depth += 1
        for each in node.body[1:] if ast.get_docstring(node, clean=False) is not None else node.body:
            self.visit(each)
        self.depth -= 1

    visit_FunctionDef = visit_AsyncFunctionDef = visit_function

    def visit(self, node):
        if self.depth or isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)):
            super().visit(node)

    def visit_Raise(self, node):
        """The words of an error are no result; that it is raised is, unless it is an assertion."""
        if not (isinstance(node.exc, ast.Call) and getattr(node.exc.func, "id", "") == "AssertionError"):
            self.leave_out(node)

    def visit_JoinedStr(self, node):
        pass

    def visit_Assert(self, node):
        pass

    def visit_Compare(self, node):
        for left, operator, right in zip([node.left, *node.comparators], node.ops, node.comparators):
            self.between(left, right, operator)
        self.generic_visit(node)

    def visit_BoolOp(self, node):
        for left, right in zip(node.values, node.values[1:]):
            self.between(left, right, node.op)
        self.generic_visit(node)

    def visit_BinOp(self, node):
        texts = (ast.JoinedStr, ast.List)
        if not any(isinstance(each, texts) or is_text(each) for each in (node.left, node.right)):
            self.between(node.left, node.right, node.op)
        self.generic_visit(node)

    def visit_UnaryOp(self, node):
        if isinstance(node.op, ast.Not):
            begin = self.places.begin(node)
            self.found.append((begin, NOT.match(self.places.text, begin).end(), ""))
        self.generic_visit(node)

    def visit_Constant(self, node):
        if node.value is True or node.value is False:
            self.replace(node, str(not node.value))
        elif type(node.value) is int:
            self.replace(node, str(node.value + 1))
            if node.value:
                self.replace(node, str(node.value - 1))

    def visit_Expr(self, node):
        if isinstance(node.value, ast.Call):
            self.leave_out(node)
        self.generic_visit(node)

    def visit_AugAssign(self, node):
        self.leave_out(node)
        self.generic_visit(node)

    def visit_Assign(self, node):
        if all(isinstance(each, (ast.Attribute, ast.Subscript)) for each in node.targets):
            self.leave_out(node)
        self.generic_visit(node)

    def leave_out(self, node):
        self.replace(node, LEFT_OUT)

    def replace(self, node, becomes):
        self.found.append((self.places.begin(node), self.places.end(node), becomes))


def is_text(node):
    return isinstance(node, ast.Constant) and isinstance(node.value, (str, bytes))


def mutants(file, text):
    """All mutants of a file, in the order of their places."""
    places = Places(text)
    finder = Finder(places)
    finder.visit(ast.parse(text))
    found = [Mutant(file, places.line(begin), begin, end, text[begin:end], becomes)
             for begin, end, becomes in set(finder.found)]
    return sorted(found, key=lambda mutant: (mutant.begin, mutant.end, mutant.becomes))
