// SPDX-License-Identifier: MIT
// node judged.mjs WALK.wasm JUDGE.wasm IMAGE FRAMES: draws the first frames of an image's path, spoils a pixel of each, and judges them. Prints
// a line each: SHA-256 of what double precision draws, and of the verdict.
import crypto from "node:crypto";
import fs from "node:fs";
import { Judge } from "../../../tools/templates/judge.mjs";
import { Walk } from "../../../tools/templates/walk.mjs";

const [walkFile, judgeFile, imageFile, frames] = process.argv.slice(2);
const module = (file) => new WebAssembly.Module(fs.readFileSync(file));
const image = new Uint8Array(fs.readFileSync(imageFile)), walk = new Walk(module(walkFile)), judge = new Judge(module(judgeFile), image);
walk.open(image);
for (let i = 0; i < Number(frames); i++) {
  const frame = walk.draw(null), pixels = frame.pixels.slice();
  pixels[i] ^= 1;
  const answer = judge.ask({ wants: ["double", "verdict"], pose: frame.pose, frame: frame.number, pixels });
  console.log(...[answer.double, answer.verdict].map((bytes) => crypto.createHash("sha256").update(bytes).digest("hex")));
}
