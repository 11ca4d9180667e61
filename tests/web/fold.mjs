// The fold of a whole log in a page: JSON as tests/bench/page_fold.cpp prints it.
// usage: node fold.mjs PAGE.html LOG.mcap TIMES
import fs from "node:fs";
import { openBrowser, shown } from "./browser.mjs";

const [, , path, log, times] = process.argv;
const { browser, open } = await openBrowser({ width: 960, height: 640 });
const { page } = await open(path);
await shown(page);
await page.waitForFunction(() => window.rocinante.isAtRest(), null, { timeout: 120000 });
await page.evaluate(() => document.body.append(Object.assign(document.createElement("input"), { type: "file", id: "log" })));
await page.locator("#log").setInputFiles(log);
const answer = await page.evaluate(async (times) => {
  const bytes = new Uint8Array(await document.querySelector("#log").files[0].arrayBuffer());
  let shortest = Infinity, whole;
  for (let i = 0; i < times; ++i) {
    const begun = performance.now();
    whole = window.rocinante.calls.fold(bytes);
    shortest = Math.min(shortest, performance.now() - begun);
  }
  return { ms: shortest, ...whole };
}, Number(times));
console.log(JSON.stringify(answer));
await browser.close();
