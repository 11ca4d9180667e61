// The pictures of one case in one of five views.
const kModes = [
  { name: "side", title: "Side by side" },
  { name: "slider", title: "Slider" },
  { name: "flicker", title: "Flicker" },
  { name: "difference", title: "Difference" },
  { name: "heat", title: "Heat map" },
];

class Stage {
  static flicker_ms = 600; // below three flashes a second

  constructor(store, told) {
    this.store = store;
    this.told = told; // (text, row): called with the pixel below the pointer
    this.element = find("stage");
    this.transform = new ViewTransform();
    this.mode = "side";
    this.divider = 0.5;
    this.flick = false;
    this.panes = [];
    this.shown = null;
    this.calm = matchMedia("(prefers-reduced-motion: reduce)");
    this.paused = this.calm.matches;
    const resized = new ResizeObserver(() => this.draw());
    resized.observe(this.element);
    resized.observe(find("case"));
    addEventListener("resize", () => this.draw());
    setInterval(() => {
      if (this.mode === "flicker" && !this.paused && !document.hidden) this.swap();
    }, Stage.flicker_ms);
    this.listen();
  }

  get can_compare() {
    const shown = this.shown;
    return shown?.golden && shown?.frame && shown.golden.width === shown.frame.width &&
      shown.golden.height === shown.frame.height;
  }

  async show(frame) {
    const call = this.call = Symbol("only the last call counts");
    const ids = frame.pictures;
    const [golden, drawn, mask, compared, thumbnail] = await Promise.all(
      [ids.golden, ids.frame, ids.mask, ids.compared, ids.thumbnail].map((id) => this.store.get(id)));
    if (this.call !== call) return false;
    // With masks, the compared picture differs from the drawn one.
    this.shown = { frame: drawn, golden, mask, compared: compared ?? drawn, thumbnail };
    this.lit = null;
    this.transform.fitted = true;
    this.arrange();
    return true;
  }

  setMode(mode) {
    this.mode = mode;
    this.arrange();
  }

  effectiveMode() {
    return this.can_compare ? this.mode : "side";
  }

  arrange() {
    const { frame, golden, thumbnail } = this.shown ?? {};
    this.element.replaceChildren();
    this.panes = [];
    const add = (caption, layers) => {
      const pane = new Pane(caption, caption + " of " + (this.name ?? "the case"));
      pane.layers = layers;
      this.panes.push(pane);
      this.element.append(pane.figure);
    };
    const mode = this.effectiveMode();
    if (mode === "side") {
      if (golden) add("golden, as accepted", () => [{ image: golden.image }]);
      if (frame) add("frame, as drawn now", () => [{ image: frame.image }]);
      if (!golden && !frame && thumbnail) add("frame, kept small because it is the same", () => [{ image: thumbnail.image, is_reduced: true }]);
    } else if (mode === "slider") {
      add("golden to the left, frame to the right", () => [
        { image: golden.image, until: this.divider }, { image: frame.image, from: this.divider }]);
    } else if (mode === "flicker") {
      add("golden", () => [{ image: (this.flick ? frame : golden).image }]);
    } else if (mode === "difference") {
      add("difference: from yellow (slight) to red; the rest of the frame in grey",
        () => [{ image: this.differenceOf().image }]);
    } else {
      const heat = this.heatOf();
      add("heat map: mean difference of 16x16 pixels, black 0 to pale yellow " + heat.hottest.toFixed(2),
        () => [{ image: heat.image }]);
    }
    if (this.panes.length === 0) {
      this.element.append(make("p", { className: "nothing", textContent: "No picture of this frame." }));
    }
    find("slider-label").hidden = !this.can_compare || mode === "flicker";
    find("flicker").hidden = mode !== "flicker";
    this.draw();
  }

  differenceOf() {
    const shown = this.shown;
    shown.differences ??= pixelDifferences(shown.compared, shown.golden);
    shown.difference ??= { image: differenceImage(shown.frame, shown.differences) };
    return shown.difference;
  }

  heatOf() {
    const shown = this.shown;
    shown.differences ??= pixelDifferences(shown.compared, shown.golden);
    shown.heat ??= heatImage(shown.frame, shown.differences);
    return shown.heat;
  }

  size() {
    const { frame, golden, thumbnail } = this.shown;
    return frame ?? golden ?? thumbnail;
  }

  // Panes side by side or below one another, whichever shows the pictures larger, and no larger than
  // the pictures then are. On a narrow page only the width limits them.
  layOut(size) {
    const gap = 8, caption = 22, border = 2, least = 160, count = this.panes.length;
    const main = find("case"), scrolls = getComputedStyle(main).overflowY === "auto";
    const width = this.element.clientWidth;
    const height = scrolls ? Math.max(least, main.clientHeight - this.element.offsetTop - 36) : Infinity;
    const beside = Math.min(((width - (count - 1) * gap) / count - border) / size.width, (height - caption - border) / size.height);
    const below = Math.min((width - border) / size.width,
      ((height - (count - 1) * gap) / count - caption - border) / size.height);
    const scale = Math.max(beside, below, 1 / 16);
    this.element.style.gridAutoFlow = below > beside ? "row" : "column";
    for (const { figure, canvas } of this.panes) {
      figure.style.width = Math.floor(size.width * scale) + border + "px";
      canvas.style.height = Math.floor(size.height * scale) + border + "px";
    }
  }

