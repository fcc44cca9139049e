# SPDX-License-Identifier: MIT
"""What GDB prints for the library's fixed-point numbers and angles: a decimal number, and the stored integer in brackets.
GDB itself runs this file, as make gdb asks it to; print/r shows the stored integer alone."""

import gdb.printing

BINARY_PLACES = {"fxl_q16_16": 16, "fxl_q2_30": 30, "fxl_q1_31": 31, "fxl_q18_46": 46}
ANGLE = "fxl_angle"


def text_of(name, stored):
    """The words for a stored integer of the type of this name."""
    if name == ANGLE:
        turned = stored - (1 << 32) if stored >= 1 << 31 else stored
        return f"{turned * 360 / (1 << 32):.6g} degrees [{stored:#010x}]"
    return f"{stored / (1 << BINARY_PLACES[name]):.10g} [{stored}]"


class Printer:
    def __init__(self, value):
        self.name, self.value = value.type.unqualified().name, value

    def to_string(self):
        return text_of(self.name, int(self.value))


def printer_of(value):
    """GDB asks for each value; None: GDB prints it without help."""
    name = value.type.unqualified().name
    return Printer(value) if name in BINARY_PLACES or name == ANGLE else None


gdb.printing.register_pretty_printer(None, printer_of, replace=True)
