# SPDX-License-Identifier: MIT
"""Lists the fuzzer's corpus, or adds an input to it, with a hash of what the library answers to it.

    fixel corpus                                     how many inputs each harness has
    fixel corpus --harness NAME                      the inputs of one: name, bytes, hash of the answers
    fixel corpus --harness NAME --add FILE           adds a file to the harness's archive, and a line to its record
    fixel corpus --harness NAME --unpack FOLDER      writes the inputs as files, for a fuzzer of your choice

An archive, host_tests/fuzz/corpus/NAME.zip, is the same bytes on every machine: inputs in the order of their names, not
compressed, without times, owners and permissions. The name of an input is the SHA-1 of its bytes, as libFuzzer names it.
The archive is replaced before the record. If the command is killed in between, the same command adds the line.
Exit: 0 done, 1 the library fails on the input, or answers otherwise than the record says, 2 refused. After 1 and 2 nothing
was changed.
"""

import argparse
import hashlib
import io
import os
import pathlib
import zipfile

from fixel.base import children, output, reading, scratch
from fixel.base.errors import ToolError, one_line
from fixel.base.table import table

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
CORPUS = CHECKOUT / "host_tests" / "fuzz" / "corpus"
RECORDS = CHECKOUT / "host_tests" / "fuzz" / "record"
HARNESSES = {"scene": 8192, "pipeline": 4096}     # and the longest input in bytes
MOMENT = (1980, 1, 1, 0, 0, 0)      # the first that a ZIP archive can say
UNIX, READABLE = 3, 0o644 << 16     # the system and the permissions that each entry is said to have
WORDS_MAX = 200                     # characters of what a failed harness said


def relative(path):
    """A path as one types it in the checkout."""
    return os.path.relpath(path, CHECKOUT)


# --- an archive ----------------------------------------------------------------

def archive_of(harness):
    return CORPUS / f"{harness}.zip"


def name_of(content):
    """The name of an input."""
    return hashlib.sha1(content, usedforsecurity=False).hexdigest()


def pack(inputs):
    """The bytes of the archive of {name: content}."""
    blob = io.BytesIO()
    with zipfile.ZipFile(blob, "w", zipfile.ZIP_STORED) as archive:
        for name in sorted(inputs):
            entry = zipfile.ZipInfo(name, MOMENT)
            entry.create_system, entry.external_attr = UNIX, READABLE
            archive.writestr(entry, inputs[name])
    return blob.getvalue()


def read(file):
    """{name: content} of an archive."""
    try:
        with zipfile.ZipFile(file) as archive:
            names = archive.namelist()
            inputs = {name: archive.read(name) for name in names}
    except FileNotFoundError:
        return {}
    except (OSError, ValueError, EOFError, NotImplementedError, RuntimeError, zipfile.BadZipFile) as error:
        raise _damaged(file, str(error)) from error
    if len(inputs) < len(names):
        raise _damaged(file, "two of its inputs have one name")
    for name, content in inputs.items():
        if name != name_of(content):
            raise _damaged(file, f"{one_line(name)} is not the SHA-1 of that input")
    return inputs


def _damaged(file, words):
    return ToolError(f"{relative(file)}: is no archive of inputs ({words}); take it from git again")


def write(file, inputs):
    output.write_file(file, pack(inputs))


def unpack(inputs, folder):
    """Writes inputs as files of a folder; their paths, in the order of their names."""
    folder = pathlib.Path(folder)
    output.make_folder(folder)
    for name, content in inputs.items():
        if not (folder / name).exists():
            output.write_file(folder / name, content)
    return [folder / name for name in sorted(inputs)]


def unpacked(harness, build):
    """The folder below the build folder with the inputs of the corpus, and nothing else."""
    folder, inputs = pathlib.Path(build) / "fuzz" / "inputs" / harness, read(archive_of(harness))
    unpack(inputs, folder)
    for path in folder.iterdir():
        if path.name not in inputs:
            path.unlink()
    return folder


# --- the record of answers ------------------------------------------------------

def record_of(harness):
    return RECORDS / f"{harness}.txt"


def read_record(harness):
    """{name of an input: hash}."""
    file = record_of(harness)
    return dict(line.split() for line in file.read_text(encoding="ascii").splitlines()) if file.exists() else {}


