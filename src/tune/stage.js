"use strict";
// The drawing: what is asked for, shown, turned, moved, zoomed and compared.

let shown = null;        // of the picture on the stage: {size, camera, bitmaps, png, half}
let kept = null;         // settings to compare with; null: nothing is compared
let underway = null;     // {half, abort}
let wanted = null;       // {half}
let settling = 0;

/// Asks for a picture of the settings as they are then. One is underway at a time, and a full one gives way at once.
function draw(half) {
  wanted = {half};
  document.body.dataset.drawn = "";
  clearTimeout(settling);
  if (half) settling = setTimeout(() => draw(false), 250);
  if (underway && !underway.half) underway.abort.abort();
  if (!underway) work();
}

async function work() {
  while (wanted) {
    underway = {...wanted, abort: new AbortController()};
    wanted = null;
    try {
      await drawOnce(underway.half, underway.abort.signal);
    } catch (error) {
      if (error.name !== "AbortError") mark(error);
    }
    underway = null;
  }
  live = null;
}

async function pictureOf(settings, more, signal) {
  const answer = await ask("/picture", settings, more, signal);
  if (!answer) return null;
  const picture = JSON.parse(answer.headers.get("X-Inkedge-Picture"));
  picture.png = await answer.blob();
  let at = picture.bytes;
  const parts = picture.layers.map(layer => picture.png.slice(at, at += layer.bytes));
  picture.png = picture.png.slice(0, picture.bytes, "image/png");
  picture.bitmaps = await Promise.all([picture.png, ...parts].map(part => createImageBitmap(part)));
  return picture;
}

async function drawOnce(half, signal) {
  const started = performance.now();
  const picture = await pictureOf({...values}, {half}, signal);
  if (!picture) return;
  mark(null);
  if (half) picture.size = picture.size.map(side => side * 2);  // it is shown as large as the full one
  const last = shown;
  shown = {...picture, half};
  compose();
  for (const bitmap of last ? last.bitmaps : []) bitmap.close();
  $("time").textContent = `${half ? "half" : "full"} size in ${Math.round(performance.now() - started)} ms`;
  $("warning").textContent = $("warning").title = picture.warnings.join("; ");
  if (kept && !half) {
    const from = (texts, isCamera) => Object.entries(texts)
      .filter(([name]) => (byName[name].group === "camera") === isCamera);
    const settings = Object.fromEntries([...from(kept, false), ...from(values, true)]);
    const before = await pictureOf(settings, {before: true}, signal);
    if (before) paint($("before"), before.bitmaps);
  }
  document.body.dataset.drawn = half ? "half" : "full";
}

// Maps lie under the picture, each as strong as the others.
function paint(canvas, [picture, ...maps]) {
  canvas.width = picture.width;
  canvas.height = picture.height;
  const context = canvas.getContext("2d");
  maps.forEach((map, i) => {
    context.globalAlpha = 1 / (i + 1);
    context.drawImage(map, 0, 0);
  });
  context.globalAlpha = 1;
  if (maps.length) context.globalCompositeOperation = "multiply";
  if (showsPicture) context.drawImage(picture, 0, 0);
}

function compose() {
  if (!shown) return;
  paint($("picture"), shown.bitmaps);
  fit();
}

function fit() {
  if (!shown) return;
  const box = $("stage");
  const scale = Math.min((box.clientWidth - 16) / shown.size[0], (box.clientHeight - 16) / shown.size[1], 4);
  $("sheet").style.width = shown.size[0] * scale + "px";
  $("sheet").style.height = shown.size[1] * scale + "px";
  $("slider").style.width = $("sheet").style.width;
}
new ResizeObserver(fit).observe($("stage"));

