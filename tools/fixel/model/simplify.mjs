// SPDX-License-Identifier: MIT
// Makes fewer triangles of a model by meshoptimizer: simplify.py starts it.
//
// usage: node simplify.mjs MODULE VERTICES ATTRIBUTES CORNERS TARGET ERROR WEIGHT...
// It reads positions (3 floats a vertex), attributes (so many floats a vertex), and the vertices of corners (32 bits), and
// writes the vertices of the corners that are left.
import { readFileSync, writeSync } from 'node:fs';

const [module, ...words] = process.argv.slice(2);
const [vertices, attributes, corners, target, error, ...weights] = words.map(Number);
const { MeshoptSimplifier } = await import(module);
await MeshoptSimplifier.ready;

const bytes = readFileSync(0);
const input = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
const positions = new Float32Array(input, 0, 3 * vertices);
const values = new Float32Array(input, 12 * vertices, attributes * vertices);
const indices = new Uint32Array(input, 4 * (3 + attributes) * vertices, corners);
const [left] = MeshoptSimplifier.simplifyWithAttributes(indices, positions, 3, values, attributes, weights, null, target, error);
const output = Buffer.from(left.buffer, left.byteOffset, left.byteLength);
for (let done = 0; done < output.length; ) {
    done += writeSync(1, output, done);
}
