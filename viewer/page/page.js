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

const inflatedStream = (id) => new Blob([bytesOf(id)]).stream().pipeThrough(new DecompressionStream("gzip"));
const inflated = async (id) => new Uint8Array(await new Response(inflatedStream(id)).arrayBuffer());

// Compiled while the browser makes a context to draw with, and reads what comes after this script.
async function startViewer() {
  const compiled = WebAssembly.compile(await inflated("viewer"));
  compiled.catch(() => {});  // awaited below
  // viewer/web/web_context.cpp takes it over. Frames are drawn into framebuffers of its own and copied: the
  // canvas needs neither depth nor samples. A paused page is drawn once.
  canvas.getContext("webgl2", {alpha: false, depth: false, antialias: false, preserveDrawingBuffer: true});
  // In place of a second file: the script is a part of this one.
  const script = document.createElement("script");
  script.textContent = new TextDecoder().decode(await inflated("viewer-script"));
  document.head.append(script);
  const module = await compiled;
  return rocinanteViewer({
    canvas,
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(module, imports).then((instance) => done(instance, module), fail);
      return {};
    },
    printErr: (text) => console.error(text),
  });
}
function fail(problem) {
  say("This browser cannot show the session: " + (problem && problem.message || problem), true);
}

// Parts that stand after this script are there once the document is.
const wholeDocument = new Promise((done) => {
  if (document.readyState !== "loading") done();
  else document.addEventListener("DOMContentLoaded", done);
});

// Calls of the viewer.
function makeCalls(viewer) {
  const taken = (bytes) => {
    const at = viewer._malloc(Math.max(bytes.length, 1));
    viewer.HEAPU8.set(bytes, at);
    return at;
  };
  const text = (at) => viewer.UTF8ToString(at);
  const json = (at) => JSON.parse(text(at));
  const withText = (given, use) => {
    const at = taken(new TextEncoder().encode(given + "\0"));
    const answer = use(at);
    viewer._free(at);
    return answer;
  };
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
    // Care: 0 everything, 1 as much as is drawn in time, 2 little.
    draw: (ns, width, height, scale, care = 0) => text(viewer._rocinante_draw(ns, width, height, scale, care)),
    makeDetail: () => viewer._rocinante_make_detail() !== 0,
    finishPictures: () => viewer._rocinante_finish_pictures(),
    frameTook: (ms) => viewer._rocinante_frame_took(ms),
    rung: () => viewer._rocinante_rung(),
    pick: (...all) => json(viewer._rocinante_pick(...all)),
    select: (path) => withText(path, (at) => text(viewer._rocinante_select(at))),
    readPlots: (messages) => viewer._rocinante_read_plots(messages),
    plots: (device, ...all) => withText(device, (at) => json(viewer._rocinante_plots(at, ...all))),
    fold(log) {
      const at = taken(log);
      const answer = json(viewer._rocinante_fold(at, log.length));
      viewer._free(at);
      return answer;
    },
    warning: () => text(viewer._rocinante_warning()),
    camera: () => text(viewer._rocinante_camera()),
    useCamera: (name) => withText(name, (at) => text(viewer._rocinante_use_camera(at))),
    orbit: (...all) => text(viewer._rocinante_orbit(...all)),
    pan: (...all) => text(viewer._rocinante_pan(...all)),
    zoom: (...all) => text(viewer._rocinante_zoom(...all)),
  };
}

let calls, about, panels, plots;
let events = [];
let now = 0;             // ns from the session's origin
let playing = false;
let speed = 1;
let selected = {device: "", link: ""};
let due = false;         // a frame was asked for
let askedAt = 0;
let isDrawing = false;   // the browser still draws the last one, and the next one waits for it
let wasPlaying = false;  // the last frame was one of a log that plays
let linkFault = "";      // what is wrong with the link, until another camera is chosen
let lastTick = 0;
let movedAt = -1e9;      // when the picture was last asked to move
let wasMoving = false;   // the last frame was drawn as one of many
let listedAt = 0;        // when the devices were last listed
let restTimer = 0;
const kRestMs = 60;      // nothing moved for this long: at rest, and everything is drawn
const kListMs = 100;     // how often the values are listed while frames are drawn one after another
const careOf = {whole: 0, moving: 1, first: 2};
// Since the page was opened, in the order in which they come; restMs: from the last movement until
// everything was drawn; detailedMs: coarser meshes are there.
const stats = {frames: 0, scriptMs: performance.now(), startedMs: 0, openedMs: 0, firstDrawnMs: 0, firstPictureMs: 0,
  restMs: 0, detailedMs: 0};

