"use strict";
// The control that fits a setting: {parts, refresh}; refresh() shows what the setting is.

function make(tag, properties, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

const short = number => String(+(+number).toPrecision(6));

/// The ends of a slider, or null if none fits.
function sliderOf(setting) {
  const number = parseFloat(setting.begin || setting.default);
  let [low, high] = [setting.min ?? -Infinity, setting.max ?? Infinity];
  if (setting.kind === "length") [low, high] = [0.5, 12];
  else if (!["number", "count"].includes(setting.kind) || setting.group === "limits") return null;
  else if (setting.unit === "DEG" && high > 360) [low, high] = [-180, 180];
  else if (high - low > 400) {
    if (!isFinite(number)) return null;
    low = Math.max(low, 0);
    high = Math.min(high, Math.max(number * 8, setting.kind === "count" ? 16 : 1));
  }
  const step = setting.kind === "count" ? 1 : Math.pow(10, Math.floor(Math.log10((high - low) / 100)));
  return {min: low, max: high, step, number: isFinite(number) ? number : low};
}

function textField(setting, id) {
  const field = make("input", {id, type: "text", placeholder: setting.default || setting.unit, spellcheck: false,
    autocomplete: "off", title: setting.range});
  field.onchange = () => put({[setting.name]: field.value.trim()});
  return {parts: [field], refresh: () => { field.value = values[setting.name] ?? ""; }};
}

// Three numbers: all of them, or none.
function vectorControl(setting, id) {
  const fields = ["x", "y", "z"].map(axis => make("input", {type: "text", placeholder: axis, spellcheck: false,
    autocomplete: "off", title: setting.default, ariaLabel: `${setting.name} ${axis}`}));
  fields[0].id = id;
  const set = () => {
    const numbers = fields.map(field => field.value.trim());
    const given = numbers.filter(Boolean).length;
    if (given === 0 || given === 3) put({[setting.name]: given ? numbers.join(",") : ""});
  };
  for (const field of fields) field.onchange = set;
  return {parts: fields, refresh: () => {
    const numbers = (values[setting.name] || ",,").split(",");
    fields.forEach((field, i) => { field.value = numbers[i]; });
  }};
}

function choiceControl(setting, id) {
  const box = make("select", {id, title: setting.range});
  if (!setting.choices.includes(setting.begin))
    box.append(make("option", {value: "", textContent: setting.default || "none"}));
  box.append(...setting.choices.map(choice => make("option", {value: choice, textContent: choice})));
  box.onchange = () => put({[setting.name]: box.value});
  return {parts: [box], refresh: () => { box.value = textOf(setting.name); }};
}

/// Adds a name to a list, or takes it out.
function toggle(setting, name) {
  const on = listed(setting, textOf(setting.name));
  if (!on.delete(name)) on.add(name);
  const names = setting.choices.filter(choice => on.has(choice));
  put({[setting.name]: names.join(",") || (setting.words ? "none" : "")});
}

function listControl(setting, id) {
  const box = make("fieldset", {id});
  const marks = setting.choices.map(choice => make("input", {type: "checkbox", value: choice,
    onchange: () => toggle(setting, choice)}));
  box.append(...marks.map(mark => make("label", {}, mark, " " + mark.value)));
  return {parts: [box], refresh: () => {
    const on = listed(setting, textOf(setting.name));
    for (const mark of marks) mark.checked = on.has(mark.value);
  }};
}

// A colour as a well takes it; names of colours are drawn to be known.
const wellText = (() => {
  const context = document.createElement("canvas").getContext("2d");
  return text => {
    context.fillStyle = "#000000";
    context.fillStyle = text;
    return /^#[0-9a-f]{6}$/.test(context.fillStyle) ? context.fillStyle : "#ffffff";
  };
})();

function colorControl(setting, id) {
  const text = textField(setting, id);
  const well = make("input", {type: "color", ariaLabel: setting.name});
  well.oninput = () => put({[setting.name]: well.value}, true);
  const parts = [well, ...text.parts];
  if (/none/.test(setting.unit))
    parts.push(make("button", {textContent: "none", onclick: () => put({[setting.name]: "none"})}));
  return {parts, refresh: () => { text.refresh(); well.value = wellText(textOf(setting.name)); }};
}

function numberControl(setting, id) {
  const text = textField(setting, id);
  const ends = sliderOf(setting);
  if (!ends) return text;
  const {min, max, step} = ends;
  const slider = make("input", {type: "range", min, max, step, ariaLabel: setting.name});
  slider.oninput = () => put({[setting.name]: short(slider.value)}, true);
  slider.onchange = () => put({[setting.name]: short(slider.value)});
  return {parts: [slider, ...text.parts], refresh: () => {
    text.refresh();
    const at = parseFloat(textOf(setting.name));
    slider.value = isFinite(at) ? at : ends.number;
  }};
}

// "outline:width=3,color=#555;crease:..." by type; what a pen has besides is kept.
function pensOf(text) {
  const pens = {};
  for (const pen of text.split(";").filter(Boolean)) {
    const colon = pen.indexOf(":");
    pens[pen.slice(0, colon)] = Object.fromEntries(pen.slice(colon + 1).split(",").map(part => part.split("=")));
  }
  return pens;
}
const pensText = pens => Object.entries(pens).filter(([, pen]) => Object.keys(pen).length)
  .map(([type, pen]) => `${type}:${Object.entries(pen).map(([key, text]) => `${key}=${text}`).join(",")}`).join(";");

function pensControl(setting, id) {
  const text = textField(setting, id);
  const box = make("div", {className: "pens"});
  const set = (type, key, value, moving) => {
    const pens = pensOf(textOf(setting.name));
    pens[type] = {...pens[type], [key]: value};
    if (value === "") delete pens[type][key];
    put({[setting.name]: pensText(pens)}, moving);
  };
  const rows = setting.choices.map(type => {
    const name = make("span", {textContent: type});
    const slider = make("input", {type: "range", min: 0.5, max: 12, step: 0.1, ariaLabel: `width of ${type} lines`});
    const width = make("input", {type: "text", placeholder: "width", ariaLabel: `width of ${type} lines, as text`,
      title: byName["line-width"].range});
    const well = make("input", {type: "color", ariaLabel: `colour of ${type} lines`});
    slider.dataset.pen = type;
    slider.oninput = () => set(type, "width", short(slider.value), true);
    slider.onchange = () => set(type, "width", short(slider.value), false);
    width.onchange = () => set(type, "width", width.value.trim(), false);
    well.oninput = () => set(type, "color", well.value, true);
    box.append(name, slider, width, well);
    return {type, name, slider, width, well};
  });
  return {parts: [make("div", {style: "flex: 1"}, box, make("div", {className: "control"}, ...text.parts))],
    refresh: () => {
      text.refresh();
      const pens = pensOf(textOf(setting.name));
      for (const {type, name, slider, width, well} of rows) {
        const pen = pens[type] || {};
        name.className = Object.keys(pen).length ? "set" : "";
        slider.value = parseFloat(pen.width ?? textOf("line-width"));
        width.value = pen.width ?? "";
        well.value = wellText(pen.color ?? textOf("line-color"));
      }
    }};
}

function controlOf(setting, id) {
  const kinds = {choice: choiceControl, list: listControl, color: colorControl, number: numberControl,
    count: numberControl, length: numberControl, pens: pensControl, vector: vectorControl};
  return (kinds[setting.kind] || textField)(setting, id);
}
