"use strict";
// What is taken away, and how the page begins.

let kind = "command";
let texts = {};
let asking = 0;

// A flag is not broken at its hyphens.
function showText() {
  const parts = kind === "command" ? texts.command.split(/(?<= )(?=--)/) : [texts[kind]];
  $("text").replaceChildren(...parts.map(part => kind === "command" ? make("span", {textContent: part}) : part));
}

/// Returns whether the settings are such that they can be taken away.
async function takeTexts() {
  try {
    const answer = await ask("/texts", values);
    texts = await answer.json();
    showText();
    markIdle(texts.idle);
    return true;
  } catch (error) {
    mark(error);
    return false;
  }
}

for (const button of document.querySelectorAll("#kinds button")) {
  button.onclick = () => {
    kind = button.dataset.kind;
    for (const each of document.querySelectorAll("#kinds button"))
      each.setAttribute("aria-pressed", String(each === button));
    showText();
  };
}

$("copy").onclick = async () => {
  clearTimeout(asking);
  if (!await takeTexts()) return;
  try {
    await navigator.clipboard.writeText(texts[kind]);
  } catch {
    getSelection().selectAllChildren($("text"));
    document.execCommand("copy");
  }
  $("copy").textContent = "Copied";
  setTimeout(() => { $("copy").textContent = "Copy"; }, 1500);
};

for (const button of document.querySelectorAll("#downloads button")) {
  button.onclick = async () => {
    button.disabled = true;
    try {
      const blob = await (await ask("/file", values, {output: button.dataset.file})).blob();
      const link = make("a", {href: URL.createObjectURL(blob), download: button.dataset.file});
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    } catch (error) {
      mark(error);
    }
    button.disabled = false;
  };
}

$("preset").onchange = () => {
  const preset = model.presets.find(each => each.name === $("preset").value);
  $("preset").value = "";
  if (preset) put(preset.values);
};

watchers.push((names, moving) => {
  refresh(names);
  if (names.some(name => byName[name].kind === "length" || byName[name].kind === "color")) rows["line-style"].refresh();
  refreshLayers();
  if ($("onlyChanged").checked) find();
  draw(moving);
  clearTimeout(asking);
  asking = setTimeout(takeTexts, moving ? 150 : 0);
});

(async () => {
  try {
    const answer = await fetched("/beginning");
    model = await answer.json();
    if (!answer.ok) throw new Error(model.error);
    for (const setting of model.settings) byName[setting.name] = setting;
    const name = model.model.split("/").pop();
    $("title").textContent = $("title").title = name;
    document.title = `${name} · inkedge tune`;
    $("facts").textContent = `${model.triangles.toLocaleString("en")} triangles`;
    $("facts").title = model.warnings.join("\n");
    $("preset").append(make("option", {value: "", textContent: "Preset…"}),
      ...model.presets.map(({name: value, help: title}) => make("option", {value, textContent: value, title})));
    addGroups();
    addLayers();
    put(Object.fromEntries(model.settings.map(setting => [setting.name, setting.value])));
  } catch (error) {
    mark(error);
  }
})();
