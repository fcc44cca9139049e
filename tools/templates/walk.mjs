// SPDX-License-Identifier: MIT
// The walk of firmware/web/web.c: a scene image opened and drawn frame by frame, in a page or in Node.

export const DONE = 93;             // boards/contract/system.h
const COUNTERS = ["in", "backfacing", "outside", "degenerate", "refused", "drawn", "clipped"];  // fxl_counters
const POSE_WORDS = 6;               // fxl_pose: x, y, z, yaw, pitch, roll

/** What the module says of an image or a frame that it refuses. */
export class Refused extends Error {}

/** What a module said. */
export function told(exports) {
  return new TextDecoder().decode(new Uint8Array(exports.memory.buffer, exports.said(), exports.said_bytes())).trim();
}

/** A CRC as it is written. */
export function crcWords(crc) {
  return crc.toString(16).padStart(8, "0");
}

export class Walk {
  /** module: a WebAssembly.Module of build/web/walk.wasm. */
  constructor(module) {
    this.module = module;
    this.begin();
  }

  begin() {
    this.exports = new WebAssembly.Instance(this.module).exports;     // imports nothing
    this.number = 0;
  }

  /** Opens a scene image. Refused: a sentence; the walk then has no scene. */
  open(image) {
    this.begin();                   // memory that an earlier scene took
    const at = this.exports.scene(image.length);
    if (!at) {
      throw new Refused(`the image has ${image.length} bytes, for which the page has no memory`);
    }
    new Uint8Array(this.memory, at, image.length).set(image);
    this.restart();
  }

  /** The scene as it was made: the next frame is the first of its path. */
  restart() {
    this.number = 0;
    this.call(() => this.exports.open());
  }

  /** Draws the next frame. held: the keys that move the eye, or null for the scene's path. */
  draw(held) {
    this.call(() => this.exports.draw(this.number, held !== null, held || 0));
    this.number++;
    return this.shown();
  }

  /** Draws the frame of that number from a pose, the six numbers of fxl_pose; keys move the eye on from there. */
  drawFrom(number, pose) {
    this.number = number;
    this.exports.place(...pose);
    return this.draw(0);
  }

  call(what) {
    let code;
    try {
      code = what();
    } catch (trap) {
      throw new Refused(this.said() || `the program stopped: ${trap.message}`);
    }
    if (code !== DONE) {
      throw new Refused(this.said());
    }
  }

  said() {
    return told(this.exports);
  }

  get memory() {
    return this.exports.memory.buffer;
  }

  /** The last frame. pixels and palette are views of the module's memory until the next call. */
  shown() {
    const words = new Uint32Array(this.memory, this.exports.shown());
    const [width, height, bits, pixels, palette, pathFrames, crc, pose] = words;
    const Pixels = bits === 16 ? Uint16Array : Uint8Array;
    return {
      width, height, bits, pathFrames, crc, number: this.number - 1,
      pixels: new Pixels(this.memory, pixels, width * height),
      palette: new Uint8Array(this.memory, palette, 3 * 256),
      pose: new Int32Array(this.memory, pose, POSE_WORDS),
      counters: Object.fromEntries(COUNTERS.map((name, i) => [name, words[8 + i]])),
    };
  }
}
