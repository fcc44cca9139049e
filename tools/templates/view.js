// SPDX-License-Identifier: MIT
// The live window: a websocket's frames on the page, the page's keys to the websocket.
import { Picture, Plot, dimmed, paletteWords } from "./view_picture.js";

const KEYS = {  // by the key's place, whatever the layout: bits of fixel/viewer.h
  ArrowUp: 1, KeyW: 1, ArrowDown: 2, KeyS: 2, ArrowLeft: 4, KeyA: 4, ArrowRight: 8, KeyD: 8,
  KeyR: 16, PageUp: 16, KeyF: 32, PageDown: 32, KeyQ: 64, KeyE: 128,
};
const BESIDE = { Digit0: "", Digit1: "double", Digit2: "difference", Digit3: "wireframe" };
const NAMES = { double: "double precision", difference: "difference", wireframe: "outlines, in double" };
const WANTS = { "": 0, double: 1, difference: 1, wireframe: 2 };
const PLOTTED = 240;        // frames
const WORDS_INTERVAL = 125; // milliseconds between two changes of the figures: they are to be read
const RATE_SPAN = 1000;     // milliseconds that a rate is measured over
const FIGURES_WIDTH = 316;  // of the column beside the frames, where it fits
const CAPTION_HEIGHT = 26;

const at = (id) => document.getElementById(id);
const number = (value, digits = 0) =>
  value.toLocaleString("en", { minimumFractionDigits: digits, maximumFractionDigits: digits });

let socket, hello, fixed, other, palette, grey;
let newest = null, drawing = false, beside = "", scale = 1, wordsAt = 0;
const plot = new Plot(at("plot"), PLOTTED);
const shown = [];           // {time, number} of the frames of the last second
const held = new Map();     // what is held: a key or a button -> bit
let compared = { frames: 0, pixels: 0 };

// --- the wire ------------------------------------------------------------------

function connect() {
  socket = new WebSocket(`ws://${location.host}${location.pathname}live`);
  socket.binaryType = "arraybuffer";
  socket.onmessage = ({ data }) => {
    if (typeof data === "string") {
      const message = JSON.parse(data);
      if (message.type === "hello") {
        greet(message);
      } else {
        end(message.message, "The view was ended.");
      }
    } else {
      newest = unpack(data);
      redraw();
    }
  };
  socket.onclose = () => end("", "The connection was lost: is `make view` still running? Then reload this page.");
}

function say(message) {
  if (socket.readyState === WebSocket.OPEN) {
    socket.send(JSON.stringify(message));
  }
}

function unpack(data) {
  const length = new DataView(data).getUint32(0, true);
  const frame = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, length)));
  const [pixels, double, outlines] = frame.bytes;
  let offset = 4 + length;
  frame.pixels = new Uint8Array(data, offset, pixels);
  frame.double = new Uint8Array(data, offset += pixels, double);
  frame.outlines = new DataView(data, offset + double, outlines);
  return frame;
}

function greet(message) {
  hello = message;
  at("board").textContent = hello.board;
  at("cpu").textContent = hello.cpu;
  at("scene").textContent = `${hello.scene}, ${hello.width} × ${hello.height}`;
  at("beside-label").hidden = at("beside-choice").hidden = !hello.judged;
  at("state").textContent = "live";
  at("state").className = "live";
  document.title = `${hello.board} – Fixel live`;
  palette = paletteWords(Uint8Array.from(atob(hello.palette), (c) => c.charCodeAt(0)));
  grey = dimmed(palette);
  fixed = new Picture(at("fixed"), hello.width, hello.height);
  other = new Picture(at("other"), hello.width, hello.height);
  fixed.plain();
  other.plain();
  layOut();
}

/** The first word about an end is the one that counts. */
function end(message, instead) {
  if (at("state").className === "ended") {
    return;
  }
  at("state").textContent = "ended";
  at("state").className = "ended";
  at("banner").textContent = message || instead;
  at("banner").hidden = false;
  layOut();
}

