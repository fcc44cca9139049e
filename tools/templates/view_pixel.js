// SPDX-License-Identifier: MIT
// The pixel under the pointer, in words.

const NO_FACE = 0xffff;
const FACE_SIZE = 16;  // bytes of a pixel's face: host_tests/judges/live/main.c

/** The pixel of a frame of width x height that an event of the pointer is at, on a canvas that shows it. */
export function pixelAt(canvas, event, width, height) {
  const box = canvas.getBoundingClientRect();
  const place = (offset, size, count) => Math.max(0, Math.min(count - 1, Math.floor(offset / size * count)));
  return { x: place(event.clientX - box.left, box.width, width), y: place(event.clientY - box.top, box.height, height) };
}

/** What a frame shows at a pixel: {index, red, green, blue}; and by the reference renderer's answer, if that came with
 * the frame, double: the colour there, face: null for the background, or {instance, face,
 * distance, texel}: texel is null or its column, row, and width and height of its level. picked: null, or what the board said
 * last of a pixel: if of this one, it is seen.picked. */
export function lookAt(frame, pixel, width, palette, picked) {
  const place = pixel.y * width + pixel.x, seen = { board: colour(frame.pixels[place], palette) };
  if (picked && picked.number === frame.number && picked.pixel[0] === pixel.x && picked.pixel[1] === pixel.y) {
    seen.picked = picked;
  }
  if (frame.faces.byteLength && frame.double.length) {
    const at = FACE_SIZE * place, numbers = [0, 2, 8, 10, 12, 14].map(offset => frame.faces.getUint16(at + offset, true));
    const [instance, face, ...texel] = numbers, distance = frame.faces.getFloat32(at + 4, true);
    seen.double = colour(frame.double[place], palette);
    seen.face = instance === NO_FACE ? null : { instance, face, distance, texel: texel[2] ? texel : null };
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

function faceWords({ instance, face, distance, texel }) {
  const words = `instance ${instance}, face ${face}, ${distance.toPrecision(4)} away`;
  return texel ? `${words}, texel ${texel[0]}, ${texel[1]} of ${texel[2]} × ${texel[3]}` : words;
}

function pickedWords({ status, instance, face }) {
  if (status !== 0) {
    return status === NO_FACE ? "nothing was picked" : `fxl_pick_face answered status ${status}`;
  }
  return instance === NO_FACE ? "background" : `instance ${instance}, face ${face}`;
}

/** A pixel in a sentence. hello.judged: the reference renderer can say which face it shows; hello.picks: the board can. */
export function pixelWords(pixel, seen, hello) {
  const words = `Pixel ${pixel.x}, ${pixel.y}: ${colourWords(seen.board)}`;
  if (seen.picked) {
    return `${words}; ${pickedWords(seen.picked)}`;
  }
  if (!seen.double) {
    return hello.judged || hello.picks ? `${words}; …` : words;
  }
  const face = seen.face ? faceWords(seen.face) : "background";
  return seen.double.index === seen.board.index ? `${words}; ${face}`
    : `${words}. Double precision: ${colourWords(seen.double)}; ${face}`;
}
