"use strict";
// All settings, grouped and searchable, and the layers.

const rows = {};    // by name: {row, refresh, words}
const groups = [];  // {group, count, names}

// What people say for what settings are called.
const saidFor = {heavy: "width", heavier: "width", thick: "width", thicker: "width", thickness: "width", bold: "width",
  bolder: "width", weight: "width", thin: "width", thinner: "width", fine: "width", colour: "color", resolution: "size",
  silhouette: "outline", contour: "contour", rotate: "angle", turn: "angle", dotted: "dashed"};

function addRow(setting) {
  const id = "s-" + setting.name;
  const control = controlOf(setting, id);
  const reset = make("button", {textContent: "reset", title: `${setting.name} as by default`,
    onclick: () => put({[setting.name]: ""})});
  const row = make("div", {className: "row"},
    make("div", {className: "head"},
      make("label", {htmlFor: id, textContent: setting.name, title: "--" + setting.name}),
      make("span", {className: "idle", textContent: "no effect now"}), reset),
    make("div", {className: "control"}, ...control.parts),
    make("div", {className: "help", textContent: setting.help}));
  row.dataset.name = setting.name;
  const words = [setting.name, setting.short, setting.group, setting.help, setting.range, ...(setting.choices || [])];
  rows[setting.name] = {row, refresh: control.refresh, words: words.join(" ").toLowerCase()};
  return row;
}

function addGroups() {
  for (const name of new Set(model.settings.map(setting => setting.group))) {
    const settings = model.settings.filter(setting => setting.group === name);
    const count = make("span", {className: "count"});
    const group = make("details", {open: ["picture", "lines"].includes(name)},
      make("summary", {}, name, count), ...settings.map(addRow));
    groups.push({group, count, names: settings.map(setting => setting.name), open: group.open});
    $("groups").append(group);
  }
}

function refresh(names) {
  for (const name of names) {
    rows[name].refresh();
    rows[name].row.classList.toggle("changed", name in values);
  }
  for (const {count, names: all} of groups) {
    const changed = all.filter(name => name in values).length;
    count.textContent = changed ? `${changed} changed` : "";
  }
}

function find() {
  const words = $("search").value.toLowerCase().split(/\s+/).filter(Boolean)
    .map(word => saidFor[word] || saidFor[word.replace(/s$/, "")] || word.replace(/s$/, ""));
  const changedOnly = $("onlyChanged").checked;
  const fits = name => words.every(word => rows[name].words.includes(word)) && (!changedOnly || name in values);
  for (const {group, names, open} of groups) {
    for (const name of names) rows[name].row.hidden = !fits(name);
    group.hidden = !names.some(fits);
    group.open = words.length || changedOnly ? !group.hidden : open;
  }
  $("empty").hidden = groups.some(({group}) => !group.hidden);
}

// Layers: the picture, the maps that lie under it, and the types of its lines.
const layers = [];
let showsPicture = true;
function addLayers() {
  const chip = (text, title, pressed, click) => {
    const button = make("button", {textContent: text, title, onclick: click});
    layers.push(() => button.setAttribute("aria-pressed", String(pressed())));
    return button;
  };
  const chipsOf = setting => setting.choices.map(name => chip(name, `--${setting.name}`,
    () => listed(setting, textOf(setting.name)).has(name), () => toggle(setting, name)));
  $("mapLayers").append(chip("picture", "the drawing, over the maps", () => showsPicture, () => {
    showsPicture = !showsPicture;
    refreshLayers();
    compose();
  }), ...chipsOf(byName.maps));
  $("lineLayers").append(...chipsOf(byName.lines));
}
const refreshLayers = () => { for (const each of layers) each(); };

/// Marks the setting that an error of the server is about; null: none.
function mark(error) {
  $("wrong").textContent = $("wrong").title = error ? error.message : "";
  const found = error && /^--?([a-z-]+)/.exec(error.message);
  for (const [name, {row}] of Object.entries(rows)) row.classList.toggle("wrong", !!found && name === found[1]);
}

/// Shows why settings do nothing: texts by name.
function markIdle(idle) {
  for (const [name, {row}] of Object.entries(rows)) {
    row.classList.toggle("idle", name in idle);
    row.querySelector(".idle").title = idle[name] || "";
  }
}

$("search").oninput = $("onlyChanged").onchange = find;
$("reset").onclick = () => put(defaultsOf(Object.keys(byName)));
addEventListener("keydown", event => {
  const typing = event.target.matches("input[type=text], input[type=search]");
  if (event.key === "/" && !typing) {
    $("search").focus();
    event.preventDefault();
  }
});
