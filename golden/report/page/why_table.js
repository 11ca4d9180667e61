// What changed: differing pixels by link, joints of the two sessions, files of the model.
class WhyTable {
  constructor(stage) {
    this.stage = stage;
    this.body = find("why-links").tBodies[0];
    this.pinned = 0;
  }

  show(why) {
    this.pinned = 0;
    find("why").hidden = !why;
    find("case").classList.toggle("explained", Boolean(why));
    if (!why) return this.body.replaceChildren();
    find("why-basis").textContent = why.basis;
    this.body.replaceChildren(...why.rows.map((row) => this.rowOf(row)));
    find("why-pixels").textContent = "Pixels, of " + grouped(why.differing);
    find("why-links").hidden = why.rows.length === 0;
    this.list("why-state", why.state);
    this.list("why-files", why.files);
  }

  list(id, lines) {
    find(id).hidden = lines.length === 0;
    find(id).querySelector("ul").replaceChildren(...lines.map((line) => make("li", { textContent: line })));
  }

  rowOf(row) {
    const button = make("button", { type: "button", textContent: row.name, "aria-pressed": "false",
      title: "Show its pixels: cyan where it is, magenta where it was, yellow where it differs" });
    const line = make("tr", {}, make("td", {}, button),
      make("td", { textContent: grouped(row.pixels) }),
      make("td", { textContent: row.what }));
    line.dataset.row = row.row;
    const light = (number) => this.light(number || this.pinned);
    line.addEventListener("pointerenter", () => light(row.row));
    line.addEventListener("pointerleave", () => light(0));
    button.addEventListener("focus", () => light(row.row));
    button.addEventListener("blur", () => light(0));
    button.addEventListener("click", () => this.pin(this.pinned === row.row ? 0 : row.row));
    return line;
  }

  pin(row) {
    this.pinned = row;
    for (const line of this.body.rows) {
      line.querySelector("button").setAttribute("aria-pressed", String(Number(line.dataset.row) === row));
    }
    this.light(row);
  }

  light(row) {
    this.mark(row);
    this.stage.light(row);
  }

  // Marks the row of the pixel below the pointer; the pictures do not change.
  mark(row) {
    for (const line of this.body.rows) line.classList.toggle("lit", Number(line.dataset.row) === row);
  }

  nameOf(row) {
    const line = [...this.body.rows].find((each) => Number(each.dataset.row) === row);
    return line?.querySelector("button").textContent ?? "";
  }
}
