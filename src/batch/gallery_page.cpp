#include "batch/gallery.h"

namespace inkedge::batch {

// Cards are made as they are scrolled to, and load their pictures then: pages of many items open at once.
std::string_view galleryPage() noexcept {
    return R"html(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Gallery</title>
<style>
  :root { color-scheme: light; --ink: #222; --soft: #666; --line: #ddd; --bad: #b00020; --odd: #946200; }
  * { box-sizing: border-box; }
  body { margin: 0; font: 14px/1.4 system-ui, sans-serif; color: var(--ink); background: #f6f6f4; }
  header { position: sticky; top: 0; z-index: 1; display: flex; flex-wrap: wrap; gap: 8px 12px; align-items: center;
           padding: 10px 16px; background: #fff; border-bottom: 1px solid var(--line); }
  header button, header select, header input { font: inherit; padding: 4px 10px; border: 1px solid var(--line);
           border-radius: 6px; background: #fff; color: inherit; }
  header button[aria-pressed="true"] { background: var(--ink); color: #fff; border-color: var(--ink); }
  #count { color: var(--soft); margin-left: auto; }
  main { display: grid; grid-template-columns: repeat(auto-fill, minmax(200px, 1fr)); gap: 12px; padding: 16px; }
  .card { display: flex; flex-direction: column; padding: 0; border: 1px solid var(--line); border-radius: 8px;
          overflow: hidden; background: #fff; font: inherit; color: inherit; text-align: left; cursor: pointer; }
  .card:focus-visible, .card:hover { outline: 2px solid var(--ink); }
  .card .picture { aspect-ratio: 1; display: flex; align-items: center; justify-content: center; background: #fff;
                   color: var(--bad); padding: 8px; overflow: hidden; }
  .card img { width: 100%; height: 100%; object-fit: contain; }
  .card .text { padding: 8px 10px; border-top: 1px solid var(--line); width: 100%; }
  .id { overflow: hidden; text-overflow: ellipsis; white-space: nowrap; font-weight: 600; }
  .facts { color: var(--soft); font-size: 12px; }
  .bad { color: var(--bad); } .odd { color: var(--odd); }
  dialog { width: min(96vw, 1100px); height: 94vh; padding: 0; border: 0; border-radius: 10px; }
  dialog::backdrop { background: #0008; }
  .large { display: grid; grid-template-rows: auto auto 1fr auto; height: 100%; }
  .large > * { padding: 8px 16px; min-width: 0; }
  .large .tabs { display: flex; flex-wrap: wrap; gap: 6px; border-bottom: 1px solid var(--line); }
  .large .tabs button { font: inherit; border: 1px solid var(--line); border-radius: 6px; background: #fff; }
  .large .tabs button[aria-pressed="true"] { background: var(--ink); color: #fff; }
  .large .shown { min-height: 0; display: flex; align-items: center; justify-content: center; background: #eee;
                  cursor: pointer; }
  .large .shown img { max-width: 100%; max-height: 100%; min-height: 0; }
  .large pre { margin: 0; max-height: 24vh; overflow: auto; white-space: pre-wrap; font-size: 12px; }
  .close { float: right; font: inherit; border: 0; background: none; font-size: 18px; cursor: pointer; }
</style>
<header>
  <div id="filters" role="group" aria-label="Which items"></div>
  <label>Sort <select id="sort"></select></label>
  <input id="search" type="search" placeholder="Id or message" aria-label="Id or message">
  <span id="count"></span>
</header>
<main id="cards"></main>
<div id="more"></div>
<dialog id="dialog"></dialog>
<script type="application/json" id="results">[
{results}
]</script>
<script>
"use strict";
const results = JSON.parse(document.getElementById("results").textContent);
const isPicture = file => /\.(png|svg|jpe?g|webp)$/i.test(file);
for (const item of results) {
  item.pictures = item.files.filter(isPicture);
  item.length = Object.values(item.lengths).reduce((sum, length) => sum + length, 0);
}
const upper = (values, share) => values.sort((a, b) => a - b)[Math.floor(share * (values.length - 1))] ?? 0;
const drawn = results.filter(item => item.state === "drawn");
const slow = upper(drawn.map(item => item.seconds), 0.95);
const long = upper(drawn.map(item => item.length), 0.95);
const filters = {
  "All": () => true,
  "Failed": item => item.state !== "drawn",
  "Slow": item => item.seconds >= slow && slow > 0,
  "Warnings": item => item.warnings.length > 0,
  "Most lines": item => item.length >= long && long > 0,
};
const by = value => (a, b) => value(b) - value(a) || (a.id < b.id ? -1 : 1);
const sorts = {
  "id": (a, b) => a.id < b.id ? -1 : 1,
  "seconds": by(item => item.seconds),
  "triangles": by(item => item.triangles),
  "lines": by(item => item.length),
  "warnings": by(item => item.warnings.length),
};
if (results.some(item => item.score)) sorts["worst score"] = by(item => item.score ? 1 - item.score.f1 : -1);

const make = (tag, properties, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};
const addressOf = file => file.split("/").map(encodeURIComponent).join("/");
const cards = document.getElementById("cards");
const more = document.getElementById("more");
const dialog = document.getElementById("dialog");
let filter = "All", shown = [], made = 0;

function factsOf(item) {
  const parts = [`${item.seconds.toFixed(2)} s`, `${item.triangles.toLocaleString("en")} triangles`];
  if (item.length > 0) parts.push(`${Math.round(item.length).toLocaleString("en")} px of lines`);
  if (item.score) parts.push(`F1 ${item.score.f1.toFixed(3)}`);
  return parts.join(" \u00b7 ");
}

function card(item) {
  const picture = item.pictures.length > 0
    ? make("img", {src: addressOf(item.pictures[0]), loading: "lazy", alt: ""})
    : make("span", {textContent: item.error ?? "no picture"});
  const text = make("div", {className: "text"}, make("div", {className: "id", textContent: item.id, title: item.id}),
                    make("div", {className: "facts", textContent: factsOf(item)}));
  if (item.state !== "drawn") text.append(make("div", {className: "bad", textContent: item.state}));
  const warnings = item.warnings.length;
  if (warnings > 0)
    text.append(make("div", {className: "odd", textContent: warnings === 1 ? "1 warning" : `${warnings} warnings`}));
  return make("button", {className: "card", onclick: () => open(item)},
              make("div", {className: "picture"}, picture), text);
}

function open(item) {
  let at = 0;
  const image = make("img", {alt: ""});
  const tabs = make("div", {className: "tabs"});
  const show = i => {
    at = i;
    image.src = addressOf(item.pictures[i]);
    tabs.querySelectorAll("button").forEach((tab, k) => tab.setAttribute("aria-pressed", k === i));
  };
  item.pictures.forEach((file, i) => tabs.append(
    make("button", {textContent: file.slice(item.id.length + 1).replace(/\.png$/, ""), onclick: () => show(i)})));
  const {pictures, length, files, ...facts} = item;
  const area = make("div", {className: "shown", title: "The next one",
                            onclick: () => pictures.length > 0 && show((at + 1) % pictures.length)});
  area.append(pictures.length > 0 ? image : make("p", {className: "bad", textContent: item.error ?? "no picture"}));
  dialog.replaceChildren(make("div", {className: "large"},
    make("div", {}, make("button", {className: "close", textContent: "\u00d7", onclick: () => dialog.close()}),
         make("strong", {textContent: item.id}), make("div", {className: "facts", textContent: factsOf(item)})),
    tabs, area, make("pre", {textContent: JSON.stringify(facts, null, 1)})));
  if (pictures.length > 0) show(0);
  dialog.showModal();
}

function addCards() {
  const end = Math.min(made + 120, shown.length);
  for (; made < end; ++made) cards.append(card(shown[made]));
}

function update() {
  const words = document.getElementById("search").value.toLowerCase();
  shown = results.filter(filters[filter]).filter(
    item => !words || item.id.toLowerCase().includes(words) || (item.error ?? "").toLowerCase().includes(words)
            || item.warnings.some(warning => warning.toLowerCase().includes(words)));
  shown.sort(sorts[document.getElementById("sort").value]);
  cards.replaceChildren();
  made = 0;
  addCards();
  document.getElementById("count").textContent = `${shown.length} of ${results.length}`;
  document.querySelectorAll("#filters button").forEach(
    button => button.setAttribute("aria-pressed", button.dataset.filter === filter));
}

for (const name of Object.keys(filters)) {
  const count = results.filter(filters[name]).length;
  const button = make("button", {textContent: `${name} ${count}`, onclick: () => { filter = name; update(); }});
  button.dataset.filter = name;
  document.getElementById("filters").append(button, " ");
}
for (const name of Object.keys(sorts)) document.getElementById("sort").append(make("option", {textContent: name}));
document.getElementById("sort").onchange = update;
document.getElementById("search").oninput = update;
new IntersectionObserver(seen => { if (seen.some(one => one.isIntersecting)) addCards(); },
                         {rootMargin: "1000px"}).observe(more);
update();
</script>
</html>
)html";
}

}  // namespace inkedge::batch
