# SPDX-License-Identifier: MIT
"""How a tool fails: one clear sentence on stderr and a non-zero exit.

What exit codes mean, for every tool:
  0       done
  1       the result is bad: frames differ, verification failed, a test failed,
          the emulator ended without the program's code
  2       refused: an argument, a file, a missing program; nothing was changed
  10..50  a board's program ended with that code (boards/contract/system.h)
  124     a board's program hung: nothing new came within its limit of CPU time
  129, 130, 143  ended by SIGHUP, SIGINT (Ctrl-C), SIGTERM
  134     the core locked up
  141     what read its output has ended (SIGPIPE, as of any Unix tool): "fixel ... | head"
"""

import os
import select
import signal
import sys
import time

from fixel.base import children, interpreter, placing, scratch

ENDINGS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
ONCE_MORE = 0.01    # seconds
BEAT = 0.5          # seconds
LAST = 60.0         # seconds in which a tool ends that was told to


def printable(text):
    """Lines of another program as they are printed: whatever controls a terminal is escaped."""
    return "".join(c if c == "\n" else escaped(c) for c in text)


def one_line(text):
    """A file's name, or a message with names, as it is printed: line breaks are escaped too."""
    return "".join(map(escaped, str(text)))


def escaped(character):
    """A character as it is, or its escape if it has no picture."""
    return character if character.isprintable() else character.encode("unicode_escape").decode()


def _print_anything():
    """A file's name need not be text in the terminal's encoding: what cannot be printed is escaped."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")


class ToolError(Exception):
    """What was wrong, where, and what to do about it: one line. words: of another program, such as a compiler, in lines."""

    def __init__(self, message, exit_code=2, words=""):
        super().__init__(f"{message}\n{words}" if words else message)
        self.message, self.exit_code, self.words = message, exit_code, words

    def with_words(self, words):
        """The same error, with more words of another program."""
        return ToolError(self.message, self.exit_code, "\n".join(filter(None, (self.words, words))))

    def shown(self):
        """The message as it is printed."""
        return one_line(self.message) + (f"\n{printable(self.words)}" if self.words else "")


class Ended(KeyboardInterrupt):
    """A signal ended the tool."""

    def __init__(self, number):
        super().__init__()
        self.number = number


_told = None        # (number of the signal that ended the tool, when)


def _end(number, _frame):
    global _told
    _told = _told or (number, time.monotonic())
    children.end_all()
    raise Ended(number)


def _heed_lost(unraisable):
    """Python ignores what is raised in a destructor. If a signal comes just there, it comes once more."""
    if not isinstance(unraisable.exc_value, Ended):
        sys.__unraisablehook__(unraisable)
        return
    number = unraisable.exc_value.number
    signal.signal(signal.SIGALRM, lambda _, frame: _end_once_more(number, frame))
    signal.setitimer(signal.ITIMER_REAL, ONCE_MORE, BEAT)


def _end_once_more(number, frame):
    """What is raised within _heed_lost would be lost too: on a busy machine it may take longer than ONCE_MORE."""
    while frame is not None:
        if frame.f_code is _heed_lost.__code__:
            signal.setitimer(signal.ITIMER_REAL, ONCE_MORE, BEAT)
            return
        frame = frame.f_back
    signal.signal(signal.SIGALRM, _tick)
    _end(number, None)


def _tick(_number, _frame):
    """Python asks for signals before a system call and where one interrupts it. One that comes between the two is
    heeded when the call ends, perhaps after minutes; so each wait is interrupted now and then, and goes on.

    What a signal raises may also leave a lock of Python's own held, for which the clearing up then waits for ever. So
    a tool that was told to end ends at last without it: the next command removes what it leaves."""
    if _told and time.monotonic() - _told[1] > LAST:
        os._exit(128 + _told[0])


def _begin():
    """What every tool does first: it ends with make, ends its children with itself, and removes what others
    left, or puts it back. A signal that the caller had ignored, as nohup does, stays ignored."""
    _print_anything()
    if "MAKELEVEL" in os.environ:
        children.follow_parent()
    for number in ENDINGS:
        if signal.getsignal(number) in (signal.SIG_DFL, signal.default_int_handler):
            signal.signal(number, _end)
    sys.unraisablehook = _heed_lost
    signal.signal(signal.SIGALRM, _tick)
    signal.setitimer(signal.ITIMER_REAL, BEAT, BEAT)
    for sentence in scratch.remove_left_over(placing.mend):
        print(f"note: {one_line(sentence)}", file=sys.stderr)


def _finish():
    """Whoever is impatient now would leave something behind. Python, as it ends, gives up each handler: a timer
    that still ran would kill it."""
    for number in (*ENDINGS, signal.SIGALRM):
        signal.signal(number, signal.SIG_IGN)
    signal.setitimer(signal.ITIMER_REAL, 0)


def _is_unread(stream):
    """Whether nobody is left who could read what is written to a stream."""
    asked = select.poll()
    asked.register(stream, 0)
    return bool(asked.poll(0))


def _flush():
    """That nobody reads the output is known here, not when Python ends. Of a full disk Python tells as it ends."""
    try:
        if sys.stdout is not None:
            sys.stdout.flush()
    except OSError as error:
        if isinstance(error, BrokenPipeError):
            raise


def _end_unread():
    """Nobody reads the output any more. What is left of it goes nowhere, without a word. The exit code."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())
    os.close(nowhere)
    return 128 + signal.SIGPIPE


def _run(main):
    """The exit code of a tool's main(argv). argparse leaves it by SystemExit, after help or a refusal."""
    try:
        code = main(sys.argv[1:])
    except SystemExit as leaving:
        code = leaving.code
        # argparse of Python 3.11.2 says that nobody reads the help; that of 3.11.7 and later ones passes over it.
        if not code and sys.stdout is not None and _is_unread(sys.stdout.fileno()):
            raise BrokenPipeError from None
    _flush()
    return code


def run_main(main):
    """Runs a tool's main(argv) -> exit code and turns ToolError into a sentence."""
    try:
        _begin()
        code = _run(main)
    except BrokenPipeError:
        if not _is_unread(sys.stdout.fileno()):
            raise       # another pipe, and a mistake of the tool
        code = _end_unread()
    except ToolError as error:
        print(f"error: {error.shown()}", file=sys.stderr)
        code = error.exit_code
    except OSError as error:
        if not interpreter.lacks_files(error):
            raise
        print(f"error: {interpreter.LACKING}", file=sys.stderr)
        code = 2
    except (KeyboardInterrupt, ImportError) as error:
        if isinstance(error, ImportError) and not _told:
            raise       # else a module that was being imported has answered the signal so, as numpy does
        number = _told[0] if _told else getattr(error, "number", signal.SIGINT)
        print("interrupted" if number == signal.SIGINT else f"ended by {signal.Signals(number).name}", file=sys.stderr)
        code = 128 + number
    finally:
        _finish()
    sys.exit(code)
