# SPDX-License-Identifier: MIT
"""Models of controllers of colours and of greys, written from their data sheets: those of MIPI's commands, and OLEDs that fill
windows by commands of their own. The drivers are in lib/screen; neither was made from the other.
"""

import dataclasses

import numpy

from fixel.base.errors import ToolError

UNWRITTEN = 0xDEAD  # a colour of the noise in a controller's memory when power comes
REST = 120          # milliseconds that a controller wants after a reset, and after it was woken


def require(holds, sentence):
    """Every rule of a data sheet."""
    if not holds:
        raise ToolError(f"the wires of the display: {sentence}", exit_code=1)


@dataclasses.dataclass(frozen=True)
class Glass:
    """How a glass is joined to its controller. columns, rows: of the memory in the mode that the module is wired for.
    left, top: where the glass begins, counted from the side of the memory that is at its upper left when the picture is
    not turned. mirrored: the memory's own columns and rows run against those of the glass."""
    columns: int
    rows: int
    width: int
    height: int
    left: int = 0
    top: int = 0
    mirrored: tuple = (False, False)
    blue_first: bool = False    # its sub-pixels are blue, green, red
    inverted: bool = False      # it shows the complement of what it is sent
    com_pins: int = 0x12        # how the lines of an OLED are joined to the controller
    first_line: int = 0         # of the controller's scanned lines, the first that the glass has
    dark: bool = False          # a bit that is set is dark: an LCD

    def cut(self, memory):
        """The part of a memory that the glass shows, as seen when the picture is not turned."""
        seen = memory[::-1 if self.mirrored[1] else 1, ::-1 if self.mirrored[0] else 1]
        return seen[self.top:self.top + self.height, self.left:self.left + self.width]


class Colour:
    """A controller of MIPI's commands, in pixels of RGB565."""

    WRITE = 0x2C    # the command whose data are pixels
    FORMAT = 0x55   # 16 bits a pixel
    PIXEL_BYTES = 2
    TURNS = (0, 1, 2, 3)    # quarter turns that it can show
    HIGHEST = None          # of greys the highest level; None: RGB565
    UNIT = (1, 1)           # columns and rows that an address has: frames begin with one

    def __init__(self, glass):
        self.glass = glass
        self.memory = numpy.full((glass.rows, glass.columns), UNWRITTEN, numpy.uint16)
        self.asleep, self.on, self.inverted = True, False, False
        self.format, self.access = 0x66, 0      # after reset: 18 bits
        self.rested = self.awake_for = 0        # milliseconds
        self.command, self.arguments = None, b""
        self.window = [(0, glass.columns - 1), (0, glass.rows - 1)]

    def _seen(self):
        """The memory as pixels are written to it: bit 5 exchanges rows and columns, bits 6 and 7 mirror them."""
        seen = self.memory[::-1 if self.access & 0x80 else 1, ::-1 if self.access & 0x40 else 1]
        return seen.T if self.access & 0x20 else seen

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

    @property
    def takes_pixels(self):
        """Whether data that come now are pixels."""
        return self.command == self.WRITE

    @classmethod
    def frame_bytes(cls, width, height, glass):
        """Bytes of a frame on a glass."""
        return cls.PIXEL_BYTES * width * height

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
        elif command == self.WRITE:
            self._write(data)
        elif command in (0x36, 0x3A):
            require(len(data) == 1, f"command {command:#x} has {len(data)} bytes of data")
            if command == 0x36:
                self.access = data[0]
            else:
                self.format = data[0]
        else:
            require(False, f"there is no command {command:#x}")

    def _set_window(self, axis, data):
        require(len(data) == 4, "a window has four bytes an axis")
        first, last = numpy.frombuffer(data, ">u2").tolist()
        require(first <= last < self._seen().shape[1 - axis], f"the window {first}..{last} is beyond its memory")
        self.window[axis] = (first, last)

    def _write(self, data):
        (left, right), (top, bottom) = self.window
        shape = (bottom - top + 1, right - left + 1)
        require(right < self._seen().shape[1] and bottom < self._seen().shape[0], "the window was set for another turn")
        require(self.format == self.FORMAT, f"pixels come before it was told that they have {8 * self.PIXEL_BYTES} bits")
        require(len(data) == self.PIXEL_BYTES * shape[0] * shape[1], "the pixels do not fill their window, whole and once")
        self._seen()[top:bottom + 1, left:right + 1] = self._pixels(data).reshape(shape)

    def _pixels(self, data):
        """The bytes of pixels as RGB565."""
        return numpy.frombuffer(data, ">u2")

    def picture(self, turns=0):
        """What the glass shows whoever turned the module counter-clockwise by quarter turns: pixels of RGB565."""
        require(self.on, "it was never turned on")
        shown = self.glass.cut(self.memory).copy()
        if bool(self.access & 8) != self.glass.blue_first:
            shown = shown << 11 | shown & 0x07E0 | shown >> 11
        return numpy.rot90(~shown if self.inverted != self.glass.inverted else shown, turns)


