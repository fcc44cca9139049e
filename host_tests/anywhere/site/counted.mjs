// SPDX-License-Identifier: MIT
// node counted.mjs WALK.wasm COUNTER.wasm IMAGE FRAMES SETTING...: counts the first frames of an image's path for a board with the settings, and prints
// {noRoom, names, frames} as build/host/predict does.
import fs from "node:fs";
import { Counter } from "../../../tools/templates/counter.mjs";
import { Walk } from "../../../tools/templates/walk.mjs";

const [walkFile, counterFile, imageFile, frames, ...settings] = process.argv.slice(2);
const module = (file) => new WebAssembly.Module(fs.readFileSync(file));
const image = new Uint8Array(fs.readFileSync(imageFile)), counter = new Counter(module(counterFile), image, settings.map(Number));
const counted = [], walk = new Walk(module(walkFile));
walk.open(image);
const most = Math.min(frames, walk.shown().pathFrames);
for (let i = 0; i < most && !counter.noRoom; i++) {
  counted.push(counter.count(walk.draw(null).pose, i));
}
console.log(JSON.stringify({ noRoom: counter.noRoom, names: counter.names, frames: counted }));
