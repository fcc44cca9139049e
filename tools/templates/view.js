// SPDX-License-Identifier: MIT
// The live window: a websocket's frames on the page, the page's keys to the websocket.
import { Held, press } from "./view_keys.js";
import { savePicture, takeFiles } from "./view_files.js";
import { Picture, Plot, dimmed, paletteWords } from "./view_picture.js";
import { lookAt, pixelAt, pixelWords } from "./view_pixel.js";
import { FIGURES_WIDTH, Zoom, scaleBelow, scaleOf } from "./view_zoom.js";

const COMMANDS = {
  Digit0: () => show(""), Digit1: () => show("double"), Digit2: () => show("difference"), Digit3: () => show("wireframe"),
  KeyO: () => at("open").click(), KeyP: () => say({ type: "pause", paused: !paused }), Period: () => say({ type: "step" }),
  Home: () => say({ type: "restart" }), Equal: () => zoomBy(1), NumpadAdd: () => zoomBy(1), Minus: () => zoomBy(-1),
  NumpadSubtract: () => zoomBy(-1),
};
const NAMES = { double: "double precision", difference: "difference", wireframe: "outlines, in double" };
const FRAME = 1, OUTLINES = 2, FACES = 4, VERDICT = 8;  // of the reference renderer: tools/fixel/view_reference.py
const WANTS = { "": 0, double: FRAME, difference: VERDICT, wireframe: OUTLINES };
const PLOTTED = 240;        // frames
const WORDS_INTERVAL = 125; // milliseconds between two changes of the figures: they are to be read
const RATE_SPAN = 1000;     // milliseconds that a rate is measured over
const KEYS_MARGIN = 40;     // above and below the keys, in a narrow window
const LINES_MAX = 4096;     // picture elements on a side of a canvas with outlines

const at = (id) => document.getElementById(id);
const number = (value, digits = 0) =>
  value.toLocaleString("en", { minimumFractionDigits: digits, maximumFractionDigits: digits });

let socket, hello, fixed, other, palette, grey;
let newest = null, drawing = false, drawn = -1, beside = "", wants = 0, scale = 1, wordsAt = 0, wordsDue = 0;
let paused = false, trouble = "";
let pointed = null, picked = null;      // the pixel under the pointer, and what the board said last of such a one
const zoom = new Zoom([at("fixed").parentElement, at("other").parentElement], zoomed);
const plot = new Plot(at("plot"), PLOTTED);
const shown = [];           // {time, number} of the frames of the last second
const held = new Held((bits) => say({ type: "keys", held: bits }));
let compared = { number: -1, frames: 0, pixels: 0 };

// --- the wire ------------------------------------------------------------------

function connect() {
  socket = new WebSocket(`ws://${location.host}${location.pathname}live`);
  socket.binaryType = "arraybuffer";
  socket.onmessage = ({ data }) => {
    if (typeof data === "string") {
      const message = JSON.parse(data);
      if (message.type === "hello") {
        greet(message);
      } else if (message.type === "state") {
        setState(message);
      } else if (message.type === "picked") {
        picked = message;
        tellPixel(newest);
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
  const [pixels, double = 0, outlines = 0, faces = 0, verdict = 0] = frame.bytes;
  let offset = 4 + length;
  frame.pixels = pixelsOf(data, offset, pixels);
  frame.double = pixelsOf(data, offset += pixels, double);
  frame.outlines = new DataView(data, offset += double, outlines);
  frame.faces = new DataView(data, offset += outlines, faces);
  frame.verdict = new Uint8Array(data, offset + faces, verdict);
  return frame;
}

/** Pixels of 8 bits, or of 16, which are copied because they need not lie at an even place. */
function pixelsOf(data, offset, size) {
  return palette.length > 256 ? new Uint16Array(data.slice(offset, offset + size)) : new Uint8Array(data, offset, size);
}

function greet(message) {
  hello = message;
  at("board").textContent = hello.board;
  at("cpu").textContent = hello.cpu;
  at("scene").textContent = `${fileName(hello.scene)}, ${hello.width} × ${hello.height}`;
  at("scene").title = hello.scene;
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
  newest = picked = null;
  drawn = -1;
  point(null);
  layOut();
}

/** The rate, whether the board is paused, and what is wrong with its program: for all tabs the same. */
function setState(message) {
  paused = message.paused;
  if (trouble !== message.trouble) {
    trouble = message.trouble;
    at("banner").textContent = trouble;
    at("banner").hidden = !trouble;
    layOut();
  }
  press("[data-rate]", (button) => Number(button.dataset.rate) === message.rate);
  press("#pause", () => paused);
  at("state").textContent = message.stopped ? "stopped" : paused ? "paused" : "live";
  at("state").classList.toggle("paused", paused);
  at("state").classList.toggle("stopped", message.stopped);
  shown.length = 0;
  at("board-rate").textContent = at("page-rate").textContent = "–";
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
      if (newest) {     // else the board has frames of another size by now
        draw(newest);
      }
      say({ type: "seen" });
    });
  }
}

