// SPDX-License-Identifier: MIT
// The pixel under the pointer, in words.

const NO_FACE = 0xffff;

/** The pixel of a frame of width x height that an event of the pointer is at, on a canvas that shows it. */
export function pixelAt(canvas, event, width, height) {
  const box = canvas.getBoundingClientRect();
  const place = (offset, size, count) => Math.max(0, Math.min(count - 1, Math.floor(offset / size * count)));
  return { x: place(event.clientX - box.left, box.width, width), y: place(event.clientY - box.top, box.height, height) };
}

/** What a frame shows at a pixel: {index, red, green, blue}; and by the reference renderer's answer, if that came with
 * the frame, double: the colour there, face: {instance, face} or null for the background. */
export function lookAt(frame, pixel, width, palette) {
  const place = pixel.y * width + pixel.x, seen = { board: colour(frame.pixels[place], palette) };
  if (frame.faces.byteLength && frame.double.length) {
    const instance = frame.faces.getUint16(4 * place, true), face = frame.faces.getUint16(4 * place + 2, true);
    seen.double = colour(frame.double[place], palette);
    seen.face = instance === NO_FACE ? null : { instance, face };
  }
  return seen;
}

function colour(index, palette) {
  const word = palette[index];
  return { index, rgb: [word & 255, word >> 8 & 255, word >> 16 & 255] };
}

function colourWords({ index, rgb }) {
  return `colour ${index}, RGB ${rgb.join(" ")}`;
}

/** A pixel in a sentence. isJudged: the reference renderer can say which face it shows. */
export function pixelWords(pixel, seen, isJudged) {
  const words = `Pixel ${pixel.x}, ${pixel.y}: ${colourWords(seen.board)}`;
  if (!seen.double) {
    return isJudged ? `${words}; …` : words;
  }
  const face = seen.face ? `instance ${seen.face.instance}, face ${seen.face.face}` : "background";
  return seen.double.index === seen.board.index ? `${words}; ${face}`
    : `${words}. Double precision: ${colourWords(seen.double)}; ${face}`;
}
