"use strict";
// The parts that stand in this page, in pieces: the viewer, the cell and the findings, compressed, and the
// log, which is decoded while the browser still reads the page, straight to where the viewer reads it.
const rocinanteParts = (function () {
const element = (id) => document.getElementById("rocinante-" + id);
const sizeOf = (text) => text.length / 4 * 3 - (text.endsWith("==") ? 2 : text.endsWith("=") ? 1 : 0);

const kMostBytes = 2 ** 31;  // of WebAssembly's memory, see cmake/web.cmake

// What is wrong with the page, in its own sentence, and not with the browser.
const fault = (text) => Object.assign(new Error(text), {ofPage: true});

// Fills `bytes`, which has the text's size.
function decode(text, bytes) {
  if (bytes.setFromBase64) { bytes.setFromBase64(text); return; }
  const decoded = atob(text);
  for (let i = 0; i < decoded.length; ++i) bytes[i] = decoded.charCodeAt(i);
}

// The part's next piece.
function takeAway(piece) {
  const next = piece.nextElementSibling;
  piece.remove();
  return next && next.dataset.more !== undefined ? next : null;
}

// Not by a Blob, whose bytes go to the browser's process and back.
function inflatedStream(id) {
  const stream = new DecompressionStream("gzip");
  const writer = stream.writable.getWriter();
  const toldBelow = (written) => written.catch(() => {});  // the reader fails with it
  let piece = element(id);
  if (!piece) throw fault("the page was cut: it has no " + id);
  for (; piece; piece = takeAway(piece)) {
    const text = piece.textContent;
    if (text.length % 4) throw fault("the page was cut: it has no whole " + id);
    const bytes = new Uint8Array(sizeOf(text));
    decode(text, bytes);
    toldBelow(writer.write(bytes));
  }
  toldBelow(writer.close());
  return stream.readable;
}
async function inflated(id) {
  try {
    return new Uint8Array(await new Response(inflatedStream(id)).arrayBuffer());
  } catch (problem) {
    throw problem.ofPage ? problem : fault(`the page was changed: its ${id} cannot be unpacked`);
  }
}

// Resolves once `test` holds, which is asked whenever the browser has read on; it throws when that cannot be
// any more.
function until(test) {
  return new Promise((done, failed) => {
    const look = () => {
      try { if (!test()) return; } catch (problem) { failed(problem); }
      watch.disconnect();
      document.removeEventListener("DOMContentLoaded", look);
      done();
    };
    const watch = new MutationObserver(look);
    watch.observe(document.body, {childList: true});
    document.addEventListener("DOMContentLoaded", look);
    look();
  });
}
const isRead = () => document.readyState !== "loading";

// The log of this page, in the viewer's memory: where it is, its size, and how much of it is there. `say` is
// told as more comes.
function readLog(viewer, say) {
  let piece = element("log");
  if (!piece) throw fault("the page was cut: it has no log");
  const size = Number(piece.dataset.bytes);
  if (!(size >= 0)) throw fault("the page's log was changed");
  const log = {at: size < kMostBytes ? viewer._malloc(Math.max(size, 1)) : 0, size, there: 0};
  if (!log.at) throw new Error("not enough memory in this browser for a log of " + Math.round(size / 1e6) + " MB");
  const take = () => {
    const before = log.there;
    while (piece && (piece.nextElementSibling || isRead())) {
      const text = piece.textContent;
      const isSound = text.length % 4 === 0 && log.there + sizeOf(text) <= size;
      if (!isSound) throw fault("the page's log was cut or changed");
      const bytes = viewer.HEAPU8.subarray(log.at + log.there, log.at + log.there + sizeOf(text));
      try { decode(text, bytes); } catch { throw fault("the page's log was changed"); }
      log.there += sizeOf(text);
      piece = takeAway(piece);
    }
    if (log.there < size && isRead()) throw fault("the page ends within its log: it was cut");
    if (log.there > before && log.there < size) say(log);
  };
  // Resolves once so much of it is there.
  log.reaches = (bytes) => until(() => { take(); return log.there >= Math.min(bytes, size); });
  return log;
}

return {
  inflated, readLog,
  has: (id) => Boolean(element(id)),
  // Resolves once what stands before the log is there.
  beforeLog: () => until(() => element("log") || isRead()),
};
})();
