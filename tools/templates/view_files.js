// SPDX-License-Identifier: MIT
// Files that a page takes from its reader, and hands to him.

/** take gets the file that is dropped on an element, or chosen by a button: input is a file input, which need not be seen. */
export function takeFiles(stage, button, input, take) {
  for (const name of ["dragover", "dragleave", "drop"]) {
    stage.addEventListener(name, (event) => {
      event.preventDefault();
      stage.classList.toggle("dropping", name === "dragover");
      if (name === "drop" && event.dataTransfer.files.length) {
        take(event.dataTransfer.files[0]);
      }
    });
  }
  button.addEventListener("click", () => input.click());
  input.addEventListener("change", () => {
    if (input.files.length) {
      take(input.files[0]);
      input.value = "";     // the same file, changed meanwhile, may be chosen again
    }
  });
}

/** Hands bytes to the browser as a file. */
export function saveFile(blob, name) {
  const link = document.createElement("a");
  link.download = name;
  link.href = URL.createObjectURL(blob);
  link.click();
  URL.revokeObjectURL(link.href);
}

/** The same of a picture, as PNG. */
export function savePicture(canvas, name) {
  canvas.toBlob((blob) => saveFile(blob, name));
}
