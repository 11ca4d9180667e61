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

// Compiled while the browser makes a context to draw with, and reads what comes after this script.
async function startViewer() {
  const text = rocinanteParts.inflated("viewer-script");
  const compiled = WebAssembly.compile(await rocinanteParts.inflated("viewer"));
  for (const awaited_below of [text, compiled]) awaited_below.catch(() => {});
  // viewer/web/web_context.cpp takes it over. Frames are drawn into framebuffers of its own and copied: the
  // canvas needs neither depth nor samples. A paused page is drawn once.
  canvas.getContext("webgl2", {alpha: false, depth: false, antialias: false, preserveDrawingBuffer: true});
  // In place of a second file: the script is a part of this one.
  const script = document.createElement("script");
  script.textContent = new TextDecoder().decode(await text);
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
  const what = problem && problem.message || String(problem);
  say(problem && problem.ofPage ? what : "This browser cannot show the session: " + what, true);
}

let calls, about, panels, plots;
let layout = {};         // what the page begins with (viewer/page/page_layout.h); empty: nothing is said
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
const kBeginningBytes = 4 << 20;  // of a log; more than a chunk of it has
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

function drawPicture(care) {
  const {width, height, scale} = size();
  if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
  const fault = calls.draw(now, width, height, scale, care);
  canvas.getContext("webgl2").flush();  // it draws beside what follows here
  return fault;
}

function draw(care) {
  const fault = drawPicture(care);
  const warning = calls.warning();
  const trouble = window.rocinanteServed ? window.rocinanteServed.trouble : "";
  say(fault || linkFault || trouble || warning, Boolean(fault || linkFault));
  element("time").textContent = seconds(now);
  if (document.activeElement !== element("scrub") || playing) element("scrub").value = String(now);
  const at = performance.now();
  const isListed = care !== careOf.moving || at - listedAt >= kListMs;
  if (isListed) listedAt = at;
  plots.moveCursor(now, isListed ? panels.showDevices() : null, isListed);
  ++stats.frames;
}

// Mesh by mesh, what moving pictures draw in place of meshes that are finer than the eye sees: while nothing
// else is asked for, beside a log that plays too.
function makeDetail() {
  if (due && !playing) { setTimeout(makeDetail, 50); return; }
  if (calls.makeDetail()) setTimeout(makeDetail, 0);
  else stats.detailedMs = performance.now();
}

// Pictures on surfaces, one by one, and the whole picture then: it has them, as any that is asked for sooner.
function decodeNext() {
  if (calls.nextPicture()) setTimeout(decodeNext, 0); else ask();
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
// Before the link, which may say another camera. Returns what is wrong with it.
function useLayout() {
  const faults = [
    layout.camera ? calls.useCamera(layout.camera) : "",
    layout.insets ? calls.useInsets(layout.insets) : "",
    calls.choosePlots(layout.plots || []),
  ];
  return faults.find(Boolean) || "";
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
  if (name && !about.cameras.includes(name)) {
    const option = other || choice.appendChild(document.createElement("option"));
    option.dataset.byHand = "yes";
    option.value = name;
    option.textContent = name.startsWith("@") ? "by hand" : name;
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

// Of a long log, its beginning is shown while the browser reads the rest of the page: a moment that is there,
// by a camera that does not depend on the rest.
async function openSession(viewer, cell) {
  const log = rocinanteParts.readLog(viewer, ({there, size}) => say(`Reading the log: ${Math.round(100 * there / size)} % ...`));
  await log.reaches(kBeginningBytes);
  const fault = calls.open(cell, log);
  if (log.there === log.size) return fault;
  if (!fault) showBeginning();
  await log.reaches(log.size);
  return fault ? calls.open(cell, log) : calls.openWhole();
}
function showBeginning() {
  about = calls.about();
  now = about.start_ns;
  if (layout.camera) calls.useCamera(layout.camera);
  const words = new URLSearchParams(location.hash.slice(1));
  if (words.has("t")) now = Math.round(Number(words.get("t")) * 1e9);
  if (words.has("camera") && calls.useCamera(words.get("camera")) || calls.isFitted()) return;
  if (!(now >= about.start_ns && now < about.end_ns) || drawPicture(careOf.first)) return;
  whenDrawn(() => { stats.firstPictureMs = stats.firstPictureMs || performance.now(); });
}

// What pointers and the panels beside the picture see of it.
const page = {
  get calls() { return calls; },
  get about() { return about; },
  get layout() { return layout; },
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
  await rocinanteParts.beforeLog();
  const given = ["findings", "events"].map(rocinanteParts.inflated);
  for (const awaited_below of given) awaited_below.catch(() => {});
  if (rocinanteParts.has("layout")) layout = JSON.parse(new TextDecoder().decode(await rocinanteParts.inflated("layout")));
  const [viewer, cell] = await Promise.all([viewerStarts, rocinanteParts.inflated("cell")]);
  calls = rocinanteCalls(viewer);
  stats.startedMs = performance.now();
  const served = window.rocinanteServed;  // served.js: the session comes from a server
  const fault = served ? await served.open(viewer, calls, cell, say) : await openSession(viewer, cell);
  if (fault) { say(fault, true); return; }
  stats.openedMs = performance.now();
  about = calls.about();
  now = about.start_ns;
  panels = rocinantePanels(page);
  plots = rocinantePlots(page);
  element("bar").hidden = false;
  element("devices").hidden = window.innerWidth < 640;
  const layoutFault = useLayout();
  useLink();
  linkFault = linkFault || layoutFault;
  listenToBar();
  rocinantePointers(page);
  listenToKeys();
  window.addEventListener("hashchange", () => { useLink(); ask(); });
  canvas.addEventListener("webglcontextlost", () => say("the browser has taken its WebGL 2 back: open the page again", true));
  // For tests, and for whoever looks from the console.
  window.rocinante = {calls, stats, about, plots, now: () => now, seek, setPlaying, isPlaying: () => playing,
    isAtRest: () => stats.frames > 1 && !due && !isDrawing && !playing && !wasMoving};
  draw(careOf.first);
  stats.firstDrawnMs = performance.now();
  whenDrawn(async () => {
    stats.firstPictureMs = stats.firstPictureMs || performance.now();
    decodeNext();
    new ResizeObserver(() => { plots.show(); ask(); }).observe(canvas);
    const [found, happened] = (await Promise.all(given)).map((bytes) => JSON.parse(new TextDecoder().decode(bytes)));
    events = happened || calls.events();
    panels.showList(found, events);
    if (plots.begins()) plots.toggle();
    if (served) served.run(about, seek);
    setTimeout(makeDetail, 200);
  });
} catch (problem) {
  fail(problem);
}
})();