def with_answers(harness, answers):
    """The record and these answers, of which none may be another than that on record."""
    old = read_record(harness)
    other = sorted(name for name in answers if old.get(name, answers[name]) != answers[name])
    if other:
        raise ToolError(f"{relative(record_of(harness))}: the answers to {len(other)} inputs are others now, the first is "
                        f"{other[0]}: where that is meant, remove their lines", exit_code=1)
    return {**old, **answers}


def write_record(harness, answers):
    """Makes these answers the record, and says what that adds and removes."""
    old, file = read_record(harness), record_of(harness)
    output.write_file(file, "".join(f"{name} {answers[name]}\n" for name in sorted(answers)))
    print(f"{relative(file)}: {len(set(answers) - set(old))} added, {len(set(old) - set(answers))} removed, {len(answers)} in all")


def replayed(harness, build, files):
    """{name of a file: hash of what the library answers to it now}."""
    program = pathlib.Path(build) / "host" / "fuzz" / f"replay_{harness}"
    try:
        done = children.run([program, *files], text=True, errors="replace", cwd=CHECKOUT)
    except OSError as error:
        raise ToolError(f"{program}: cannot be started ({error.strerror}); make corpus builds it") from error
    if done.returncode:
        words = next((line for line in done.stderr.splitlines() if "rror:" in line or "does not hold" in line),
                     f"{program.name} ended with {done.returncode}")
        raise ToolError(f"the library fails: {one_line(words[:WORDS_MAX])}", exit_code=1)
    return dict(line.split() for line in done.stdout.splitlines())


def add_records(build):
    """The inputs of the corpus that have no line get one; lines of no input go."""
    for harness in HARNESSES:
        answers = replayed(harness, build, sorted(unpacked(harness, build).iterdir()))
        record = with_answers(harness, answers)
        write_record(harness, {name: record[name] for name in answers})


# --- the command -----------------------------------------------------------------

def add(harness, file, build):
    """Adds a file to the corpus of a harness, and the answers to its record."""
    most = HARNESSES[harness]
    content = reading.read_whole(file, most, f"the harness {harness} reads no longer input")
    name, inputs, record = name_of(content), read(archive_of(harness)), read_record(harness)
    if name in inputs and name in record:
        raise ToolError(f"{file}: {relative(archive_of(harness))} has this input already, as {name}")
    with scratch.folder("corpus") as folder:
        record = with_answers(harness, replayed(harness, build, unpack({name: content}, folder)))
    inputs[name] = content
    write(archive_of(harness), inputs)
    print(f"{relative(archive_of(harness))}: {name} of {len(content)} bytes, {len(inputs)} inputs in all")
    write_record(harness, record)


def print_harnesses():
    """How many inputs each harness has."""
    rows = []
    for harness in HARNESSES:
        inputs = read(archive_of(harness))
        rows.append([harness, len(inputs), sum(map(len, inputs.values())), len(read_record(harness))])
    print(table(rows, ["harness", "inputs", "bytes", "on record"]))


def print_inputs(harness):
    """A line for each input of a harness."""
    record = read_record(harness)
    print("\n".join(f"{name} {len(content):5} {record.get(name, 'not on record')}"
                    for name, content in sorted(read(archive_of(harness)).items())))


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--harness", choices=list(HARNESSES), help="whose corpus")
    made.add_argument("--add", metavar="FILE", help="an input to add")
    made.add_argument("--unpack", metavar="FOLDER", help="a folder to write the inputs into, as files")
    made.add_argument("--build", default="build", help="folder of the programs")
    return made


def before(options):
    """Refuses inputs of no harness, and a file that is not there."""
    if (options.add or options.unpack) and not options.harness:
        raise ToolError(f"--harness is missing: whose corpus? One of {', '.join(HARNESSES)}")
    if options.add:
        reading.open_regular(options.add)[0].close()


def main(argv):
    options = parser().parse_args(argv)
    before(options)
    build = pathlib.Path(options.build).resolve()
    if options.add:
        add(options.harness, options.add, build)
    if options.unpack:
        print(f"{options.unpack}: {len(unpack(read(archive_of(options.harness)), options.unpack))} inputs")
    if not (options.add or options.unpack):
        print_inputs(options.harness) if options.harness else print_harnesses()
    return 0
