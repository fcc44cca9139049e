// SPDX-License-Identifier: MIT
// Frames on canvases, and the reference renderer's answer beside them.

const GREY = 0.35, FLOOR = 20;             // the dimmed frame under marks and lines
const MARK = 0xffa000ff, RING = 0xffdcaaff; // ABGR: magenta, and a paler one around it
const RING_DISTANCE = 3;                    // pixels: one pixel alone is easily overlooked
const LINE = "#ffd34d";
const WITHIN = 1, BEYOND = 2;               // of the verdict; host_tests/judges/live/main.c

/** Opaque ABGR words, as a canvas keeps them, of red, green, blue of each value that a pixel may have. */
export function paletteWords(bytes) {
  const words = new Uint32Array(bytes.length / 3);
  for (let i = 0; i < words.length; i++) {
    words[i] = 0xff000000 | bytes[3 * i + 2] << 16 | bytes[3 * i + 1] << 8 | bytes[3 * i];
  }
  return words;
}

/** The words of all values of RGB565. */
export function rgb565Words() {
  const bytes = new Uint8Array(3 * 65536);
  for (let i = 0; i < 65536; i++) {
    const red = i >> 11, green = i >> 5 & 63, blue = i & 31;
    bytes.set([red << 3 | red >> 2, green << 2 | green >> 4, blue << 3 | blue >> 2], 3 * i);
  }
  return paletteWords(bytes);
}

/** The same in dim grey. */
export function dimmed(words) {
  return words.map((word) => {
    const mean = ((word & 255) + (word >> 8 & 255) + (word >> 16 & 255)) / 3;
    const grey = Math.trunc(mean * GREY + FLOOR);
    return 0xff000000 | grey << 16 | grey << 8 | grey;
  });
}

/** A canvas of one picture element a pixel. */
export class Picture {
  constructor(canvas, width, height) {
    this.canvas = canvas;
    this.width = width;
    this.height = height;
    this.context = canvas.getContext("2d", { alpha: false });
    this.data = new ImageData(width, height);
    this.words = new Uint32Array(this.data.data.buffer);
  }

  /** Back to one element a pixel, where something else was drawn. */
  plain() {
    if (this.canvas.width !== this.width || this.canvas.height !== this.height) {
      this.canvas.width = this.width;
      this.canvas.height = this.height;
    }
  }

  put(indices, palette) {
    this.plain();
    for (let i = 0; i < indices.length; i++) {
      this.words[i] = palette[indices[i]];
    }
    this.context.putImageData(this.data, 0, 0);
  }

  /** A frame, dim, with a mark and a ring where the verdict is that it differs beyond the bound; how many pixels
   * do, and how many differ within the bound. */
  putDifference(indices, verdict, grey) {
    this.plain();
    const differing = [];
    let within = 0;
    for (let i = 0; i < indices.length; i++) {
      this.words[i] = grey[indices[i]];
      within += verdict[i] === WITHIN;
      if (verdict[i] === BEYOND) {
        differing.push(i);
      }
    }
    differing.forEach((i) => this.ring(i % this.width, Math.trunc(i / this.width)));
    differing.forEach((i) => { this.words[i] = MARK; });
    this.context.putImageData(this.data, 0, 0);
    return { beyond: differing.length, within };
  }

  ring(x, y) {
    for (let d = -RING_DISTANCE; d <= RING_DISTANCE; d++) {
      this.dot(x + d, y - RING_DISTANCE);
      this.dot(x + d, y + RING_DISTANCE);
      this.dot(x - RING_DISTANCE, y + d);
      this.dot(x + RING_DISTANCE, y + d);
    }
  }

  dot(x, y) {
    if (x >= 0 && x < this.width && y >= 0 && y < this.height) {
      this.words[y * this.width + x] = RING;
    }
  }