function draw(frame) {
  if (frame.number !== drawn) {
    count(frame);
  }
  paint(frame);
  if (!wordsDue) {
    wordsDue = setTimeout(() => {
      wordsDue = 0;
      wordsAt = performance.now();
      if (newest) {
        tell(newest);
      }
    }, Math.max(0, wordsAt + WORDS_INTERVAL - performance.now()));
  }
}

function paint(frame) {
  fixed.put(frame.pixels, palette);
  at("number").textContent = number(frame.number);
  if (beside && frame.given & WANTS[beside]) {
    drawBeside(frame);
  }
  tellPixel(frame);
}

function count(frame) {
  if (frame.number < drawn) {     // the board has begun anew
    shown.length = 0;
    plot.clear();
  }
  drawn = frame.number;
  const now = performance.now();
  shown.push({ time: now, number: frame.number });
  while (now - shown[0].time > RATE_SPAN) {
    shown.shift();
  }
  if (frame.instructions) {
    plot.add(frame.instructions);
  }
}

function drawBeside(frame) {
  let words = NAMES[beside];
  if (beside === "double") {
    other.put(frame.double, palette);
  } else if (beside === "difference") {
    const { beyond, within } = other.putDifference(frame.pixels, frame.verdict, grey);
    if (frame.number !== compared.number) {
      compared = { number: frame.number, frames: compared.frames + 1, pixels: compared.pixels + beyond };
    }
    words += `: ${number(beyond)} pixels, ${number(compared.pixels)} in ${number(compared.frames)} frames; `
      + `${number(within)} within the bound`;
  } else {
    const fine = Math.min(scale * zoom.factor, Math.floor(LINES_MAX / Math.max(hello.width, hello.height)));
    words += `: ${number(other.putWireframe(frame.pixels, grey, frame.outlines, fine))} polygons`;
  }
  at("other-name").textContent = words;
  at("other-number").textContent = number(frame.number);
}

