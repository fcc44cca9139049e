# SPDX-License-Identifier: MIT
"""What frames cost: counted instructions, cycles, sizes, stacks, predictions, and the comparison of clippers.

What frames cost, for `fixel bench`, `bench-diff`, `clippers`, `costs`, `predict`, `profile` and `size`. The command has
the module of its name; `bench_report.py`, `baseline.py`, `clippers_report.py`, `costs_renewal.py`, `prediction.py`,
`profiling.py` and `sizes.py` do its work. `bench_plan.py` reads what is measured, and `bench_run.py` measures it by
`counter.py`. The modules `clippers_*.py` do the same for the comparison of clippers. `frame_costs.py` has what
`predict` predicts from. `stack.py`, `linked_size.py` and `program_sizes.py` find stack and sizes.
"""
