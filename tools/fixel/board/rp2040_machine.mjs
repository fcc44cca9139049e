// SPDX-License-Identifier: MIT
// A Raspberry Pi Pico by rp2040js, without a host: what rp2040.mjs and a page have in common. It reads no file and imports nothing.

const RAM = 0x20000000, STAGE = 0x20041f00, STAGE_BYTES = 256;     // where the boot ROM copies it to
const SELECT = 17, CLOCK = 18, DATA = 19, DATA_COMMAND = 20, RESET = 21, FRAME = 22, HIGH = 1, SPI = 1;    // pins: those of ports/pico_sdk
const STEPS = 1024;

export const hex = (value) => `0x${(value >>> 0).toString(16).padStart(8, '0')}`;

function crc(bytes) { // CRC-32/MPEG-2, as the boot ROM has it
  let sum = 0xffffffff;
  for (const byte of bytes) {
    sum ^= byte << 24;
    for (let bit = 0; bit < 8; bit++) sum = sum & 0x80000000 ? sum << 1 ^ 0x04c11db7 : sum << 1;
  }
  return sum >>> 0;
}

// A new RP2040 with the flash, which is erased behind it. The package's PLL is always locked. By the data sheet (2.18) it locks if it and its
// oscillator have power.
export function powered(RP2040, flash) {
  const mcu = new RP2040();
  mcu.flash.set(flash);
  const { pllSys } = mcu, readPll = pllSys.readUint32.bind(pllSys);
  pllSys.readUint32 = (offset) => (offset === 0 && pllSys.pwr & 0x21 ? readPll(offset) & 0x7fffffff : readPll(offset));
  return mcu;
}

// What the boot ROM does with a flash that begins with a second stage. Null, or why it does not start.
export function boot(mcu) {
  const stage = mcu.flash.subarray(0, STAGE_BYTES), { core } = mcu, found = crc(stage.subarray(0, STAGE_BYTES - 4));
  if (found !== new DataView(mcu.flash.buffer).getUint32(STAGE_BYTES - 4, true)) return `the boot ROM does not start it: the second stage has the CRC ${hex(found)}`;
  mcu.sram.set(stage, STAGE - RAM);
  core.SP = STAGE;
  core.LR = 0;
  core.PC = STAGE;
  return null;
}

// What a display on SPI0 gets: to.byte(is data or a command, value, its bits, nanoseconds of silence before it), to.selected(), to.frame().
// Each byte takes the time that the wire takes. Nothing comes out of SPI0 where another pin was made its clock or its data.
export function listen(mcu, to) {
  const spi = mcu.spi[0], pin = mcu.gpio, sent = mcu.clock.createAlarm(() => spi.completeTransmit(0));
  let last = 0;
  spi.onTransmit = (value) => {
    const begun = mcu.clock.nanos, takes = spi.dataBits * 1e9 / spi.clockFrequency;
    sent.schedule(takes);
    const joined = pin[CLOCK].functionSelect === SPI && pin[DATA].functionSelect === SPI;
    if (joined && pin[SELECT].value !== HIGH) to.byte(pin[DATA_COMMAND].value === HIGH, value, spi.dataBits, begun - last);
    last = begun + takes;
  };
  pin[SELECT].addListener(() => to.selected());
  pin[FRAME].addListener((now, before) => { if (before <= HIGH && now <= HIGH) to.frame(); });
  // The display wakes from its reset now: what was sent before is none of its business.
  pin[RESET].addListener((now) => { if (now === HIGH) last = mcu.clock.nanos; });
}

// Some instructions, until isOver(); or the wait for an interrupt. Null, or why it never ends.
export function advance(mcu, isOver) {
  const { core, clock } = mcu;
  if (core.waiting) {
    if (clock.nextAlarm === null) return 'the program waits for an interrupt that never comes';
    const next = Math.max(clock.nanosToNextAlarm, 1);
    clock.tick(next);
    core.cycles += Math.round(next * mcu.clkSys / 1e9);
  } else {
    for (let count = 0; count < STEPS && !core.waiting && !isOver(); count++) clock.tick(core.executeInstruction() * 1e9 / mcu.clkSys);
  }
  return null;
}