// The camera as it moves on before pictures of it come.
let live = null;
const plus = (a, b, factor = 1) => a.map((x, i) => x + factor * b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const pointText = point => point.map(short).join(",");

function moved() {
  if (live) return live;
  const {camera, size, half} = shown;
  const away = plus(camera.eye, camera.centre, -1);
  const target = "camera-focal-point" in values ? values["camera-focal-point"].split(",").map(Number)
    : plus(camera.eye, camera.back, -Math.hypot(...away));
  const {azimuth, elevation} = camera;
  live = {...camera, size, target, azimuth, elevation, distance: Math.hypot(...plus(camera.eye, target, -1)),
    focal: camera.focal * (half ? 2 : 1), zoom: parseFloat(textOf("camera-zoom-factor"))};
  return live;
}

// The settings of a camera that looks from where it does, by angles.
function angleTexts(camera) {
  if ("camera-position" in values) {
    const [a, e] = [camera.azimuth, camera.elevation].map(degrees => degrees * Math.PI / 180);
    const right = cross(camera.modelUp, camera.modelFront);
    const back = [0, 1, 2].map(i => Math.cos(e) * (Math.sin(a) * right[i] + Math.cos(a) * camera.modelFront[i])
      + Math.sin(e) * camera.modelUp[i]);
    return {"camera-position": pointText(plus(camera.target, back, camera.distance)), "camera-direction": ""};
  }
  const texts = {...defaultsOf(["view", "camera-direction", "camera-index"]),
    "camera-azimuth-angle": short(camera.azimuth), "camera-elevation-angle": short(camera.elevation)};
  if (camera.orthographic && !("camera-orthographic" in values) && !("scale" in values))
    texts["camera-orthographic"] = "0";
  return texts;
}

function turn(dx, dy) {
  const camera = moved();
  camera.azimuth = (camera.azimuth - dx * 0.4 + 540) % 360 - 180;
  camera.elevation = Math.max(-90, Math.min(90, camera.elevation + dy * 0.4));
  camera.azimuth = Math.round(camera.azimuth * 100) / 100;
  camera.elevation = Math.round(camera.elevation * 100) / 100;
  put(angleTexts(camera), true);
}

function pan(dx, dy) {
  const camera = moved();
  const depth = camera.orthographic ? 1 : camera.distance;
  const scale = depth / camera.focal * camera.size[0] / $("sheet").clientWidth;
  const step = plus(plus([0, 0, 0], camera.right, -dx * scale), camera.up, dy * scale);
  camera.target = plus(camera.target, step);
  camera.eye = plus(camera.eye, step);
  const texts = {"camera-focal-point": pointText(camera.target)};
  if ("camera-position" in values) texts["camera-position"] = pointText(camera.eye);
  if ("camera-index" in values) Object.assign(texts, angleTexts(camera));
  put(texts, true);
}

function zoom(factor) {
  const camera = moved();
  camera.zoom = Math.max(0.001, Math.min(1e6, camera.zoom * factor));
  camera.focal *= factor;
  put({"camera-zoom-factor": String(+camera.zoom.toPrecision(4))}, true);
}

const frameAll = () => put(defaultsOf(groupNames("camera")));
$("frame").onclick = frameAll;

const pointers = new Map();
$("stage").onpointerdown = event => {
  if (event.target === $("slider") || !shown) return;
  $("stage").setPointerCapture(event.pointerId);
  $("stage").classList.add("moving");
  pointers.set(event.pointerId, event);
  $("hover").hidden = true;
};
$("stage").onpointermove = event => {
  const last = pointers.get(event.pointerId);
  if (!last) return hover(event);
  const [dx, dy] = [event.clientX - last.clientX, event.clientY - last.clientY];
  if (!dx && !dy) return;
  if (pointers.size === 2) {
    const other = [...pointers.values()].find(pointer => pointer.pointerId !== event.pointerId);
    const apart = pointer => Math.hypot(pointer.clientX - other.clientX, pointer.clientY - other.clientY);
    zoom(apart(event) / Math.max(1, apart(last)));
    pan(dx / 2, dy / 2);
  } else if (event.shiftKey || event.buttons & 6) pan(dx, dy); else turn(dx, dy);
  pointers.set(event.pointerId, event);
};
$("stage").onpointerup = $("stage").onpointercancel = event => {
  if (pointers.delete(event.pointerId) && !pointers.size) {
    $("stage").classList.remove("moving");
    if (document.body.dataset.drawn !== "full") draw(false);
  }
};
$("stage").oncontextmenu = event => event.preventDefault();
$("stage").addEventListener("wheel", event => {
  event.preventDefault();
  if (shown) zoom(Math.exp(-event.deltaY * 0.001));
}, {passive: false});
$("stage").onkeydown = event => {
  if (event.target !== $("stage") || !shown || event.ctrlKey || event.altKey || event.metaKey) return;
  const way = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
  if (way && event.shiftKey) pan(way[0] * 20, way[1] * 20);
  else if (way) turn(way[0] * 12.5, way[1] * 12.5);
  else if (event.key === "+" || event.key === "=") zoom(1.1);
  else if (event.key === "-") zoom(1 / 1.1);
  else if (event.key === "0") frameAll();
  else return;
  event.preventDefault();
};

// What lies under the pointer, once it and the picture rest.
let resting = 0;
function hover(event) {
  clearTimeout(resting);
  $("hover").hidden = true;
  resting = setTimeout(async () => {
    if (document.body.dataset.drawn !== "full") return;
    const box = $("sheet").getBoundingClientRect();
    const at = [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
    if (at.some(share => share < 0 || share >= 1)) return;
    try {
      const [x, y] = at.map((share, i) => Math.floor(share * shown.size[i]));
      const answer = await ask("/hover", values, {x, y});
      if (answer) showHovered(await answer.json(), event);
    } catch { /* the picture says what is wrong */ }
  }, 120);
}
function showHovered({types, object, patch}, event) {
  const box = $("stage").getBoundingClientRect();
  $("hover").textContent = [types.join(" + "), object, patch ? `patch ${patch}` : ""].filter(Boolean).join(" · ");
  $("hover").hidden = !$("hover").textContent;
  const left = Math.min(event.clientX - box.left + 14, box.width - $("hover").offsetWidth - 4);
  $("hover").style.transform = `translate(${Math.max(left, 0)}px, ${Math.max(event.clientY - box.top - 30, 0)}px)`;
}
$("stage").onpointerleave = () => { clearTimeout(resting); $("hover").hidden = true; };

$("compare").onclick = () => {
  kept = kept ? null : {...values};
  $("compare").setAttribute("aria-pressed", String(!!kept));
  $("before").hidden = $("slider").hidden = $("divider").hidden = !kept;
  if (kept && shown) paint($("before"), shown.bitmaps);
  slide();
  draw(false);
};
function slide() {
  $("before").style.clipPath = `inset(0 ${100 - $("slider").value}% 0 0)`;
  $("divider").style.left = $("slider").value + "%";
}
$("slider").oninput = slide;
