# SPDX-License-Identifier: MIT
"""What frames cost: counted instructions, cycles, sizes, stacks, predictions, and the comparison of clippers."""
