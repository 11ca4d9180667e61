"use strict";
// The page around the viewer: it inflates the parts, gives them to the WebAssembly of viewer/web and
// turns input into its calls. What a session is and how it looks is decided there, not here.
(async function () {
const element = (id) => document.getElementById(id);
const canvas = element("rocinante-canvas");

function say(text, isFault) {
  element("message").textContent = text;
  element("message").classList.toggle("fault", Boolean(isFault));
}

function bytesOf(id) {
  const script = element("rocinante-" + id);
  const text = atob(script.textContent);
  script.remove();
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

async function inflated(id) {
  const stream = new Blob([bytesOf(id)]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

async function startViewer() {
  // In place of a second file: the script is a part of this one.
  const script = document.createElement("script");
  script.textContent = new TextDecoder().decode(await inflated("viewer-script"));
  document.head.append(script);
  return rocinanteViewer({canvas, wasmBinary: await inflated("viewer"), printErr: (text) => console.error(text)});
}

// Calls of the viewer.
function makeCalls(viewer) {
  const taken = (bytes) => {
    const at = viewer._malloc(Math.max(bytes.length, 1));
    viewer.HEAPU8.set(bytes, at);
    return at;
  };
  const text = (at) => viewer.UTF8ToString(at);
  const json = (at) => JSON.parse(text(at));
  return {
    open(cell, log) {
      const at = [taken(cell), taken(log)];
      const fault = text(viewer._rocinante_open(at[0], cell.length, at[1], log.length));
      at.forEach((each) => viewer._free(each));
      return fault;
    },
    about: () => json(viewer._rocinante_about()),
    events: () => json(viewer._rocinante_events()),
    devices: (ns) => json(viewer._rocinante_devices(ns)),
    poses: (ns) => text(viewer._rocinante_poses(ns)),
    draw: (ns, width, height, scale) => text(viewer._rocinante_draw(ns, width, height, scale)),
    warning: () => text(viewer._rocinante_warning()),
    camera: () => text(viewer._rocinante_camera()),
    useCamera(name) {
      const at = taken(new TextEncoder().encode(name + "\0"));
      const fault = text(viewer._rocinante_use_camera(at));
      viewer._free(at);
      return fault;
    },
    orbit: (...all) => text(viewer._rocinante_orbit(...all)),
    pan: (...all) => text(viewer._rocinante_pan(...all)),
    zoom: (...all) => text(viewer._rocinante_zoom(...all)),
  };
}

let calls, about;
let now = 0;             // ns from the session's origin
let playing = false;
let speed = 1;
let selected = "";
let due = false;         // a frame was asked for
let linkFault = "";      // what is wrong with the link, until another camera is chosen
let lastTick = 0;
// Since the page was opened, in the order in which they come.
const stats = {frames: 0, scriptMs: performance.now(), startedMs: 0, openedMs: 0, firstPictureMs: 0};

const size = () => {
  const scale = Math.min(Math.max(window.devicePixelRatio || 1, 1), 4);
  const box = canvas.getBoundingClientRect();
  return {width: Math.max(1, Math.round(box.width * scale)), height: Math.max(1, Math.round(box.height * scale)), scale};
};
const clamped = (ns) => Math.min(Math.max(Math.round(ns), about.start_ns), about.end_ns);
const seconds = (ns) => (ns / 1e9).toFixed(3) + " s";

function jointText(joint) {
  if (joint.kind === "angle") return (joint.value * 180 / Math.PI).toFixed(1) + "\u00b0";
  return joint.value.toFixed(4) + (joint.kind === "length" ? " m" : "");
}

function showDevices() {
  const panel = element("devices");
  if (panel.hidden) return;
  const devices = calls.devices(now);
  if (devices.error) return;
  const rows = devices.map((device) => {
    const box = document.createElement("section");
    box.classList.toggle("away", !device.visible);
    const title = document.createElement("h2");
    title.textContent = device.name;
    title.classList.toggle("selected", device.name === selected);
    title.onclick = () => { selected = selected === device.name ? "" : device.name; showDevices(); setLink(); };
    const list = document.createElement("dl");
    for (const joint of device.joints) {
      const name = document.createElement("dt");
      name.textContent = joint.name;
      const value = document.createElement("dd");
      value.textContent = jointText(joint);
      value.classList.toggle("outside", joint.outside);
      list.append(name, value);
    }
    box.append(title, list);
    return box;
  });
  panel.replaceChildren(...rows);
}

function draw() {
  due = false;
  const {width, height, scale} = size();
  if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
  const fault = calls.draw(now, width, height, scale);
  const warning = calls.warning();
  const trouble = window.rocinanteServed ? window.rocinanteServed.trouble : "";
  say(fault || linkFault || trouble || warning, Boolean(fault || linkFault));
  element("time").textContent = seconds(now);
  if (document.activeElement !== element("scrub") || playing) element("scrub").value = String(now);
  showDevices();
  ++stats.frames;
}

function tick(at) {
  if (playing) {
    now = clamped(now + (at - lastTick) * 1e6 * speed);
    if (now >= about.end_ns) setPlaying(false);
  }
  lastTick = at;
  draw();
  if (playing) ask();
}
function ask() {
  if (due) return;
  due = true;
  requestAnimationFrame(tick);
}

function setPlaying(on) {
  if (about.live) return;
  if (on && now >= about.end_ns) now = about.start_ns;
  playing = on;
  lastTick = performance.now();
  element("play").textContent = on ? "\u275a\u275a" : "\u25b6";
  element("play").setAttribute("aria-label", on ? "Pause" : "Play");
  if (on) ask(); else setLink();
}
function seek(ns) {
  now = clamped(ns);
  ask();
}

// A link to this moment, as it is read when a page is opened with it.
function setLink() {
  const words = ["t=" + String(now / 1e9)];
  if (calls.camera()) words.push("camera=" + encodeURIComponent(calls.camera()));
  if (selected) words.push("select=" + encodeURIComponent(selected));
  history.replaceState(null, "", "#" + words.join("&"));
}
function useLink() {
  const words = new URLSearchParams(location.hash.slice(1));
  linkFault = words.has("camera") ? calls.useCamera(words.get("camera")) : "";
  if (words.has("select")) selected = words.get("select");
  if (words.has("t")) {
    const t = Number(words.get("t"));
    if (Number.isFinite(t)) now = clamped(t * 1e9);
    else linkFault = "the link's t= is not a number of seconds";
  }
  showCamera();
}
function showCamera() {
  const name = calls.camera();
  const choice = element("camera");
  const other = choice.querySelector("option[data-by-hand]");
  if (name.startsWith("@")) {
    const option = other || choice.appendChild(document.createElement("option"));
    option.dataset.byHand = "yes";
    option.value = name;
    option.textContent = "by hand";
    choice.value = name;
  } else {
    if (other) other.remove();
    choice.value = name || about.cameras[0];
  }
}

function chooseCamera(name) {
  linkFault = calls.useCamera(name);
  showCamera();
  setLink();
  ask();
}

// The mouse as in `rocinante view`: the left button turns, the right one or shift moves, the wheel
// zooms to the pointer. Two fingers move and zoom.
function listenToPointers() {
  const fingers = new Map();
  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    const {width, height, scale} = size();
    return {x: (event.clientX - box.left) * scale, y: (event.clientY - box.top) * scale, width, height};
  };
  const zoomAt = (steps, at) => calls.zoom(now, steps, at.x - at.width / 2, at.y - at.height / 2, at.width, at.height);
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, place(event));
    canvas.focus({preventScroll: true});
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const at = place(event);
    if (fingers.size === 2) {
      const other = [...fingers].find(([id]) => id !== event.pointerId)[1];
      const span = (a) => Math.max(Math.hypot(a.x - other.x, a.y - other.y), 1);
      zoomAt(10 * Math.log(span(at) / span(before)), {...at, x: (at.x + other.x) / 2, y: (at.y + other.y) / 2});
      calls.pan(now, (at.x - before.x) / 2, (at.y - before.y) / 2, at.width, at.height);
    } else {
      const moves = event.shiftKey || (event.buttons & 6) !== 0;
      (moves ? calls.pan : calls.orbit)(now, at.x - before.x, at.y - before.y, at.width, at.height);
    }
    fingers.set(event.pointerId, at);
    ask();
  });
  const end = (event) => {
    if (!fingers.delete(event.pointerId)) return;
    linkFault = "";
    showCamera();
    setLink();
  };
  canvas.addEventListener("pointerup", end);
  canvas.addEventListener("pointercancel", end);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoomAt(-Math.sign(event.deltaY) * Math.min(Math.abs(event.deltaY) / 100, 3), place(event));
    showCamera();
    setLink();
    ask();
  }, {passive: false});
}

