// SPDX-License-Identifier: MIT
// What a frame costs on a board: the figures of fixel predict, which the site has for each frame of a scene's path.

const ESCAPED = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#x27;" };       // as html.escape of Python
const RATE = "of drawing alone, by the model, code in RAM";

/** The rate of so many cycles a frame, as it is said. */
export function rateWords(clock, cycles) {
  const rate = clock * 1e6 / cycles;
  return `${rate.toFixed(rate >= 10 ? 0 : 1)} frames a second`;
}

/** What a badge says of a path's mean frame: words of tools/fixel/bench/badge.py. board: what people call it. */
export function badgeWords(board, clock, cost) {
  if (cost.why_not) {
    return `no room on ${board}, by model`;
  }
  return cost.mean.cycles && clock ? `${rateWords(clock, cost.mean.cycles)} on ${board} at ${clock} MHz, drawing alone, by model`
    : `${count(cost.mean.instructions)} instructions a frame on ${board}, by model`;
}

/** A badge as SVG. badge: its picture, and pixels of a letter and beside the words. */
export function badgePicture(badge, words) {
  const length = Math.round(badge.letter * words.length), said = words.replace(/[&<>"']/g, (letter) => ESCAPED[letter]);
  const values = { words: said, length, width: length + badge.beside };
  return badge.picture.replace(/{{(\w+)}}/g, (_, name) => values[name]);
}

function count(number) {
  return number.toLocaleString("en");
}

function kilobytes(bytes) {
  return count(Math.ceil(bytes / 1024));
}

/** The card of a page that says it. */
export class CostCard {
  /** at: finds an element by its id; parts: names of the parts of a frame; boards: {name: { core, clock, paces }}. */
  constructor(at, parts, boards) {
    Object.assign(this, { at, boards });
    this.rows = parts.map((part) => {
      const row = at("parts").tBodies[0].insertRow(), name = document.createElement("th");
      name.scope = "row";
      name.textContent = part;
      row.append(name);
      const cells = [row.insertCell(), row.insertCell(), row.insertCell()];
      cells[2].className = "bar";
      cells[2].append(document.createElement("i"));
      return cells;
    });
    this.chosen();
  }

  get board() {
    return this.at("board").value;
  }

  get clock() {
    const { value, validity } = this.at("clock");
    return validity.valid && value ? Number(value) : null;
  }

  /** Begins with the board's own clock. A core whose cycles are not known has none. */
  chosen() {
    const { clock, paces } = this.boards[this.board];
    this.at("clock").value = paces ? clock : "";
    this.at("clock").disabled = !paces;
  }

  /** cost: of a scene on the board; null: none is known. taken: instructions of the frame, all and then those of each part; or undefined. */
  tell(cost, taken) {
    const cycles = taken && this.cyclesOf(taken.slice(1));
    this.at("cost").textContent = cost?.why_not ? "no room" : taken ? `${count(taken[0])} instructions` : "–";
    this.at("cycles").textContent = cycles ? this.cycleWords(cycles[0]) : "";
    this.at("parts").hidden = !(taken?.length > 1);
    this.at("cycles-head").textContent = cycles ? "cycles" : "";
    this.rows.forEach((cells, i) => {
      const part = taken?.[i + 1] ?? 0;
      cells[0].textContent = count(part);
      cells[1].textContent = cycles ? count(cycles[i + 1]) : "";
      cells[2].firstChild.style.width = `${taken ? 100 * part / taken[0] : 0}%`;
    });
    this.at("cost-words").textContent = this.words(cost, taken, cycles);
  }

  /** All cycles of a frame, then those of each part; null where the core's are not known. */
  cyclesOf(parts) {
    const { paces } = this.boards[this.board], spent = paces && parts.map((part, i) => part * paces[i]);
    return spent && [spent.reduce((sum, each) => sum + each, 0), ...spent].map(Math.round);
  }

  cycleWords(cycles) {
    return `${count(cycles)} cycles${this.clock ? `: ${rateWords(this.clock, cycles)} ${RATE}` : ", by the model, code in RAM"}`;
  }

  words(cost, taken, cycles) {
    if (cost === undefined) {
      return "…";
    }
    if (!cost) {
      return "fixel predict says what a file of yours costs on this board.";
    }
    if (cost.why_not) {
      return `${cost.why_not}.`;
    }
    const memory = `Program and scene take ${kilobytes(cost.flash.program + cost.flash.scene)} of ${kilobytes(cost.flash.of)} KB of flash, `
      + `and ${kilobytes(cost.ram.program)} of ${kilobytes(cost.ram.of)} KB of RAM.`;
    if (!taken) {
      return memory;
    }
    return `An estimate, as make predict BOARD=${this.board} makes it. ${cycles ? "" : "No model knows this core’s cycles, so no rate follows. "}${memory}`;
  }
}
