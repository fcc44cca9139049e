# SPDX-License-Identifier: MIT
"""The table of make prove: each function of the library has a row or is measured, each row has its harness. No prover runs."""

import pathlib
import re

import pytest

from conftest import CHECKOUT
from fixel.base.errors import ToolError
from fixel.prove import cbmc, exact, formulas, functions, mutants, others, prove, proving, recomputed, rows

BUILT_PROGRAMS = ()
ARITH = """/* lib/math/arith.h:40:NC */ extern uint32_t fxl_divide_u64 (uint64_t, uint32_t, uint32_t *);
/* lib/draw/../math/arith.h:80:NF */ static int64_t fxl_round_shift (int64_t, unsigned int);
/* lib/math/arith.c:35:NF */ extern uint32_t fxl_divide_u64 (uint64_t, uint32_t, uint32_t *);
/* lib/raster/fill.c:9:NF */ static const uint8_t *(*row_of (void)) (const struct row *, int);
"""


@pytest.fixture(scope="module")
def all_functions():
    return functions.find(CHECKOUT)


def test_names_are_read_from_what_the_compiler_writes():
    found = [functions.LINE.match(line) for line in ARITH.splitlines()]
    assert [bool(each) for each in found] == [False, True, True, True]
    assert [functions.name_in(each[3]) for each in found if each] == ["fxl_round_shift", "fxl_divide_u64", "row_of"]


def test_every_room_s_functions_are_found(all_functions):
    assert all_functions["lib/math/arith.c:fxl_divide_u64"] is True
    assert all_functions["lib/math/arith.c:divide_digit"] is False
    assert all_functions["lib/math/arith.h:fxl_round_shift"] is False
    assert {key.split("/")[1] for key in all_functions} == set(functions.ROOMS)
    assert not [key for key in all_functions if ".." in key]


def test_every_row_and_what_is_measured_is_a_function():
    """Those that are proved within others are known only when the provers ran: they are in neither list."""
    every = rows.read(CHECKOUT)
    own, (measured, wrong) = {row.function for row in every if row.is_whole}, rows.measured(CHECKOUT)
    assert not wrong
    assert not own & set(measured)
    known = functions.find(CHECKOUT)
    assert not (own | set(measured)) - set(known), "there is no such function any more"


def test_documents_have_the_numbers_of_the_table(all_functions, tmp_path, monkeypatch):
    """What neither a row proves nor a list names as measured is proved within a row: make prove fails otherwise."""
    every, measured = rows.read(CHECKOUT), set(rows.measured(CHECKOUT)[0])
    own = {row.function for row in every if row.is_whole}
    external = {key for key, is_external in all_functions.items() if is_external}
    entries, wrong = proving.state_of_assembly(CHECKOUT)
    assert not wrong
    kernels = {kernel for each in entries for kernel in each["by"]}
    numbers = [*(len(every) for _ in range(2)), sum(row.tool == "cbmc" for row in every), sum(row.checks for row in every if row.tool == "cbmc"),
               len(all_functions), len(own), len(set(all_functions) - own - measured), len(measured),
               len(external), len(external & own), len(external - own - measured), len(external & measured),
               len(entries), len({each["entry"].partition(":")[0] for each in entries}), len(kernels)]
    monkeypatch.setattr(functions, "find", lambda root: all_functions)
    assert proving.numbers(CHECKOUT) == (numbers, len(all_functions), len(all_functions) - len(measured))
    (tmp_path / "docs").mkdir()
    for name in ("SOUNDNESS.md", "docs/evidence.md"):
        (tmp_path / name).write_text(re.sub(r"\d", "0", (CHECKOUT / name).read_text(encoding="utf-8")), encoding="utf-8")
    proving.renew_numbers(tmp_path, *proving.numbers(CHECKOUT))
    for root in (CHECKOUT, tmp_path):
        said = re.search(r"it printed: (.*?) All rows take", (root / "SOUNDNESS.md").read_text(encoding="utf-8"), re.S)[1]
        assert [int(number.replace(",", "")) for number in re.findall(r"\b[\d,]*\d\b", said)] == numbers, "fixel prove --numbers writes them"
        evidence = (root / "docs/evidence.md").read_text(encoding="utf-8")
        assert f"{len(all_functions) - len(measured):,} of the {len(all_functions):,} functions of `lib/`" in " ".join(evidence.split())