// --- frames --------------------------------------------------------------------

function redraw() {
  if (!drawing) {
    drawing = true;
    requestAnimationFrame(() => {
      drawing = false;
      draw(newest);
      say({ type: "seen" });
    });
  }
}

function draw(frame) {
  fixed.put(frame.pixels, palette);
  at("number").textContent = number(frame.number);
  if (beside && frame.given & WANTS[beside]) {
    drawBeside(frame);
  }
  const now = performance.now();
  shown.push({ time: now, number: frame.number });
  while (now - shown[0].time > RATE_SPAN) {
    shown.shift();
  }
  if (frame.instructions) {
    plot.add(frame.instructions);
  }
  if (now - wordsAt > WORDS_INTERVAL) {
    wordsAt = now;
    tell(frame);
  }
}

function drawBeside(frame) {
  let words = NAMES[beside];
  if (beside === "double") {
    other.put(frame.double, palette);
  } else if (beside === "difference") {
    const pixels = other.putDifference(frame.pixels, frame.double, grey);
    compared = { frames: compared.frames + 1, pixels: compared.pixels + pixels };
    words += `: ${number(pixels)} pixels; ${number(compared.pixels)} in ${number(compared.frames)} frames`;
  } else {
    words += `: ${number(other.putWireframe(frame.pixels, grey, frame.outlines, scale))} polygons`;
  }
  at("other-name").textContent = words;
  at("other-number").textContent = number(frame.number);
}

function tell(frame) {
  const first = shown[0], last = shown[shown.length - 1], seconds = (last.time - first.time) / 1000;
  if (seconds > 0.2) {
    at("board-rate").textContent = number((last.number - first.number) / seconds, 1);
    at("page-rate").textContent = number((shown.length - 1) / seconds, 1);
  }
  at("instructions").textContent = frame.instructions ? number(frame.instructions) : "not counted on this board";
  plot.draw();
  tellPolygons(frame.counters);
  ["x", "y", "z"].forEach((axis, i) => { at(axis).textContent = number(frame.position[i] / 65536, 3); });
  ["yaw", "pitch", "roll"].forEach((turn, i) => {
    const degrees = frame.angles[i] * 360 / 2 ** 32;
    at(turn).textContent = `${number(turn !== "yaw" && degrees > 180 ? degrees - 360 : degrees, 1)}°`;
  });
  press("[data-rate]", (button) => Number(button.dataset.rate) === frame.rate);
}

function tellPolygons(counters) {
  const body = at("polygons").tBodies[0];
  for (const [name, count] of Object.entries(counters)) {
    let row = body.querySelector(`tr[data-name="${name}"]`);
    if (!row) {
      row = body.insertRow();
      row.dataset.name = name;
      row.append(Object.assign(document.createElement("th"), { textContent: name.replace("_", " "), scope: "row" }));
      row.insertCell();
      row.insertCell().className = "bar";
      row.cells[2].append(document.createElement("i"));
    }
    row.cells[1].textContent = number(count);
    row.cells[2].firstChild.style.width = `${100 * count / Math.max(1, counters.in)}%`;
  }
}

// --- the layout: whole screen pixels for each pixel of a frame -------------------

/** How many screen pixels a frame's may take, with so many frames in a row, the figures aside or below. */
function scaleOf(columns, rows, room, height, ratio) {
  const tall = Math.floor((height / rows - CAPTION_HEIGHT) * ratio / hello.height);
  const aside = Math.floor((room - FIGURES_WIDTH) * ratio / (columns * hello.width));
  const below = Math.floor(room * ratio / (columns * hello.width));
  return Math.min(tall, Math.max(aside, Math.min(below, 2 * ratio)));
}

