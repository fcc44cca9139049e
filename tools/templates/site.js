// SPDX-License-Identifier: MIT
// The first page of the site: the library as WebAssembly draws a scene, and the page says what the frame costs on a board.
import { Held, press } from "./view_keys.js";
import { Picture, paletteWords, rgb565Words, savePicture } from "./view_picture.js";
import { Views } from "./site_views.js";
import { Refused, Walk } from "./walk.mjs";

const FRAME_TIME = 1000 / 30;   // milliseconds of a frame of a path
const SLOW = 6;                 // times as long
const POSE_LENGTH = 6;
const IMAGE = /[.]fxls$/i;

const at = (id) => document.getElementById(id);
const data = JSON.parse(at("data").textContent);
const state = { walk: null, picture: null, name: "", image: null, costs: null, frame: null, paused: false, slow: false, byKeys: false,
  due: 0, colours: null, colourBytes: "" };
const views = new Views({ select: at("view"), words: at("view-words"), pixel: at("pixel"), canvas: at("screen"), say, fetched });
const held = new Held(() => { if (held.bits) { state.byKeys = true; go(); } });

// --- scenes ------------------------------------------------------------------------

async function fetched(name) {
  const answer = await fetch(name);
  if (!answer.ok) {
    throw new Refused(`${name}: ${answer.status} ${answer.statusText}`);
  }
  return answer;
}

/** Opens a scene of the site. */
async function openScene(name) {
  const [image, costs] = await Promise.all([fetched(`scenes/${name}.fxls`).then((got) => got.arrayBuffer()),
    fetched(`scenes/${name}.json`).then((got) => got.json())]);
  open(name, new Uint8Array(image), costs);
}

/** Opens an image. costs: by board, or null for a file of the reader's own. */
function open(name, image, costs) {
  state.walk.open(image);
  Object.assign(state, { name, image, costs, byKeys: false, picture: null, colourBytes: "" });
  at("scene").value = costs ? name : "";
  at("scene-name").textContent = costs ? (data.scenes.find((each) => each.name === name).said || name) : `${name}, a file of yours`;
  draw();
}

function say(words) {
  at("banner").hidden = !words;
  at("banner").textContent = words;
}

/** Does what may be refused; says so, and answers whether it was done. */
async function tried(what) {
  try {
    await what();
    return true;
  } catch (fault) {
    if (!(fault instanceof Refused)) {
      throw fault;
    }
    say(fault.message);
    return false;
  }
}

/** A file of the reader's: an image is checked by the library and drawn. */
async function openFile(file) {
  say("");
  const was = { name: state.name, image: state.image, costs: state.costs };
  const isDone = await tried(async () => {
    if (!IMAGE.test(file.name)) {
      throw new Refused(`${file.name}: this page draws scene images. In a checkout this makes one of a model or a scene file:\n`
        + `  tools/scene.py build ${file.name} -o scene.fxls\nand make view SCENE=${file.name} shows it live.`);
    }
    open(file.name, new Uint8Array(await file.arrayBuffer()), null);
  });
  if (!isDone && was.image) {
    const words = at("banner").textContent;
    open(was.name, was.image, was.costs);
    say(words);
  }
}

// --- frames ------------------------------------------------------------------------

function draw() {
  const { walk } = state;
  if (!state.byKeys && state.frame && walk.number > 0 && walk.number >= state.frame.pathFrames) {
    walk.restart();
  }
  show(walk.draw(state.byKeys || !walk.shown().pathFrames ? held.bits : null));
}

function show(frame) {
  state.frame = frame;
  if (!state.picture) {
    state.picture = new Picture(at("screen"), frame.width, frame.height);
  }
  state.picture.put(frame.pixels, colours(frame));
  at("crc").textContent = frame.crc.toString(16).padStart(8, "0");
  if (state.paused) {
    lookClosely();
  } else {
    views.clear();
    at("view").value = "board";
  }
  at("number").textContent = state.byKeys ? "of your walk" : `${frame.number} of ${frame.pathFrames}`;
  tellCost();
}

/** Shows the frame that stands by the view that is chosen, if that is another than the library's. */
function lookClosely() {
  if (views.isOther) {
    views.show(state.frame, state.picture, state.colours, state.image);
  } else {
    views.clear();
  }
}

/** What each value of a pixel looks like, made once a palette. */
function colours(frame) {
  const bytes = String(frame.bits === 16 ? 16 : frame.palette);
  if (bytes !== state.colourBytes) {
    state.colourBytes = bytes;
    state.colours = frame.bits === 16 ? rgb565Words() : paletteWords(frame.palette);
  }
  return state.colours;
}