def test_every_row_has_its_harness_and_its_checks_on_record():
    for row in rows.read(CHECKOUT):
        assert row.checks > 0, f"{row.id}: fixel prove --tidy writes them down"
        if row.tool == "cbmc":
            harness = re.search(rf"^void {row.harness}\(void\)\n{{\n(.*?)\n}}", row.place.read_text(encoding="utf-8"), re.M | re.S)
            assert harness[1].rstrip().endswith("PROOF_ENDS();"), row.id


# Rows in which a conversion may change a value: none is added, and one that needs it no more is taken out.
NARROWS = {"fxl_billboard_find_texels", "fxl_fraction", "fxl_is_rotation", "fxl_project_inside",
           "next_row_of_chains", "show_any"}


def test_conversions_keep_values_but_in_rows_that_are_named():
    every = [each for each in rows.read(CHECKOUT) if each.tool == "cbmc"]
    assert {each.id for each in every if each.narrows} == NARROWS
    assert {each.id for each in every if "--conversion-check" not in cbmc._checks(each)} == NARROWS
    assert not [each.id for each in every if "conversion" in " ".join(each.flags)]


def test_few_functions_are_exempt_from_the_check_of_conversions():
    exempt = []
    for path in sorted((CHECKOUT / "lib").rglob("*.[ch]")):
        text = path.read_text(encoding="utf-8")
        assert path.name == "core.h" or "#pragma CPROVER" not in text, path
        for part in re.findall(r'check disable "conversion"\n#endif\n(.*?)#ifdef FXL_PROVE\n#pragma CPROVER check pop', text, re.S):
            exempt += re.findall(r"^static inline \w+ (\w+)\(", part, re.M)
    assert exempt == ["fxl_low_8", "fxl_low_16", "fxl_low_32", "fxl_bits_32", "fxl_bits_64", "fxl_signed_32", "fxl_signed_64",
                      "fxl_multiply_s64", "fxl_multiply_s64_u16"]


SAYS_SIZE = re.compile(r"up to|\btwo\b|\bthree\b|\bruns of|\bof \d+ |\b\d+ (?:points|corners)|any paint|the same")


def small_tables(text, harness):
    """{static table: its entries, 2 to 16} of those that a harness uses, itself or by functions of its text."""
    sizes = {name: int(value) for name, value in re.findall(r"^#define (\w+) +(\d+)\b", text, re.M)}
    bodies = {found[1]: found[2] for found in re.finditer(r"^\w.*?\b(\w+)\([^;{]*\)\n\{\n(.*?)\n\}", text, re.M | re.S)}
    reached, waiting = set(), [harness]
    while waiting:
        name = waiting.pop()
        if name in bodies and name not in reached:
            reached.add(name)
            waiting += re.findall(r"\b(\w+)\(", bodies[name])
    used = set(re.findall(r"\w+", " ".join(bodies[name] for name in reached)))
    tables = {name: sizes.get(size, int(size) if size.isdigit() else 0) for name, size in re.findall(r"^static [\w ]*?(\w+)\[(\w+)\];", text, re.M)}
    return {name: size for name, size in tables.items() if name in used and 2 <= size <= 16}


def test_sentences_of_rows_say_how_large_their_tables_are():
    tables = (CHECKOUT / rows.PROOFS / "scene/scene_tables.h").read_text(encoding="utf-8")
    some = [row for row in rows.read(CHECKOUT) if row.tool == "cbmc"]
    texts = {path: path.read_text(encoding="utf-8") for path in {row.place for row in some}}
    texts = {path: (tables if "scene_tables.h" in text else "") + text for path, text in texts.items()}
    bounded = [row for row in some if small_tables(texts[row.place], row.harness)]
    assert len(bounded) > 50
    assert not [(row.id, row.property) for row in bounded if not SAYS_SIZE.search(row.property)]


