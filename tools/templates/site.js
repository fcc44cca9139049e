// SPDX-License-Identifier: MIT
// The first page of the site: the library as WebAssembly draws a scene, and the page says what the frame costs on a board.
import { CostCard, badgePicture, badgeWords } from "./site_cost.js";
import { FrameCounts } from "./site_count.js";
import { Held, press } from "./view_keys.js";
import { saveFile, savePicture, takeFiles } from "./view_files.js";
import { Picture, paletteWords, rgb565Words } from "./view_picture.js";
import { Views } from "./site_views.js";
import { Refused, Walk, crcWords } from "./walk.mjs";

const FRAME_TIME = 1000 / 30;   // milliseconds of a frame of a path
const SLOW = 6;                 // times as long
const POSE_LENGTH = 6;
const IMAGE = /[.]fxls$/i;

const at = (id) => document.getElementById(id);
const data = JSON.parse(at("data").textContent);
const card = new CostCard(at, data.parts, data.boards);
const state = { walk: null, picture: null, name: "", image: null, isMine: false, costs: new Map(), myCost: null, frame: null, paused: false, slow: false, byKeys: false,
  due: 0, colours: null, colourBytes: "" };
const views = new Views({ select: at("view"), words: at("view-words"), pixel: at("pixel"), canvas: at("screen"), say, fetched });
const counts = new FrameCounts(fetched, data.boards);
const held = new Held(() => { if (held.bits) { state.byKeys = true; go(); } });

// --- scenes ------------------------------------------------------------------------

/** The answer for a file, or for what is posted. Refused: the server's sentence, if it is one of the tools. */
async function fetched(name, how) {
  const answer = await fetch(name, how).catch(() => { throw new Refused(`${name}: the server does not answer`); });
  if (!answer.ok || (data.compiles && answer.headers.get("Content-Type").startsWith("text/plain"))) {
    throw new Refused((data.compiles && await answer.text()) || `${name}: ${answer.status} ${answer.statusText}`);
  }
  return answer;
}

/** Opens a scene of the site. */
async function openScene(name) {
  const [image] = await Promise.all([fetched(`scenes/${encodeURIComponent(name)}.fxls`).then((got) => got.arrayBuffer()), data.compiles || fetchCost(name)]);
  open(name, new Uint8Array(image), false);
  if (data.compiles) {
    tellCostOf(state.image);
  }
}

/** Has what a scene of the site costs on each board. */
async function fetchCost(name) {
  if (!state.costs.has(name)) {
    state.costs.set(name, await (await fetched(`scenes/${name}.json`)).json());
  }
}

/** The same of an image: from the page's server where that compiles and predicts, or else counted here. Null: it is not known. */
async function askCost(image) {
  if (data.compiles) {
    return (await posted(`predict?board=${card.board}`, image)).json();
  }
  if (!counts.knows(card.board)) {
    return null;
  }
  await counts.load();
  return counts.costOf(image, card.board);
}

/** Says what the image that is open costs, as soon as that is known. */
async function tellCostOf(image) {
  const { board } = card;
  state.myCost = undefined;
  const isDone = await tried(async () => {
    const cost = await askCost(image);
    if (state.image === image && card.board === board) {
      state.myCost = cost;
    }
  });
  if (!isDone) {
    state.myCost = null;
  }
  tellCost();
}

function posted(what, body) {
  return fetched(what, { method: "POST", body });
}

