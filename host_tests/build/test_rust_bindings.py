# SPDX-License-Identifier: MIT
"""The declarations of Rust that are made of the public headers: tools/fixel/package/rust_bindings.py."""

import re

import pytest

from fixel.base.errors import ToolError
from fixel.base.version import version
from fixel.package import one_file, rust_bindings

BUILT_PROGRAMS = ()
HEADER = """
#ifdef __cplusplus
extern "C" {
#endif
#define FXL_SMALLEST 12u
#define FXL_LARGEST FXL_CAST(int64_t, FXL_SMALLEST * FXL_UNITS(2) / 5)
#define FXL_CHOSEN (FXL_SMALLEST >= 19 ? 512 : FXL_SMALLEST >= 9 ? 256 : 128)
#define FXL_POLYGON_CAPACITY 32
#define fxl_begin FXL_NAME_WITH(fxl_begin, FXL_POLYGON_CAPACITY)
#define FXL_CALL(x) (x)
typedef int32_t fxl_number; /* a number */
enum { FXL_A = 3, FXL_B, FXL_C = 1u << 5 };
typedef enum { FXL_OK = 0, FXL_E_ONE } fxl_status;
FXL_STATIC_ASSERT(FXL_A == 3, "no");
struct fxl_hidden;
/* A record. */
typedef struct {
    uint8_t few, many[2][FXL_SMALLEST]; /* of a kind */
    /* Flags. */
    bool one : 1;
    bool two : 1;
    union {
        uint32_t in;
        const struct fxl_hidden *const *type;
    };
    fxl_status (*call)(void *user, const uint8_t *bytes, size_t size);
} fxl_record;
typedef struct {
    FXL_ALIGN_8 fxl_number first;
} fxl_aligned;
extern const fxl_record fxl_one, fxl_two;
static inline fxl_number fxl_inline(void) { return 1; }
/* Begins. */
fxl_status fxl_begin(fxl_record *record, const char *names[2], fxl_number);
void fxl_end(void);
const char *fxl_text(fxl_status status);
#ifdef __cplusplus
}
#endif
"""


def declared(header):
    """Its lines without documentation."""
    return [line.strip() for line in rust_bindings.Bindings(header).text().splitlines() if not line.strip().startswith("//")]


@pytest.mark.parametrize("line", [
    "pub const FXL_SMALLEST: u32 = 12;", f"pub const FXL_LARGEST: i64 = {12 * 131072 // 5};", "pub const FXL_CHOSEN: u32 = 256;",
    "pub type fxl_number = i32;", "pub const FXL_B: u32 = 4;", "pub const FXL_C: u32 = 32;", "pub type fxl_status = c_uint;",
    "pub few: u8,", "pub many: [[u8; 12]; 2],", "pub bits_2: u8,", "pub anonymous_3: fxl_record_anonymous_3,", "pub union fxl_record_anonymous_3 {",
    "pub r#in: u32,", "pub r#type: *const *const fxl_hidden,",
    'pub call: Option<unsafe extern "C" fn(user: *mut c_void, bytes: *const u8, size: usize) -> fxl_status>,',
    "#[repr(C, align(8))]", "pub struct fxl_hidden {", "pub static fxl_two: fxl_record;", '#[link_name = "fxl_begin_for_polygons_of_32"]',
    "pub fn fxl_begin(record: *mut fxl_record, names: *mut *const c_char, _2: fxl_number) -> fxl_status;", "pub fn fxl_end();",
    "pub fn fxl_text(status: fxl_status) -> *const c_char;"])
def test_what_c_becomes(line):
    assert line in declared(HEADER)


def test_what_is_left_out():
    text = "\n".join(declared(HEADER))
    assert "fxl_inline" not in text and "FXL_CALL" not in text and "pub two" not in text and text.count("bits_") == 1


def test_comments_stand_where_they_belong():
    text = rust_bindings.Bindings(HEADER).text()
    assert "/// of a kind\n    pub many" in text or "/// of a kind\n    pub few" in text
    assert "/// Flags.\n    pub bits_2" in text and "    /// Begins.\n    #[link_name" in text and "/// A record.\n#[repr(C)]" in text


@pytest.mark.parametrize("text", ["fxl_number one = 3;", "enum { FXL_A = sizeof(int) };", "void fxl_sort(int (*less)(int a));"])
def test_what_it_does_not_know_is_a_sentence(text):
    with pytest.raises(ToolError, match="the bindings of Rust do not know"):
        rust_bindings.Bindings(text)


def test_the_headers_are_read_whole():
    header = one_file.header_text(version())
    bindings = rust_bindings.Bindings(header)
    code = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    functions = set(re.findall(r"^(?!static|typedef)[a-z][\w \*]*?\b(fxl_\w+)\([^;{}]*\);", code, re.MULTILINE))
    assert {name for name, _, _, _ in bindings.functions} == functions and len(functions) > 100
    records = {name for name in re.findall(r"^\} (fxl_\w+);", code, re.MULTILINE) if name not in bindings.plain or name in bindings.records}
    assert records <= set(bindings.records)
    assert bindings.constants.values["FXL_COORDINATE_MAX"] == 8191 * 65536 and bindings.constants.values["FXL_STATUS_COUNT"] == 25
    c, rust = bindings.layouts()
    counted = int(re.search(r"\[u32; (\d+)\]", rust)[1])
    assert counted == c.count("sizeof(") + c.count("offsetof(") == rust.count("size_of::<") + rust.count("offset_of!(")
