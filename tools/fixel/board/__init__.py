# SPDX-License-Identifier: MIT
"""Programs that run: emulated boards and the host, their flash, displays, dumps, debuggers and probes."""
