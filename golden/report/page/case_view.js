// The figures, facts and commands of one case.
function pairs(list, entries) {
  const nodes = [];
  for (const [name, value, isCommand] of entries) {
    if (value === undefined || value === null || value === "") continue;
    const text = value instanceof Node ? value : make(isCommand ? "code" : "span", { textContent: value });
    const content = make("dd", { className: isCommand ? "command" : "" }, text);
    if (isCommand) {
      const button = make("button", { type: "button", textContent: "Copy", "aria-label": "Copy: " + name });
      button.addEventListener("click", () => copyText(value, button));
      content.append(button);
    }
    nodes.push(make("dt", { textContent: name }), content);
  }
  list.replaceChildren(...nodes);
}

function figuresText(figures) {
  if (!figures) return "";
  const over = figures.over;
  return `${grouped(figures.differing)} differing ${figures.differing === 1 ? "pixel" : "pixels"}; over 1/2/8/32: ${over.map(grouped).join("/")}; ` +
    `largest ${figures.max} at (${figures.x}, ${figures.y}); worst tile: mean ${figures.tile_mean.toFixed(2)}, ` +
    `${figures.tile_over} ${figures.tile_over === 1 ? "pixel" : "pixels"} over 32`;
}

function showCase(frame) {
  find("case-name").textContent = frame.name;
  find("case-verdict").textContent = frame.verdict;
  find("case-verdict").className = "verdict " + frame.verdict;
  find("case-cause").hidden = !frame.cause || frame.cause === find("cause").textContent;
  find("case-cause").textContent = frame.cause ?? "";
  find("case-rule").textContent = frame.rule;
  pairs(find("facts-list"), [
    ["figures", figuresText(frame.figures)],
    ["tolerance", frame.tolerance],
    ...frame.facts,
    ["moment", frame.page ? make("a", { href: frame.page, textContent: frame.moment + ", in a page of the session" }) : frame.moment], ["camera", frame.camera], ["tags", frame.tags.join(", ")],
    ["key", frame.key], ["pixels", frame.pixels], ["inputs", frame.inputs],
    ["run again", frame.run, true],
    ["approve", frame.can_approve ? frame.approve : "", true],
  ]);
}