def test_every_harness_has_a_row():
    named = {(row.place, row.harness) for row in rows.read(CHECKOUT)}
    harnesses = {(path, name) for path in rows.files(CHECKOUT) if path.suffix == ".c"
                 for name in re.findall(r"^void ((?:prove|enumerate)_\w+)\(void\)$", path.read_text(encoding="utf-8"), re.M)}
    assert len(harnesses) > 300
    assert not harnesses - named


def test_contracts_that_are_used_are_proved_without_a_circle():
    assert rows.circles(rows.read(CHECKOUT)) == []
    assert rows.lemmas(CHECKOUT, rows.read(CHECKOUT)) == []


def test_transcriptions_are_of_functions_as_they_are_and_run_beside_them():
    every = rows.read(CHECKOUT)
    for row in every:
        others.check_texts(CHECKOUT, row) if row.tool in ("z3", "gappa") else None
    assert not rows.unrun(every)


def test_a_function_that_changed_fails_what_was_written_from_it_until_somebody_accepts_it(tmp_path):
    """Comments and white space are no change."""
    source = tmp_path / "lib/math/a.c"
    source.parent.mkdir(parents=True)
    text = "static int a(int x)\n{\n    return x + 1; /* one */\n}\n\nstatic int b(int x)\n{\n    return x;\n}\n"
    source.write_text(text, encoding="utf-8")
    of = {f"lib/math/a.c:{name}": functions.text_of(tmp_path, f"lib/math/a.c:{name}") for name in "ab"}
    listed = ", ".join(f'"{name}" = "{known}"' for name, known in of.items())
    path = harness_file(tmp_path, f'; [[row]]\n; function = "lib/math/a.c:a"\n; property = "p"\n; of = {{ {listed} }}\n\n(text)\n', "equations.smt2")
    others.check_texts(tmp_path, rows.rows_of(path)[0])
    source.write_text(text.replace("/* one */", "").replace("    return x;", "  return\n    x;"), encoding="utf-8")
    others.check_texts(tmp_path, rows.rows_of(path)[0])
    source.write_text(text.replace("return x;", "return -x;"), encoding="utf-8")
    with pytest.raises(cbmc.Failed, match="b of lib/math/a.c has changed .*--accept --only 'a'"):
        others.check_texts(tmp_path, rows.rows_of(path)[0])
    rows.accept(tmp_path, rows.rows_of(path), functions.text_of)
    others.check_texts(tmp_path, rows.rows_of(path)[0])
    assert "million inputs" in rows.unrun(rows.rows_of(path))[0]


def test_hashes_are_renewed_of_named_rows_alone():
    with pytest.raises(ToolError, match="--only"):
        prove.before(prove.parser().parse_args(["--accept"]))


def test_a_lemma_of_which_no_row_of_z3_speaks_is_named(tmp_path):
    (tmp_path / "lib/math").mkdir(parents=True)
    (tmp_path / "lib/math/a.c").write_text("int a(int x)\n{\n    FXL_LEMMA(x > 1);\n    return x;\n}\n", encoding="utf-8")
    assert rows.lemmas(tmp_path, [])[0].startswith("lib/math/a.c:a ")
    assert not rows.lemmas(tmp_path, [row("a", tool="z3", of={"lib/math/a.c:a": ""})])


@pytest.mark.parametrize("text, wanted", [
    ("(define-fun a () Int (- (* 2 x) (div y 3) 1)) (define-fun b-c () Int (ite (<= 0 a 5) (mod a 2) (- a)))",
     {"p_a": "(((wide)2 * x) - floor_of(y, (wide)3) - (wide)1)", "p_b_c": "(((wide)0 <= p_a && p_a <= (wide)5) ? floor_rest(p_a, (wide)2) : (-p_a))"}),
    ("(define-fun a () Bool (=> (= x y z) (or (not (< x 18446744073709551616)) (> x 1)))) (assert a)",
     {"p_a": "(!(x == y && y == z) || ((!(x < ((wide)4 * ((wide)1 << 62) + 0))) || (x > (wide)1)))"}),
])
def test_formulas_of_z3_as_c(text, wanted):
    assert dict(formulas.of_z3(text, "p")) == wanted


