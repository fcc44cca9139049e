# SPDX-License-Identifier: MIT
"""What frames cost: counted instructions, cycles, sizes, stacks, predictions, and the comparison of clippers.

The commands `fixel bench`, `bench-diff`, `clippers`, `costs`, `predict`, `profile` and `size` have the modules of their names.
`bench_plan.py` reads what is measured, and `bench_run.py` measures it by `counter.py`. The modules `clippers_*.py` do the same
for the comparison of clippers. `frame_costs.py` has what `predict` predicts from. `stack.py` and `linked_size.py` find stack
and sizes.
"""
