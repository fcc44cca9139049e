// SPDX-License-Identifier: MIT
// A Raspberry Pi Pico: node rp2040.mjs RP2040JS SILENCE IMAGE [WORD...]: RP2040JS is a folder with the package rp2040js, SILENCE how many
// million cycles the program may go without a call to its host, IMAGE the flash. The program finds
// the words as its arguments, and its files in the folder in which this runs. Exit code: the program's, or one of
// boards/contract/system.h for what the emulator itself reports.
// node rp2040.mjs RP2040JS SILENCE IMAGE --alone FRAMES: without a host, as a real board without a debugger: each BKPT is a fault. Ends when its
// display has so many frames, and says by which clocks they came.
// node rp2040.mjs RP2040JS SILENCE IMAGE --memory FILE SIZE: writes what the core reads of its flash, and runs nothing.
import { closeSync, openSync, readFileSync, readSync, writeFileSync, writeSync } from 'node:fs';
import { createRequire } from 'node:module';
import { advance, boot, hex, listen, powered } from './rp2040_machine.mjs';

const FLASH = 0x10000000, RAM = 0x20000000;
const WARNINGS = 100, END = 'FIXEL,end';
const BOARD = 22, UNALIGNED = 42, BUS = 46, USAGE = 47, HANG = 50, DONE = 93; // boards/contract/system.h

// Semihosting ("Semihosting for AArch32 and AArch64", Arm) for rp2040js: what boards/parts/semihosting.c calls, BKPT 0xAB
// with the operation in r0 and its parameters in r1.
const [OPEN, CLOSE, WRITE0, WRITE, READ, SEEK, GET_CMDLINE, EXIT_EXTENDED, ELAPSED] =
  [0x01, 0x02, 0x04, 0x05, 0x06, 0x0a, 0x15, 0x20, 0x30];
const APPLICATION_EXIT = 0x20026, FATAL = 1, MODES = { 1: 'r', 5: 'w' };

class Semihosting {
  // words: the program's arguments, its name first. say(text), ticks(): what is counted, end(status).
  constructor(mcu, words, say, ticks, end) {
    Object.assign(this, { mcu, line: words.join(' '), say, ticks, end, files: new Map(), next: 1 });
  }

  word(address) { return this.mcu.readUint32(address) >>> 0; }

  // The bytes of the RAM themselves, or a copy of others.
  bytes(address, size) {
    const { mcu } = this;
    if (address >= RAM && address - RAM + size <= mcu.sram.length) return mcu.sram.subarray(address - RAM, address - RAM + size);
    return Uint8Array.from({ length: size }, (_, i) => mcu.readUint8(address + i));
  }

  put(address, bytes) { bytes.forEach((byte, i) => this.mcu.writeUint8(address + i, byte)); }

  text(address) {
    let size = 0;
    while (this.mcu.readUint8(address + size) !== 0) size++;
    return Buffer.from(this.bytes(address, size)).toString('latin1');
  }

  open(address) {
    const name = Buffer.from(this.bytes(this.word(address), this.word(address + 8))).toString('latin1');
    const mode = MODES[this.word(address + 4)];
    if (!mode || /[/\\]/.test(name)) return -1;
    try {
      this.files.set(this.next, { fd: openSync(name, mode), at: 0 });
    } catch {
      return -1;
    }
    return this.next++;
  }

  // How many bytes are missing.
  transfer(address, how) {
    const file = this.files.get(this.word(address)), size = this.word(address + 8);
    if (!file) return size;
    let done = 0;
    try {
      done = how(file, this.word(address + 4), size);
    } catch (error) {
      this.say(`the host's file: ${error.code}\n`);
    }
    file.at += done;
    return size - done;
  }

  operate(operation, address) {
    switch (operation) {
      case OPEN: return this.open(address);
      case CLOSE: {
        const file = this.files.get(this.word(address));
        if (!file) return -1;
        closeSync(file.fd);
        this.files.delete(this.word(address));
        return 0;
      }
      case WRITE0: this.say(this.text(address)); return 0;
      case WRITE: return this.transfer(address, (file, from, size) => {
        for (let done = 0; done < size;) done += writeSync(file.fd, this.bytes(from + done, size - done));
        return size;
      });
      case READ: return this.transfer(address, (file, to, size) => {
        const read = Buffer.alloc(size), done = readSync(file.fd, read, 0, size, file.at);
        this.put(to, read.subarray(0, done));
        return done;
      });
      case SEEK: {
        const file = this.files.get(this.word(address));
        if (!file) return -1;
        file.at = this.word(address + 4);
        return 0;
      }
      case GET_CMDLINE: {
        const line = Buffer.from(`${this.line}\0`, 'latin1');
        if (line.length > this.word(address + 4)) return -1;
        this.put(this.word(address), line);
        this.mcu.writeUint32(address + 4, line.length - 1);
        return 0;
      }
      case EXIT_EXTENDED: this.end(this.word(address) === APPLICATION_EXIT ? this.word(address + 4) & 255 : FATAL); return 0;
      case ELAPSED: {
        const ticks = BigInt(this.ticks());
        this.mcu.writeUint32(address, Number(ticks & 0xffffffffn));
        this.mcu.writeUint32(address + 4, Number(ticks >> 32n));
        return 0;
      }
      default: return -1;
    }
  }