def test_formulas_of_gappa_as_c():
    text = "@down = fixed<0, dn>;\nd = down(z * 1b-3); # a\ne = d / 2 + 0.5;\n{ z in [1, 1b30] /\\ |e| <= 2 -> (d >= 0 -> e in [-1, d]) /\\ e / z <= 1 }\ne -> d;\n"
    assert dict(formulas.of_gappa(text, "p")) == {
        "p_d": "(round_down(z * 0x1p-3Q))", "p_e": "(p_d / 2.0Q + 0.5Q)",
        "p_assumed": "(((z) >= (1.0Q) && (z) <= (0x1p30Q)) && ((magnitude_of((p_e))) <= (2.0Q)))",
        "p_holds": "((!((p_d) >= (0.0Q)) || ((p_e) >= (-1.0Q) && (p_e) <= (p_d))) && ((p_e / z) <= (1.0Q)))"}


def test_constants_are_what_their_formulas_give():
    """No prover is needed, so this is done whenever the tests are."""
    for row in rows.read(CHECKOUT):
        if row.tool == "recomputed":
            assert recomputed.prove(None, CHECKOUT, row, None)["checks"] == row.checks, row.id


def test_rows_state_results_of_functions_as_they_are():
    """The record of fixel prove --mutants is of today's text, and no seed has fewer than four of five."""
    kept = mutants.load(CHECKOUT)
    assert len(kept) >= 12
    for function, entry in kept.items():
        assert entry["text"] == functions.text_of(CHECKOUT, function), f"{function} has changed: fixel prove --mutants --only {function}"
        assert len(entry["noticed"]) == len(mutants.SEEDS) and min(entry["noticed"]) >= mutants.LEAST, function


# --- verdicts ------------------------------------------------------------------------------

def said(*results):
    """What cbmc prints. A line may name a file of its own."""
    lines = [f"[f.{number}] {'file lib/b.c ' * (number == 1)}line 3 {words}: {status}" for number, (words, status) in enumerate(results, 1)]
    failed = sum(status == "FAILURE" for _, status in results)
    return "\n".join(["** Results:", "lib/a.c function f", *lines, f"** {failed} of {len(results)} failed (1 iterations)", "VERIFICATION FAILED"])


def test_a_row_is_proved_if_only_its_end_fails():
    assert cbmc.judge(said(("overflow", "SUCCESS"), (cbmc.REACHED, "FAILURE"))) == (1, set())


def test_a_function_counts_only_if_its_end_is_reached():
    """A call that stands under a condition which never holds is none."""
    assert cbmc.judge(said((cbmc.ENDS, "FAILURE"), (cbmc.REACHED, "FAILURE"))) == (0, {"f"})
    assert cbmc.judge(said((cbmc.ENDS, "SUCCESS"), (cbmc.REACHED, "FAILURE"))) == (0, set())


@pytest.mark.parametrize("results, words", [
    ([("overflow", "FAILURE"), (cbmc.REACHED, "FAILURE")], "overflow: failure"),
    ([("overflow", "UNKNOWN"), (cbmc.REACHED, "FAILURE")], "overflow: unknown"),
    ([("overflow", "SUCCESS"), (cbmc.REACHED, "SUCCESS")], "never ends for any input"),
    ([("overflow", "SUCCESS")], "no PROOF_ENDS"),
    ([(cbmc.ENDS, "FAILURE")], "no PROOF_ENDS"),
])
def test_a_row_is_not_proved(results, words):
    with pytest.raises(cbmc.Failed, match=words):
        cbmc.judge(said(*results))


def test_an_end_without_a_verdict():
    with pytest.raises(cbmc.TooLong):
        cbmc.judge("Running propositional reduction\n")
    with pytest.raises(cbmc.Failed, match="Out of memory"):
        cbmc.judge("Out of memory\n")


