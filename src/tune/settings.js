"use strict";
// The settings as this tab has them.

let model = {settings: [], presets: []};  // as the server describes them
let values = {};                          // texts by name, of those that are not as by default
const byName = {};                        // descriptions
const watchers = [];                      // called with the names that changed, and whether more of them follow at once

const textOf = name => values[name] ?? byName[name].begin;

/// The names that a text of a list stands for.
function listed(setting, text) {
  const words = setting.words || {};
  return new Set(text.split(",").flatMap(word => words[word] || (word === "none" ? [] : [word])).filter(Boolean));
}

function isDefault(setting, text) {
  if (text === "" || text === setting.begin) return true;
  if (setting.kind !== "list") return false;
  const [a, b] = [listed(setting, text), listed(setting, setting.begin)];
  return a.size === b.size && [...a].every(name => b.has(name));
}

/// Changes settings: texts by name, empty ones are as by default.
/// @param moving  whether more changes follow at once, as while a slider is dragged
function put(texts, moving = false) {
  for (const [name, text] of Object.entries(texts)) {
    if (isDefault(byName[name], text)) delete values[name]; else values[name] = text;
  }
  for (const watch of watchers) watch(Object.keys(texts), moving);
}

const groupNames = group => model.settings.filter(setting => setting.group === group).map(setting => setting.name);
const defaultsOf = names => Object.fromEntries(names.map(name => [name, ""]));
