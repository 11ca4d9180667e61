"use strict";
// Curves of the selected device's joints and signals, or of the layout's values and the signals of no device, over the session. What a curve is, its scale and its
// limits come from viewer/web; here they are laid out, with a cursor that scrubs.
function rocinantePlots(page) {
  const kHeight = 40;            // of a lane, in pixels
  const kMessages = 2000;        // read at a time
  const kReadMs = 12;            // in one go, so that the page continues
  const kShowMs = 150;           // how often curves grow while the log is read
  const panel = document.getElementById("plots");
  const say = document.getElementById("plots-say");
  let part = 0;                  // of the log that is read; -1: it cannot be read on
  let isReading = false;
  let shownAt = 0;
  let lanes = [];
  let drawn = "";                // what the lanes show
  const chosen = page.layout.plots || [];  // shown while no device is selected
  if (page.layout.plots_height) panel.style.maxHeight = `min(${page.layout.plots_height}px, 60vh)`;

  function readOn() {
    const begun = performance.now();
    while (part >= 0 && part < 1 && performance.now() - begun < kReadMs) part = page.calls.readPlots(kMessages);
    isReading = part >= 0 && part < 1 && !panel.hidden;
    if (performance.now() - shownAt > kShowMs || !isReading) show();
    if (isReading) setTimeout(readOn, 0);
    else page.ask();  // the values of this moment, beside the curves
  }

  function makeLane(lane, width) {
    const box = document.getElementById("lane").content.firstElementChild.cloneNode(true);
    const one = (name) => box.querySelector("." + name);
    one("joint").textContent = lane.name;
    one("range").textContent = lane.text || "not stated";
    const svg = one("curves");
    svg.setAttribute("viewBox", `0 0 ${width} ${kHeight}`);
    one("curve").setAttribute("d", lane.curve);
    one("bars").setAttribute("d", lane.bars);
    for (const name of ["lower", "upper"]) {
      const at = lane[name];
      if (at === null) { one(name).remove(); continue; }
      for (const [key, value] of [["x1", 0], ["x2", width], ["y1", at], ["y2", at]]) one(name).setAttribute(key, value);
    }
    return {box, svg, name: lane.name, unit: lane.unit, value: one("value"), cursor: one("cursor")};
  }

  function show() {
    if (panel.hidden) return;
    const device = page.selectedDevice();
    const width = Math.max(50, Math.round(panel.clientWidth - 16));
    const wanted = JSON.stringify([device, width, part]);
    if (wanted === drawn) return;
    drawn = wanted;
    shownAt = performance.now();
    const given = page.calls.plots(device, page.now(), width, kHeight);
    lanes = (given.lanes || []).map((lane) => makeLane(lane, width));
    document.getElementById("lanes").replaceChildren(...lanes.map((lane) => lane.box));
    const whose = (device || (chosen.length ? "plots of the layout, and signals of no device" : "signals of no device")) + (given.more ? `, and ${given.more} more signals without a curve` : "");
    say.textContent = !device && !lanes.length ? "Choose a device: click it in the picture or in the list."
      : part < 0 ? "The log cannot be read on: the curves end there."
      : part < 1 ? `${whose}: reading the log, ${Math.round(100 * part)} %`
      : lanes.length ? whose : device + " has no joints and no signals with numbers";
    moveCursor(page.now(), null, true);
  }

  // `values`: name and text of the values of this moment, or null when they are not at hand. `isListed`: values
  // are shown anew.
  function moveCursor(now, values, isListed) {
    const ofLayout = isListed && chosen.length && !panel.hidden && !page.selectedDevice() ? page.calls.chosen(now) : {};
    const length = Math.max(page.about.end_ns - page.about.start_ns, 1);
    for (const lane of lanes) {
      const x = (now - page.about.start_ns) / length * lane.svg.viewBox.baseVal.width;
      lane.cursor.setAttribute("x1", x);
      lane.cursor.setAttribute("x2", x);
      if (!isListed || !(values || chosen.includes(lane.name))) continue;
      const text = ofLayout[lane.name] || values && values.get(lane.name) || "";
      // A signal in several units has a lane for each: "17.5 kg" is of one of them.
      const isOfLane = lane.unit === undefined || lane.unit === text.replace(/^\S* ?/, "");
      lane.value.textContent = isOfLane ? text : "";
    }
  }

  function scrub(event) {
    const box = document.getElementById("lanes").getBoundingClientRect();
    const x = (event.clientX - box.left) / Math.max(box.width, 1);
    page.seek(page.about.start_ns + x * (page.about.end_ns - page.about.start_ns));
  }
  const area = document.getElementById("lanes");
  area.addEventListener("pointerdown", (event) => { area.setPointerCapture(event.pointerId); scrub(event); });
  area.addEventListener("pointermove", (event) => { if (event.buttons & 1) scrub(event); });
  area.addEventListener("pointerup", () => page.setLink());

  return {
    show,
    moveCursor,
    toggle() {
      panel.hidden = !panel.hidden;
      document.getElementById("curves").setAttribute("aria-pressed", String(!panel.hidden));
      if (!panel.hidden && !page.selectedDevice() && !chosen.length) page.selectFirst();
      drawn = "";
      if (!isReading) readOn();
      page.ask();
    },
    part: () => part,
    // Whether the layout has them shown.
    begins: () => chosen.length > 0 && !page.layout.plots_hidden,
  };
}
