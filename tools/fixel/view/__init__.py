# SPDX-License-Identifier: MIT
"""The live window: its server, its board, its reference renderer, and a browser for its test.

`view.py` and `record.py` are the commands `fixel view` and `record`. `view_server.py` serves
the page, `view_guard.py` says to whom, `view_board.py` runs the board, `view_window.py` has its frames, and `view_reference.py` draws the
same pose in double precision. `view_own.py` builds and runs a program of the user's own. `view_drawing.py` has the page that draws in the browser, and compiles what is dropped on it. `browser.py` opens the page for tests and
recordings."""
