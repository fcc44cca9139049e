# SPDX-License-Identifier: MIT
"""What every tool uses: errors, files, child processes, limits, progress, tables.

`errors.py` turns an error into one sentence and an exit code. `output.py` and `placing.py` put files and folders in place,
`reading.py` reads input, `scratch.py` has temporary folders, and `children.py` starts other programs. `limits.py` and
`bounded.py` limit their time and memory. `interpreter.py` starts a command by the Python of `.venv`. `make.py`, of `fixel
make`, has the options that variables of `make` become; `before.py` looks at them before set-up. `foreign.py` knows the formats
of files that no tool reads. `completion.py` is `fixel completion`. `version.py` reads the project's version.
"""
