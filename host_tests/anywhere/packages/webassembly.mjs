// SPDX-License-Identifier: MIT
// node webassembly.mjs MODULE SCENE.fxls OUT.fxld: the host of webassembly.c. Exit code: 0, or one of boards/contract/system.h.
import { readFileSync, writeFileSync } from 'node:fs';

const DONE = 93; // boards/contract/system.h
const [file, image, out] = process.argv.slice(2);
const { exports: board } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(file))); // throws if the module imports anything
const bytes = (at, size) => new Uint8Array(board.memory.buffer, at, size);
const scene = readFileSync(image);
bytes(board.scene(scene.length), scene.length).set(scene);
let trap;
try { board.run(); } catch (fault) { trap = fault; }
const [status, dump, dumpBytes, text, textBytes] = new Uint32Array(board.memory.buffer, board.outcome(), 5);
process.stderr.write(bytes(text, textBytes));
if (status === 0) throw trap; // not the one of system_exit
if (status === DONE) writeFileSync(out, bytes(dump, dumpBytes));
else process.exitCode = status;
