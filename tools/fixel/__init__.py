# SPDX-License-Identifier: MIT
"""What Fixel's command-line tools share."""
