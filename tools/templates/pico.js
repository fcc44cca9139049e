// SPDX-License-Identifier: MIT
// The page of the emulated Pico: its display beside what the library draws in the page, and both CRC.
import { press } from "./view_keys.js";
import { Picture, rgb565Words } from "./view_picture.js";
import { Walk } from "./walk.mjs";

const at = (id) => document.getElementById(id);
const data = JSON.parse(at("data").textContent), words = rgb565Words();
const state = { run: 0, walk: null, paused: false, waits: false, pictures: {}, equal: 0, game: false };
const GAME = "game", programs = [...data.scenes, GAME];     // the game is a program of its own
const worker = new Worker("pico_worker.js", { type: "module" });

async function bytes(name) {
  const answer = await fetch(name);
  if (!answer.ok) {
    throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
  }
  return new Uint8Array(await answer.arrayBuffer());
}

/** CRC-32 of pixels of RGB565, the byte with red first, as fxl_band_crc. */
function crcOf(pixels) {
  let sum = 0xffffffff;
  for (const pixel of pixels) {
    for (const byte of [pixel >> 8, pixel & 255]) {
      sum ^= byte;
      for (let bit = 0; bit < 8; bit++) {
        sum = sum & 1 ? sum >>> 1 ^ 0xedb88320 : sum >>> 1;
      }
    }
  }
  return (~sum >>> 0).toString(16).padStart(8, "0");
}

/** A frame of the library as RGB565: entries of a palette by the upper bits of their colours, as fxl_pixels_rgb565. */
function asRgb565({ bits, pixels, palette }) {
  if (bits === 16) {
    return pixels;
  }
  const of = (i) => (palette[3 * i] & 0xf8) << 8 | (palette[3 * i + 1] & 0xfc) << 3 | palette[3 * i + 2] >> 3;
  return Uint16Array.from(pixels, of);
}

/** The middle of a picture, where a display shows a frame that is smaller. */
function middle({ width, height, pixels }, frame) {
  const left = width - frame.width >> 1, top = height - frame.height >> 1;
  return left < 0 || top < 0 ? pixels : Uint16Array.from({ length: frame.width * frame.height },
    (_, i) => pixels[width * (top + Math.trunc(i / frame.width)) + left + i % frame.width]);
}

/** Shows pixels; seen: those of the frame among them, whose CRC it says and answers. */
function put(id, { width, height, pixels }, seen) {
  const last = state.pictures[id];
  if (!last || last.width !== width || last.height !== height) {
    at(id).width = width;
    at(id).height = height;
    state.pictures[id] = new Picture(at(id), width, height);
  }
  state.pictures[id].put(pixels, words);
  return at(`${id}-crc`).textContent = crcOf(seen);
}

function fault(text) {
  at("banner").hidden = !text;
  at("banner").textContent = text;
  if (text) {
    at("verdict").textContent = "it stopped";
  }
}

// --- what the board sends ----------------------------------------------------------

function take({ number, picture }) {
  if (state.game) {
    const frame = number % data.game.length, sent = put("wires", picture, picture.pixels);
    tell(frame, number, sent, at("library-crc").textContent = data.game[frame]);
    return;
  }
  const frame = nextOfLibrary(), pixels = asRgb565(frame);
  const sent = put("wires", picture, middle(picture, frame));
  tell(frame.number, number, sent, put("library", { ...frame, pixels }, pixels));
}

/** Says whether a frame was sent as it was drawn. had: how many frames came before it. */
function tell(number, had, sent, drawn) {
  state.equal = sent === drawn ? state.equal + 1 : state.equal;
  at("verdict").textContent = sent === drawn ? `frame ${number}: equal` : `frame ${number} differs`;
  at("words").textContent = `${state.equal} of ${had + 1} frames equal.`;
}

function nextOfLibrary() {
  if (state.walk.number > 0 && state.walk.number >= state.walk.shown().pathFrames) {
    state.walk.restart();
  }
  return state.walk.draw(null);
}

worker.addEventListener("message", ({ data: said }) => {
  if (said.run !== state.run) {
    return;
  }
  if (said.fault) {
    fault(`${said.fault}\n${said.said}`);
  } else if (said.picture) {
    take(said);
    if (state.paused) {
      state.waits = true;
    } else {
      worker.postMessage("go");
    }
  } else if (!state.pictures.wires) {
    at("verdict").textContent = `it starts: ${(said.cycles / 1e6).toFixed(0)} million cycles`;
  }
});

// --- the page ----------------------------------------------------------------------

async function begin(name) {
  fault("");
  const game = name === GAME, [program, scene] = await Promise.all([bytes(game ? "pico-game.bin" : "pico.bin"), bytes(`scenes/${name}.fxls`)]);
  if (!game) {
    state.walk.open(scene);
  }
  at("library").hidden = game;
  at("beside").textContent = game ? "The same play on a PC, when this site was written" : "The library in this page";
  Object.assign(state, { game, run: state.run + 1, waits: false, pictures: {}, equal: 0 });
  at("name").textContent = game ? "PROGRAM=game" : `SCENE=scenes/${name}.toml`;
  at("verdict").textContent = "it starts";
  at("words").textContent = "";
  worker.postMessage({ run: state.run, program, scene, sceneAt: data.sceneAt });
}

function pause(isPaused) {
  state.paused = isPaused;
  press("#pause", () => isPaused);
  if (!isPaused && state.waits) {
    state.waits = false;
    worker.postMessage("go");
  }
}

/** The scene that the address names, or the first one. */
function named() {
  const name = location.hash.slice(1);
  return programs.includes(name) ? name : programs[0];
}

async function start() {
  at("scene").append(...programs.map((name) => Object.assign(document.createElement("option"), { value: name, textContent: name })));
  at("scene").addEventListener("change", () => { location.hash = at("scene").value; });
  at("pause").addEventListener("click", () => pause(!state.paused));
  const open = () => begin(at("scene").value = named()).catch((problem) => fault(problem.message));
  addEventListener("hashchange", open);
  state.walk = new Walk(await WebAssembly.compile(await bytes("walk.wasm")));
  pause(matchMedia("(prefers-reduced-motion: reduce)").matches);
  await open();
}

start();
