# SPDX-License-Identifier: MIT
"""What modules of displays show of their wires. The controllers are written from their data sheets: those of colours and greys in
colour_controllers.py, those of one bit a pixel here. The drivers are in lib/screen; neither was made from the other.
"""

import numpy

from fixel.board.colour_controllers import (UNWRITTEN, Colour, Gc9107, Gc9a01, Glass, Ili9488, Ssd1322, Ssd1327, Ssd1331,  # noqa: F401
                                            Ssd1351, Windows, require)


class Pages:
    """A controller of pages of eight rows, whose rows are scanned: an SSD1306."""

    PAGES = 8
    takes_pixels = True     # whenever data come
    HIGHEST, TURNS, UNIT = 1, (0, 2), (1, 8)    # as those of Colour
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

    @staticmethod
    def frame_bytes(width, height, glass):
        """Bytes of a frame on a glass."""
        return -(-height // 8) * width

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

    @property
    def scanned_lines(self):
        """How many lines it was told to scan."""
        return self.settings[0xA8] + 1

    def _scanned(self, lit):
        """What the scanned lines show that the glass has, of the memory whose first axis is scanned. Line n shows line
        n + offset of the memory; a scan that runs the other way counts n from the last line that is scanned."""
        count, glass = self.scanned_lines, self.glass
        lines = numpy.arange(glass.first_line, glass.first_line + count)
        shown = (count - 1 - lines if self.scan_mirrored else lines) + self.settings[0xD3] & lit.shape[0] - 1
        require((shown < count).all(), "a line of the glass is not scanned")
        return lit[shown, ::-1 if self.segments_mirrored else 1]

    def _lit(self):
        """The pixels of the memory."""
        lit = self.memory[:, None, :] >> numpy.arange(8, dtype=numpy.uint8)[None, :, None] & 1
        return lit.reshape(8 * self.PAGES, self.glass.columns)

    def _pins(self):
        require(self.scanned_lines == self.glass.height, "it was told of another glass")
        return self._scanned(self._lit())

    def picture(self, turns=0):
        """What the glass shows whoever turned the module by two quarter turns or none: pixels of 0 and 1."""
        require(self.on, "it was never turned on")
        require(self.COM_PINS is None or self.settings[0xDA] == self.glass.com_pins, "it was told of other COM pins")
        return numpy.rot90(self.glass.cut(self._pins() ^ self.inverted ^ self.glass.dark), turns)


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
        require(self.scanned_lines == self.glass.width, "it was told of another glass")
        require(self.settings.get(0xDC, 0) == 0, "it is scrolled")
        return self._scanned(self._lit().T).T


class St7565(Pages):
    """An LCD of 65 lines, of which the glass has 64, and 132 segments. All its lines are scanned. 28 to 2F turn on booster, regulator and
    follower, which all must be on."""

    TWO_BYTES = frozenset([0x81, 0xF8])
    PLAIN = frozenset([0x40, 0xA0, 0xA1, 0xA2, 0xA3, 0xA4, 0xA6, 0xA7, 0xC0, 0xC8, 0xE2, *range(0x20, 0x30)])
    COM_PINS = None

    def __init__(self, glass):
        super().__init__(glass)
        self.power = 0

    def _set(self, command):
        super()._set(command)
        if command == 0xE2:
            self.power, self.segments_mirrored, self.scan_mirrored, self.page, self.column = 0, False, False, 0, 0
        elif command & 0xF8 == 0x28:
            self.power = command & 7

    def _pins(self):
        require(self.power == 7, "its voltages are off")
        return self._lit()[::-1 if self.scan_mirrored else 1, ::-1 if self.segments_mirrored else 1]


class Pcd8544(Pages):
    """An LCD of 48 lines and 84 segments. Bit 0 of the function set (20 to 27) chooses between two sets of commands, bit 1 lets pixels go
    down columns, bit 2 powers down."""

    PAGES, TURNS = 6, (0,)

    def __init__(self, glass):
        super().__init__(glass)
        self.function, self.mode, self.voltage, self.bias = 4, 8, 0, 0      # after reset

    def take_command(self, data):
        for command in data:
            if command & 0xF8 == 0x20:
                self.function = command & 7
            elif self.function & 1:
                self._set_voltages(command)
            elif command & 0x80:
                require(command & 0x7F < 84, "the column is beyond its memory")
                self.column = command & 0x7F
            elif command & 0xF8 == 0x40:
                require(command & 7 < self.PAGES, "the page is beyond its memory")
                self.page = command & 7
            else:
                require(command & 0xFA == 0x08, f"there is no command {command:#x}")
                self.mode = command

    def _set_voltages(self, command):
        if command & 0x80:
            self.voltage = command & 0x7F
        elif command & 0xF8 == 0x10:
            self.bias = command & 7
        else:
            require(command & 0xFC == 0x04, f"there is no command {command:#x} of its other set")

    def take_data(self, data):
        require(not self.function & 2, "pixels go along rows")
        super().take_data(data)

    def _pins(self):
        require(not self.function & 4 and self.voltage > 0 and self.bias == 3, "it is powered down, or its voltages are not those of 48 lines")
        require(self.mode in (0x0C, 0x0D), "it shows no memory")
        self.inverted = self.mode == 0x0D
        return self._lit()

    def picture(self, turns=0):
        self.on = not self.function & 4
        return super().picture(turns)


class MemoryLcd:
    """Sharp's memory LCD. The bits of a message come as they are counted: M0 (write), M1 (polarity of the glass), M2 (clear), five that
    mean nothing, the number of a row with its lowest bit first, its pixels, eight that mean nothing; then the next row, or eight more. A
    pixel of 1 is white. The polarity must change all the time: here from frame to frame."""

    HIGHEST, TURNS, UNIT, takes_pixels = 1, (0,), (1, 1), True
    alternates = True       # with the next frame: it is sent whole

    def __init__(self, glass):
        self.glass = glass
        self.memory = numpy.full((glass.rows, glass.columns), 1, numpy.uint8)
        self.memory[::2, ::3] = 0
        self.polarity, self.polarity_of_frame = False, False

    @staticmethod
    def frame_bytes(width, height, glass):
        """Bytes of a frame on a glass: whole rows of it, each with mode, number and end."""
        return (glass.columns // 8 + 4) * height

    def pause(self, milliseconds):
        """It needs none."""

    def finish(self):
        """Every message is done when it comes."""

    def take_command(self, data):
        require(False, "it has no line for commands")

    def take_data(self, data):
        bits = numpy.unpackbits(numpy.frombuffer(data, numpy.uint8))
        self.polarity = bool(bits[1])
        if bits[2]:
            require(not bits[0] and len(bits) == 16, "a message that clears has 16 bits")
            self.memory[:] = 1
            return
        if not bits[0]:
            require(len(bits) == 16, "a message that changes the polarity alone has 16 bits")
            return
        each = 8 + self.glass.columns + 8
        require(len(bits) > 16 and (len(bits) - 16) % each == 0, "a message is no mode, whole rows with their ends, and an end")
        for row in bits[8:-8].reshape(-1, each):
            number = int(row[:8] @ (1 << numpy.arange(8)))
            require(1 <= number <= self.glass.rows, f"there is no row {number}")
            self.memory[number - 1] = row[8:-8]

    def picture(self, turns=0):
        """What the glass shows."""
        require(not self.alternates or self.polarity != self.polarity_of_frame, "its polarity did not change since the frame before")
        self.polarity_of_frame = self.polarity
        return numpy.rot90(self.glass.cut(self.memory ^ self.glass.inverted), turns)


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


# place driver: the model in Python, and MODULES
_ILI9341 = Colour, Glass(240, 320, 240, 320, mirrored=(True, False), blue_first=True)
_ILI9488 = Ili9488, Glass(320, 480, 320, 480, mirrored=(True, False), blue_first=True)
_SSD1351 = Ssd1351, Glass(128, 128, 128, 128, mirrored=(False, True))
_GC9A01 = Gc9a01, Glass(240, 240, 240, 240, mirrored=(True, False), blue_first=True, inverted=True)
_GC9107 = Gc9107, Glass(128, 160, 128, 160, blue_first=True)
_SSD1331 = Ssd1331, Glass(96, 64, 96, 64, mirrored=(True, True))
_SSD1327 = Ssd1327, Glass(128, 128, 128, 128, mirrored=(True, True))
_SSD1322 = Ssd1322, Glass(480, 128, 256, 64, 112, mirrored=(False, True))
_ST7565 = St7565, Glass(132, 64, 128, 64, mirrored=(True, False), dark=True)
_PCD8544 = Pcd8544, Glass(84, 48, 84, 48, dark=True)
_LS013B7DH03 = MemoryLcd, Glass(128, 128, 128, 128)
_LS027B7DH01 = MemoryLcd, Glass(400, 240, 400, 240)
_SH1106 = _oled(132, 128, 64, 2, controller=Sh1106)
_SSD1309 = _oled(128, 128, 64, controller=Ssd1309)

# Of each driver of the library, a common module, and of each module of fixel/display.h: its controller and glass.
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
    "gc9107": _GC9107, "gc9107_128x128": (Gc9107, Glass(128, 160, 128, 128, 0, 32, blue_first=True)),
    "ssd1331": _SSD1331, "ssd1331_96x64": _SSD1331, "ssd1322": _SSD1322, "ssd1322_256x64": _SSD1322,
    "ssd1327": _SSD1327, "ssd1327_128x128": _SSD1327,
    "ssd1327_96x96": (Ssd1327, Glass(128, 128, 96, 96, 16, mirrored=(True, True), first_line=32)),
    "st7565": _ST7565, "st7565_128x64": _ST7565, "pcd8544": _PCD8544, "pcd8544_84x48": _PCD8544,
    "ls013b7dh03": _LS013B7DH03, "ls013b7dh03_128x128": _LS013B7DH03,
    "ls027b7dh01": _LS027B7DH01, "ls027b7dh01_400x240": _LS027B7DH01,
}


def start(name):
    """The controller of a module when power comes."""
    controller, glass = MODULES[name]
    return controller(glass)


def model(name):
    """The class of a module's controller: what it takes, and how it turns."""
    return MODULES[name][0]
