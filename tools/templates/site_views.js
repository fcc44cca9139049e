// SPDX-License-Identifier: MIT
// What the first page shows in the place of the library's picture while the scene stands: what double precision draws, where that
// differs, outlines, overdraw, and what is under the pointer. The reference renderer is fetched when it is first asked for.
import { dimmed, overdraw } from "./view_picture.js";
import { lookAt, pixelAt, pixelWords } from "./view_pixel.js";

const SCALE = 3;        // elements of the canvas a pixel, for outlines
const WANTS = ["double", "outlines", "faces", "verdict"];
const HEAT = [[24, 26, 31], [38, 92, 140], [52, 156, 124], [214, 178, 58], [214, 102, 45], [196, 44, 68]];      // none, one, ... five and more

const number = (count, thing) => `${count.toLocaleString("en")} ${thing}${count === 1 ? "" : "s"}`;

/** Words about each view, of a frame and its answer; and what draws it. */
const VIEWS = {
  double: (picture, { frame, answer, colours }) => {
    picture.put(double(frame, answer), colours);
    return "What the reference renderer draws in double precision.";
  },
  differ: (picture, { frame, answer, colours }) => {
    const { beyond, within } = picture.putDifference(frame.pixels, answer.verdict, dimmed(colours));
    return `${number(within + beyond, "pixel")} of ${number(frame.width * frame.height, "pixel")} differ from double precision; `
      + `${beyond} beyond the bound: 1/8192 pixel from an edge, or a texel within its bound.`;
  },
  outlines: (picture, { frame, answer, colours }) =>
    `${number(picture.putWireframe(frame.pixels, dimmed(colours), new DataView(answer.outlines.buffer), SCALE), "polygon")} that are drawn.`,
  overdraw: (picture, { frame, answer }) => {
    const counts = overdraw(new DataView(answer.outlines.buffer), frame.width, frame.height);
    picture.put(counts.map((count) => Math.min(count, HEAT.length - 1)), HEAT.map(([red, green, blue]) => 0xff000000 | blue << 16 | green << 8 | red));
    const sum = counts.reduce((all, count) => all + count, 0);
    return `Polygons a pixel: ${(sum / counts.length).toFixed(2)} on the mean, ${counts.reduce((most, count) => Math.max(most, count), 0)} at most.`;
  },
};

function double(frame, answer) {
  return frame.bits === 16 ? new Uint16Array(answer.double.buffer) : answer.double;
}

export class Views {
  /** The elements: the select of a view, and what says words of it and of a pixel; say: for what went wrong. fetched(name): the answer for a file. */
  constructor({ select, words, pixel, canvas, say, fetched }) {
    Object.assign(this, { select, words, pixel, canvas, say, fetched, worker: null, image: null, asked: 0, shown: null });
    canvas.addEventListener("pointermove", (event) => this.look(event));
    canvas.addEventListener("pointerleave", () => { this.pixel.textContent = ""; });
  }

  /** Whether something else than the library's picture is to be seen. */
  get isOther() {
    return this.select.value !== "board";
  }

  /** The library's picture is shown again, as it moves. */
  clear() {
    this.asked++;
    this.shown = null;
    this.words.textContent = this.pixel.textContent = "";
  }

  /** Asks for a frame that stands, and shows it by the view that is chosen. */
  async show(frame, picture, colours, image) {
    const stands = { ...frame, pixels: frame.pixels.slice(), pose: frame.pose.slice() };
    this.clear();
    this.words.textContent = "The reference renderer draws it …";
    const asked = this.asked;
    try {
      const answer = await this.ask(image, stands);
      if (asked === this.asked) {
        this.shown = { frame: stands, answer, colours, picture };
        this.put();
      }
    } catch (fault) {
      if (asked === this.asked) {
        this.words.textContent = "";
        this.say(`The reference renderer: ${fault.message}.`);
      }
    }
  }

  /** Shows what was answered by the view that is chosen. */
  put() {
    const { picture, frame, colours } = this.shown, view = VIEWS[this.select.value];
    if (view) {
      this.words.textContent = view(picture, this.shown);
    } else {
      picture.put(frame.pixels, colours);
      this.words.textContent = "";
    }
  }

  async ask(image, frame) {
    if (this.image !== image) {
      this.worker ??= new Worker("judge_worker.js", { type: "module" });
      this.module ??= await WebAssembly.compile(await (await this.fetched("judge.wasm")).arrayBuffer());
      this.image = image;
      this.worker.postMessage({ module: this.module, image });
    }
    const number = this.asked;
    return new Promise((resolve, reject) => {
      const take = ({ data }) => {
        if (data.number === number || data.number === undefined) {
          this.worker.removeEventListener("message", take);
          (data.fault ? reject(new Error(data.fault)) : resolve(data.answer));
        }
      };
      this.worker.addEventListener("message", take);
      this.worker.postMessage({ number, wants: WANTS, pose: frame.pose, frame: frame.number, pixels: frame.pixels });
    });
  }

  look(event) {
    if (!this.shown) {
      return;
    }
    const { frame, answer, colours } = this.shown, at = pixelAt(this.canvas, event, frame.width, frame.height);
    const seen = lookAt({ ...frame, faces: new DataView(answer.faces.buffer), double: double(frame, answer) }, at, frame.width, colours, null);
    this.pixel.textContent = pixelWords(at, seen, { judged: true });
  }
}
