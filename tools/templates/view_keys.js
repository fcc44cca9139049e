// SPDX-License-Identifier: MIT
// The keys that move the eye: on the keyboard, and buttons with data-bit in the page's #keys.

const KEYS = {  // by the key's place, whatever the layout: bits of fixel/viewer.h
  ArrowUp: 1, KeyW: 1, ArrowDown: 2, KeyS: 2, ArrowLeft: 4, KeyA: 4, ArrowRight: 8, KeyD: 8,
  KeyR: 16, PageUp: 16, KeyF: 32, PageDown: 32, KeyQ: 64, KeyE: 128,
};

const BUTTONS = [   // as they stand; page.css lays them out
  [64, "Q", "roll left"], [1, "W ↑", "forward"], [128, "E", "roll right"], [16, "R", "look up"],
  [4, "A ←", "turn left"], [2, "S ↓", "back"], [8, "D →", "turn right"], [32, "F", "look down"],
];

/** Says of each button that a selector finds whether it is pressed. */
export function press(selector, isPressed) {
  document.querySelectorAll(selector).forEach((button) => {
    button.setAttribute("aria-pressed", String(isPressed(button)));
  });
}

/** Those that are held. */
export class Held {
  /** changed: gets the bits of all that are held, after each change. */
  constructor(changed) {
    this.changed = changed;
    this.held = new Map();      // a key or a button -> bit
  }

  get bits() {
    return [...this.held.values()].reduce((sum, bit) => sum | bit, 0);
  }

  /** commands: what any other key does, by its code. */
  listen(commands) {
    addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey || event.target.closest?.("input, select")) {
        return; // the browser's own
      }
      if (event.code in KEYS) {
        event.preventDefault();
        this.hold(event.code, KEYS[event.code]);
      } else if (event.code in commands && (event.code === "Period" || !event.repeat)) {
        event.preventDefault();
        commands[event.code]();
      }
    });
    addEventListener("keyup", (event) => this.hold(event.code, 0));
    addEventListener("blur", () => this.letGo());
    document.addEventListener("visibilitychange", () => this.letGo());
    document.getElementById("keys").append(...BUTTONS.map((each) => this.button(...each)));
    press("[data-bit]", () => false);
  }

  button(bit, key, words) {
    const made = document.createElement("button"), label = document.createElement("kbd");
    made.dataset.bit = bit;
    label.textContent = key;
    made.append(label, words);
    this.listenToButton(made);
    return made;
  }

  hold(what, bit) {
    if (bit ? this.held.get(what) === bit : !this.held.has(what)) {
      return;
    }
    if (bit) {
      this.held.set(what, bit);
    } else {
      this.held.delete(what);
    }
    this.tell();
  }

  letGo() {
    if (this.held.size) {
      this.held.clear();
      this.tell();
    }
  }

  tell() {
    const bits = this.bits;
    press("[data-bit]", (button) => Boolean(Number(button.dataset.bit) & bits));
    this.changed(bits);
  }

  /** A button: held by pointer, or by Space and Enter where it has the focus. */
  listenToButton(button) {
    const what = `button ${button.dataset.bit}`, bit = Number(button.dataset.bit);
    const release = () => this.hold(what, 0);
    button.addEventListener("pointerdown", (event) => {
      button.setPointerCapture(event.pointerId);
      this.hold(what, bit);
    });
    button.addEventListener("keydown", (event) => {
      if (event.code === "Space" || event.code === "Enter") {
        event.preventDefault();
        this.hold(what, bit);
      }
    });
    button.addEventListener("keyup", (event) => {
      if (event.code === "Space" || event.code === "Enter") {     // any other key leaves alone what the pointer holds
        release();
      }
    });
    for (const name of ["pointerup", "pointercancel", "lostpointercapture", "blur"]) {
      button.addEventListener(name, release);
    }
  }
}
