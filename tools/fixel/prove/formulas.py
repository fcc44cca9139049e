# SPDX-License-Identifier: MIT
"""Formulas of rows of Z3 and Gappa as C, so that a program of an enumeration gives both them and the function the same inputs.

What such a row's text defines, (define-fun NAME () ...) or NAME = ...;, is an expression of its variables. `header` writes each as a
macro PREFIX_NAME, where PREFIX is the harness's name after enumerate_, and variables of the same names stand in the harness. Of Gappa's claim
{ what is assumed -> what holds } there are PREFIX_assumed and PREFIX_holds. Integers have 128 bits, reals 113.
"""

import re

from fixel.base.errors import ToolError

INCLUDE = '#include "formula.h"'
TOKEN = re.compile(r"[()]|[^\s()]+")
JOINED = {"+": " + ", "*": " * ", "and": " && ", "or": " || "}
COMPARED = {"=": "==", "<=": "<=", "<": "<", ">=": ">=", ">": ">"}
CALLED = {"div": "floor_of", "mod": "floor_rest"}
STATEMENT = re.compile(r"(@?\w+) = ([^;{}]+);")
ROUNDED = {"fixed<0, dn>": "round_down", "fixed<0, up>": "round_up"}
# Of an expression of Gappa: 2^n, another number, a name, the bars of a magnitude.
PART = re.compile(r"1b(?P<power>-?\d+)|(?P<number>\d+(?:\.\d+)?(?:e-?\d+)?)|(?P<name>[A-Za-z_]\w*)|\|(?P<magnitude>[^|]+)\|")


def _nested(words):
    """The next expression of a list of tokens, which it takes out."""
    word = words.pop(0)
    if word != "(":
        return word
    found = []
    while words[0] != ")":
        found.append(_nested(words))
    words.pop(0)
    return found


def _name(name):
    return name.replace("-", "_")


def _integer(expression, own):
    """C of an expression of Z3. own: {a defined name: its macro}."""
    if isinstance(expression, str):
        if not expression.isdigit():
            return own.get(expression, _name(expression))
        number = int(expression)
        return f"((wide){number >> 62} * ((wide)1 << 62) + {number & (1 << 62) - 1})" if number >> 63 else f"(wide){number}"
    head, *rest = expression
    parts = [_integer(each, own) for each in rest]
    if head in JOINED:
        return f"({JOINED[head].join(parts)})"
    if head == "-":
        return f"(-{parts[0]})" if len(parts) == 1 else f"({' - '.join(parts)})"
    if head in COMPARED:
        return "(" + " && ".join(f"{a} {COMPARED[head]} {b}" for a, b in zip(parts, parts[1:])) + ")"
    if head in CALLED:
        return f"{CALLED[head]}({', '.join(parts)})"
    if head == "not":
        return f"(!{parts[0]})"
    if head == "=>":
        return f"(!{parts[0]} || {parts[1]})"
    if head == "ite":
        return f"({parts[0]} ? {parts[1]} : {parts[2]})"
    raise ToolError(f"no C is known for '({head} ...' of a formula of Z3")


def of_z3(text, prefix):
    """[(macro, C)] of what a text of Z3 defines."""
    words, found, own = TOKEN.findall(re.sub(r";.*", "", text)), [], {}
    while words:
        each = _nested(words)
        if each[0] == "define-fun":
            own[each[1]] = f"{prefix}_{_name(each[1])}"
            found.append((own[each[1]], _integer(each[4], own)))
    return found


def _real(expression, own):
    """C of an expression of Gappa."""
    def part(found):
        if found["power"]:
            return f"0x1p{found['power']}Q"
        if found["magnitude"]:
            return f"magnitude_of({_real(found['magnitude'], own)})"
        return f"{found['number']}{'' if re.search('[.e]', found['number']) else '.0'}Q" if found["number"] else own.get(found["name"], found["name"])

    return f"({PART.sub(part, ' '.join(expression.split()))})"


def _split(text, sign):
    """The parts between signs that stand in no brackets."""
    parts, depth, begin = [], 0, 0
    for place, letter in enumerate(text):
        depth += (letter in "([") - (letter in ")]")
        if depth == 0 and text.startswith(sign, place):
            parts.append(text[begin:place])
            begin = place + len(sign)
    return [*parts, text[begin:]]


def _claim(text, own):
    """C of a claim of Gappa."""
    text = text.strip()
    first, *then = _split(text, "->")
    if then:
        return f"(!{_claim(first, own)} || {_claim('->'.join(then), own)})"
    several = _split(text, "/\\")
    if len(several) > 1:
        return f"({' && '.join(_claim(each, own) for each in several)})"
    within = re.fullmatch(r"(.*?) in \[([^,]*),([^\]]*)\]", text, re.S)
    if within:
        a, low, high = (_real(each, own) for each in within.groups())
        return f"({a} >= {low} && {a} <= {high})"
    compared = re.fullmatch(r"(.*?)\s*(<=|>=)\s*(.*)", text, re.S)
    if text.startswith("(") and (not compared or "->" in text):
        return _claim(text[1:-1], own)
    if not compared:
        raise ToolError(f"no C is known for '{text}' of a formula of Gappa")
    return f"({_real(compared[1], own)} {compared[2]} {_real(compared[3], own)})"


def of_gappa(text, prefix):
    """[(macro, C)] of what a text of Gappa defines and claims."""
    text = re.sub(r"#.*", "", text)
    found, own = [], {}
    for name, value in STATEMENT.findall(text.partition("{")[0]):
        if name.startswith("@"):
            own[name[1:]] = ROUNDED[value]
        else:
            expression = _real(value, own)
            own[name] = f"{prefix}_{name}"
            found.append((own[name], expression))
    first, *then = _split(text.partition("{")[2].partition("}")[0], "->")
    return [*found, (f"{prefix}_assumed", _claim(first, own)), (f"{prefix}_holds", _claim("->".join(then), own))]


def header(rows, formulas):
    """The text of formula.h for a file's rows. formulas: {id: a row of Z3 or Gappa}."""
    out = []
    for row in rows:
        if row.formula:
            if row.formula not in formulas:
                raise ToolError(f"{row.id}: no row of Z3 or Gappa of its folder has the id '{row.formula}'")
            source = formulas[row.formula]
            made = (of_z3 if source.tool == "z3" else of_gappa)(source.program, row.harness.removeprefix("enumerate_"))
            out += [f"#define {name} {text}" for name, text in made]
    return "\n".join(dict.fromkeys(out)) + "\n"