class Ili9488(Colour):
    """It takes pixels of 18 bits on SPI: a byte a channel, of which it has the upper six bits. The model keeps RGB565, so the
    lowest bit of red and of blue must be the upper one again."""

    FORMAT, PIXEL_BYTES = 0x66, 3

    def _pixels(self, data):
        red, green, blue = (numpy.frombuffer(data, numpy.uint8).reshape(-1, 3) >> 2).astype(numpy.uint16).T
        for channel in (red, blue):
            require((channel & 1 == channel >> 5).all(), "a channel is not a whole part of white")
        return red >> 1 << 11 | green << 5 | blue >> 1


class Gc9a01(Colour):
    """Its B6, which FE and EF unlock, says which way sources and gates are scanned. Libraries disagree on what it does after
    reset, so it must be told. 66 and 67 are in no data sheet: gc9a01_mpy, issue 38, has that there is no picture without them."""

    UNDESCRIBED = {0x66: bytes.fromhex("3C00CD67454510000000"), 0x67: bytes.fromhex("003C0000000154103298")}

    def __init__(self, glass):
        super().__init__(glass)
        self.unlocked, self.scan, self.told = b"", None, set()

    def _do(self, command, data):
        if command in (0xFE, 0xEF):
            self.unlocked += bytes([command])
        elif command == 0xB6:
            require(self.unlocked.endswith(b"\xFE\xEF") and len(data) == 2, "command 0xb6 is locked, or has not two bytes of data")
            self.scan = data[1]
        elif command in self.UNDESCRIBED:
            require(self.unlocked.endswith(b"\xFE\xEF") and data == self.UNDESCRIBED[command], f"register {command:#x} is locked, or set otherwise")
            self.told.add(command)
        else:
            super()._do(command, data)
            if command == 0x01:
                self.unlocked, self.scan, self.told = b"", None, set()

    def picture(self, turns=0):
        require(self.scan is not None, "it was not told which way it scans")
        require(self.told == set(self.UNDESCRIBED), "registers 0x66 and 0x67 were not set: it shows no picture")
        written = self.memory
        self.memory = written[::-1 if self.scan & 0x40 else 1, ::-1 if self.scan & 0x20 else 1]
        shown = super().picture(turns)
        self.memory = written
        return shown


class Gc9107(Colour):
    """FE and EF unlock registers of voltages and of the scan, which the data sheet describes in part. Public drivers send these."""

    UNLOCKED = frozenset([0xB0, 0xB2, 0xB3, 0xB6, 0xB7, 0xAC, 0xAB, 0xB4, 0xA8, 0xB8, 0xE8, 0xE9, 0xEA, 0xC6, 0xC7])

    def __init__(self, glass):
        super().__init__(glass)
        self.unlocked, self.told = b"", set()

    def _do(self, command, data):
        if command in (0xFE, 0xEF):
            self.unlocked += bytes([command])
        elif command in self.UNLOCKED:
            require(self.unlocked.endswith(b"\xFE\xEF") and len(data) == 1, f"register {command:#x} is locked, or has not one byte of data")
            self.told.add(command)
        else:
            super()._do(command, data)
            if command == 0x01:
                self.unlocked, self.told = b"", set()

    def picture(self, turns=0):
        require(self.told == self.UNLOCKED, "its voltages were not set")
        return super().picture(turns)