const size = () => {
  const scale = Math.min(Math.max(window.devicePixelRatio || 1, 1), 4);
  const box = canvas.getBoundingClientRect();
  return {width: Math.max(1, Math.round(box.width * scale)), height: Math.max(1, Math.round(box.height * scale)), scale};
};
const clamped = (ns) => Math.min(Math.max(Math.round(ns), about.start_ns), about.end_ns);
const seconds = (ns) => (ns / 1e9).toFixed(3) + " s";

// Calls `then` once the browser has drawn what was asked for so far.
function whenDrawn(then) {
  const gl = canvas.getContext("webgl2");
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  const look = () => {
    if (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) { setTimeout(look, 3); return; }
    gl.deleteSync(fence);
    then();
  };
  setTimeout(look, 0);
}

function draw(care) {
  const {width, height, scale} = size();
  if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
  const fault = calls.draw(now, width, height, scale, care);
  const warning = calls.warning();
  const trouble = window.rocinanteServed ? window.rocinanteServed.trouble : "";
  say(fault || linkFault || trouble || warning, Boolean(fault || linkFault));
  element("time").textContent = seconds(now);
  if (document.activeElement !== element("scrub") || playing) element("scrub").value = String(now);
  const at = performance.now();
  const isListed = care !== careOf.moving || at - listedAt >= kListMs;
  if (isListed) listedAt = at;
  plots.moveCursor(now, isListed ? panels.showDevices() : null);
  ++stats.frames;
}

// Mesh by mesh, what moving pictures draw in place of meshes that are finer than the eye sees: while nothing
// else is asked for, beside a log that plays too.
function makeDetail() {
  if (due && !playing) { setTimeout(makeDetail, 50); return; }
  if (calls.makeDetail()) setTimeout(makeDetail, 0);
  else stats.detailedMs = performance.now();
}

// While a log plays, the next frame is prepared as soon as the browser wants one, beside the last ones
// that it still draws. Otherwise it waits for those, and is of what is known by then: so packets and
// input are taken at once, and not behind frames that queue up.
function tick(at) {
  due = false;
  const begun = performance.now();
  const isMoving = playing || begun - movedAt < kRestMs;
  const isFirstAtRest = wasMoving && !isMoving;
  if (playing) {
    now = clamped(now + (at - lastTick) * 1e6 * speed);
    if (now >= about.end_ns) setPlaying(false);
    // What a frame costs is how long the next one was kept waiting.
    if (wasPlaying) calls.frameTook(begun - Math.max(askedAt, lastTick));
  }
  lastTick = at;
  draw(isMoving ? careOf.moving : careOf.whole);
  wasMoving = isMoving;
  wasPlaying = playing;
  clearTimeout(restTimer);
  if (playing) { askToMove(); return; }
  isDrawing = true;
  whenDrawn(() => {
    isDrawing = false;
    if (isMoving) calls.frameTook(performance.now() - begun);
    if (isFirstAtRest) stats.restMs = performance.now() - movedAt;
    if (due) requestAnimationFrame(tick);
  });
  if (isMoving) restTimer = setTimeout(ask, kRestMs + 1);
}
function ask() {
  if (due) return;
  due = true;
  askedAt = performance.now();
  if (!isDrawing) requestAnimationFrame(tick);
}
// For pictures that are followed by others.
function askToMove() {
  movedAt = performance.now();
  ask();
}

function setPlaying(on) {
  if (about.live) return;
  if (on && now >= about.end_ns) now = about.start_ns;
  playing = on;
  lastTick = performance.now();
  element("play").textContent = on ? "\u275a\u275a" : "\u25b6";
  element("play").setAttribute("aria-label", on ? "Pause" : "Play");
  if (on) askToMove(); else { ask(); setLink(); }
}
function seek(ns) {
  now = clamped(ns);
  askToMove();
}
function nextEvent(direction) {
  const ahead = events.filter((event) => direction * (event.ns - now) > 0).map((event) => event.ns);
  if (ahead.length) seek(direction > 0 ? Math.min(...ahead) : Math.max(...ahead));
}

