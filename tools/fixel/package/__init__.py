# SPDX-License-Identifier: MIT
"""What others build Fixel from: the library in one file, and packages."""
