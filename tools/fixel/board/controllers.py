# SPDX-License-Identifier: MIT
"""What modules of displays show of their wires. The controllers are written from their data sheets: ST7789, ILI9341,
ST7735, ST7796, GC9A01 and SSD1351 in RGB565, ILI9488 in three bytes a pixel, SSD1306, SSD1309, SH1106 and SH1107 in black and white. The drivers are in lib/screen; neither was
made from the other.
"""

import dataclasses

import numpy

from fixel.base.errors import ToolError

UNWRITTEN = 0xDEAD  # a colour of the noise in a controller's memory when power comes
REST = 120          # milliseconds that a controller wants after a reset, and after it was woken
ROWS_OF_SSD1351 = 128


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

    def cut(self, memory):
        """The part of a memory that the glass shows, as seen when the picture is not turned."""
        seen = memory[::-1 if self.mirrored[1] else 1, ::-1 if self.mirrored[0] else 1]
        return seen[self.top:self.top + self.height, self.left:self.left + self.width]


class Colour:
    """A controller of MIPI's commands, in pixels of RGB565."""

    WRITE = 0x2C    # the command whose data are pixels
    FORMAT = 0x55   # 16 bits a pixel
    PIXEL_BYTES = 2

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


class Ssd1351(Colour):
    """An OLED of colours: commands of its own, and bits 0 and 1 of its access are 5 and 6 of MIPI's. Bit 4 mirrors the scan and not
    the memory."""

    WRITE = 0x5C
    ARGUMENTS = {0xA0: 1, 0xA1: 1, 0xA2: 1, 0xAB: 1, 0xB1: 1, 0xB3: 1, 0xB4: 3, 0xB5: 1, 0xB6: 1, 0xBE: 1, 0xC1: 3, 0xC7: 1,
                 0xCA: 1, 0xFD: 1, 0x15: 2, 0x75: 2, 0xA6: 0, 0xA7: 0, 0xAE: 0, 0xAF: 0}
    LOCKED = frozenset([0xA2, 0xB1, 0xB3, 0xBB, 0xBE, 0xC1])     # until FD B1 came

    def __init__(self, glass):
        super().__init__(glass)
        self.unlocked, self.start_line, self.scan_mirrored, self.lines = False, 0, False, 128     # after reset

    def _do(self, command, data):
        if command == self.WRITE:
            self._write(data)
            return
        require(len(data) == self.ARGUMENTS.get(command, -1), f"command {command:#x} has {len(data)} bytes of data")
        require(self.unlocked or command not in self.LOCKED, f"command {command:#x} is locked")
        if command == 0xFD:
            self.unlocked = data[0] == 0xB1
        elif command in (0x15, 0x75):
            axis = int(command == 0x75)
            require(data[0] <= data[1] < self.memory.shape[1 - axis], "the window is beyond its memory")
            self.window[axis ^ self.access >> 5 & 1] = (data[0], data[1])
        elif command == 0xA0:
            self.format = 0x55 if data[0] & 0xC0 == 0x40 else 0
            require(data[0] & 0x20, "odd and even rows are joined on two sides")
            self.access = (data[0] & 1) << 5 | (data[0] & 2) << 5 | (0 if data[0] & 4 else 8)
            self.scan_mirrored = bool(data[0] & 0x10)
        elif command == 0xA1:
            self.start_line = data[0] & 127
        elif command == 0xA2:
            require(data[0] == 0, "its lines are moved, which this model does not play")
        elif command in (0xA6, 0xA7):
            self.inverted = command == 0xA7
        elif command in (0xAE, 0xAF):
            self.on = command == 0xAF
        elif command == 0xCA:
            self.lines = data[0] + 1

    def _rows(self):
        """Which row of the memory each line of the glass shows. By the data sheet the scan has N lines, the multiplex ratio. Line i
        of it shows the row that lies i behind the start line, and drives pin COM i, or COM N - 1 - i if bit 4 of A0 mirrors it. The
        glass has the pins from COM 0 on."""
        rows = numpy.full(ROWS_OF_SSD1351, -1)
        for line in range(self.lines):
            rows[self.lines - 1 - line if self.scan_mirrored else line] = (self.start_line + line) % ROWS_OF_SSD1351
        require((rows[:self.glass.height] >= 0).all(), "a line of the glass is not scanned")
        return rows[:self.glass.height]

    def picture(self, turns=0):
        written = self.memory
        self.memory = written[self._rows()]
        shown = super().picture(turns)
        self.memory = written
        return shown


