# SPDX-License-Identifier: MIT
"""Scene images: written, read and checked; scenes and fonts as C."""