function listenToKeys() {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === "SELECT") return;
    const step = event.shiftKey ? 1e9 : 1e8;
    const keys = {
      " ": () => setPlaying(!playing),
      ArrowLeft: () => seek(now - step),
      ArrowRight: () => seek(now + step),
      Home: () => seek(about.start_ns),
      End: () => seek(about.end_ns),
      d: () => element("panel").click(),
    };
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
    setLink();
  });
}

function listenToBar() {
  element("play").onclick = () => setPlaying(!playing);
  const scrub = element("scrub");
  scrub.min = String(about.start_ns);
  scrub.max = String(about.end_ns);
  scrub.addEventListener("input", () => seek(Number(scrub.value)));
  scrub.addEventListener("change", () => setLink());
  element("speed").onchange = (event) => { speed = Number(event.target.value); };
  element("camera").onchange = (event) => chooseCamera(event.target.value);
  element("panel").onclick = () => {
    element("devices").hidden = !element("devices").hidden;
    element("panel").setAttribute("aria-pressed", String(!element("devices").hidden));
    ask();
  };
  for (const name of about.cameras) {
    const option = element("camera").appendChild(document.createElement("option"));
    option.value = option.textContent = name;
  }
}

function showEvents() {
  const length = Math.max(about.end_ns - about.start_ns, 1);
  const marks = calls.events().slice(0, 2000).map((event) => {
    const mark = document.createElement("i");
    mark.style.left = 100 * (event.ns - about.start_ns) / length + "%";
    mark.title = event.text;
    return mark;
  });
  element("marks").replaceChildren(...marks);
}

