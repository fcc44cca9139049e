# SPDX-License-Identifier: MIT
"""Model files and meshes: OBJ, glTF, STL, built-in solids, and what is done with their faces.

Model files and meshes, for `fixel build`, `export` and `run`. `model_file.py` chooses the reader of a file: `obj.py`
with `obj_colours.py`, `obj_materials.py` and `mtl.py`, `gltf.py` with
`gltf_check.py`, `gltf_material.py`, `gltf_glow.py` and `gltf_left_out.py`, `stl.py`, `ply.py` with `ply_header.py`, `ply_binary.py`,
`ply_text.py` and `ply_strips.py`. `number_text.py` reads the numbers of text files, `model_text.py`
their lines. `named_file.py` finds the files that they name. `suffixes.py` knows formats by their names' endings, `content.py` by how they begin; other formats are in `base/foreign.py`. `solids.py` has the built-in solids. `mesh.py` is what all of them give;
`mend.py`, `t_junctions.py`, `merge.py`, `clusters.py` and others change it.
"""
