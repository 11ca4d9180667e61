"use strict";
// For a page that `rocinante serve` gives: where its session comes from (viewer/page/page.js asks).
const rocinanteServed = (function () {
const kind = document.getElementById("rocinante-served").dataset.kind;
// Whoever opens the page with a token has it for what the page asks for, too.
const token = new URLSearchParams(location.search).get("token");
const address = (path) => new URL(path + (token ? "?token=" + encodeURIComponent(token) : ""), location.href);

const kPieceBytes = 4 << 20;
const kMostBytes = 2e9;  // viewer/page/page_file.h; beyond 2^32 an address would wrap around
const kSilentMs = 5000;  // the server restates everything every two seconds
const served = {kind, trouble: ""};

// The log in pieces, so that a broken connection costs one of them.
async function piece(from, size) {
  for (let attempt = 1; ; ++attempt) {
    try {
      const answer = await fetch(address("log"), {headers: {Range: `bytes=${from}-${from + size - 1}`}});
      if (!answer.ok) throw new Error((await answer.text()).trim());
      const whole = answer.status === 206 ? Number(answer.headers.get("Content-Range").split("/")[1]) : null;
      return {bytes: new Uint8Array(await answer.arrayBuffer()), whole};
    } catch (problem) {
      if (attempt === 3) throw problem;
      await new Promise((resolve) => setTimeout(resolve, 500 * attempt));
    }
  }
}

// In the viewer's memory.
async function readLog(viewer, say) {
  const first = await piece(0, kPieceBytes);
  const size = first.whole === null ? first.bytes.length : first.whole;
  if (!(size <= kMostBytes)) {
    throw new Error(`a page holds a log of at most ${kMostBytes / 1e6} MB, and this one has ${Math.round(size / 1e6)} MB`);
  }
  const log = {at: viewer._malloc(Math.max(size, 1)), size, there: 0};
  if (!log.at) throw new Error("not enough memory in this browser for a log of " + Math.round(size / 1e6) + " MB");
  for (let next = first; ; next = await piece(log.there, kPieceBytes)) {
    const bytes = next.bytes.subarray(0, size - log.there);
    viewer.HEAPU8.set(bytes, log.at + log.there);
    log.there += bytes.length;
    if (log.there === size) return log;
    if (bytes.length === 0) throw new Error("the server's log ends early");
    say(`Reading the log: ${Math.round(100 * log.there / size)} % ...`);
  }
}

// Empty, or what is wrong.
served.open = async (viewer, calls, cell, say) => {
  if (kind === "log") return calls.open(cell, await readLog(viewer, say));
  const taken = (bytes) => {
    const at = viewer._malloc(bytes.length);
    viewer.HEAPU8.set(bytes, at);
    return at;
  };
  const at = taken(cell);
  const fault = viewer.UTF8ToString(viewer._rocinante_open_live(at, cell.length));
  viewer._free(at);
  served.take = (bytes) => {
    const message = taken(bytes);
    const wrong = viewer.UTF8ToString(viewer._rocinante_take(message, bytes.length));
    viewer._free(message);
    return wrong;
  };
  served.now = () => viewer._rocinante_live_ns();
  return fault;
};

function listen(about, show) {
  const socket = new WebSocket(Object.assign(address("live"), {protocol: location.protocol === "https:" ? "wss:" : "ws:"}),
    "rocinante.v1");
  socket.binaryType = "arraybuffer";
  let heard = performance.now();
  const watch = setInterval(() => {
    const silent = performance.now() - heard > kSilentMs;
    const trouble = silent && socket.readyState === WebSocket.OPEN ? "nothing is heard: the sources are silent" : "";
    if (socket.readyState !== WebSocket.OPEN || trouble === served.trouble) return;
    served.trouble = trouble;
    show(about.end_ns);
  }, 500);
  socket.onmessage = (event) => {
    heard = performance.now();
    served.trouble = served.take(new Uint8Array(event.data));
    about.end_ns = served.now();
    show(about.end_ns);
  };
  socket.onclose = () => {
    clearInterval(watch);
    served.trouble = "the connection to the server is lost; trying again ...";
    show(about.end_ns);
    setTimeout(() => listen(about, show), 1000);
  };
}

// After the first picture: `show` draws that moment.
served.run = (about, show) => {
  if (kind !== "live") return;
  for (const id of ["play", "track", "lists", "curves"]) document.getElementById(id).hidden = true;
  document.getElementById("speed").parentElement.hidden = true;
  document.getElementById("bar").prepend(Object.assign(document.createElement("strong"), {id: "live", textContent: "live"}));
  listen(about, show);
};
return served;
})();
window.rocinanteServed = rocinanteServed;
