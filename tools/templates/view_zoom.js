// SPDX-License-Identifier: MIT
// Frames that are shown larger than their place on the page: each scrolls in a frame of its own, all to the same part.

const FACTORS = [1, 2, 4, 8];

export class Zoom {
  /** ports: elements that scroll, each around a canvas. */
  constructor(ports, changed) {
    this.ports = ports;
    this.changed = changed;     // called after a change of the factor
    this.factor = 1;
    this.width = this.height = 0;
    for (const port of ports) {
      port.addEventListener("scroll", () => this.follow(port));
    }
  }

  /** The place that each picture has on the page, in pixels of CSS. */
  fit(width, height) {
    this.width = width;
    this.height = height;
    this.apply();
  }

  apply() {
    for (const port of this.ports) {
      port.style.width = `${this.width}px`;
      port.style.height = `${this.height}px`;
      port.style.overflow = this.factor === 1 ? "hidden" : "auto";
      port.firstElementChild.style.width = `${this.width * this.factor}px`;
      port.firstElementChild.style.height = `${this.height * this.factor}px`;
    }
  }

  /** One factor more or less. The point at part (x, y) of the picture stays where it is; without: that in the middle. */
  step(by, point) {
    const place = FACTORS.indexOf(this.factor) + by, port = this.ports[0];
    if (place < 0 || place >= FACTORS.length) {
      return;
    }
    const part = point || {
      x: (port.scrollLeft + this.width / 2) / (this.width * this.factor),
      y: (port.scrollTop + this.height / 2) / (this.height * this.factor),
    };
    const left = part.x * this.width * this.factor - port.scrollLeft, top = part.y * this.height * this.factor - port.scrollTop;
    this.factor = FACTORS[place];
    this.apply();
    port.scrollLeft = part.x * this.width * this.factor - left;
    port.scrollTop = part.y * this.height * this.factor - top;
    this.follow(port);
    this.changed();
  }

  follow(port) {
    for (const each of this.ports) {
      each.scrollLeft = port.scrollLeft;
      each.scrollTop = port.scrollTop;
    }
  }

  get isLeast() {
    return this.factor === FACTORS[0];
  }

  get isMost() {
    return this.factor === FACTORS[FACTORS.length - 1];
  }
}

export const FIGURES_WIDTH = 316;  // of the column beside the frames, where it fits
const CAPTION_HEIGHT = 26;

/** How many screen pixels a pixel of a frame may take, with so many frames in a row, the figures aside or below. */
export function scaleOf(frame, columns, rows, room, height, ratio) {
  const tall = Math.floor((height / rows - CAPTION_HEIGHT) * ratio / frame.height);
  const aside = Math.floor((room - FIGURES_WIDTH) * ratio / (columns * frame.width));
  const below = Math.floor(room * ratio / (columns * frame.width));
  return Math.min(tall, Math.max(aside, Math.min(below, 2 * ratio)));
}

/** The same in a narrow window. */
export function scaleBelow(frame, rows, room, height, ratio) {
  const tall = Math.floor((height / rows - CAPTION_HEIGHT) * ratio / frame.height);
  return Math.min(tall, Math.floor(room * ratio / frame.width));
}
