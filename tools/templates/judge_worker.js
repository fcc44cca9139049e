// SPDX-License-Identifier: MIT
// The reference renderer beside the page: {module, image} opens a scene, and any other message is a question of Judge.ask.
import { Judge } from "./judge.mjs";

let judge = null;

addEventListener("message", ({ data }) => {
  try {
    if (data.module) {
      judge = new Judge(data.module, data.image);
    } else {
      postMessage({ number: data.number, answer: judge.ask(data) });
    }
  } catch (fault) {
    postMessage({ number: data.number, fault: fault.message });
  }
});