/** Opens an image. isMine: a file of the reader's own. */
function open(name, image, isMine) {
  state.walk.open(image);
  state.myCost = null;
  Object.assign(state, { name, image, isMine, byKeys: false, picture: null, colourBytes: "" });
  at("scene").value = isMine ? "" : name;
  at("scene-name").textContent = isMine ? `${name}, a file of yours` : data.scenes.find((each) => each.name === name).said || name;
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

/** A file of the reader's: an image is checked by the library and drawn; another file is compiled first, if the page's server can. */
async function openMine(file) {
  let image = new Uint8Array(await file.arrayBuffer());
  if (!IMAGE.test(file.name) && data.compiles) {
    image = new Uint8Array(await (await posted(`compile?name=${encodeURIComponent(file.name)}`, image)).arrayBuffer());
  } else if (!IMAGE.test(file.name)) {
    throw new Refused(`${file.name}: this page draws scene images. A page that compiles models and scene files, too, is that of\n  make view SCENE=${file.name}\n`
      + `or, with the Python package, fixel view ${file.name}. In a checkout, tools/scene.py build ${file.name} -o scene.fxls makes an image of it.`);
  }
  open(file.name, image, true);
  tellCostOf(image);
}

/** The same; where it is refused, what was drawn before goes on. */
async function openFile(file) {
  say("");
  const was = { name: state.name, image: state.image, isMine: state.isMine };
  const isDone = await tried(() => openMine(file));
  if (!isDone && was.image) {
    const words = at("banner").textContent;
    open(was.name, was.image, was.isMine);
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
  at("crc").textContent = crcWords(frame.crc);
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

/** What the scene costs on the board, as far as it is here. */
function cost() {
  return state.isMine || data.compiles ? state.myCost : state.costs.get(state.name)?.[card.board] ?? null;
}

/** Instructions of the frame: of the path of the first scene on the first board they are there; others are counted, once what counts is here. */
function taken() {
  const known = cost(), { frame, image } = state;
  if (!known || known.why_not || (known.instructions && !state.byKeys)) {
    return known?.instructions?.[frame.number];
  }
  if (!counts.cores) {
    tried(() => counts.load().then(tellCost));
    return undefined;
  }
  return counts.taken(image, card.board, frame, !state.byKeys && frame.pathFrames > 0);
}

function tellCost() {
  card.tell(cost(), taken());
}

function saveBadge() {
  if (cost()?.mean || cost()?.why_not) {
    const words = badgeWords(data.boards[card.board].name, card.clock, cost());
    saveFile(new Blob([badgePicture(data.badge, words)], { type: "image/svg+xml" }), `${state.name}-${card.board}.svg`);
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
  KeyO: () => at("open").click(),
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
    if (data.compiles && said.has("file")) {    // it was dropped on the live window
      await openMine(new File([await (await fetched("kept")).arrayBuffer()], said.get("file")));
      return;
    }
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
  at("link").addEventListener("click", () => {
    pause(true);
    if (state.isMine) {
      say("No link holds a file of yours.");
    } else {
      location.hash = linkOf();
    }
  });
  at("board").addEventListener("change", () => {
    card.chosen();
    if (state.isMine || data.compiles) {
      tellCostOf(state.image);
    }
    tellCost();
  });
  at("clock").addEventListener("input", tellCost);
  at("badge").addEventListener("click", saveBadge);
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
  takeFiles(at("stage"), at("open"), at("file"), openFile);
}

/** As an <iframe>: the picture alone, and a way to the whole page. */
function embed() {
  document.documentElement.classList.add("embed");
  at("whole").hidden = false;
  at("whole").addEventListener("click", () => { at("whole").href = `${location.pathname}${linkOf()}`; });
}

async function start() {
  if (new URLSearchParams(location.search).has("embed")) {
    embed();
  }
  at("scene").append(...data.scenes.map(({ name }) => Object.assign(document.createElement("option"), { value: name, textContent: name })));
  const hasModule = await tried(async () => { state.walk = new Walk(await WebAssembly.compile(await (await fetched("walk.wasm")).arrayBuffer())); });
  if (!hasModule) {
    at("unserved").hidden = true;
    return;
  }
  listen();
  pause(matchMedia("(prefers-reduced-motion: reduce)").matches);
  press("#slow", () => false);
  await openLink();
  at("unserved").hidden = true;
  requestAnimationFrame(tick);
}

start();
