// SPDX-License-Identifier: MIT
// A program of examples/ as firmware/web/frames.c keeps its frames, in a page or in Node.
import { DONE, Refused, told } from "./walk.mjs";

const KEPT = 6;     // words: width, height, bits of a pixel, frames, where the first one is, bytes from one to the next

export class Program {
  /** module: a WebAssembly.Module of the site's programs; frames: after so many it is ended, if it does not end itself. Refused: a sentence. */
  constructor(module, frames) {
    this.exports = new WebAssembly.Instance(module).exports;        // imports nothing
    try {
      this.exports.run(frames);
    } catch (trap) {
      if (this.exports.status() !== DONE) {
        throw new Refused(told(this.exports) || `the program stopped: ${trap.message}`);
      }
    }
    [this.width, this.height, this.bits, this.count, this.first, this.size] = new Uint32Array(this.exports.memory.buffer, this.exports.kept(), KEPT);
  }

  /** A frame that it drew: its pixels, as views of the module's memory, and their CRC. */
  frame(number) {
    const { buffer } = this.exports.memory, at = this.first + number * this.size, Pixels = this.bits === 16 ? Uint16Array : Uint8Array;
    return { crc: new Uint32Array(buffer, at, 1)[0], pixels: new Pixels(buffer, at + 4, this.width * this.height) };
  }

  /** 256 x red, green, blue. */
  get palette() {
    return new Uint8Array(this.exports.memory.buffer, this.exports.palette(), 3 * 256);
  }
}