  /** The frame, dim, under the outlines of its polygons, which are drawn as finely as the screen can:
   * they do not keep to pixels. How many there are. */
  putWireframe(indices, grey, outlines, scale) {
    this.canvas.width = this.width * scale;
    this.canvas.height = this.height * scale;
    for (let i = 0; i < indices.length; i++) {
      this.words[i] = grey[indices[i]];
    }
    const small = new OffscreenCanvas(this.width, this.height);
    small.getContext("2d").putImageData(this.data, 0, 0);
    this.context.imageSmoothingEnabled = false;
    this.context.drawImage(small, 0, 0, this.canvas.width, this.canvas.height);
    this.context.strokeStyle = LINE;
    this.context.lineWidth = 1;
    return strokeOutlines(this.context, outlines, scale);
  }
}

function strokeOutlines(context, outlines, scale) {
  let count = 0, at = 0;
  context.beginPath();
  while (at < outlines.byteLength) {
    const points = outlines.getUint16(at, true);
    at += 4;
    for (let i = 0; i < points; i++, at += 8) {
      const x = outlines.getFloat32(at, true) * scale, y = outlines.getFloat32(at + 4, true) * scale;
      if (i === 0) {
        context.moveTo(x, y);
      } else {
        context.lineTo(x, y);
      }
    }
    context.closePath();
    count++;
  }
  context.stroke();
  return count;
}

/** How many polygons cover each pixel's centre. */
export function overdraw(outlines, width, height) {
  const counts = new Uint8Array(width * height);
  for (let at = 0; at < outlines.byteLength;) {
    const points = [], count = outlines.getUint16(at, true);
    at += 4;
    for (let i = 0; i < count; i++, at += 8) {
      points.push([outlines.getFloat32(at, true), outlines.getFloat32(at + 4, true)]);
    }
    cover(points, width, height, counts);
  }
  return counts;
}

function cover(points, width, height, counts) {
  const heights = points.map(([, y]) => y);
  const first = Math.max(0, Math.ceil(Math.min(...heights) - 0.5)), end = Math.min(height, Math.ceil(Math.max(...heights) - 0.5));
  for (let row = first; row < end; row++) {
    const crossings = points.map((from, i) => [from, points[(i + 1) % points.length]])
      .filter(([from, to]) => from[1] <= row + 0.5 !== to[1] <= row + 0.5)
      .map(([from, to]) => from[0] + (row + 0.5 - from[1]) * (to[0] - from[0]) / (to[1] - from[1])).sort((a, b) => a - b);
    for (let i = 0; i + 1 < crossings.length; i += 2) {
      const end = Math.min(width, Math.ceil(crossings[i + 1] - 0.5));
      for (let column = Math.max(0, Math.ceil(crossings[i] - 0.5)); column < end; column++) {
        counts[row * width + column]++;
      }
    }
  }
}

/** A line of the last values, from 0 to a round number above them. */
export class Plot {
  constructor(canvas, most) {
    this.canvas = canvas;
    this.most = most;
    this.values = [];
  }

  clear() {
    this.values = [];
  }

  add(value) {
    this.values.push(value);
    if (this.values.length > this.most) {
      this.values.shift();
    }
  }

  draw() {
    const ratio = window.devicePixelRatio || 1, style = getComputedStyle(this.canvas);
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    const context = this.canvas.getContext("2d");
    context.scale(ratio, ratio);
    const top = roundAbove(Math.max(1, ...this.values)), room = height - 14;
    context.font = "11px system-ui, sans-serif";
    context.fillStyle = style.getPropertyValue("--quiet");
    context.strokeStyle = style.getPropertyValue("--line");
    context.textBaseline = "top";
    context.fillText(shortNumber(top), 0, 0);
    for (const y of [13.5, height - 0.5]) {
      context.beginPath();
      context.moveTo(0, y);
      context.lineTo(width, y);
      context.stroke();
    }
    context.strokeStyle = style.getPropertyValue("--accent");
    context.lineWidth = 1.5;
    context.beginPath();
    this.values.forEach((value, i) => {
      const x = width - (this.values.length - 1 - i) * width / (this.most - 1);
      context.lineTo(x, height - 1 - value / top * (room - 1));
    });
    context.stroke();
  }
}

/** 1, 2 or 5 times a power of ten, not below a number. */
export function roundAbove(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= value);
}

function shortNumber(value) {
  return value >= 1e6 ? `${value / 1e6} million` : value.toLocaleString("en");
}
