"use strict";
// Beside the picture: the devices with their joints and signals, and the list of findings and events.
function rocinantePanels(page) {
  const element = (id) => document.getElementById(id);
  const made = (tag, name, text) => {
    const it = document.createElement(tag);
    if (name) it.className = name;
    if (text !== undefined) it.textContent = text;
    return it;
  };

  function signalRows(device) {
    const rows = [];
    for (const signal of device.signals || []) {
      rows.push(made("dt", "signal", signal.name), made("dd", "signal " + signal.kind, signal.text));
      rows[rows.length - 2].title = `${signal.series}, a ${signal.kind} stated by ${signal.owner}`;
      rows[rows.length - 1].title = signal.text;
    }
    if (device.unlisted) rows.push(made("dt", "signal", `and ${device.unlisted} more signals`), made("dd"));
    return rows;
  }

  // The last may have no name: the signals of no device.
  function deviceBox(device) {
    if (device.more) return made("p", "", `and ${device.more} more devices that are not in the cell`);
    const box = made("section");
    box.classList.toggle("away", !device.visible);
    const isSelected = device.name === page.selectedDevice();
    const title = made("h2", isSelected && device.name ? "selected" : "", device.name || "Signals of no device");
    title.onclick = () => page.select(isSelected ? "" : device.name, "");
    const list = made("dl");
    if (device.link) {
      list.append(made("dt", "link", device.link.name));
      list.append(made("dd", "link", device.link.text));
    }
    for (const joint of device.joints) {
      list.append(made("dt", "", joint.name), made("dd", joint.outside ? "outside" : "", joint.text));
    }
    list.append(...signalRows(device));
    box.append(title, list);
    return box;
  }

  // Returns the selected device's values by joint and `signal PATH NAME`, or null.
  function showDevices() {
    if (element("devices").hidden && element("plots").hidden) return null;
    const devices = page.calls.devices(page.now());
    if (devices.error) return null;
    if (!element("devices").hidden) element("devices").replaceChildren(...devices.map(deviceBox));
    const selected = devices.find((device) => device.name === page.selectedDevice());
    return selected ? new Map([...selected.joints.map((joint) => [joint.name, joint.text]),
      ...(selected.signals || []).map((signal) => [signal.series, signal.text])]) : null;
  }

  const secondsText = (ns) => (ns / 1e9).toFixed(3) + " s";

  function findingRow(finding) {
    const row = made("button", "row " + finding.severity);
    row.type = "button";
    row.append(made("span", "when", finding.first_ns === undefined ? "" : secondsText(finding.first_ns)));
    row.append(made("span", "what", finding.text + (finding.count > 1 ? ` (${finding.count} times)` : "")));
    row.title = [finding.rule, finding.hint].filter(Boolean).join(": ");
    row.onclick = () => {
      if (finding.subject && page.hasDevice(finding.subject)) page.select(finding.subject, "");
      if (finding.first_ns !== undefined) page.seek(finding.first_ns);
      page.setLink();
    };
    return row;
  }
  function eventRow(event) {
    const row = made("button", "row event");
    row.type = "button";
    row.append(made("span", "when", secondsText(event.ns)), made("span", "what", event.text));
    row.onclick = () => { page.seek(event.ns); page.setLink(); };
    return row;
  }

  function mark(name, from, until, title) {
    const length = Math.max(page.about.end_ns - page.about.start_ns, 1);
    const it = made("i", name);
    it.style.left = 100 * (from - page.about.start_ns) / length + "%";
    if (until > from) it.style.width = `max(2px, ${100 * (until - from) / length}%)`;
    it.title = title;
    return it;
  }

  const kMost = 2000;  // rows and marks of each kind
  // Findings are of the whole session, and so are events: once is enough. `given` is null where
  // nobody has looked for findings.
  function showList(given, events) {
    const rows = [];
    const findings = given || [];
    const heading = (text) => rows.push(made("h2", "", text));
    if (given) heading(findings.length ? `Findings of check: ${findings.length}` : "Findings of check: none");
    rows.push(...findings.slice(0, kMost).map(findingRow));
    heading(`Events: ${events.length}`);
    rows.push(...events.slice(0, kMost).map(eventRow));
    const leftOut = element("list").dataset.leftOut;
    if (leftOut) { heading("Left out"); rows.push(made("p", "", leftOut)); }
    element("list").replaceChildren(...rows);
    element("lists").textContent = findings.length ? `Findings (${findings.length})` : "Events";
    const timed = findings.filter((finding) => finding.first_ns !== undefined).slice(0, kMost);
    element("marks").replaceChildren(
      ...events.slice(0, kMost).map((event) => mark("event", event.ns, event.ns, event.text)),
      ...timed.map((finding) => mark(finding.severity, finding.first_ns, finding.last_ns, finding.text)));
  }

  function toggle(panel, button) {
    element(panel).hidden = !element(panel).hidden;
    element(button).setAttribute("aria-pressed", String(!element(panel).hidden));
    page.ask();
  }

  return {showDevices, showList, toggle};
}
