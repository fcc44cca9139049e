# SPDX-License-Identifier: MIT
"""What others build Fixel from: the library in one file, and packages.

`fixel one-file`, of `one_file.py`, writes the library as `fixel.h` and `fixel.c`, joined from `lib/`.
`private_names.py` finds the names that a source has for itself, which must not meet in one file.

`fixel packages`, of `packages.py`, writes the packages of Arduino, PlatformIO, ESP-IDF, Zephyr, Conan and Rust into
`build/packages`, by `layouts.toml`, the one table of what each has. `rust_bindings.py` makes
declarations of Rust of the public headers.

`fixel api-check`, of `api_check.py`, compares the one file with that of the last tag, by abidiff. `fixel release`, of
`release.py`, writes every artefact into `dist`, with the SPDX list of what is in them. `repository.py` asks git.
"""
