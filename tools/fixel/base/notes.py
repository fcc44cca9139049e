# SPDX-License-Identifier: MIT
"""What there is to say of a file that was read."""


class Usual(str):
    """A note that is the same for every file, or for nearly every file of a format: it is told with -v alone."""


def told(notes, all_of_them):
    """The notes that are told. all_of_them: whether -v asks for the usual ones too."""
    return [note for note in notes if all_of_them or not isinstance(note, Usual)]