function layOut() {
  if (!hello) {
    return;
  }
  const ratio = window.devicePixelRatio || 1, room = document.documentElement.clientWidth;
  const height = window.innerHeight - at("stage").getBoundingClientRect().top - window.scrollY;
  const frames = beside ? 2 : 1;
  const abreast = scaleOf(frames, 1, room, height, ratio), stacked = scaleOf(1, frames, room, height, ratio);
  const isStacked = stacked > abreast || room < frames * hello.width;
  // A narrow window scrolls: there a frame may be as wide as it is.
  const narrow = room < 2 * FIGURES_WIDTH ? Math.floor(room * ratio / hello.width) : 1;
  scale = Math.max(1, narrow, isStacked ? stacked : abreast);
  for (const canvas of [at("fixed"), at("other")]) {
    canvas.style.width = `${scale * hello.width / ratio}px`;
    canvas.style.height = `${scale * hello.height / ratio}px`;
  }
  const left = room - frames * scale * hello.width / ratio;
  at("stage").style.setProperty("--gap", `${isStacked ? 0 : Math.max(0, Math.min(12, left))}px`);
  at("stage").style.flexDirection = isStacked ? "column" : "row";
}

function press(selector, isPressed) {
  document.querySelectorAll(selector).forEach((button) => {
    button.setAttribute("aria-pressed", String(isPressed(button)));
  });
}

function show(what) {
  if (what && !hello.judged) {
    return;     // a game: no reference renderer knows it
  }
  beside = what;
  compared = { frames: 0, pixels: 0 };
  at("beside").hidden = !what;
  at("other-name").textContent = NAMES[what] || "";
  at("other-number").textContent = "–";
  press("[data-beside]", (button) => button.dataset.beside === beside);
  layOut();
  say({ type: "wants", wants: WANTS[beside] });
}

// --- keys ------------------------------------------------------------------------

function hold(what, bit) {
  if (bit ? held.get(what) === bit : !held.has(what)) {
    return;
  }
  if (bit) {
    held.set(what, bit);
  } else {
    held.delete(what);
  }
  tellKeys();
}

function tellKeys() {
  const bits = [...held.values()].reduce((sum, bit) => sum | bit, 0);
  press("[data-bit]", (button) => Boolean(Number(button.dataset.bit) & bits));
  say({ type: "keys", held: bits });
}

function letGo() {
  if (held.size) {
    held.clear();
    tellKeys();
  }
}

function listen() {
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) {
      return; // the browser's own
    }
    if (event.code in KEYS) {
      event.preventDefault();
      hold(event.code, KEYS[event.code]);
    } else if (event.code in BESIDE && !event.repeat) {
      show(BESIDE[event.code]);
    }
  });
  addEventListener("keyup", (event) => hold(event.code, 0));
  addEventListener("blur", letGo);
  document.addEventListener("visibilitychange", letGo);
  addEventListener("resize", layOut);
  document.querySelectorAll("[data-beside]").forEach((button) => {
    button.addEventListener("click", () => show(button.dataset.beside));
  });
  document.querySelectorAll("[data-rate]").forEach((button) => {
    button.addEventListener("click", () => say({ type: "rate", rate: Number(button.dataset.rate) }));
  });
  document.querySelectorAll("[data-bit]").forEach(listenToKey);
}

/** A key on the page: held by pointer, or by Space and Enter where it has the focus. */
function listenToKey(button) {
  const what = `button ${button.dataset.bit}`, bit = Number(button.dataset.bit);
  const release = () => hold(what, 0);
  button.addEventListener("pointerdown", (event) => {
    button.setPointerCapture(event.pointerId);
    hold(what, bit);
  });
  button.addEventListener("keydown", (event) => {
    if (event.code === "Space" || event.code === "Enter") {
      event.preventDefault();
      hold(what, bit);
    }
  });
  for (const name of ["pointerup", "pointercancel", "lostpointercapture", "keyup", "blur"]) {
    button.addEventListener(name, release);
  }
}

press("[data-beside]", (button) => button.dataset.beside === "");
press("[data-rate]", () => false);
press("[data-bit]", () => false);
listen();
connect();
