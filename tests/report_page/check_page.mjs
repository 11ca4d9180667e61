// Every control of a report whose frames are: first and second (different), third (same).
// usage: node check_page.mjs REPORT/index.html FOLDER_FOR_SCREENSHOTS
import assert from "node:assert/strict";
import { openReport } from "./browser.mjs";

const [, , report, pictures] = process.argv;
const { browser, page, complaints } = await openReport(report, { reducedMotion: "no-preference" });
const text = (selector) => page.locator(selector).innerText();
const canvasHash = () => page.evaluate(() => document.querySelector("#stage canvas").toDataURL());
const shown = (name) => page.waitForFunction((wanted) => document.body.dataset.shown === wanted, name);
let checks = 0;
async function check(what, body) {
  await body();
  ++checks;
  console.log("ok: " + what);
}

await check("the first frame that needs a person is shown", async () => {
  assert.equal(await text("#case-name"), "first");
  assert.equal(await text("#verdict"), "different");
  assert.equal(await text("#shown"), "2 of 3 frames shown");
  assert.match(await text("#counts"), /2 different/);
});
await check("the page opens with the cause, and so does the list of its frames", async () => {
  const cause = await text("#cause");
  assert.match(cause, /^in .*frame.*: joint|^in .*frame.*: link|^in .*frame.*: box/);
  assert.equal(await text("#cases .cause"), cause);
});
await check("pictures are as large as the window allows", async () => {
  const wide = await page.evaluate(() => {
    const stage = document.getElementById("stage").clientWidth;
    const panes = [...document.querySelectorAll("#stage canvas")].map((each) => each.clientWidth);
    const main = document.getElementById("case");
    const below = main.clientHeight - document.getElementById("stage").offsetTop;
    const high = document.querySelector("#stage canvas").clientHeight;
    return { width: panes.reduce((a, b) => a + b) / stage, height: high / below };
  });
  assert.ok(Math.max(wide.width, wide.height) > 0.85, JSON.stringify(wide));
});
await check("verdicts, words and tags filter", async () => {
  await page.getByLabel("same", { exact: true }).check();
  assert.equal(await text("#shown"), "3 of 3 frames shown");
  await page.keyboard.press("Escape");
  await page.locator("#case").focus();
  await page.keyboard.press("/");
  await page.keyboard.type("second");
  assert.equal(await text("#shown"), "1 of 3 frames shown");
  await shown("second");
  await page.keyboard.press("Escape");
  await page.locator("#filter-text").fill("");
  await page.getByLabel("Tag").selectOption("quick");
  assert.equal(await text("#shown"), "1 of 3 frames shown");
  await shown("first");
  await page.getByLabel("Tag").selectOption("");
  await page.getByLabel("same", { exact: true }).uncheck();
  await page.locator("#case").focus();
});
await check("notes on the suite are told", async () => {
  await page.locator("#notes summary").click();
  assert.match(await text("#notes"), /mask 500,500,1x1 of case third hides nothing/);
  await page.locator("#notes summary").click();
  await page.locator("#case").focus();
});
await check("what a mask hides is no difference", async () => {
  await page.keyboard.press("j");
  await shown("second");
  await page.keyboard.press("4");
  // How many coloured pixels the difference has in each half.
  const [left, right] = await page.evaluate(() => {
    const canvas = document.querySelector("#stage canvas");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    const halves = [0, 0];
    for (let p = 0; p < data.length; p += 4) {
      if (data[p] === 255 && data[p + 2] < 60) ++halves[(p / 4) % canvas.width < canvas.width / 2 ? 0 : 1];
    }
    return halves;
  });
  assert.equal(left, 0);
  assert.ok(right > 100, "the other half differs");
  assert.match(await text("#facts-list"), /masked\s+0,0,80x120: 9600 pixels/);
  await page.keyboard.press("1");
  await page.keyboard.press("k");
  await shown("first");
});
await check("j and k go from frame to frame", async () => {
  await page.keyboard.press("j");
  await shown("second");
  await page.keyboard.press("j");  // the last one that is shown
  assert.equal(await text("#case-name"), "second");
  await page.keyboard.press("k");
  await shown("first");
});
await check("five views, by key and by click", async () => {
  const seen = new Set();
  for (const [key, panes] of [["1", 2], ["2", 1], ["3", 1], ["4", 1], ["5", 1]]) {
    await page.keyboard.press(key);
    if (key === "3") await page.keyboard.press("p");
    assert.equal(await page.locator("#stage canvas").count(), panes, "panes of view " + key);
    assert.equal(await page.locator("#modes input").nth(Number(key) - 1).isChecked(), true);
    seen.add(await canvasHash());
  }
  assert.ok(seen.size >= 4, "views look alike");
  await page.locator("#modes label", { hasText: "Difference" }).click();
  assert.equal(await page.locator("#modes input").nth(3).isChecked(), true);
});
await check("the slider goes by range and by dragging", async () => {
  await page.keyboard.press("2");
  const before = await canvasHash();
  await page.locator("#slider").fill("10");
  assert.notEqual(await canvasHash(), before);
  const box = await page.locator("#stage canvas").boundingBox();
  await page.mouse.move(box.x + box.width * 0.1, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.8, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  assert.ok(Number(await page.locator("#slider").inputValue()) > 70);
});
await check("the slider's controls can be reached at every width", async () => {
  const usual = page.viewportSize();
  for (const width of [1024, 1280, 1920]) {
    await page.setViewportSize({ width, height: 800 });
    await page.keyboard.press("2");
    const covered = await page.evaluate(() => ["slider", "zoom-in", "zoom-fit"].filter((id) => {
      const box = document.getElementById(id).getBoundingClientRect();
      return document.elementFromPoint((box.left + box.right) / 2, (box.top + box.bottom) / 2)?.id !== id;
    }));
    assert.deepEqual(covered, [], "covered at " + width);
    assert.ok(await page.evaluate(() => document.documentElement.scrollHeight <= innerHeight), "two scroll bars at " + width);
  }
  await page.setViewportSize(usual);
});
await check("at 1280x800 the cause, both pictures and the slider are seen without scrolling", async () => {
  const usual = page.viewportSize();
  await page.setViewportSize({ width: 1280, height: 800 });
  for (const key of ["1", "2"]) {
    await page.keyboard.press(key);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const { outside, used } = await page.evaluate(() => {
      const footer = document.getElementById("approval").getBoundingClientRect().top;
      const shown = [...document.querySelectorAll("#cause, #cases .cause, #slider, #stage canvas")];
      const stage = document.getElementById("stage"), canvases = [...stage.querySelectorAll("canvas")];
      const below = footer - stage.getBoundingClientRect().top;
      return {
        outside: shown.filter((each) => {
          const box = each.getBoundingClientRect();
          return box.height === 0 || box.top < 0 || box.bottom > footer || box.left < 0 || box.right > innerWidth;
        }).map((each) => each.id || each.tagName),
        used: Math.max(canvases.reduce((sum, each) => sum + each.clientWidth, 0) / stage.clientWidth, canvases[0].clientHeight / below),
      };
    });
    assert.deepEqual(outside, [], "not seen in view " + key);
    assert.ok(used > 0.85, `view ${key} uses ${used} of the room`);
  }
  await page.setViewportSize(usual);
});
await check("the slider is in every view that compares, and leads to its own", async () => {
  await page.keyboard.press("1");
  await page.keyboard.press("[");
  assert.equal(await page.locator("#modes input").nth(1).isChecked(), true);
  const before = Number(await page.locator("#slider").inputValue());
  await page.keyboard.press("]");
  assert.equal(Number(await page.locator("#slider").inputValue()), before + 5);
  await page.keyboard.press("4");
  await page.locator("#slider").fill("30");
  assert.equal(await page.locator("#modes input").nth(1).isChecked(), true);
});
await check("J and K go from cause to cause", async () => {
  await page.locator("#case").focus();
  await page.getByLabel("same", { exact: true }).check();
  await page.keyboard.press("J");
  await shown("third");
  await page.keyboard.press("K");
  await shown("first");
  await page.getByLabel("same", { exact: true }).uncheck();
  await page.locator("#case").focus();
});
await check("flicker swaps by itself, by key, and pauses", async () => {
  await page.locator("#case").focus();
  await page.keyboard.press("3");
  await page.keyboard.press("p");
  const before = await text("#stage figcaption");
  await page.waitForFunction((was) => document.querySelector("#stage figcaption").innerText !== was, before);
  await page.getByRole("button", { name: "Pause" }).click();
  const paused = await text("#stage figcaption");
  await page.waitForTimeout(1500);
  assert.equal(await text("#stage figcaption"), paused);
  await page.keyboard.press("s");
  assert.notEqual(await text("#stage figcaption"), paused);
});
await check("zoom and pan, in step, by key, wheel and drag", async () => {
  await page.keyboard.press("1");
  await page.keyboard.press("+");
  const zoomed = await text("#zoom-text");
  const hashes = () => page.evaluate(() => [...document.querySelectorAll("#stage canvas")].map((each) => each.toDataURL()));
  const [golden, frame] = await hashes();
  await page.locator("#stage").focus();
  await page.keyboard.press("ArrowRight");
  const moved = await hashes();
  assert.ok(moved[0] !== golden && moved[1] !== frame, "both panes move");
  const box = await page.locator("#stage canvas").first().boundingBox();
  await page.mouse.move(box.x + 100, box.y + 100);
  await page.mouse.wheel(0, -300);
  await page.waitForFunction((was) => document.querySelector("#zoom-text").innerText !== was, zoomed);
  await page.mouse.down();
  await page.mouse.move(box.x + 60, box.y + 80);
  await page.mouse.up();
  await page.getByRole("button", { name: "Zoom out" }).click();
  await page.getByRole("button", { name: "Zoom in" }).click();
  await page.getByRole("button", { name: "Fit" }).click();
  await page.locator("#stage canvas").first().dblclick();
});
await check("a link lights up in the picture, and the picture in the table", async () => {
  const row = page.locator("#why-links tbody tr").first();
  assert.match(await row.innerText(), /box\/body/);
  const before = await canvasHash();
  await row.hover();
  assert.notEqual(await canvasHash(), before);
  await row.locator("button").click();
  await page.locator("h1").hover();
  assert.notEqual(await canvasHash(), before, "pinned");
  await row.locator("button").click();
  await page.locator("#case-rule").hover();
  const box = await page.locator("#stage canvas").last().boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  assert.match(await text("#readout"), /golden \d+ \d+ \d+ 255 +frame .*box\/body/);
  assert.equal(await page.locator("#why-links tr.lit").count(), 1);
});
await check("frames are chosen for approval, and the list is copied", async () => {
  await page.keyboard.press("x");
  assert.equal(await text("#approval-count"), "1 frame to approve");
  await page.getByRole("button", { name: "Select all shown" }).click();
  const list = await page.locator("#approval-text").inputValue();
  assert.match(list, /^first\t[0-9a-f]{32}\nsecond\t[0-9a-f]{32}\n$/);
  await page.getByRole("button", { name: "Copy the list" }).click();
  await page.getByText("Copied").waitFor();
  await page.getByRole("button", { name: "Clear" }).click();
  assert.equal(await text("#approval-count"), "0 frames to approve");
  await page.locator("#select-case").check();
  assert.equal(await text("#approval-count"), "1 frame to approve");
});
await check("help and environment open and close", async () => {
  await page.keyboard.press("?");
  assert.match(await text("#help"), /heat map/);
  await page.keyboard.press("j");  // not while it is open
  await page.keyboard.press("Escape");
  assert.equal(await text("#case-name"), "first");
  await page.getByRole("button", { name: "Environment" }).click();
  assert.match(await text("#environment"), /llvmpipe/);
  await page.getByRole("button", { name: "Close" }).click();
});
await check("commands are told for this frame alone", async () => {
  assert.match(await text("#facts-list"), /rocinante golden run .* --only first/);
  assert.match(await text("#facts-list"), /rocinante golden approve .* -m 'WHY' --only first/);
});
await check("the frame's name is in the address", async () => {
  assert.ok(page.url().endsWith("#first"));
});
await check("every control has a name, and every picture a description", async () => {
  const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, select, textarea, canvas")]
    .filter((each) => !(each.labels?.length || each.innerText || each.getAttribute("aria-label"))).map((each) => each.outerHTML));
  assert.deepEqual(nameless, []);
  for (const landmark of ["banner", "navigation", "main", "search"]) {
    assert.ok(await page.getByRole(landmark).count() >= 1, landmark);
  }
});
await page.screenshot({ path: pictures + "/light.png" });
await browser.close();

