# SPDX-License-Identifier: MIT
"""What every tool uses: errors, files, child processes, limits, progress, tables."""
