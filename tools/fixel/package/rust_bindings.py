# SPDX-License-Identifier: MIT
"""The public headers as declarations of Rust: the text of fixel-sys/src/bindings.rs.

It reads the C that fixel.h consists of, and no more: records, unions, enumerations, functions, constants and macros of integers. What
it does not know ends it with a sentence. Comments become documentation. Macros with arguments and inline functions are left out.
"""

import re

from fixel.base.errors import ToolError

TOKEN = re.compile(r"""(?P<comment>/\*.*?\*/)|(?P<directive>^[ \t]*\#(?:\\\n|[^\n])*)|(?P<word>\w+)|(?P<string>"[^"]*")|(?P<mark>\S)""",
                   re.DOTALL | re.MULTILINE | re.VERBOSE)
SCALARS = {"void": "c_void", "bool": "bool", "char": "c_char", "int": "c_int", "size_t": "usize", "uintptr_t": "usize",
           **{f"{sign}int{bits}_t": f"{'u' if sign else 'i'}{bits}" for sign in ("u", "") for bits in (8, 16, 32, 64)}}
KEYWORDS = {"type", "in", "move", "ref", "self", "use", "where", "loop", "match", "fn", "box", "mod", "final", "as", "impl"}
PREFIXES = {"FXL_COLD", "FXL_HERE", "FXL_ALIGN_8", "extern", "static", "struct", "union"}
MACRO = re.compile(r"#\s*define\s+(\w+)[ \t]+(.*)", re.DOTALL)
HEAD = """// SPDX-License-Identifier: MIT
// Generated from fixel.h by "make packages". Change the header.

use core::ffi::{c_char, c_uint, c_void};
"""
# The macros with arguments that constants are made with.
CALLS = {"FXL_CAST": lambda kind, value: value, "FXL_UNITS": lambda n: n * 65536}


class Constants:
    """The macros and enumerators that are integers, by name."""

    def __init__(self):
        self.values, self.types = dict(CALLS), {}

    def value(self, text):
        """The value of an expression; None if it is no integer."""
        words = re.sub(r"\b(0[xX][0-9a-fA-F]+|\d+)[uUlL]*\b", r"\1", text.replace("\\\n", " ").replace("/", "//"))
        try:
            found = eval(ternary(words), {"__builtins__": {}}, Names(self.values))
        except Exception:       # no expression of integers
            return None
        return int(found) if isinstance(found, int) else None

    def add(self, name, value, kind="u32"):
        self.values[name], self.types[name] = value, kind


class Names(dict):
    """Names of types stand as the first argument of FXL_CAST, and have no value."""

    def __missing__(self, name):
        if name.endswith("_t") or name.startswith("fxl_"):
            return None
        raise KeyError(name)


def ternary(text):
    """a ? b : c of C as Python has it."""
    text = text.strip()
    if text.startswith("(") and text.endswith(")") and "?" in text:
        return f"({ternary(text[1:-1])})"
    if "?" not in text:
        return text
    test, _, rest = text.partition("?")
    yes, _, no = rest.partition(":")
    return f"({yes}) if ({test}) else ({ternary(no)})"


def tokens(text):
    """(kind, text) of each token. A comment behind something on its line is "behind"."""
    found = []
    for each in TOKEN.finditer(text):
        before = text[text.rfind("\n", 0, each.start()) + 1:each.start()]
        found.append(("behind" if each.lastgroup == "comment" and before.strip() else each.lastgroup, each[0]))
    return found


def documentation(comment, indent=""):
    """A comment as lines of ///."""
    if not comment:
        return ""
    lines = [re.sub(r"^\s*\*? ?", "", line).strip() for line in comment[2:-2].strip().splitlines()]
    return "".join(f"{indent}/// {line}".rstrip() + "\n" for line in lines)