def row(name, **more):
    return rows.Row(function=f"lib/math/arith.c:{name}", property="", place=pathlib.Path("arith.c"), id=name, **more)


PROGRAM = """
prove_f /* prove_f */
        // 0 file host_tests/proofs/math/arith.c line 3 function prove_f
        CALL prove_f::1::x := f(prove_f::1::x)
     1: CALL gone(prove_f::1::x)
        // 1 file host_tests/proofs/math/arith.c line 4 function prove_f
        END_FUNCTION

f /* f */
        // 2 file lib/math/../view/arith.c line 7 function f
        CALL clear$link1(f::x)
        CALL *f::table.check(f::x)
     2: END_FUNCTION

clear /* clear */
        // 3 file lib/math/arith.c line 9 function clear
        END_FUNCTION

clear$link1 /* clear$link1 */
        // 4 file lib/view/arith.c line 9 function clear
        END_FUNCTION

gone /* gone */
        // 5 file lib/view/arith.c line 19 function gone
        END_FUNCTION

by_pointer /* by_pointer */
        // 6 file lib/view/arith.c line 29 function by_pointer
        END_FUNCTION
"""


def test_only_what_is_called_by_name_is_within_a_row():
    """A function that the harness has in its place is not, and a static function is that of its own file."""
    found, direct = cbmc._within(PROGRAM, row("f", harness="prove_f", stands_in={"gone": "any_gone"}))
    assert {name: place for name, place in found.items() if place[0].startswith("lib/")} == {
        "f": ("lib/view/arith.c", "f"), "clear$link1": ("lib/view/arith.c", "clear")}
    assert direct == set()      # this f is of another file than the row's
    assert cbmc._within(PROGRAM.replace("math/../view", "math"), row("f", harness="prove_f"))[1] == {"clear$link1"}


def test_a_row_fails_whose_function_calls_what_never_comes_back():
    """Unless another case of the row comes back from there. A call under a condition that never holds shows nothing of what is called."""
    once, never = {"checks": 4, "within": [], "lost": []}, {"checks": 4, "within": [], "lost": ["emit_all"]}
    assert "calls emit_all" in proving.failure(row("a"), [(None, never)])
    assert proving._summed(row("a", checks=4), [(None, {**never, "seconds": 1.0})])["state"] == "not proved"
    assert proving.failure(row("a"), [(0, never), (1, once)]) is None
    assert proving.failure(row("a"), [(0, {"failed": "overflow"}), (1, once)]) == "case 0: overflow"


def test_a_contract_without_a_row_and_a_circle_are_found():
    assert rows.circles([row("a", contract=True, uses=["b"])]) == ["a uses the contract of b, which no row proves"]
    both = [row("a", contract=True, uses=["b"]), row("b", contract=True, uses=["a"])]
    assert len(rows.circles(both)) == 2
    assert rows.circles([row("a", contract=True, uses=["a"], induction="on the depth")]) == []


def test_a_lost_check_is_found():
    some = [(None, {"checks": 4, "within": [], "seconds": 1.0})]
    assert proving._summed(row("a", checks=4), some)["state"] == "proved"
    assert proving._summed(row("a", checks=5), some)["state"] == "lost a check"
    assert proving._summed(row("a"), some)["state"] == "no record"
    assert proving._summed(row("a", checks=4), [*some, (2, {"failed": "x", "seconds": 0.0})])["state"] == "not proved"


def test_the_table_says_what_has_no_row():
    result = {"row": "a", "function": "lib/math/arith.c:a", "state": "proved", "tool": "cbmc", "whole": True, "within": ["lib/math/arith.c:b"]}
    every = {f"lib/math/arith.c:{name}": True for name in "abcd"}
    shown, wrong = proving.state_of_all(every, [result], {"lib/math/arith.c:c": ("fuzz", "why")})
    assert [each["state"] for each in shown] == ["proved", "proved within", "measured", "no row"]
    assert len(wrong) == 1 and wrong[0].startswith("lib/math/arith.c:d has no row")
    _, wrong = proving.state_of_all(every, [result], {f"lib/math/arith.c:{name}": ("fuzz", "why") for name in "bcd"})
    assert len(wrong) == 1 and "b is proved within now" in wrong[0]


