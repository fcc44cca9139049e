# SPDX-License-Identifier: MIT
"""The site: a page that draws, and all documents.

`fixel docs`, of `docs.py`, writes the Markdown of the tree as pages, with the reference of the public functions and types:
`reference.py` has Doxygen read the headers. `fixel site`, of `site.py`, writes these and the first page, whose scenes
`firmware/web` draws as WebAssembly; `costs.py` says what their frames cost, and `gallery.py` writes a page for each, for the programs of examples/, which
`programs.py` compiles, and for the models of make showcase. `pages.py` fills the templates. `packing.py` says how large the site is, and packs its pictures.
`tools/templates/site.*` and `walk.mjs` are the page, which the live window serves too: `tools/fixel/view/view_drawing.py`.
"""