// A PATH of docs/rendering.md.
const wordOf = (name) => name.replace(/[%/#*]/g, (each) => "%" + each.charCodeAt(0).toString(16).toUpperCase());
const pathOf = ({device, link}) => device && wordOf(device) + (link ? "/" + wordOf(link) : "");
function select(device, link) {
  selected = {device, link};
  linkFault = calls.select(pathOf(selected));
  plots.show();
  setLink();
  ask();
}
function useSelection(path) {
  const parts = path.split("/").map((word) => { try { return decodeURIComponent(word); } catch { return word; } });
  selected = {device: parts[0], link: parts[1] || ""};
  const fault = calls.select(pathOf(selected));
  if (fault) selected = {device: "", link: ""};
  return fault;
}

// A link to this moment, as it is read when a page is opened with it.
function setLink() {
  const words = ["t=" + String(now / 1e9)];
  if (calls.camera()) words.push("camera=" + encodeURIComponent(calls.camera()));
  if (selected.device) words.push("select=" + encodeURIComponent(pathOf(selected)));
  history.replaceState(null, "", "#" + words.join("&"));
}
function useLink() {
  const words = new URLSearchParams(location.hash.slice(1));
  linkFault = words.has("camera") ? calls.useCamera(words.get("camera")) : "";
  if (words.has("select")) linkFault = useSelection(words.get("select")) || linkFault;
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

function press(button) {
  if (!element(button).hidden) element(button).click();
}
function listenToKeys() {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === "SELECT") return;
    if (event.key === " " && event.target.classList.contains("row")) return;
    const step = event.shiftKey ? 1e9 : 1e8;
    const keys = {
      " ": () => setPlaying(!playing),
      ArrowLeft: () => seek(now - step),
      ArrowRight: () => seek(now + step),
      Home: () => seek(about.start_ns),
      End: () => seek(about.end_ns),
      ",": () => nextEvent(-1),
      ".": () => nextEvent(1),
      d: () => press("panel"),
      l: () => press("lists"),
      p: () => press("curves"),
      Escape: () => select("", ""),
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
  element("panel").onclick = () => panels.toggle("devices", "panel");
  element("lists").onclick = () => panels.toggle("list", "lists");
  element("curves").onclick = () => plots.toggle();
  for (const name of about.cameras) {
    const option = element("camera").appendChild(document.createElement("option"));
    option.value = option.textContent = name;
  }
}

// What pointers and the panels beside the picture see of it.
const page = {
  get calls() { return calls; },
  get about() { return about; },
  now: () => now,
  selectedDevice: () => selected.device,
  hasDevice: (name) => about.devices.includes(name),
  select,
  selectFirst() { if (about.devices.length) select(about.movable[0] || about.devices[0], ""); },
  canvas, size, say, seek, setLink, ask, askToMove,
  // The camera was moved by hand.
  cameraMoved() { linkFault = ""; showCamera(); setLink(); },
};

try {
  const viewerStarts = startViewer();
  await wholeDocument;
  const findings = inflated("findings");
  const [viewer, cell] = await Promise.all([viewerStarts, inflated("cell")]);
  calls = makeCalls(viewer);
  stats.startedMs = performance.now();
  const served = window.rocinanteServed;  // served.js: the session comes from a server
  const fault = served ? await served.open(viewer, calls, cell, say) : calls.open(cell, bytesOf("log"));
  if (fault) { say(fault, true); return; }
  stats.openedMs = performance.now();
  about = calls.about();
  now = about.start_ns;
  panels = rocinantePanels(page);
  plots = rocinantePlots(page);
  element("bar").hidden = false;
  element("devices").hidden = window.innerWidth < 640;
  useLink();
  listenToBar();
  rocinantePointers(page);
  listenToKeys();
  window.addEventListener("hashchange", () => { useLink(); ask(); });
  canvas.addEventListener("webglcontextlost", () => say("the browser has taken its WebGL 2 back: open the page again", true));
  // For tests, and for whoever looks from the console.
  window.rocinante = {calls, stats, about, plots, now: () => now, seek, setPlaying, isPlaying: () => playing,
    isAtRest: () => !due && !isDrawing && !playing && !wasMoving};
  draw(careOf.first);
  stats.firstDrawnMs = performance.now();
  whenDrawn(async () => {
    stats.firstPictureMs = performance.now();
    ask();
    new ResizeObserver(() => { plots.show(); ask(); }).observe(canvas);
    const found = JSON.parse(new TextDecoder().decode(await findings));
    events = calls.events();
    panels.showList(found, events);
    if (served) served.run(about, seek);
    setTimeout(makeDetail, 200);
  });
  // Beside the browser's renderer, which draws that first picture meanwhile.
  calls.finishPictures();
} catch (problem) {
  fail(problem);
}
})();
