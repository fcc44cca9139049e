# SPDX-License-Identifier: MIT
"""Model files and meshes: OBJ, glTF, STL, built-in solids, and what is done with their faces.

For `fixel build`, `export` and `run`. `model_file.py` chooses the reader of a file, and refuses what holds something else than its name says:
`obj.py` with `obj_materials.py` and `mtl.py`, `gltf.py` with the modules `gltf_*.py`, `stl.py`, `ply.py` with `ply_tables.py`.
`model_text.py` reads the lines and numbers of texts, `sources.py` finds the files that they name. `suffixes.py` knows formats by their
names' endings; other formats are in `base/foreign.py`. `solids.py` has the built-in solids. `mesh.py` is what all of them give;
`simplify.py`, `t_junctions.py`, `merge.py`, `clusters.py` and others change it."""
