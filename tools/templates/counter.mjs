// SPDX-License-Identifier: MIT
// What the library does in a frame on a board with certain settings, counted by host_tests/judges/web/predict.c, in a page or in Node.

const NO_ROOM = 0, WRONG = 1, COUNT = 2, NAMES = 3, COUNTS = 4, SETTINGS = 5, POSE = 6;      // words of what it tells

/** The nearest whole number, of two the even one: as Python rounds. */
export function whole(number) {
  const up = Math.round(number);
  return up - number === 0.5 && up % 2 ? up - 1 : up;
}

export class Counter {
  /** module: a WebAssembly.Module of build/web/counter.wasm; image: the bytes of a scene image; settings: the bytes of a board's band, the entries of
   * its order, the bytes of its list, the entries of its cache, and the bytes that limit the list. Throws a sentence where the image is of no use;
   * .noRoom says what the board has no room for, or is "". */
  constructor(module, image, settings) {
    this.exports = new WebAssembly.Instance(module).exports;        // imports nothing
    const at = this.exports.scene(image.length);
    if (!at) {
      throw new Error("there is not enough memory for the image");
    }
    new Uint8Array(this.memory, at, image.length).set(image);
    new Uint32Array(this.memory, this.told(SETTINGS), settings.length).set(settings);
    this.exports.open(image.length);
    this.complain();
    this.noRoom = this.text(this.told(NO_ROOM));
    this.names = Array.from(new Uint32Array(this.memory, this.told(NAMES), this.told(COUNT)), (name) => this.text(name));
  }

  get memory() {
    return this.exports.memory.buffer;
  }

  told(word) {
    return new Uint32Array(this.memory, this.exports.told(), POSE + 1)[word];
  }

  text(at) {
    const rest = new Uint8Array(this.memory, at);
    return at ? new TextDecoder().decode(rest.subarray(0, rest.indexOf(0))) : "";
  }

  complain() {
    const wrong = this.text(this.told(WRONG));
    if (wrong) {
      throw new Error(wrong);
    }
  }

  /** The counts, in the order of .names, of a frame from the six numbers of fxl_pose; what moves is where it is in that frame of the path. */
  count(pose, frame) {
    new Int32Array(this.memory, this.told(POSE), pose.length).set(pose);
    this.exports.count(frame);
    this.complain();
    return Array.from(new Float64Array(this.memory, this.told(COUNTS), this.told(COUNT)), whole);
  }
}
