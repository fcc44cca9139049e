// SPDX-License-Identifier: MIT
// What a display on SPI0 gets, as a record of its wires (docs/formats.md, section 5): wires.bin in the folder in which this runs. Each byte takes
// the time that the wire takes. Pauses of a millisecond or more are those of the wire. The pins are those of ports/pico_sdk: nothing comes out of
// SPI0 where another one was made its clock or its data.
import { closeSync, openSync, writeSync } from 'node:fs';

const SELECT = 17, CLOCK = 18, DATA = 19, DATA_COMMAND = 20, RESET = 21, FRAME = 22, HIGH = 1, SPI = 1;
const NAME = 'wires.bin';

export class Wires {
  constructor(mcu) {
    Object.assign(this, { mcu, file: null, kind: null, bytes: [], frames: 0, heard: 0, last: 0 });
    const spi = mcu.spi[0], pin = mcu.gpio;
    const sent = mcu.clock.createAlarm(() => spi.completeTransmit(0));
    spi.onTransmit = (value) => {
      const begun = mcu.clock.nanos, takes = spi.dataBits * 1e9 / spi.clockFrequency;
      sent.schedule(takes);
      const joined = pin[CLOCK].functionSelect === SPI && pin[DATA].functionSelect === SPI;
      if (joined && pin[SELECT].value !== HIGH) this.take(pin[DATA_COMMAND].value === HIGH ? 'D' : 'C', value, spi.dataBits, begun);
      this.last = begun + takes;
    };
    pin[SELECT].addListener(() => this.flush());
    pin[FRAME].addListener((now, before) => { if (before <= HIGH && now <= HIGH) this.end(); });
    // The display wakes from its reset now: what was sent before is none of its business.
    pin[RESET].addListener((now) => { if (now === HIGH) this.last = mcu.clock.nanos; });
  }

  take(kind, value, bits, begun) {
    const paused = Math.floor((begun - this.last) / 1e6);
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