  draw() {
    if (!this.shown || this.panes.length === 0) return;
    const size = this.size();
    this.layOut(size);
    const [first] = this.panes;
    if (this.transform.fitted) this.transform.fit(size.width, size.height, first.width, first.height);
    for (const pane of this.panes) {
      const layers = [...pane.layers(), { image: this.lit?.image }];
      pane.draw(this.transform, layers, this.effectiveMode() === "slider" ? this.divider : null);
    }
    if (this.effectiveMode() === "flicker") {
      first.figure.querySelector("figcaption").textContent = this.flick ? "frame, as drawn now" : "golden, as accepted";
    }
    find("zoom-text").textContent = Math.round(this.transform.scale * 100) + " %";
  }

  // Highlights the pixels of a row of the table; 0 for none.
  light(row) {
    if ((this.lit?.row ?? 0) === row) return;
    this.lit = row && this.shown?.mask ? { row, image: highlightImage(this.shown.mask, row) } : null;
    this.draw();
  }

  swap() {
    this.flick = !this.flick;
    this.draw();
  }

  setPaused(paused) {
    this.paused = paused;
    const button = find("flicker");
    button.setAttribute("aria-pressed", String(paused));
    button.textContent = paused ? "Resume" : "Pause";
  }

  setDivider(part) {
    this.divider = Math.min(1, Math.max(0, part));
    find("slider").value = Math.round(this.divider * 100);
    this.draw();
  }

  zoom(factor, at) {
    if (!this.shown) return;
    this.transform.zoom(factor, at?.x, at?.y);
    this.draw();
  }

  pan(right, down) {
    const size = this.shown && this.size();
    if (!size) return;
    this.transform.pan(right, down, size.width, size.height);
    this.draw();
  }

  fit() {
    this.transform.fitted = true;
    this.draw();
  }

  paneOf(event) {
    return this.panes.find((pane) => pane.canvas === event.target);
  }

  nearDivider(event, pane) {
    return pane && this.effectiveMode() === "slider" &&
      Math.abs(pane.fromMiddle(event).x + pane.width / 2 - this.divider * pane.width) < 10;
  }

  listen() {
    const element = this.element;
    let drag = null;
    element.addEventListener("pointerdown", (event) => {
      const pane = this.paneOf(event);
      if (!pane || event.button !== 0) return;
      drag = { x: event.clientX, y: event.clientY, pane, divides: this.nearDivider(event, pane) };
      pane.canvas.setPointerCapture(event.pointerId);
      element.classList.add("dragging");
    });
    element.addEventListener("pointermove", (event) => {
      const pane = drag?.pane ?? this.paneOf(event);
      element.classList.toggle("divide", Boolean(drag?.divides || this.nearDivider(event, pane)));
      if (drag?.divides) {
        this.setDivider((pane.fromMiddle(event).x + pane.width / 2) / pane.width);
      } else if (drag) {
        this.pan(drag.x - event.clientX, drag.y - event.clientY);
        drag.x = event.clientX;
        drag.y = event.clientY;
      } else if (pane) {
        this.tell(this.transform.pictureAt(...Object.values(pane.fromMiddle(event))));
      }
    });
    const release = () => {
      drag = null;
      element.classList.remove("dragging");
    };
    element.addEventListener("pointerup", release);
    element.addEventListener("pointercancel", release);
    element.addEventListener("pointerleave", () => this.told("", 0));
    element.addEventListener("wheel", (event) => {
      const pane = this.paneOf(event);
      if (!pane) return;
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.002)), pane.fromMiddle(event));
    }, { passive: false });
    element.addEventListener("dblclick", () => this.fit());
  }

  tell({ x, y }) {
    const { frame, golden, mask } = this.shown ?? {};
    const inside = (picture) => picture && x >= 0 && y >= 0 && x < picture.width && y < picture.height;
    const colorIn = (picture) => Array.from(picture.pixels.subarray((y * picture.width + x) * 4).slice(0, 4)).join(" ");
    const parts = [];
    if (inside(golden)) parts.push("golden " + colorIn(golden));
    if (inside(frame)) parts.push("frame " + colorIn(frame));
    if (parts.length === 0) return this.told("", 0);
    const at = inside(mask) ? (y * mask.width + x) * 4 : -1;
    const row = at < 0 ? 0 : mask.pixels[at] || mask.pixels[at + 1] || mask.pixels[at + 2];
    this.told(`(${x}, ${y})  ${parts.join("  ")}`, row);
  }
}
