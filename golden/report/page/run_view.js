// Runs: sessions compared as motion. Findings as a list, joints as curves: the accepted band and the
// session under test.
class RunView {
  constructor(runs, pictures, is_open, pick) {
    this.pictures = pictures;
    this.is_open = is_open; // of what is not fine
    this.pick = pick; // (number, on): called when a run is chosen for approval
    this.boxes = new Map();
    find("runs").hidden = runs.length === 0;
    find("runs").append(...runs.map((run, number) => this.section(run, number)));
  }

  mark(number, on) {
    this.boxes.get(number).checked = on;
  }

  section(run, number) {
    const head = make("h3", {}, make("span", { className: "verdict " + run.verdict, textContent: run.verdict }),
      " run " + run.name);
    const is_fine = run.verdict === "same" || run.verdict === "expected";
    const section = make("details", { className: "run", open: this.is_open && !is_fine },
      make("summary", {}, head, make("span", { textContent: run.rule })));
    if (run.can_approve && this.pick) {
      const box = make("input", { type: "checkbox" });
      box.addEventListener("change", () => this.pick(number, box.checked));
      this.boxes.set(number, box);
      section.append(make("label", {}, box, " approve"));
    }
    if (run.findings.length > 0) {
      section.append(make("ul", {}, ...run.findings.map((finding) => this.finding(finding, run.page))));
    }
    if (run.pictures) section.append(make("div", { className: "run-pictures" }, ...run.pictures.map((one) => this.picture(one))));
    if (run.changes.length > 0) {
      section.append(make("h4", { textContent: "Changed in the model since" }),
        make("ul", {}, ...run.changes.map((change) => make("li", { textContent: change }))));
    }
    const about = [`log ${run.log}`, `accepted ${run.accepted.join(", ")}`, `aligned by ${run.align}`, ...run.notes];
    section.append(make("p", { className: "soft", textContent: about.join("; ") }));
    return section;
  }

  // The accepted session is its clear ghost.
  picture({ picture, device, run_ns, accepted_ns, left_out }) {
    const at = (ns) => (ns / 1e9).toFixed(3) + " s";
    const hidden = left_out?.length ? `; not shown: ${left_out.join(", ")}` : "";
    const says = `${device} at ${at(run_ns)}; clear: as accepted, at ${at(accepted_ns)}${hidden}`;
    return make("figure", {}, make("img", { src: this.pictures.address(`${picture}`), alt: says, loading: "lazy" }),
      make("figcaption", { textContent: says }));
  }

  // The session's page opens where it begins to differ.
  finding(finding, page) {
    const item = make("li", {}, finding.what);
    if (page) {
      const device = finding.kind === "joint" || finding.kind === "pose" ? finding.item.split("/")[0] : "";
      const link = `${page}#t=${finding.first_run_ns / 1e9}` + (device ? "&select=" + encodeURIComponent(device) : "");
      item.append(" ", make("a", { href: link, textContent: "in the session" }));
    }
    if (finding.curve) item.append(this.curve(finding));
    return item;
  }

  // Gaps where a value is null.
  curve({ item, unit, curve, first_accepted_ns, until_accepted_ns }) {
    const width = 640, height = 160, left = 56, bottom = 20;
    const numbers = [...curve.least, ...curve.most, ...curve.value].filter((number) => number !== null);
    const low = Math.min(...numbers), high = Math.max(...numbers);
    const begin = curve.seconds[0], end = curve.seconds[curve.seconds.length - 1];
    const x = (seconds) => left + (seconds - begin) / (end - begin || 1) * (width - left - 4);
    const y = (number) => 6 + (high - number) / (high - low || 1) * (height - bottom - 6);
    const place = (index, number) => `${x(curve.seconds[index]).toFixed(1)},${y(number).toFixed(1)}`;
    const line = (values, order) => order.filter((index) => values[index] !== null)
      .map((index) => place(index, values[index])).join(" ");
    const forth = curve.seconds.map((_, index) => index), back = [...forth].reverse();
    const svg = (tag, properties, ...children) => {
      const element = document.createElementNS(find("svg").namespaceURI, tag);
      for (const [name, value] of Object.entries(properties)) element.setAttribute(name, value);
      element.append(...children);
      return element;
    };
    const label = (text, at_x, at_y, anchor) => svg("text", { x: at_x, y: at_y, "text-anchor": anchor }, text);
    const from = x(Math.max(begin, first_accepted_ns / 1e9)), until = x(Math.min(end, until_accepted_ns / 1e9));
    return svg("svg", { class: "curve", viewBox: `0 0 ${width} ${height}`, role: "img",
      "aria-label": `${item}: the accepted band and this session over time` },
      svg("rect", { class: "beyond", x: from, y: 6, width: Math.max(1, until - from), height: height - bottom - 6 }),
      svg("polygon", { class: "band", points: `${line(curve.most, forth)} ${line(curve.least, back)}` }),
      svg("polyline", { class: "value", points: line(curve.value, forth) }),
      label(`${high.toFixed(2)} ${unit}`, left - 4, 14, "end"),
      label(`${low.toFixed(2)} ${unit}`, left - 4, height - bottom, "end"),
      label(`${begin.toFixed(1)} s`, left, height - 5, "start"),
      label(`${end.toFixed(1)} s`, width - 4, height - 5, "end"));
  }
}