def test_assembly_that_no_kernel_compares_is_named(tmp_path):
    measured_file(tmp_path, '[assembly]\n"lib/a/b.S" = ["fill"]\n"lib/a/gone.S" = ["fill", "nothing"]\n')
    (tmp_path / "lib/a").mkdir(parents=True)
    for name in "bc":
        (tmp_path / f"lib/a/{name}.S").write_text(f"    .global fxl_{name}\n", encoding="utf-8")
    (tmp_path / "firmware/equality").mkdir(parents=True)
    (tmp_path / "firmware/equality/record.txt").write_text(f"m3 fill {'a' * 12} {'b' * 12} 5\nm0 fill {'a' * 12} {'b' * 12} 7\n", encoding="utf-8")
    entries, wrong = proving.state_of_assembly(tmp_path)
    assert entries == [{"entry": "lib/a/b.S:fxl_b", "by": {"fill": 5}}, {"entry": "lib/a/c.S:fxl_c", "by": {}}]
    assert [words.split()[0] for words in wrong] == ["lib/a/c.S", "measured.toml", "measured.toml:"] and "nothing" in wrong[2]


def test_only_some_tools_show_that_nothing_is_undefined():
    one = {"row": "a", "function": "lib/math/arith.c:a", "state": "proved", "tool": "gappa", "whole": False, "within": []}
    shown, wrong = proving.state_of_all({"lib/math/arith.c:a": True}, [one], {"lib/math/arith.c:a": ("fuzz", "why")})
    assert [each["state"] for each in shown] == ["measured"] and not wrong
    shown, _ = proving.state_of_all({"lib/math/arith.c:a": True}, [{**one, "tool": "enumeration", "whole": True}], {})
    assert shown[0]["state"] == "proved"


# --- other tools ---------------------------------------------------------------------------

@pytest.mark.parametrize("quote, numbers", [
    ("#define A {}u", [31]),
    ("of {} in all", [1.647]),
    ("table[4] = {{*}}", [1, 2, 0x1F, -4]),
    ("bytes:{.byte}", [5, 6, 7]),
])
def test_numbers_are_read_from_a_text(quote, numbers):
    text = "#define A  0x1Fu\n/* it is\n * of 1.647 in all. */\nint table[4] = {\n    T(1), 2u,\n    0x1F, -4};\nbytes:\n    .byte 5, 6\n    .byte 7\n"
    assert recomputed.numbers_of(text, [quote]) == numbers


def test_a_text_that_is_gone_or_twice_fails_a_row():
    for text in ("int b = 1;", "int a = 1; int a = 2;"):
        with pytest.raises(cbmc.Failed, match="and once is wanted"):
            recomputed.numbers_of(text, ["int a = {};"])


def test_exact_numbers():
    assert exact.floor(exact.pi() * 10 ** 40) == 31415926535897932384626433832795028841971
    assert exact.nearest(exact.arctangent(exact.Real(1)) * 4 * 10 ** 40) == exact.nearest(exact.pi() * 10 ** 40)
    assert exact.nearest(exact.tangent(exact.pi() / 4) * 10 ** 40) == 10 ** 40
    assert exact.floor(exact.root(exact.Real(2), 3) * 10 ** 20) == 125992104989487316476
    assert exact.power_below(exact.Real(1, 9)) == 3


@pytest.mark.parametrize("text, words", [
    ("{ x in [0, 1] -> x in ? }", "no goal with a bound"),
    ("{ x in [0, 1] -> x in [0, 1] }\ny -> x / z;\n", "divides"),
])
def test_a_script_of_gappa_that_shows_nothing_is_refused(tmp_path, text, words):
    with pytest.raises(cbmc.Failed, match=words):
        others._gappa(tmp_path, tmp_path, rows.Row(function="f:a", property="", place=tmp_path / "a.gappa", id="a", tool="gappa", program=text))