function tell(frame) {
  const first = shown[0], last = shown[shown.length - 1], seconds = first ? (last.time - first.time) / 1000 : 0;
  if (seconds > 0.2 && !paused) {
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
}

function tellPixel(frame) {
  if (pointed && frame) {
    const seen = lookAt(frame, pointed, hello.width, palette, picked);
    at("pixel-words").textContent = pixelWords(pointed, seen, hello);
    at("swatch").hidden = false;
    at("swatch").style.background = `rgb(${seen.board.rgb.join(" ")})`;
  }
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

function layOut() {
  if (!hello) {
    return;
  }
  const ratio = window.devicePixelRatio || 1, room = document.documentElement.clientWidth;
  const isNarrow = room < 2 * FIGURES_WIDTH;  // then the keys are below the picture, and the figures below the keys
  const height = window.innerHeight - at("stage").getBoundingClientRect().top - window.scrollY
    - at("bar").offsetHeight - (isNarrow ? at("keys").offsetHeight + KEYS_MARGIN : 0);
  const frames = beside ? 2 : 1;
  const abreast = scaleOf(hello, frames, 1, room, height, ratio);
  const stacked = isNarrow ? scaleBelow(hello, frames, room, height, ratio)
    : scaleOf(hello, 1, frames, room, height, ratio);
  const isStacked = isNarrow || stacked > abreast || room < frames * hello.width;
  scale = Math.max(1, isStacked ? stacked : abreast);
  zoom.fit(scale * hello.width / ratio, scale * hello.height / ratio);
  const left = room - frames * scale * hello.width / ratio;
  at("stage").style.setProperty("--gap", `${isStacked ? 0 : Math.max(0, Math.min(12, left))}px`);
  at("stage").style.flexDirection = isStacked ? "column" : "row";
}

function show(what) {
  if (what && !hello.judged) {
    return;     // a game: no reference renderer knows it
  }
  beside = what;
  compared = { number: -1, frames: 0, pixels: 0 };
  at("beside").hidden = !what;
  at("other-name").textContent = NAMES[what] || "";
  at("other-number").textContent = "–";
  press("[data-beside]", (button) => button.dataset.beside === beside);
  layOut();
  tellWants();
  if (newest) {
    paint(newest);
  }
}

/** Tells the server which parts of the reference renderer's answer the page shows. */
function tellWants() {
  const now = WANTS[beside] | (pointed && hello.judged ? FRAME | FACES : 0);
  if (now !== wants) {
    wants = now;
    say({ type: "wants", wants });
  }
}

function zoomed() {
  at("zoom").textContent = `${zoom.factor}×`;
  at("smaller").disabled = zoom.isLeast;
  at("larger").disabled = zoom.isMost;
  if (newest) {
    paint(newest);
  }
}

/** More (1) or less (-1), about the pixel under the pointer. */
function zoomBy(by) {
  zoom.step(by, pointed && { x: (pointed.x + 0.5) / hello.width, y: (pointed.y + 0.5) / hello.height });
}

function point(pixel) {
  const place = pixel && [pixel.x, pixel.y];
  if (hello.picks && String(place) !== String(pointed && [pointed.x, pointed.y])) {
    say({ type: "point", pixel: place });
  }
  pointed = pixel;
  tellWants();
  tellPixel(newest);
}

/** The last part of a path. */
function fileName(path) {
  return path.split(/[\\/]/).pop();
}

/** Hands the board's frame to the browser as a file. */
function save() {
  const scene = fileName(hello.scene).replace(/[.][^.]*$/, "");
  savePicture(at("fixed"), `${hello.board}-${scene}-${newest.number}.png`);
}

/** A file of the reader's: the page that draws in the browser opens it. */
async function take(file) {
  const answer = await fetch("keep", { method: "POST", body: file }).catch(() => null);
  if (answer?.ok) {
    location.assign(`draw.html#${new URLSearchParams({ file: file.name })}`);
  } else {
    at("banner").textContent = `${file.name} was not taken: ${answer ? answer.statusText : "the server does not answer"}.`;
    at("banner").hidden = false;
    layOut();
  }
}

// --- keys ------------------------------------------------------------------------

function listen() {
  held.listen(COMMANDS);
  addEventListener("resize", layOut);
  document.querySelectorAll("[data-beside]").forEach((button) => {
    button.addEventListener("click", () => show(button.dataset.beside));
  });
  document.querySelectorAll("[data-rate]").forEach((button) => {
    button.addEventListener("click", () => say({ type: "rate", rate: Number(button.dataset.rate) }));
  });
  for (const [name, code] of Object.entries({ pause: "KeyP", step: "Period", restart: "Home", larger: "Equal",
    smaller: "Minus" })) {
    at(name).addEventListener("click", COMMANDS[code]);
  }
  at("save").addEventListener("click", () => newest && save());
  takeFiles(at("stage"), at("open"), at("file"), take);
  [at("fixed"), at("other")].forEach(listenToPointer);
}

/** The pixel under the pointer; under a finger, the last that it touched. */
function listenToPointer(canvas) {
  for (const name of ["pointermove", "pointerdown"]) {
    canvas.addEventListener(name, (event) => {
      if (newest) {
        point(pixelAt(canvas, event, hello.width, hello.height));
      }
    });
  }
  canvas.addEventListener("pointerleave", (event) => {
    if (event.pointerType === "mouse") {
      point(null);
    }
  });
}

press("[data-beside]", (button) => button.dataset.beside === "");
press("[data-rate]", () => false);
press("#pause", () => false);
zoomed();
listen();
connect();
