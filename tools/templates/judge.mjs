// SPDX-License-Identifier: MIT
// The reference renderer of host_tests/judges/web/judge.c and its verdict on a frame, in a page's worker or in Node.

const REQUEST = 36, POSE_AT = 8, FRAME_AT = 32;                     // host_tests/judges/live/main.c
const PARTS = { double: 1, outlines: 2, faces: 4, verdict: 8 };     // and what a request calls them, in the order of an answer

export class Judge {
  /** module: a WebAssembly.Module of build/web/judge.wasm; image: the bytes of a scene image. Throws a sentence where it has no use. */
  constructor(module, image) {
    this.exports = new WebAssembly.Instance(module).exports;        // imports nothing
    const at = this.exports.scene(image.length);
    if (!at) {
      throw new Error("there is not enough memory for the image");
    }
    this.bytes(at, image.length).set(image);
    this.complain(this.exports.open(image.length));
  }

  bytes(at, size) {
    return new Uint8Array(this.exports.memory.buffer, at, size);
  }

  complain(at) {
    if (at) {
      const rest = this.bytes(at, this.exports.memory.buffer.byteLength - at);
      throw new Error(new TextDecoder().decode(rest.subarray(0, rest.indexOf(0))));
    }
  }

  /** What double precision draws of the six numbers of fxl_pose, with what moves where it is in that frame of the path. wants: names of PARTS.
   * pixels: the frame that the library drew, for the verdict. Answers {name: bytes, a copy} of the parts. */
  ask({ wants, pose, frame, pixels }) {
    const at = this.exports.request(), request = new DataView(this.exports.memory.buffer, at, REQUEST);
    this.bytes(at, REQUEST).set([65, 83, 75, 83, wants.reduce((all, name) => all | PARTS[name], 0), 0, 0, 0]);
    pose.forEach((number, i) => request.setInt32(POSE_AT + 4 * i, number, true));
    request.setUint32(FRAME_AT, frame, true);
    if (wants.includes("verdict")) {
      this.bytes(this.exports.board(), pixels.byteLength).set(new Uint8Array(pixels.buffer, pixels.byteOffset, pixels.byteLength));
    }
    this.complain(this.exports.ask());
    const words = new Uint32Array(this.exports.memory.buffer, this.exports.answer(), 8);
    return Object.fromEntries(Object.keys(PARTS).map((name, i) => [name, this.bytes(words[i], words[4 + i]).slice()]));
  }
}
