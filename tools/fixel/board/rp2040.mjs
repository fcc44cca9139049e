// SPDX-License-Identifier: MIT
// A Raspberry Pi Pico: node rp2040.mjs RP2040JS SILENCE IMAGE [WORD...]: RP2040JS is a folder with the package rp2040js, SILENCE how many
// million cycles the program may go without a call to its host, IMAGE the flash. The program finds
// the words as its arguments, and its files in the folder in which this runs. Exit code: the program's, or one of
// boards/contract/system.h for what the emulator itself reports.
// node rp2040.mjs RP2040JS SILENCE IMAGE --alone FRAMES: without a host, as a real board without a debugger: each BKPT is a fault. Ends when its
// display has so many frames, and says by which clocks they came.
// node rp2040.mjs RP2040JS SILENCE IMAGE --memory FILE SIZE: writes what the core reads of its flash, and runs nothing.
import { readFileSync, writeFileSync, writeSync } from 'node:fs';
import { createRequire } from 'node:module';
import { Semihosting } from './rp2040_semihosting.mjs';
import { Wires } from './rp2040_wires.mjs';

const FLASH = 0x10000000, RAM = 0x20000000, STAGE = 0x20041f00, STAGE_BYTES = 256; // where the boot ROM copies it to
const WARNINGS = 100, END = 'FIXEL,end';
const BOARD = 22, UNALIGNED = 42, BUS = 46, USAGE = 47, HANG = 50, DONE = 93; // boards/contract/system.h

const [folder, silence, image, ...words] = process.argv.slice(2);
const { RP2040 } = createRequire(import.meta.url)(folder);
const mcu = new RP2040(), core = mcu.core, clock = mcu.clock;
mcu.flash.set(readFileSync(image)); // a new RP2040 has an erased one

if (words[0] === '--memory') {
  const seen = new DataView(new ArrayBuffer(Number(words[2])));
  for (let at = 0; at < seen.byteLength; at += 4) seen.setUint32(at, mcu.readUint32(FLASH + at), true);
  writeFileSync(words[1], new Uint8Array(seen.buffer));
  process.exit(0);
}

let status = -1, warned = 0, heard = 0;
const hex = (value) => `0x${(value >>> 0).toString(16).padStart(8, '0')}`;
const say = (text) => writeSync(1, text);

function fail(code, sentence) {
  if (status >= 0) return;
  status = code;
  const r = core.registers;
  say(`\nfault: ${sentence}\n  pc  ${hex(core.PC)}  lr  ${hex(core.LR)}  sp  ${hex(core.SP)}\n`
    + `  r0  ${hex(r[0])}  r1  ${hex(r[1])}  r2  ${hex(r[2])}  r3  ${hex(r[3])}  r12 ${hex(r[12])}\n`);
}

// The emulated core has no hard fault: it only warns, and a program that went wild would run for ever.
function warn(name, text) {
  if (/not 32 bit aligned/.test(text)) fail(UNALIGNED, `misaligned address (${text})`);
  else if (name === 'CortexM0Core') fail(USAGE, `instruction that the core cannot execute (${text})`);
  else if (name === 'RP2040') fail(BUS, `nothing at this address (${text})`);
  else if (++warned > WARNINGS) fail(BOARD, `more than ${WARNINGS} warnings of the emulator; the last: ${name}: ${text}`);
  else process.stderr.write(`rp2040js: ${name}: ${text}\n`);
}
mcu.logger = { debug() {}, info() {}, warn, error: warn };

function crc(bytes) { // CRC-32/MPEG-2, as the boot ROM has it
  let sum = 0xffffffff;
  for (const byte of bytes) {
    sum ^= byte << 24;
    for (let bit = 0; bit < 8; bit++) sum = sum & 0x80000000 ? sum << 1 ^ 0x04c11db7 : sum << 1;
  }
  return sum >>> 0;
}

// What the boot ROM does with a flash that begins with a second stage.
function boot() {
  const stage = mcu.flash.subarray(0, STAGE_BYTES);
  if (crc(stage.subarray(0, 252)) !== new DataView(mcu.flash.buffer).getUint32(252, true)) {
    return fail(BOARD, `the boot ROM does not start it: the second stage has the CRC ${hex(crc(stage.subarray(0, 252)))}`);
  }
  mcu.sram.set(stage, STAGE - RAM);
  core.SP = STAGE;
  core.LR = 0;
  core.PC = STAGE;
}

const host = new Semihosting(mcu, words, say, () => core.cycles, (code) => { status = code; });
const frames = words[0] === '--alone' ? Number(words[1]) : null;
mcu.onBreak = (number) => {
  heard = core.cycles;
  if (number !== 0xab) fail(USAGE, `breakpoint ${number}`);
  else if (frames !== null) fail(USAGE, 'a call to a debugger, and there is none');
  else host.call();
};
const wires = new Wires(mcu);
// The package's PLL is always locked. By the data sheet (2.18) it locks if it and its oscillator have power.
const { pllSys } = mcu, readPll = pllSys.readUint32.bind(pllSys);
pllSys.readUint32 = (offset) => (offset === 0 && pllSys.pwr & 0x21 ? readPll(offset) & 0x7fffffff : readPll(offset));
// What is printed on the serial port. A line END ends a program that goes on for ever on a real board.
let line = '';
mcu.uart[0].onByte = (byte) => {
  say(Buffer.from([byte]));
  if (byte === 10 && line === END) status = DONE;
  line = byte === 10 ? '' : line + String.fromCharCode(byte);
};

boot();
while (status < 0) {
  if (core.waiting) {
    if (clock.nextAlarm === null) { fail(HANG, 'the program waits for an interrupt that never comes'); break; }
    const next = Math.max(clock.nanosToNextAlarm, 1);
    clock.tick(next);
    core.cycles += Math.round(next * mcu.clkSys / 1e9);
  } else {
    for (let count = 0; count < 1024 && !core.waiting && status < 0 && wires.frames !== frames; count++) {
      clock.tick(core.executeInstruction() * 1e9 / mcu.clkSys);
    }
  }
  if (wires.frames === frames) {
    say(`alone: ${frames} frames, core ${mcu.clkSys} Hz, SPI ${mcu.spi[0].clockFrequency} Hz\n`);
    status = DONE;
  }
  if (core.cycles - Math.max(heard, wires.heard) > silence * 1e6) fail(HANG, `the program hung: it asked nothing of its host for ${silence} million cycles`);
}
wires.close();
host.close();
process.exit(status);