class Pages:
    """A controller of pages of eight rows, whose rows are scanned: an SSD1306."""

    PAGES = 8
    takes_pixels = True     # whenever data come
    TWO_BYTES = frozenset([0x20, 0x81, 0x8D, 0xA8, 0xAD, 0xD3, 0xD5, 0xD9, 0xDA, 0xDB])  # commands with an argument
    PLAIN = frozenset([0x40, 0xA0, 0xA1, 0xA4, 0xA6, 0xA7, 0xC0, 0xC8])                  # those that it must know
    COM_PINS = 0x12                                                                      # after reset; None: no such command

    def __init__(self, glass):
        self.glass = glass
        self.memory = numpy.full((self.PAGES, glass.columns), 0xA5, numpy.uint8)
        self.page = self.column = 0
        self.on = False
        self.settings = {0xA8: 8 * self.PAGES - 1, 0xD3: 0, 0xDA: self.COM_PINS}   # after reset: multiplex, offset, COM pins
        self.segments_mirrored = self.scan_mirrored = self.inverted = False

    def pause(self, milliseconds):
        """It needs none."""

    def finish(self):
        """Every command is done when it comes."""

    def take_command(self, data):
        commands = iter(data)
        for command in commands:
            if command in self.TWO_BYTES:
                self.settings[command] = next(commands, None)
                require(self.settings[command] is not None, f"command {command:#x} lacks its argument")
            elif command < 0x10:
                self.column = self.column & 0xF0 | command
            elif command < 0x20:
                self.column = self.column & 0x0F | (command & 15) << 4
            elif 0xB0 <= command < 0xB0 + self.PAGES:
                self.page = command & 15
            elif command & 0xFE == 0xAE:
                self.on = command == 0xAF
            else:
                require(command in self.PLAIN, f"there is no command {command:#x}")
                self._set(command)

    def _set(self, command):
        """A command without an argument."""
        if command & 0xFE == 0xA0:
            self.segments_mirrored = command == 0xA1
        elif command & 0xFE == 0xA6:
            self.inverted = command == 0xA7
        elif command & 0xF0 == 0xC0:
            self.scan_mirrored = command == 0xC8

    def take_data(self, data):
        require(self.column + len(data) <= self.memory.shape[1], "bytes come behind the last column")
        self.memory[self.page, self.column:self.column + len(data)] = numpy.frombuffer(data, numpy.uint8)
        self.column += len(data)

    def _scanned(self, lit):
        """What the scanned lines show that the glass has, of the memory whose first axis is scanned. Line n shows line
        n + offset of the memory; a scan that runs the other way counts n from the last line that is scanned."""
        count, glass = self.settings[0xA8] + 1, self.glass
        lines = numpy.arange(glass.first_line, glass.first_line + count)
        shown = (count - 1 - lines if self.scan_mirrored else lines) + self.settings[0xD3] & lit.shape[0] - 1
        require((shown < count).all(), "a line of the glass is not scanned")
        return lit[shown, ::-1 if self.segments_mirrored else 1]

    def _lit(self):
        """The pixels of the memory."""
        lit = self.memory[:, None, :] >> numpy.arange(8, dtype=numpy.uint8)[None, :, None] & 1
        return lit.reshape(8 * self.PAGES, self.glass.columns)

    def _pins(self):
        require(self.settings[0xA8] + 1 == self.glass.height, "it was told of another glass")
        return self._scanned(self._lit())

    def picture(self, turns=0):
        """What the glass shows whoever turned the module by two quarter turns or none: pixels of 0 and 1."""
        require(self.on, "it was never turned on")
        require(self.COM_PINS is None or self.settings[0xDA] == self.glass.com_pins, "it was told of other COM pins")
        return numpy.rot90(self.glass.cut(self._pins() ^ self.inverted), turns)


# place driver: the model in Python, MODULES, and the comment at the top
class Sh1106(Pages):
    """It knows no other mode than that of pages, and its converter is switched by AD."""

    TWO_BYTES = Pages.TWO_BYTES - {0x20, 0x8D}


class Ssd1309(Pages):
    """It has no converter, and a lock: FD 12 opens it."""

    TWO_BYTES = Pages.TWO_BYTES - {0x8D, 0xAD} | {0xFD}


class Sh1107(Pages):
    """Sixteen pages, of which the columns are scanned. 20 and 21 choose the mode, and DC where the scan begins."""

    PAGES = 16
    TWO_BYTES = Pages.TWO_BYTES - {0x20, 0x8D, 0xDA} | {0xDC}
    PLAIN = Pages.PLAIN - {0x40} | {0x20}
    COM_PINS = None

    def _pins(self):
        require(self.settings[0xA8] + 1 == self.glass.width, "it was told of another glass")
        require(self.settings.get(0xDC, 0) == 0, "it is scrolled")
        return self._scanned(self._lit().T).T


