// SPDX-License-Identifier: MIT
// The page of a program of examples/: it runs here, all its frames at once, and they are shown again and again.
import { press } from "./view_keys.js";
import { savePicture } from "./view_files.js";
import { Picture, paletteWords, rgb565Words } from "./view_picture.js";
import { Program } from "./program.mjs";
import { Refused, crcWords } from "./walk.mjs";

const FRAME_TIME = 1000 / 30;   // milliseconds
const at = (id) => document.getElementById(id);
const data = JSON.parse(at("data").textContent);
const state = { number: 0, due: 0, paused: false };

function show() {
  const { program, picture, colours, number } = state, { crc, pixels } = program.frame(number);
  picture.put(pixels, colours);
  at("crc").textContent = crcWords(crc);
  at("number").textContent = `${number} of ${program.count}`;
}

function step() {
  state.number = (state.number + 1) % state.program.count;
  show();
}

function tick(now) {
  requestAnimationFrame(tick);
  if (!state.paused && now >= state.due) {
    state.due = Math.max(state.due + FRAME_TIME, now);
    step();
  }
}

function pause(isPaused) {
  state.paused = isPaused;
  press("#pause", () => isPaused);
}

async function start() {
  const answer = await fetch(`${data.name}.wasm`);
  if (!answer.ok) {
    throw new Refused(`${data.name}.wasm: ${answer.status} ${answer.statusText}`);
  }
  const program = new Program(await WebAssembly.compile(await answer.arrayBuffer()), data.frames);
  state.program = program;
  state.picture = new Picture(at("screen"), program.width, program.height);
  state.picture.plain();
  state.colours = program.bits === 16 ? rgb565Words() : paletteWords(program.palette);
  show();
  at("unserved").hidden = true;
  at("pause").addEventListener("click", () => pause(!state.paused));
  at("step").addEventListener("click", () => { pause(true); step(); });
  at("save").addEventListener("click", () => savePicture(at("screen"), `${data.name}-${state.number}.png`));
  pause(program.count === 1 || matchMedia("(prefers-reduced-motion: reduce)").matches);
  requestAnimationFrame(tick);
}

start().catch((fault) => {
  at("banner").hidden = false;
  at("banner").textContent = fault.message;
  if (!(fault instanceof Refused)) {
    throw fault;
  }
});
