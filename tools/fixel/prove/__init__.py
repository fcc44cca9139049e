# SPDX-License-Identifier: MIT
"""Proofs of what the library's text says.

`fixel prove`: properties of the library's text that hold for every input. `prove.py` has the options and `proving.py` does the
work: the rows side by side, then the table of all functions. `rows.py` reads the rows in the comments of `host_tests/proofs`, `functions.py` finds every
function of the shipped text, `provers.py` fetches the provers. `cbmc.py` proves a row by CBMC, `others.py` by Z3, by Gappa or by
running every input, `recomputed.py` by computing a constant again, with the numbers of `exact.py`. `bugs.py` and `mutants.py` show that rows fail where the library is wrong.
"""