function tellCost() {
  const board = at("board").value, cost = state.costs && state.costs[board];
  const words = (text, more) => { at("cost").textContent = text; at("cost-words").textContent = more; };
  if (!cost) {
    words("–", "fixel predict says what a file of yours costs.");
  } else if (cost.why_not) {
    words("no room", `${cost.why_not}.`);
  } else if (state.byKeys) {
    words("–", "Counted for the path alone: “back to start” follows it.");
  } else {
    const spent = cost.instructions[state.frame.number];
    words(spent === undefined ? "–" : `${spent.toLocaleString("en")} instructions`,
      `An estimate for this frame, as make predict BOARD=${board} makes it: drawing alone. An instruction takes one cycle or more. `
      + `The program of make run, which can draw every scene, and this scene take ${Math.ceil(cost.flash / 1024)} KB of flash.`);
  }
}

// --- time --------------------------------------------------------------------------

function tick(now) {
  requestAnimationFrame(tick);
  if (state.paused || now < state.due) {
    return;
  }
  const length = FRAME_TIME * (state.slow ? SLOW : 1);
  state.due = now - state.due > length ? now + length : state.due + length;     // a slow machine draws fewer frames
  step();
}

function step() {
  if (state.image) {
    tried(draw).then((isDone) => { if (!isDone) { pause(true); } });
  }
}

function pause(isPaused) {
  state.paused = isPaused;
  if (!isPaused && views.isOther) {
    at("view").value = "board";
    views.clear();
  }
  press("#pause", () => isPaused);
}

function go() {
  pause(false);
}

const COMMANDS = {
  KeyP: () => pause(!state.paused), Period: () => { pause(true); step(); }, KeyL: () => { state.slow = !state.slow; press("#slow", () => state.slow); },
  Home: () => { state.byKeys = false; state.walk.restart(); step(); },
};

// --- a link ------------------------------------------------------------------------

/** What a link says: scene and frame; and where the keys have put the eye, its pose. */
function linkOf() {
  const said = new URLSearchParams({ scene: state.name, frame: state.frame.number });
  if (state.byKeys) {
    said.set("pose", Array.from(state.frame.pose).join(","));
  }
  return `#${said}`;
}

/** Opens what the address says; the first scene where it says nothing. */
async function openLink() {
  say("");
  const said = new URLSearchParams(location.hash.slice(1)), name = said.get("scene") ?? data.first;
  const isDone = await tried(async () => {
    if (!data.scenes.some((each) => each.name === name)) {
      throw new Refused(`The link names the scene “${name}”, which this site does not have.`);
    }
    await openScene(name);
    if (said.has("pose")) {
      toPose(said.get("pose"), said.get("frame") ?? "0");
    } else if (said.has("frame")) {
      toFrame(said.get("frame"));
    }
  });
  if (!isDone) {
    const words = at("banner").textContent;
    await openScene(data.first);
    say(words);
  }
}

function toFrame(word) {
  const count = state.frame.pathFrames;
  if (!/^\d+$/.test(word) || Number(word) >= count) {
    throw new Refused(`The link names frame “${word}”; the scene's path has ${count}, from 0.`);
  }
  while (state.frame.number < Number(word)) {
    draw();
  }
  pause(true);
}

function toPose(words, frame) {
  const pose = words.split(",");
  if (pose.length !== POSE_LENGTH || !pose.every((word) => /^-?\d{1,10}$/.test(word)) || !/^\d{1,9}$/.test(frame)) {
    throw new Refused("The link's pose is not six numbers, or its frame is none.");
  }
  state.byKeys = true;
  show(state.walk.drawFrom(Number(frame), pose.map(Number)));
  pause(true);
}

// --- the page ----------------------------------------------------------------------

function listen() {
  held.listen(COMMANDS);
  for (const [name, code] of Object.entries({ pause: "KeyP", step: "Period", restart: "Home", slow: "KeyL" })) {
    at(name).addEventListener("click", COMMANDS[code]);
  }
  at("save").addEventListener("click", () => savePicture(at("screen"), `${state.name}-${state.frame.number}.png`));
  at("link").addEventListener("click", () => { pause(true); location.hash = linkOf(); });
  at("board").addEventListener("change", tellCost);
  at("view").addEventListener("change", () => {
    pause(true);
    if (views.shown) {
      views.put();
    } else {
      lookClosely();
    }
  });
  at("scene").addEventListener("change", () => { say(""); tried(() => openScene(at("scene").value)); });
  addEventListener("hashchange", () => { if (location.hash !== linkOf()) { openLink(); } });
  const stage = at("stage");
  for (const name of ["dragover", "dragleave", "drop"]) {
    stage.addEventListener(name, (event) => {
      event.preventDefault();
      stage.classList.toggle("dropping", name === "dragover");
      if (name === "drop" && event.dataTransfer.files.length) {
        openFile(event.dataTransfer.files[0]);
      }
    });
  }
}

async function start() {
  at("scene").append(...data.scenes.map(({ name }) => Object.assign(document.createElement("option"), { value: name, textContent: name })));
  state.walk = new Walk(await WebAssembly.compile(await (await fetched("walk.wasm")).arrayBuffer()));
  listen();
  pause(matchMedia("(prefers-reduced-motion: reduce)").matches);
  press("#slow", () => false);
  await openLink();
  at("unserved").hidden = true;
  requestAnimationFrame(tick);
}

start();
