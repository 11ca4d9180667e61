// Assembles the page.
(() => {
  const report = JSON.parse(find("data").textContent);
  const frames = report.frames;
  const store = new PictureStore();
  let current = -1;

  find("verdict").textContent = report.verdict;
  find("verdict").classList.add(report.verdict);
  find("suite").textContent = report.title;
  find("cause").hidden = !report.cause;
  find("cause").textContent = report.cause;
  // Of what is said, but for frames alone.
  const addCounts = (counts, one, many) => find("counts").append(
    ...Object.entries(counts).filter(([, count]) => count > 0).map(([verdict, count]) => make("li", {},
      make("span", { className: "verdict " + verdict, textContent: grouped(count) }), ` ${verdict}${count === 1 ? one : many}`)));
  addCounts(report.counts, ...(report.runs.length > 0 ? [" frame", " frames"] : ["", ""]));
  addCounts(report.run_counts, " run", " runs");
  pairs(find("environment-list"), report.environment.map((entry) => [entry.name, entry.value, entry.command]));

  if (report.notes.length > 0) {
    find("notes").hidden = false;
    find("notes").firstChild.textContent = report.notes.length === 1 ? "1 note on the suite" : `${report.notes.length} notes on the suite`;
    find("notes").lastChild.append(...report.notes.map((note) => make("li", { textContent: note })));
  }

  const approval = new Approval(frames, report.runs, report.approve_from, (index, on) => {
    if (index >= frames.length) return run_view.mark(index - frames.length, on);
    list?.markPicked(index, on);
    if (index === current) find("select-case").checked = on;
  });
  // Pictures of frames have the room; without any to look at, runs are open.
  const run_view = new RunView(report.runs, store, report.show_first.length === 0,
    report.approve_from && ((run, on) => approval.set([frames.length + run], on)));
  let list = null;
  const runs = report.runs.map((_, index) => frames.length + index);
  find("approval-all").addEventListener("click", () => approval.set([...(list?.visible ?? []), ...runs], true));
  if (frames.length === 0) {
    document.querySelector(".columns").hidden = true;
    document.body.classList.add("only-runs");
    return;
  }

  const stage = new Stage(store, (text, row) => {
    find("readout").textContent = row ? `${text}  ${why.nameOf(row)}` : text;
    why.mark(row || why.pinned);
  });
  const why = new WhyTable(stage);
  const filter = new CaseFilter(frames, refilter);
  list = new CaseList(frames, store, choose);

  const radios = kModes.map(({ name, title }, index) => {
    const radio = make("input", { type: "radio", name: "mode", value: name, checked: index === 0 });
    radio.addEventListener("change", () => setMode(index));
    find("modes").append(make("label", {}, radio, title + " ", make("kbd", { textContent: String(index + 1) })));
    return radio;
  });

  function setMode(index) {
    if (radios[index].disabled) return;
    radios[index].checked = true;
    stage.setMode(kModes[index].name);
  }

  // From any view: what slides is looked at.
  function slide(part) {
    if (!stage.can_compare) return;
    if (stage.mode !== "slider") setMode(kModes.findIndex(({ name }) => name === "slider"));
    stage.setDivider(part);
  }

  async function choose(index) {
    const frame = frames[index];
    if (!frame || index === current) return;
    current = index;
    list.mark(index);
    showCase(frame);
    why.show(frame.why);
    find("readout").textContent = "";
    find("select-label").hidden = !frame.can_approve || !report.approve_from;
    find("select-case").checked = approval.picked.has(index);
    history.replaceState(null, "", "#" + encodeURIComponent(frame.name));
    stage.name = frame.name;
    if (!await stage.show(frame)) return;
    radios.forEach((radio, each) => { radio.disabled = each > 0 && !stage.can_compare; });
    document.body.dataset.shown = frame.name;
  }

  function refilter() {
    list.filter((frame) => filter.passes(frame));
    if (!list.visible.includes(current) && list.visible.length > 0) choose(list.visible[0]);
  }

  const pan = (right, down) => () => stage.pan(right * 40, down * 40);
  const toggleApproval = () => { if (current >= 0) approval.set([current], !approval.picked.has(current)); };
  new Keys([
    { keys: ["j"], what: "next frame", act: () => choose(list.step(current, 1)) },
    { keys: ["k"], what: "previous frame", act: () => choose(list.step(current, -1)) },
    { keys: ["J"], what: "first frame of the next cause", act: () => choose(list.stepCause(current, 1)) },
    { keys: ["K"], what: "first frame of this cause, or of the previous one", act: () => choose(list.stepCause(current, -1)) },
    ...kModes.map(({ title }, index) => ({ keys: [String(index + 1)], what: title.toLowerCase(), act: () => setMode(index) })),
    { keys: ["["], what: "slider: more of the frame", act: () => slide(stage.divider - 0.05) },
    { keys: ["]"], what: "slider: more of the golden", act: () => slide(stage.divider + 0.05) },
    { keys: ["s"], what: "flicker: the other picture", act: () => { stage.setPaused(true); stage.swap(); } },
    { keys: ["p"], what: "flicker: pause or resume", act: () => stage.setPaused(!stage.paused) },
    { keys: ["+", "="], what: "zoom in (also the wheel)", act: () => stage.zoom(2) },
    { keys: ["-"], what: "zoom out", act: () => stage.zoom(0.5) },
    { keys: ["0"], what: "fit (also a double click)", act: () => stage.fit() },
    { keys: ["ArrowLeft"], what: "pan left, when the picture has the focus (also drag)", act: pan(-1, 0) },
    { keys: ["ArrowRight"], what: "pan right", act: pan(1, 0) },
    { keys: ["ArrowUp"], what: "pan up", act: pan(0, -1) },
    { keys: ["ArrowDown"], what: "pan down", act: pan(0, 1) },
    { keys: ["x"], what: "select or deselect the frame for approval", act: toggleApproval },
    { keys: ["/"], what: "find", act: () => find("filter-text").focus() },
    { keys: ["?"], what: "this list", act: () => find("help").showModal() },
  ]);

  find("zoom-in").addEventListener("click", () => stage.zoom(2));
  find("zoom-out").addEventListener("click", () => stage.zoom(0.5));
  find("zoom-fit").addEventListener("click", () => stage.fit());
  find("slider").addEventListener("input", (event) => slide(event.target.value / 100));
  find("flicker").addEventListener("click", () => stage.setPaused(!stage.paused));
  find("open-help").addEventListener("click", () => find("help").showModal());
  find("open-environment").addEventListener("click", () => find("environment").showModal());
  find("select-case").addEventListener("change", (event) => approval.set([current], event.target.checked));
  stage.setPaused(stage.paused);

  filter.showOnly(report.show_first);
  list.filter((frame) => filter.passes(frame));
  const wanted = frames.findIndex((frame) => "#" + encodeURIComponent(frame.name) === location.hash);
  choose(wanted >= 0 ? wanted : list.visible[0] ?? 0);
})();