PROPERTY = ' * property = "p"\n'
HARNESS = " */\nvoid prove_a(void)\n{\n}\n"
ROW = '/* [[row]]\n * function = "a"\n'


def measured_file(folder, text):
    """What is measured, in a checkout that has nothing else."""
    path = folder / rows.MEASURED
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    return path


def harness_file(folder, text, name="arith.c"):
    """A file of harnesses in a checkout that has nothing else."""
    path = folder / rows.PROOFS / "math" / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize("text, words", [
    (ROW + HARNESS, "arith.c:1: 'property' is missing"),
    (ROW + PROPERTY + HARNESS, "arith.c:1: .* where is a"),
    (ROW + PROPERTY + " * unwnd = 3\n" + HARNESS, "unknown 'unwnd'"),
    (ROW + PROPERTY + " * unwind = true\n" + HARNESS, "'unwind' is no int"),
    (ROW.replace('"a', '"f:a') + PROPERTY + " */\nint a;\n", "no harness"),
    (ROW + " * property = p\n" + HARNESS, "cannot be read"),
    ("/*[[row]]\n" + PROPERTY + HARNESS, "a row is a comment of its own"),
])
def test_a_wrong_row_is_refused(tmp_path, text, words):
    harness_file(tmp_path, text)
    with pytest.raises(ToolError, match=words):
        rows.read(tmp_path)


def test_a_row_is_of_the_harness_below_and_of_the_source_above(tmp_path):
    path = harness_file(tmp_path, '#include "math/a.c"\n#include "math/b.h"\n' + ROW + PROPERTY + ' */\n/* [[row]]\n * id = "again"\n * function = "f:a"\n'
                        + PROPERTY + HARNESS + '#include "math/c.c"\n/* [[row]]\n * function = "c"\n' + PROPERTY + HARNESS.replace("_a", "_c"))
    assert [(row.id, row.function, row.harness, row.tool) for row in rows.rows_of(path)] == [
        ("a", "lib/math/a.c:a", "prove_a", "cbmc"), ("again", "f:a", "prove_a", "cbmc"), ("c", "lib/math/c.c:c", "prove_c", "cbmc")]


def test_rows_of_a_prover_have_the_text_below_them(tmp_path):
    one = '; [[row]]\n; function = "f:a"\n; property = "p"\n\n'
    path = harness_file(tmp_path, "; head\n" + one + one.replace(":a", ":b") + "(one)\n" + one.replace(":a", ":c") + "(two)\n", "equations.smt2")
    assert [(row.name, row.tool, row.program) for row in rows.rows_of(path)] == [
        ("a", "z3", "; head\n\n(one)\n"), ("b", "z3", "; head\n\n(one)\n"), ("c", "z3", "; head\n\n(two)\n")]


def test_tidy_takes_out_what_is_proved_and_writes_checks(tmp_path):
    path = measured_file(tmp_path, '[most]\nx = 4\n\n[[measured]]\nby = ["fuzz"]\nwhy = "v"\n[measured.functions]\n"lib/x/f" = "c"\n\n'
                         '[[measured]]\nby = ["fuzz"]\nwhy = "w"\n[measured.functions]\n"lib/x/f" = "a"\n"lib/x/g" = "a b"\n')
    rows.tidy(tmp_path, {"lib/x/f:a", "lib/x/f:c", "lib/x/g:b"})
    assert rows.measured(tmp_path) == ({"lib/x/g:a": ("fuzz", "w")}, [])
    assert path.read_text(encoding="utf-8").count("[[measured]]") == 1
    path.write_text(path.read_text(encoding="utf-8").replace("x = 1", "x = 2"), encoding="utf-8")
    assert "write x = 1" in rows.measured(tmp_path)[1][0]
    path = harness_file(tmp_path, '#include "math/a.c"\n' + ROW + PROPERTY + HARNESS)
    for checks in (7, 8):
        rows.record_checks(tmp_path, {"a": checks})
        assert [each.checks for each in rows.read(tmp_path)] == [checks]
    assert path.read_text(encoding="utf-8").count("checks =") == 1