try {
  const [viewer, cell] = await Promise.all([startViewer(), inflated("cell")]);
  calls = makeCalls(viewer);
  stats.startedMs = performance.now();
  const served = window.rocinanteServed;  // served.js: the session comes from a server
  const fault = served ? await served.open(viewer, calls, cell, say) : calls.open(cell, bytesOf("log"));
  if (fault) { say(fault, true); return; }
  stats.openedMs = performance.now();
  about = calls.about();
  now = about.start_ns;
  element("bar").hidden = false;
  element("devices").hidden = window.innerWidth < 640;
  listenToBar();
  listenToPointers();
  listenToKeys();
  useLink();
  draw();
  stats.firstPictureMs = performance.now();
  new ResizeObserver(ask).observe(canvas);
  window.addEventListener("hashchange", () => { useLink(); ask(); });
  canvas.addEventListener("webglcontextlost", () => say("the browser has taken its WebGL 2 back: open the page again", true));
  setTimeout(showEvents, 0);
  if (served) served.run(about, seek);
  // For tests, and for whoever looks from the console.
  window.rocinante = {calls, stats, about, now: () => now, seek, setPlaying, isPlaying: () => playing};
} catch (problem) {
  say("This browser cannot show the session: " + (problem && problem.message || problem), true);
}
})();
