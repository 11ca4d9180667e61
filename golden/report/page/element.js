// Finding and making elements. Text is never parsed as HTML: names of cases are untrusted.
const find = (id) => document.getElementById(id);

function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.includes("-") || name === "role" || name === "scope") element.setAttribute(name, value);
    else element[name] = value;
  }
  element.append(...children);
  return element;
}

const grouped = (number) => String(number).replace(/\B(?=(\d{3})+$)/g, ",");

// A page opened from a file may not use the clipboard: then copy from a selected field.
async function copyText(text, button) {
  let done = true;
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const field = make("textarea", { value: text, readOnly: true });
    document.body.append(field);
    field.select();
    done = document.execCommand("copy");
    field.remove();
    button.focus();
  }
  const before = button.dataset.says ?? button.textContent;
  button.dataset.says = before;
  button.textContent = done ? "Copied" : "Not copied: select and copy it by hand";
  clearTimeout(button.timer);
  button.timer = setTimeout(() => { button.textContent = before; }, 1500);
}