  call() {
    const { registers } = this.mcu.core;
    registers[0] = this.operate(registers[0], registers[1]);
  }

  close() { for (const { fd } of this.files.values()) closeSync(fd); }
}

// What a display on SPI0 gets, as a record of its wires (docs/formats.md, section 5): wires.bin in the folder in which this runs. Pauses of a
// millisecond or more are those of the wire.
const NAME = 'wires.bin';

class Wires {
  constructor(mcu) {
    Object.assign(this, { mcu, file: null, kind: null, bytes: [], frames: 0, heard: 0 });
    listen(mcu, { byte: (...what) => this.take(...what), selected: () => this.flush(), frame: () => this.end() });
  }

  take(isData, value, bits, silence) {
    const kind = isData ? 'D' : 'C', paused = Math.floor(silence / 1e6);
    if (paused > 0) { this.flush(); this.number('P', paused); }
    if (kind !== this.kind) { this.flush(); this.kind = kind; }
    if (bits > 8) this.bytes.push(value >> 8);
    this.bytes.push(value & 255);
  }

  write(kind, bytes) {
    if (this.file === null) this.file = openSync(NAME, 'w');
    const head = Buffer.alloc(5);
    head.write(kind, 0, 'latin1');
    head.writeUInt32LE(bytes.length, 1);
    writeSync(this.file, Buffer.concat([head, bytes]));
  }

  number(kind, value) {
    const bytes = Buffer.alloc(4);
    bytes.writeUInt32LE(value);
    this.write(kind, bytes);
  }

  flush() {
    if (this.bytes.length > 0) this.write(this.kind, Buffer.from(this.bytes));
    this.kind = null;
    this.bytes = [];
  }

  end() {
    this.flush();
    this.number('F', this.frames++);
    this.heard = this.mcu.core.cycles;
  }

  close() {
    if (this.file === null) return;
    this.flush();
    closeSync(this.file);
  }
}

const [folder, silence, image, ...words] = process.argv.slice(2);
const { RP2040 } = createRequire(import.meta.url)(folder);
const mcu = powered(RP2040, readFileSync(image)), core = mcu.core;

if (words[0] === '--memory') {
  const seen = new DataView(new ArrayBuffer(Number(words[2])));
  for (let at = 0; at < seen.byteLength; at += 4) seen.setUint32(at, mcu.readUint32(FLASH + at), true);
  writeFileSync(words[1], new Uint8Array(seen.buffer));
  process.exit(0);
}

let status = -1, warned = 0, heard = 0;
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

const host = new Semihosting(mcu, words, say, () => core.cycles, (code) => { status = code; });
const frames = words[0] === '--alone' ? Number(words[1]) : null;
mcu.onBreak = (number) => {
  heard = core.cycles;
  if (number !== 0xab) fail(USAGE, `breakpoint ${number}`);
  else if (frames !== null) fail(USAGE, 'a call to a debugger, and there is none');
  else host.call();
};
const wires = new Wires(mcu);
// What is printed on the serial port. A line END ends a program that goes on for ever on a real board.
let line = '';
mcu.uart[0].onByte = (byte) => {
  say(Buffer.from([byte]));
  if (byte === 10 && line === END) status = DONE;
  line = byte === 10 ? '' : line + String.fromCharCode(byte);
};

const refused = boot(mcu);
if (refused) fail(BOARD, refused);
while (status < 0) {
  const hung = advance(mcu, () => status >= 0 || wires.frames === frames);
  if (hung) fail(HANG, hung);
  if (wires.frames === frames) {
    say(`alone: ${frames} frames, core ${mcu.clkSys} Hz, SPI ${mcu.spi[0].clockFrequency} Hz\n`);
    status = DONE;
  }
  if (core.cycles - Math.max(heard, wires.heard) > silence * 1e6) fail(HANG, `the program hung: it asked nothing of its host for ${silence} million cycles`);
}
wires.close();
host.close();
process.exit(status);
