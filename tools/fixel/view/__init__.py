# SPDX-License-Identifier: MIT
"""The live window: its server, its board, its reference renderer, and a browser for its test."""
