# SPDX-License-Identifier: MIT
"""What controllers of displays make of their wires, written from their data sheets: ST7789, ILI9341 and ST7735 in
RGB565, SSD1306 and SH1106 in black and white. The drivers are in lib/screen; neither was made from the other.
"""

import numpy

from fixel.base.errors import ToolError

UNWRITTEN = 0xDEAD  # a colour of the noise in a controller's memory when power comes
REST = 120          # milliseconds that a controller wants after a reset, and after it was woken


def require(holds, sentence):
    """Every rule of a data sheet."""
    if not holds:
        raise ToolError(f"the wires of the display: {sentence}", exit_code=1)


class Colour:
    """A controller of MIPI's commands, in pixels of RGB565. columns, rows: of its memory, upright."""

    def __init__(self, columns, rows):
        self.size = (columns, rows)
        self.asleep, self.on, self.inverted = True, False, False
        self.format, self.access = 0x66, 0      # after reset: 18 bits
        self.rested = self.awake_for = 0        # milliseconds
        self.command, self.arguments = None, b""
        self._turn(0)

    def _turn(self, access):
        """Rows become columns by bit 5."""
        columns, rows = self.size[::-1] if access & 0x20 else self.size
        if access & 0x20 != self.access & 0x20 or not hasattr(self, "memory"):
            self.memory = numpy.full((rows, columns), UNWRITTEN, numpy.uint16)
            self.window = [(0, columns - 1), (0, rows - 1)]
        self.access = access

    def pause(self, milliseconds):
        self.finish()
        if self.asleep:
            self.rested += milliseconds
        else:
            self.awake_for += milliseconds

    def take_command(self, data):
        self.finish()
        require(len(data) == 1, f"{len(data)} bytes come as one command")
        self.command = data[0]

    def take_data(self, data):
        require(self.command is not None, "data come without a command")
        self.arguments += data

    def finish(self):
        """Does the last command, whose data are there."""
        if self.command is not None:
            self._do(self.command, self.arguments)
        self.command, self.arguments = None, b""

    def _do(self, command, data):
        if command == 0x01:
            self.asleep, self.on, self.inverted, self.rested, self.awake_for = True, False, False, 0, 0
        elif command == 0x11:
            require(self.rested >= REST, "it is woken too early after the reset")
            self.asleep = False
        elif command in (0x20, 0x21):
            self.inverted = command == 0x21
        elif command == 0x29:
            require(not self.asleep and self.awake_for >= REST, "it is turned on too early")
            self.on = True
        elif command in (0x2A, 0x2B):
            self._set_window(command - 0x2A, data)
        elif command == 0x2C:
            self._write(data)
        elif command in (0x36, 0x3A):
            require(len(data) == 1, f"command {command:#x} has {len(data)} bytes of data")
            if command == 0x36:
                self._turn(data[0])
            else:
                self.format = data[0]
        else:
            require(False, f"there is no command {command:#x}")

    def _set_window(self, axis, data):
        require(len(data) == 4, "a window has four bytes an axis")
        first, last = numpy.frombuffer(data, ">u2").tolist()
        require(first <= last < self.memory.shape[1 - axis], f"the window {first}..{last} is beyond its memory")
        self.window[axis] = (first, last)

    def _write(self, data):
        (left, right), (top, bottom) = self.window
        shape = (bottom - top + 1, right - left + 1)
        require(self.format == 0x55, "pixels come before it was told that they have 16 bits")
        require(len(data) == 2 * shape[0] * shape[1], "the pixels do not fill their window, whole and once")
        self.memory[top:bottom + 1, left:right + 1] = numpy.frombuffer(data, ">u2").reshape(shape)

    def picture(self):
        """What the glass shows: pixels of RGB565."""
        require(self.on, "it was never turned on")
        return self.memory.copy()


class Pages:
    """A controller of pages of eight rows. columns: of its memory, of which the glass shows 128 in the middle."""

    WIDTH, PAGES = 128, 8
    TWO_BYTES = frozenset([0x20, 0x81, 0x8D, 0xA8, 0xAD, 0xD3, 0xD5, 0xD9, 0xDA, 0xDB])  # commands with an argument
    PLAIN = frozenset([0x40, 0xA0, 0xA1, 0xA4, 0xA6, 0xA7, 0xC0, 0xC8])                  # those that it must know

    def __init__(self, columns):
        self.memory = numpy.full((self.PAGES, columns), 0xA5, numpy.uint8)
        self.page = self.column = 0
        self.on = False

    def pause(self, milliseconds):
        """It needs none."""

    def finish(self):
        """Every command is done when it comes."""

    def take_command(self, data):
        commands = iter(data)
        for command in commands:
            if command in self.TWO_BYTES:
                require(next(commands, None) is not None, f"command {command:#x} lacks its argument")
            elif command < 0x10:
                self.column = self.column & 0xF0 | command
            elif command < 0x20:
                self.column = self.column & 0x0F | (command & 15) << 4
            elif 0xB0 <= command < 0xB0 + self.PAGES:
                self.page = command & 7
            elif command & 0xFE == 0xAE:
                self.on = command == 0xAF
            else:
                require(command in self.PLAIN, f"there is no command {command:#x}")

    def take_data(self, data):
        require(self.column + len(data) <= self.memory.shape[1], "bytes come behind the last column")
        self.memory[self.page, self.column:self.column + len(data)] = numpy.frombuffer(data, numpy.uint8)
        self.column += len(data)

    def picture(self):
        """What the glass shows: pixels of 0 and 1."""
        require(self.on, "it was never turned on")
        left = (self.memory.shape[1] - self.WIDTH) // 2
        shown = self.memory[:, None, left:left + self.WIDTH] >> numpy.arange(8, dtype=numpy.uint8)[None, :, None] & 1
        return shown.reshape(8 * self.PAGES, self.WIDTH)


# Of each driver of the library: a controller when power comes.
MODELS = {"st7789": lambda: Colour(240, 320), "ili9341": lambda: Colour(240, 320), "st7735": lambda: Colour(128, 160),
          "ssd1306": lambda: Pages(128), "sh1106": lambda: Pages(132)}


def is_mono(driver):
    """Whether a driver's controller is black and white."""
    return isinstance(MODELS[driver](), Pages)
