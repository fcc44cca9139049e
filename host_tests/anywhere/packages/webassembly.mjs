// SPDX-License-Identifier: MIT
// node webassembly.mjs MODULE SCENE.fxls: draws the scene's path by the walk as WebAssembly, and prints the frames' record as hashes.json has it.
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { Walk } from '../../../tools/templates/walk.mjs';

const DIGITS = 16; // tools/fixel/check/frame_hashes.py
const [file, image] = process.argv.slice(2);
const walk = new Walk(new WebAssembly.Module(readFileSync(file)));
const record = { counters: {}, frames: [] };
walk.open(readFileSync(image));
for (let frame = walk.draw(null); ; frame = walk.draw(null)) {
  const { buffer, byteOffset, byteLength } = frame.pixels;
  record.frames.push(createHash('sha256').update(new Uint8Array(buffer, byteOffset, byteLength)).digest('hex').slice(0, DIGITS));
  for (const [name, count] of Object.entries(frame.counters)) record.counters[name] = (record.counters[name] ?? 0) + count;
  if (walk.number === frame.pathFrames) break;
}
console.log(JSON.stringify(record));
