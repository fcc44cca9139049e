# SPDX-License-Identifier: MIT
"""What tests the project: unit tests, seeded bugs, mutants, kills, frozen frames."""
