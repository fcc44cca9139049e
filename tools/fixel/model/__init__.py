# SPDX-License-Identifier: MIT
"""Model files and meshes: OBJ, glTF, STL, built-in solids, and what is done with their faces."""
