// SPDX-License-Identifier: MIT
// A Raspberry Pi Pico with a display on its SPI, in a page's worker or in Node: the flash that make flash BOARD=pico writes, run by rp2040js.
import { advance, boot, listen, powered } from "../fixel/board/rp2040_machine.mjs";

const COLUMNS = 0x2a, ROWS = 0x2b, MEMORY_WRITE = 0x2c;     // of an ST7789, by its data sheet
const SIDE = 320, PARAMETERS = 4;
const FAULTS = ["CortexM0Core", "RP2040"];                  // who of rp2040js warns of what would be a fault of a real core

/** What a display of RGB565 shows by the columns and rows that it is told to write. */
class Display {
  constructor() {
    Object.assign(this, { width: 0, height: 0, pixels: new Uint16Array(SIDE * SIDE), command: 0, bytes: [], columns: [0, 0], rows: [0, 0], x: 0, y: 0 });
  }

  byte(isData, value, bits) {
    if (bits > 8) {
      this.byte(isData, value >> 8, 8);
    }
    if (isData) {
      this.take(value & 255);
    } else {
      Object.assign(this, { command: value & 255, bytes: [], x: this.columns[0], y: this.rows[0] });
    }
  }

  take(value) {
    this.bytes.push(value);
    const [high, low, last, lastLow] = this.bytes;
    if (this.command === MEMORY_WRITE && this.bytes.length === 2) {
      this.bytes = [];
      this.put(high << 8 | low);
    } else if ((this.command === COLUMNS || this.command === ROWS) && this.bytes.length === PARAMETERS) {
      const range = [high << 8 | low, last << 8 | lastLow];
      this[this.command === COLUMNS ? "columns" : "rows"] = range;
      if (this.command === COLUMNS) {
        this.width = Math.max(this.width, range[1] + 1);
      } else {
        this.height = Math.max(this.height, range[1] + 1);
      }
    }
  }

  put(colour) {
    if (this.x < SIDE && this.y < SIDE) {
      this.pixels[SIDE * this.y + this.x] = colour;
    }
    if (this.x++ === this.columns[1]) {
      this.x = this.columns[0];
      this.y = this.y === this.rows[1] ? this.rows[0] : this.y + 1;
    }
  }

  /** {width, height, pixels: RGB565, without a gap between rows} of what was written so far. */
  picture() {
    const { width, height } = this, pixels = new Uint16Array(width * height);
    for (let y = 0; y < height; y++) {
      pixels.set(this.pixels.subarray(SIDE * y, SIDE * y + width), width * y);
    }
    return { width, height, pixels };
  }
}

export class Pico {
  /** RP2040: the class of rp2040js. program: what stands at the beginning of the flash; scene: an image, and sceneAt: where it stands. */
  constructor(RP2040, { program, scene, sceneAt }) {
    const flash = new Uint8Array(sceneAt + scene.length).fill(255);
    flash.set(program);
    flash.set(scene, sceneAt);
    this.mcu = powered(RP2040, flash);
    this.display = new Display();
    this.frames = 0;
    this.said = "";
    this.fault = boot(this.mcu);
    const warn = (name, text) => { this.fault ??= FAULTS.includes(name) ? `${name}: ${text}` : null; };
    this.mcu.logger = { debug() {}, info() {}, warn, error: warn };
    this.mcu.onBreak = () => { this.fault ??= `the program stopped: ${this.said}`; };
    this.mcu.uart[0].onByte = (byte) => { this.said += String.fromCharCode(byte); };
    listen(this.mcu, { byte: (...what) => this.display.byte(...what), selected() {}, frame: () => { this.frames++; } });
  }

  get cycles() {
    return this.mcu.core.cycles;
  }

  /** Runs on for so many cycles at most, to the end of the next frame; whether that came. Throws a sentence where the program ended. */
  run(cycles) {
    const until = this.cycles + cycles, had = this.frames;
    const isOver = () => this.frames > had || this.fault !== null || this.cycles >= until;
    while (!isOver()) {
      this.fault ??= advance(this.mcu, isOver);
    }
    if (this.fault !== null) {
      throw new Error(this.fault);
    }
    return this.frames > had;
  }
}
