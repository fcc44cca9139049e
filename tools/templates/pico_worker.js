// SPDX-License-Identifier: MIT
// An emulated Pico beside the page: {program, scene, sceneAt} begins anew, and each frame goes out as {run, number, cycles, picture}; "go" asks for
// the next one.
import { RP2040 } from "rp2040js";
import { Pico } from "./pico.mjs";

const SLICE = 2_000_000;    // cycles between two looks at what the page says

let pico = null, run = 0;

function work(asked) {
  if (asked !== run) {
    return;
  }
  try {
    const begun = pico.cycles;
    if (pico.run(SLICE)) {
      postMessage({ run, number: pico.frames - 1, picture: pico.display.picture() });
    } else {
      postMessage({ run, cycles: begun });
      setTimeout(work, 0, asked);
    }
  } catch (fault) {
    postMessage({ run, fault: fault.message, said: pico.said });
  }
}

addEventListener("message", ({ data }) => {
  if (data.program) {
    run = data.run;
    pico = new Pico(RP2040, data);
  }
  work(run);
});