// Text against what lies behind it, as WCAG measures contrast; 4.5 is its bar.
for (const colorScheme of ["light", "dark"]) {
  await check("contrast, " + colorScheme, async () => {
    const other = await openReport(report, { colorScheme, reducedMotion: "reduce" });
    const low = await other.page.evaluate(() => {
      const channels = (color) => color.match(/[\d.]+/g).map(Number);
      const light = (color) => channels(color).slice(0, 3).map((value) => value / 255)
        .map((value) => value <= 0.03928 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4)
        .reduce((sum, value, i) => sum + value * [0.2126, 0.7152, 0.0722][i], 0);
      const behind = (element) => {
        for (let each = element; each; each = each.parentElement) {
          const color = getComputedStyle(each).backgroundColor;
          if (channels(color)[3] !== 0) return color;
        }
        return "rgb(255, 255, 255)";
      };
      return [...document.querySelectorAll("body *")].filter((each) => each.checkVisibility() &&
        !each.disabled && [...each.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim()))
        .map((each) => {
          const [a, b] = [light(getComputedStyle(each).color), light(behind(each))].sort((x, y) => y - x);
          return { text: each.textContent.trim().slice(0, 40), ratio: (a + 0.05) / (b + 0.05) };
        }).filter((each) => each.ratio < 4.5);
    });
    assert.deepEqual(low, []);
    await other.page.keyboard.press("3");
    assert.equal(await other.page.locator("#flicker").innerText(), "Resume", "flicker waits where motion is unwanted");
    await other.page.screenshot({ path: `${pictures}/${colorScheme}_calm.png` });
    complaints.push(...other.complaints);
    await other.browser.close();
  });
}
assert.deepEqual(complaints, []);
console.log(`${checks} checks, no complaints`);
