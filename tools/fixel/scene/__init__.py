# SPDX-License-Identifier: MIT
"""From a scene file to a scene image: objects, places, motions, paths, colours, textures, light, trees.

For `fixel build`, `export`, `texture` and all commands that take a scene. `command.py` has the commands of scenes, `fixel info` too, which
`summary.py` prints. `making.py` starts a process under limits, in which `compiler.py` compiles; other commands that take a scene have
their image of it, and their options of `scene_options.py`. `keys.py` has the keys of a scene file, and the modules `toml_*.py` read its tables. `tree*.py`
build BSP trees. `framing.py` frames a model without a scene file, `look.py` has the options of how it looks, and `toml_table.py` writes it
as a scene file. `image_cut.py` finds what faces show of an image, `corner_normals.py` the normals at their corners."""