class Bindings:
    """Reads a header; `text` is what it makes of it."""

    def __init__(self, header):
        self.constants, self.links, self.out = Constants(), {}, []
        self.places = {}        # of each record: what C calls it
        self.records, self.opaque, self.functions, self.statics, self.plain = {}, {}, [], [], set()
        self.skipping = 0
        self.read(tokens(header))

    # --- the header ----------------------------------------------------------------------------

    def read(self, found):
        comment, statement, depth, start = "", [], 0, ""
        for kind, text in found:
            if kind == "directive":
                self.directive(text.strip())
            elif self.skipping:
                continue
            elif kind in ("comment", "behind"):
                if statement:
                    statement.append((kind, text))
                elif kind == "comment":
                    comment = text
            else:
                if not statement:
                    start, comment = comment, ""
                statement.append((kind, text))
                depth += (text in "({[") - (text in ")}]") if kind == "mark" else 0
                if depth == 0 and text in ";}" and self.ends(statement):
                    self.statement(statement, start)
                    statement = []

    @staticmethod
    def ends(statement):
        """Whether a statement is whole: its semicolon, or the end of an inline function."""
        words = [text for kind, text in statement if kind not in ("comment", "behind")]
        return words[-1] == ";" or ("inline" in words)

    def directive(self, text):
        """Leaves out what is for C++ alone; takes macros of integers."""
        if re.match(r"#\s*if(def|ndef)?\b", text):
            self.skipping += bool(self.skipping or re.match(r"#\s*ifdef\s+(__cplusplus|FXL_SMALL)|#\s*if\s+defined", text))
        elif re.match(r"#\s*endif", text):
            self.skipping = max(0, self.skipping - 1)
        elif re.match(r"#\s*else", text) and self.skipping == 1:
            self.skipping = 0       # the other branch; its #endif closes nothing
        elif not self.skipping and (macro := MACRO.match(text)):
            self.macro(macro[1], re.sub(r"/\*.*?\*/", "", macro[2]).strip())

    def macro(self, name, text):
        if named := re.match(r"FXL_NAME_WITH\((\w+), FXL_POLYGON_CAPACITY\)", text):
            self.links[name] = f"{named[1]}_for_polygons_of_{self.constants.values['FXL_POLYGON_CAPACITY']}"
        elif (value := self.constants.value(text)) is not None:
            cast = re.match(r"FXL_CAST\((\w+),", text)
            self.constant(name, value, cast[1] if cast else "u32" if 0 <= value < 1 << 32 else "i64")

    def constant(self, name, value, kind):
        self.constants.add(name, value, kind)
        self.out.append(f"pub const {name}: {SCALARS.get(kind, kind)} = {value};\n")

    # --- a statement ---------------------------------------------------------------------------

    def statement(self, statement, comment):
        words = [text for kind, text in statement if kind not in ("comment", "behind")]
        if "inline" in words or words[0] in (";", "FXL_STATIC_ASSERT", "}"):
            return
        if words[0] == "typedef" and words[1] in ("struct", "union") and words[2] != "{" and words[3] not in ("{",):
            self.opaque.setdefault(words[2], comment)       # typedef struct X X;
        elif words[0] in ("struct", "union") and len(words) == 3:
            self.opaque.setdefault(words[1], comment)
        elif words[0] == "enum" or words[:2] == ["typedef", "enum"]:
            self.enumeration(statement, comment, words[-2] if words[0] == "typedef" else "")
        elif "{" in words and ("struct" in words[:2] or "union" in words[:2]):
            name = words[-2] if words[0] == "typedef" else words[1]
            body = statement[[text for _, text in statement].index("{") + 1:]
            self.record(name, "union" if "union" in words[:2] else "struct", body, comment)
        elif words[0] == "typedef" and "(" in words:
            self.out.append(f"{documentation(comment)}pub type {words[words.index('(') + 2]} = {self.pointer_to_function(words[1:-1])[1]};\n")
        elif words[0] == "typedef":
            name, kind, _ = self.declarators(words[1:-1])[0]
            self.out.append(f"{documentation(comment)}pub type {name} = {kind};\n")
            self.plain.add(name)
        elif words[0] == "extern":
            self.statics += [(name, kind, comment) for name, kind, _ in self.declarators(words[1:-1])]
        elif "(" in words and words[-2] == ")":
            self.function(words[:-1], comment)
        else:
            raise ToolError(f"the bindings of Rust do not know this: {' '.join(words)}")

    def enumeration(self, statement, comment, name):
        if name:
            self.out.append(f"{documentation(comment)}pub type {name} = c_uint;\n")
            self.plain.add(name)
        words = [text for kind, text in statement if kind not in ("comment", "behind")]
        value = -1
        for entry in " ".join(words[words.index("{") + 1:words.index("}")]).split(","):
            if entry.strip():
                enumerator, _, stated = entry.partition("=")
                value = self.constants.value(re.sub(r"\s*<\s*<\s*", "<<", stated)) if stated else value + 1
                if value is None:
                    raise ToolError(f"the bindings of Rust do not know the value of {entry.strip()}")
                self.constant(enumerator.strip(), value, "u32")

    def function(self, words, comment):
        opening = words.index("(")
        kind = self.declarators([*words[:opening - 1], "result"])[0][1]
        parameters = self.parameters(words[opening + 1:-1])
        self.functions.append((words[opening - 1], parameters, "" if kind == "c_void" else f" -> {kind}", comment))

    # --- types ---------------------------------------------------------------------------------

    def parameters(self, words):
        if words in ([], ["void"]):
            return []
        found = []
        for index, part in enumerate(split(words)):
            if "(" in part:
                raise ToolError(f"the bindings of Rust do not know this parameter: {' '.join(part)}")
            part = part if part[-1] != "]" else [*part[:part.index("[") - 1], "*", part[part.index("[") - 1]]
            if len([word for word in part if word not in ("const", "struct", "*")]) == 1:
                part = [*part, f"_{index}"]
            found.append(self.declarators(part)[0][:2])
        return found

    def pointer_to_function(self, words):
        """(name, type) of kind (*name)(parameters)."""
        opening = words.index("(")
        result = self.declarators([*words[:opening], "result"])[0][1]
        name, rest = words[opening + 2], words[opening + 5:-1]
        kinds = ", ".join(f"{each}: {kind}" for each, kind in self.parameters(rest))
        return rust_name(name), f"Option<unsafe extern \"C\" fn({kinds}){'' if result == 'c_void' else f' -> {result}'}>"

    def declarators(self, words):
        """[(name, type, bits)] of a declaration without its semicolon. bits: of a bit-field, or 0."""
        for place, word in enumerate(words[:-1]):
            if word == "struct":
                self.opaque.setdefault(words[place + 1], "")       # a tag that is nowhere declared is opaque
        words = [word for word in words if word not in PREFIXES]
        constant = "const" in words[:2]
        words = [word for word in words if word != "const"] if "*" not in words else words
        base = next(word for word in words if word != "const")
        rest, found = words[words.index(base) + 1:], []
        for part in split(rest):
            kind, is_const = SCALARS.get(base, base), constant
            while part and part[0] in ("*", "const"):
                if part[0] == "*":
                    kind, is_const = f"*{'const' if is_const else 'mut'} {kind}", False
                else:
                    is_const = True
                part = part[1:]
            bits = int(part[2]) if ":" in part else 0
            for length in reversed(re.findall(r"\[ ([^\]]*) \]", " ".join(part))):
                kind = f"[{kind}; {self.constants.value(length)}]"
            found.append((rust_name(part[0]), kind, bits))
        return found

    # --- records -------------------------------------------------------------------------------

    def record(self, name, kind, body, comment):
        """A struct or a union; records and unions within it become types of their own, and bit-fields one byte."""
        members, derives = self.members(name, body), kind == "struct"
        self.records[name] = [member for member, _, _ in members]
        self.places.setdefault(name, name)
        lines = "".join(f"{documentation(note, '    ')}    pub {member}: {type_of},\n" for member, type_of, note in members)
        plain = derives and all(self.is_plain(type_of) for _, type_of, _ in members)
        if plain:
            self.plain.add(name)
        # An alignment is the record's own where it is that of the first member.
        aligned = ", align(8)" if "FXL_ALIGN_8" in [text for kind_of, text in body if kind_of == "word"][:1] else ""
        self.out.append(f"{documentation(comment)}#[repr(C{aligned})]\n#[derive(Clone, Copy{', Debug, PartialEq, Eq' if plain else ''})]\n"
                        f"pub {kind} {name} {{\n{lines}}}\n")

    def is_plain(self, kind):
        base = re.sub(r"^\[+|; \d+\].*$", "", kind)
        return base.startswith("*") or base in SCALARS.values() or base in self.plain

    def members(self, name, body):
        members, statement, depth, note, bits = [], [], 0, "", 0
        for kind, text in body:
            if kind == "comment":
                note = note or text
            elif kind == "behind" and members and not statement:
                members = [*members[:-1], (*members[-1][:2], members[-1][2] or text)]
            if kind in ("comment", "behind"):
                if statement:
                    statement.append((kind, text))
                continue
            if text == "}" and depth == 0:
                break
            statement.append((kind, text))
            depth += (text in "{(") - (text in "})")
            if text == ";" and depth == 0:
                new = self.member(name, statement, len(members))
                if any(width for _, _, width in new):
                    new = [] if bits else [(f"bits_{len(members)}", "u8", 0)]
                    bits = True
                else:
                    bits = False
                members += [(member, type_of, note) for member, type_of, _ in new]
                statement, note = [], ""
        return members

    def member(self, name, statement, index):
        words = [text for kind, text in statement if kind not in ("comment", "behind")][:-1]
        if "{" in words:
            statement = [each for each in statement if each[0] not in ("comment", "behind")]
            inner = words[-1] if words[-1] != "}" else f"anonymous_{index}"
            self.places[f"{name}_{inner}"] = f"(({name} *)0)->{inner}"
            self.record(f"{name}_{inner}", words[0], statement[words.index("{") + 1:], "")
            return [(rust_name(inner), f"{name}_{inner}", 0)]
        return [(*self.pointer_to_function(words), 0)] if "(" in words else self.declarators(words)

    # --- what is written -----------------------------------------------------------------------

    def text(self):
        opaque = [f"{documentation(comment)}#[repr(C)]\npub struct {name} {{\n    _private: [u8; 0],\n}}\n"
                  for name, comment in self.opaque.items() if name not in self.records]
        statics = [f"{documentation(comment, '    ')}    pub static {name}: {kind};\n" for name, kind, comment in self.statics]
        functions = [f"{documentation(comment, '    ')}" + (f'    #[link_name = "{self.links[name]}"]\n' if name in self.links else "") +
                     f"    pub fn {name}({', '.join(f'{each}: {kind}' for each, kind in parameters)}){result};\n"
                     for name, parameters, result, comment in self.functions]
        return "\n".join([HEAD, *self.out, *opaque, 'unsafe extern "C" {\n' + "\n".join(statics + functions) + "}\n"])

    def layouts(self):
        """(C, Rust): a table of the sizes and places of all records as each compiler has them, and a test that compares the two."""
        ours, theirs = [], []
        for name, members in self.records.items():
            place = self.places[name]
            if "anonymous" in place or place.startswith("((") and not place.startswith("((fxl_"):
                continue        # the record around it has its size
            ours.append(f'("{name}", size_of::<{name}>())')
            theirs.append(f"sizeof({place})")
            for member in members if place == name else []:
                if not member.startswith(("bits_", "anonymous_")):
                    ours.append(f'("{name}.{member}", offset_of!({name}, {member}))')
                    theirs.append(f"offsetof({name}, {member.removeprefix('r#')})")
        c = ('/* SPDX-License-Identifier: MIT */\n#include "fixel/all.h"\n#include <stddef.h>\n\nextern const uint32_t fixel_sys_layouts[];\n'
             "const uint32_t fixel_sys_layouts[] = {\n" + "".join(f"    {each},\n" for each in theirs) + "};\n")
        rust = ("//! Sizes and places of all records, as the C compiler has them. Generated.\n// SPDX-License-Identifier: MIT\n\n"
                "use core::mem::{offset_of, size_of};\nuse fixel_sys::*;\n\nunsafe extern \"C\" {\n"
                f"    static fixel_sys_layouts: [u32; {len(ours)}];\n}}\n\n#[test]\nfn records_are_those_of_c() {{\n"
                f"    let ours: [(&str, usize); {len(ours)}] = [\n" + "".join(f"        {each},\n" for each in ours) +
                "    ];\n    let theirs = unsafe { &fixel_sys_layouts };\n    for ((name, own), c) in ours.iter().zip(theirs) {\n"
                '        assert_eq!(*own, *c as usize, "{name}");\n    }\n}\n')
        return c, rust


def split(words):
    """Words between commas outside of brackets."""
    parts, depth = [[]], 0
    for word in words:
        depth += (word in "([") - (word in ")]")
        if word == "," and depth == 0:
            parts.append([])
        else:
            parts[-1].append(word)
    return parts


def rust_name(name):
    return f"r#{name}" if name in KEYWORDS and name != "self" else name
