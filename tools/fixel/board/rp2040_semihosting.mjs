// SPDX-License-Identifier: MIT
// Semihosting ("Semihosting for AArch32 and AArch64", Arm) for rp2040js: what boards/parts/semihosting.c calls, BKPT 0xAB
// with the operation in r0 and its parameters in r1.
import { closeSync, openSync, readSync, writeSync } from 'node:fs';

const [OPEN, CLOSE, WRITE0, WRITE, READ, SEEK, GET_CMDLINE, EXIT_EXTENDED, ELAPSED] =
  [0x01, 0x02, 0x04, 0x05, 0x06, 0x0a, 0x15, 0x20, 0x30];
const APPLICATION_EXIT = 0x20026, FATAL = 1, MODES = { 1: 'r', 5: 'w' };
const RAM = 0x20000000;

export class Semihosting {
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
