"use strict";
const data = JSON.parse(document.getElementById("data").textContent);

function make(tag, properties, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

// A point's tooltip is also shown below the plots, for fingers and keyboards.
for (const point of document.querySelectorAll(".point")) {
  const tell = () => {
    point.closest("section").querySelector(".told").textContent = point.querySelector("title").textContent;
  };
  for (const event of ["pointerenter", "focus", "click"]) point.addEventListener(event, tell);
}

for (const place of document.querySelectorAll("[data-strips]")) {
  const strips = data.strips[place.dataset.strips];
  if (!strips) continue;
  const select = make("select", { ariaLabel: "configuration" });
  strips.forEach((strip, index) => select.append(make("option", { value: index, textContent: strip.name })));
  const flip = make("button", { type: "button", textContent: "Flip" });
  const picture = (alt) => make("img", { alt });
  const [left, right, image, reference, error] =
    ["reference", "image", "image", "reference", "signed error"].map(picture);
  const slider = make("input", { type: "range", min: 0, max: 100, value: 50, ariaLabel: "image to reference" });
  const note = make("span");
  const cut = () => { right.style.clipPath = `inset(0 ${100 - slider.value}% 0 0)`; };
  const show = () => {
    const strip = strips[select.value];
    image.src = right.src = data.pictures[strip.image];
    reference.src = left.src = data.pictures[strip.reference];
    error.src = data.pictures[strip.error];
    note.textContent = strip.note;
  };
  slider.addEventListener("input", cut);
  select.addEventListener("change", show);
  flip.addEventListener("click", () => { slider.value = slider.value > 50 ? 0 : 100; cut(); });
  const pair = make("div", { className: "over" });
  pair.append(make("div", { className: "over" }, left, right), slider);
  place.append(
    make("div", { className: "controls" }, select, flip),
    make("div", { className: "row" },
      make("figure", {}, pair, make("figcaption", { textContent: "left of the slider: image; right of it: reference" })),
      make("figure", {}, image, make("figcaption", { textContent: "image" })),
      make("figure", {}, reference, make("figcaption", { textContent: "reference" })),
      make("figure", {}, error, make("figcaption", {}, "signed error; ", note))));
  show();
  cut();
}

for (const [column, head] of document.querySelectorAll("th").entries()) {
  head.firstChild.addEventListener("click", () => {
    const down = head.ariaSort === "ascending";
    document.querySelectorAll("th").forEach((other) => { other.ariaSort = "none"; });
    head.ariaSort = down ? "descending" : "ascending";
    const key = (row) => {
      const cell = row.cells[column];
      const value = cell.dataset.value;
      // What has no figure comes last, whichever way.
      if (value === undefined) return cell.textContent;
      return value === "" ? (down ? -Infinity : Infinity) : Number(value);
    };
    const body = document.querySelector("tbody");
    const rows = [...body.rows].sort((a, b) => {
      const [x, y] = [key(a), key(b)];
      return (x < y ? -1 : x > y ? 1 : 0) * (down ? -1 : 1);
    });
    body.append(...rows);
  });
}