class Windows(Colour):
    """An OLED that fills windows. ARGUMENTS: of each command, how many it has. Line i of its scan shows the row that lies i behind the
    start line and the offset, and drives pin COM i, or COM N - 1 - i if bit 4 of A0 mirrors the scan, of N lines, the multiplex ratio.
    That bit mirrors no memory."""

    ARGUMENTS = {0x15: 2, 0x75: 2, 0xA0: 1, 0xA1: 1, 0xA2: 1, 0xA4: 0, 0xA5: 0, 0xA6: 0, 0xA7: 0, 0xAE: 0, 0xAF: 0}
    NORMAL = 0xA6       # the command that shows the memory as it is
    LINES = 0xCA        # the command of the multiplex ratio
    LOCKED = frozenset()        # commands that the lock keeps, until OPEN came
    OPEN = 0xB1

    def __init__(self, glass):
        super().__init__(glass)
        self.unlocked, self.start_line, self.offset, self.scan_mirrored, self.lines = False, 0, 0, False, glass.rows    # after reset
        self.shown, self.bits = self.NORMAL, 0

    def _do(self, command, data):
        if command == self.WRITE:
            self._write(data)
            return
        require(len(data) == self.ARGUMENTS.get(command, -1), f"command {command:#x} has {len(data)} bytes of data")
        require(self.unlocked or command not in self.LOCKED, f"command {command:#x} is locked")
        if command == 0xFD:
            self.unlocked = data[0] == self.OPEN
        elif command in (0x15, 0x75):
            self._set_range(int(command == 0x75), *data)
        elif command == 0xA0:
            self.bits, self.scan_mirrored = data[0], bool(data[0] & 0x10)
            self._set_access(*data)
        elif command == 0xA1:
            self.start_line = data[0] & self.glass.rows - 1
        elif command == 0xA2:
            self.offset = data[0]
        elif command in range(0xA4, 0xA8):
            self.shown, self.inverted = command, command == 0xA7
        elif command in (0xAE, 0xAF):
            self.on = command == 0xAF
        elif command == self.LINES:
            self.lines = data[0] + 1

    def _set_range(self, axis, first, last):
        """Columns or rows of the memory, in addresses."""
        require(first <= last < (self.glass.rows if axis else self.glass.columns // self.UNIT[0]), "the window is beyond its memory")
        self.window[axis ^ self.access >> 5 & 1] = (first, last)

    def _set_access(self, bits):
        """Of colours: bits 0 and 1 are 5 and 6 of MIPI's."""
        self.format = 0x55 if bits & 0xC0 == 0x40 else 0
        require(bits & 0x20, "odd and even rows are joined on two sides")
        self.access = (bits & 1) << 5 | (bits & 2) << 5 | (8 if self._is_blue_first(bits) else 0)

    @staticmethod
    def _is_blue_first(bits):
        return bits & 4

    def _rows(self):
        """Which row of the memory each line of the glass shows."""
        pins = numpy.arange(self.glass.first_line, self.glass.first_line + self.glass.height)
        lines = (self.lines - 1 - pins if self.scan_mirrored else pins) + self.offset & self.glass.rows - 1
        require((lines < self.lines).all(), "a line of the glass is not scanned")
        return (self.start_line + lines) % self.glass.rows

    def picture(self, turns=0):
        require(self.shown in (self.NORMAL, 0xA7), "it shows no memory")
        written = self.memory
        self.memory = written[self._rows()]
        shown = self._shown(turns)
        self.memory = written
        return shown

    def _shown(self, turns):
        return super().picture(turns)


class Ssd1351(Windows):
    """Colours; arguments are data."""

    WRITE = 0x5C
    ARGUMENTS = Windows.ARGUMENTS | {0xAB: 1, 0xB1: 1, 0xB3: 1, 0xB4: 3, 0xB5: 1, 0xB6: 1, 0xBE: 1, 0xC1: 3, 0xC7: 1, 0xCA: 1, 0xFD: 1}
    LOCKED = frozenset([0xA2, 0xB1, 0xB3, 0xBB, 0xBE, 0xC1])     # until FD B1 came

    @staticmethod
    def _is_blue_first(bits):
        return not bits & 4


class WholeCommands(Windows):
    """Arguments come as commands, and all data are pixels of the window."""

    WRITE, NORMAL, LINES = None, 0xA4, 0xA8
    takes_pixels = True

    def take_command(self, data):
        self.finish()
        at = 0
        while at < len(data):
            count = self.ARGUMENTS.get(data[at])
            require(count is not None, f"there is no command {data[at]:#x}")
            require(at + count < len(data), f"command {data[at]:#x} lacks an argument")
            self._do(data[at], data[at + 1:at + 1 + count])
            at += 1 + count

    def take_data(self, data):
        self.arguments += data

    def finish(self):
        """The pixels of a window are whole when a command comes."""
        if self.arguments:
            self._write(self.arguments)
        self.arguments = b""


class Ssd1331(WholeCommands):
    """Colours, 96 x 64. AD chooses where the voltage of its glass comes from: from outside, as nothing else works."""

    ARGUMENTS = Windows.ARGUMENTS | {0x81: 1, 0x82: 1, 0x83: 1, 0x87: 1, 0x8A: 1, 0x8B: 1, 0x8C: 1, 0xA8: 1, 0xAB: 5, 0xAC: 0, 0xAD: 1, 0xB0: 1,
                                     0xB1: 1, 0xB3: 1, 0xB8: 32, 0xB9: 0, 0xBB: 1, 0xBE: 1, 0xE3: 0, 0xFD: 1}

    def __init__(self, glass):
        super().__init__(glass)
        self.supply = 0x8F      # after reset

    def _do(self, command, data):
        super()._do(command, data)
        if command == 0xAD:
            self.supply = data[0]
        require(command != 0xAF or self.supply == 0x8E, "it is turned on before its supply was chosen")


class Greys:
    """What controllers of 16 greys share. The memory has a level for each segment."""

    HIGHEST, TURNS = 15, (0, 2)

    @classmethod
    def frame_bytes(cls, width, height, glass):
        """Bytes of a frame on a glass: whole addresses of each row."""
        return -(-width // cls.UNIT[0]) * (cls.UNIT[0] // 2) * height

    def _write(self, data):
        (left, right), (top, bottom) = self.window
        each, rows, addresses = self.UNIT[0] // 2, bottom - top + 1, numpy.arange(left, right + 1)
        require(len(data) == each * rows * len(addresses), "the pixels do not fill their window, whole and once")
        levels = numpy.frombuffer(data, numpy.uint8).reshape(rows, len(addresses), each)
        pixels = numpy.stack([levels >> 4, levels & 15], -1).reshape(rows, len(addresses), 2 * each)   # the upper half first
        segments, order = self._joined(addresses)
        self.memory[top:bottom + 1, segments.reshape(-1)] = pixels[:, :, order].reshape(rows, -1)

    def _shown(self, turns):
        require(self.on, "it was never turned on")
        shown = self.glass.cut(self.memory)
        return numpy.rot90(15 - shown if self.inverted != self.glass.inverted else shown, turns)


class Ssd1327(Greys, WholeCommands):
    """Two pixels an address. The lower half of a byte goes to the first segment of its address, or to the second if bit 1 of A0 is set.
    Bit 0 counts addresses from the last one on, and exchanges no halves."""

    UNIT = (2, 1)
    OPEN = 0x12
    ARGUMENTS = Windows.ARGUMENTS | {0x81: 1, 0xA8: 1, 0xAB: 1, 0xB1: 1, 0xB3: 1, 0xB5: 1, 0xB6: 1, 0xB8: 15, 0xB9: 0, 0xBC: 1, 0xBE: 1, 0xD5: 1,
                                     0xFD: 1}

    def _set_access(self, bits):
        require(bits & 0x40 and not bits & 4, "odd and even rows are joined on two sides, and pixels go along rows")

    def _joined(self, addresses):
        """The segments of each address, and which of the two pixels of a byte each gets."""
        first = 2 * (self.memory.shape[1] // 2 - 1 - addresses if self.bits & 1 else addresses)
        return first[:, None] + numpy.arange(2), [0, 1] if self.bits & 2 else [1, 0]


class Ssd1322(Greys, Windows):
    """Four pixels an address. If bit 2 of A0 is set, the first segment has the upper half of the first byte, else the lower one of the
    second. Bit 1 counts segments from the last one on. Bit 4 of the second argument: the rows are scanned from both sides."""

    WRITE, OPEN, UNIT = 0x5C, 0x12, (4, 1)
    ARGUMENTS = Windows.ARGUMENTS | {0xA0: 2, 0xA8: 2, 0xA9: 0, 0xAB: 1, 0xB1: 1, 0xB3: 1, 0xB4: 2, 0xB5: 1, 0xB6: 1, 0xB8: 15, 0xB9: 0, 0xBB: 1,
                                     0xBE: 1, 0xC1: 1, 0xC7: 1, 0xCA: 1, 0xD1: 2, 0xFD: 1}

    def _set_access(self, bits, second):
        require(second == 0x11 and not bits & 0x21, "its rows are scanned from both sides, and pixels go along rows")

    def _joined(self, addresses):
        segments = 4 * addresses[:, None] + numpy.arange(4)
        return self.memory.shape[1] - 1 - segments if self.bits & 2 else segments, slice(None) if self.bits & 4 else slice(None, None, -1)
