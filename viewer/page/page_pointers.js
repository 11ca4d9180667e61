"use strict";
// The mouse as in `rocinante view`: the left button turns, the right one or shift moves, the wheel
// zooms to the pointer, a click selects. Two fingers move and zoom.
function rocinantePointers(page) {
  const kClickPx = 4;  // what a click may wander
  const {canvas, calls} = page;
  const fingers = new Map();
  let wandered = 0;  // pixels since the button went down; without end where it cannot be a click

  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    const {width, height, scale} = page.size();
    return {x: (event.clientX - box.left) * scale, y: (event.clientY - box.top) * scale, width, height, scale};
  };
  const zoomAt = (steps, at) =>
    calls.zoom(page.now(), steps, at.x - at.width / 2, at.y - at.height / 2, at.width, at.height);
  function pickAt(at) {
    const picked = calls.pick(page.now(), at.x, at.y, at.width, at.height);
    if (picked && picked.error) page.say(picked.error, true);
    else page.select(picked ? picked.device : "", picked ? picked.link : "");
  }

  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    wandered = fingers.size || event.button !== 0 ? Infinity : 0;
    fingers.set(event.pointerId, place(event));
    canvas.focus({preventScroll: true});
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const at = place(event);
    wandered += Math.hypot(at.x - before.x, at.y - before.y) / at.scale;
    if (wandered < kClickPx) return;
    if (fingers.size === 2) {
      const other = [...fingers].find(([id]) => id !== event.pointerId)[1];
      const span = (a) => Math.max(Math.hypot(a.x - other.x, a.y - other.y), 1);
      zoomAt(10 * Math.log(span(at) / span(before)), {...at, x: (at.x + other.x) / 2, y: (at.y + other.y) / 2});
      calls.pan(page.now(), (at.x - before.x) / 2, (at.y - before.y) / 2, at.width, at.height);
    } else {
      const moves = event.shiftKey || (event.buttons & 6) !== 0;
      (moves ? calls.pan : calls.orbit)(page.now(), at.x - before.x, at.y - before.y, at.width, at.height);
    }
    fingers.set(event.pointerId, at);
    page.askToMove();
  });
  const end = (event) => {
    if (!fingers.delete(event.pointerId)) return;
    if (wandered < kClickPx && event.type === "pointerup") pickAt(place(event));
    else page.cameraMoved();
  };
  canvas.addEventListener("pointerup", end);
  canvas.addEventListener("pointercancel", end);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoomAt(-Math.sign(event.deltaY) * Math.min(Math.abs(event.deltaY) / 100, 3), place(event));
    page.cameraMoved();
    page.askToMove();
  }, {passive: false});
}
