// SPDX-License-Identifier: MIT
// What a frame costs that is no frame of a path of the site: the library's work is counted in the page, as fixel predict counts it, and each count
// has the costs of bench/costs.json. The program that counts is fetched when it is first asked for.
import { Counter, whole } from "./counter.mjs";

export class FrameCounts {
  /** fetched(name): the answer for a file; boards: {name: { code, settings, without, memory }}. */
  constructor(fetched, boards) {
    Object.assign(this, { fetched, boards, counter: null, image: null, board: null, ofPath: [] });
  }

  /** Whether it counts images of the reader's own for a board: one that leaves nothing out. */
  knows(board) {
    return !this.boards[board].without;
  }

  /** What it takes is here then. */
  load() {
    this.loading ??= Promise.all([this.fetched("counter.wasm").then((got) => got.arrayBuffer()).then((bytes) => WebAssembly.compile(bytes)),
      this.fetched("costs.json").then((got) => got.json())]).then(([module, cores]) => Object.assign(this, { module, cores }));
    return this.loading;
  }

  /** The counter of an image on a board. */
  of(image, board) {
    if (this.image !== image || this.board !== board) {
      this.counter = new Counter(this.module, image, this.boards[board].settings);
      Object.assign(this, { image, board, ofPath: [] });
    }
    return this.counter;
  }

  /** Bytes of flash and RAM for an image, as the costs of a scene of the site have them; or why the board has no room. */
  costOf(image, board) {
    const { flash, ram } = this.boards[board].memory, found = { flash: { ...flash, scene: image.length }, ram };
    const why = image.length > flash.scene_room ? `the scene image has ${image.length} bytes, the board's scene partition ${flash.scene_room}` : this.of(image, board).noRoom;
    return why ? { ...found, why_not: why } : found;
  }

  /** Instructions of a frame: all, then those of each part. isOfPath: the frame of that number of the scene's path, which is counted once. Null
   * where the board has no room. */
  taken(image, board, frame, isOfPath) {
    const counter = this.of(image, board);
    if (counter.noRoom) {
      return null;
    }
    if (!isOfPath) {
      return this.count(counter, frame);
    }
    return this.ofPath[frame.number] ??= this.count(counter, frame);
  }

  count(counter, { pose, number }) {
    const costs = this.cores[this.boards[this.board].code], counts = counter.count(pose, number), sums = costs[counter.names[0]].map(() => 0);
    counts.forEach((count, i) => costs[counter.names[i]].forEach((cost, part) => { sums[part] += count * (part ? cost : Math.round(1000 * cost)); }));
    sums[0] /= 1000;        // costs have three decimals: the sum of thousandths is exact
    return sums.map(whole);
  }
}