def _st7789(*place, **others):
    """A glass on an ST7789, which is inverted."""
    return Colour, Glass(240, 320, *place, inverted=True, **others)


def _st7735(*place, **others):
    """A glass on an ST7735, mounted with its first row at the bottom and its first column at the right."""
    return Colour, Glass(*place, mirrored=(True, True), **others)


def _oled(columns, *place, controller=Pages, **others):
    """A glass on a controller of 64 rows, mounted upside down."""
    return controller, Glass(columns, 64, *place, mirrored=(True, True), **others)


def _sh1107(width, first_line):
    """A glass of 128 rows on an SH1107, with its lines from one on."""
    return Sh1107, Glass(128, 128, width, 128, first_line=first_line)


_ILI9341 = Colour, Glass(240, 320, 240, 320, mirrored=(True, False), blue_first=True)
_ILI9488 = Ili9488, Glass(320, 480, 320, 480, mirrored=(True, False), blue_first=True)
_SSD1351 = Ssd1351, Glass(128, 128, 128, 128, mirrored=(False, True))
_GC9A01 = Gc9a01, Glass(240, 240, 240, 240, mirrored=(True, False), blue_first=True, inverted=True)
_SH1106 = _oled(132, 128, 64, 2, controller=Sh1106)
_SSD1309 = _oled(128, 128, 64, controller=Ssd1309)

# Of each driver of the library, a common module, and of each module of fixel/modules.h: its controller and glass.
MODULES = {
    "st7789": _st7789(240, 320), "ili9341": _ILI9341, "st7735": _st7735(128, 160, 128, 160),
    "st7796": (Colour, Glass(320, 480, 320, 480, mirrored=(True, False), blue_first=True)), "gc9a01": _GC9A01,
    "ili9488": _ILI9488, "ili9488_320x480": _ILI9488, "ssd1351": _SSD1351, "ssd1351_128x128": _SSD1351,
    "ssd1351_128x96": (Ssd1351, Glass(128, 128, 128, 96, mirrored=(False, True))),
    "ssd1306": _oled(128, 128, 64), "ssd1309": _SSD1309, "sh1106": _SH1106, "sh1107": _sh1107(128, 0),
    "ili9341_240x320": _ILI9341,
    "st7789_240x320": _st7789(240, 320), "st7789_240x240": _st7789(240, 240), "st7789_135x240": _st7789(135, 240, 52, 40),
    "st7789_172x320": _st7789(172, 320, 34), "st7789_170x320": _st7789(170, 320, 35),
    "st7789_240x280": _st7789(240, 280, 0, 20),
    "st7735_128x160": _st7735(128, 160, 128, 160),
    "st7735_128x160_green": _st7735(132, 162, 128, 160, 2, 1, blue_first=True),
    "st7735_128x128": _st7735(132, 132, 128, 128, 2, 3, blue_first=True),
    "st7735_128x128_row_32": _st7735(128, 160, 128, 128, 0, 32, blue_first=True),
    "st7735_80x160": _st7735(132, 162, 80, 160, 26, 1, blue_first=True, inverted=True),
    "st7735_80x160_column_24": _st7735(128, 160, 80, 160, 24, 0),
    "st7796_320x480": (Colour, Glass(320, 480, 320, 480, mirrored=(True, False), blue_first=True)),
    "st7796_222x480": (Colour, Glass(320, 480, 222, 480, 49, mirrored=(True, False), blue_first=True, inverted=True)),
    "gc9a01_240x240": _GC9A01,
    "ssd1306_128x64": _oled(128, 128, 64), "ssd1306_128x32": _oled(128, 128, 32, com_pins=0x02),
    "ssd1306_128x64_com_02": _oled(128, 128, 64, com_pins=0x02),
    "ssd1306_64x48": _oled(128, 64, 48, 32), "ssd1306_64x32": _oled(128, 64, 32, 32), "ssd1306_72x40": _oled(128, 72, 40, 28),
    "ssd1309_128x64": _SSD1309, "ssd1309_128x64_column_2": _oled(132, 128, 64, 2, controller=Ssd1309),
    "sh1106_128x64": _SH1106, "sh1106_72x40": _oled(132, 72, 40, 30, controller=Sh1106, first_line=12),
    "sh1107_128x128": _sh1107(128, 0), "sh1107_128x128_column_96": _sh1107(128, 96), "sh1107_64x128": _sh1107(64, 32),
    "sh1107_80x128": _sh1107(80, 24),
}


def start(name):
    """The controller of a module when power comes."""
    controller, glass = MODULES[name]
    return controller(glass)


def is_mono(name):
    """Whether a module is black and white."""
    return issubclass(MODULES[name][0], Pages)
