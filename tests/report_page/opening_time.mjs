// How long a report takes to open: from asking for it to its first frame shown; the best of five.
// usage: node opening_time.mjs REPORT/index.html
import { openPage } from "./browser.mjs";

const times = [];
for (let turn = 0; turn < 5; ++turn) {
  const { browser, page, complaints } = await openPage();
  const started = performance.now();
  await page.goto("file://" + process.argv[2]);
  await page.waitForFunction(() => document.body.dataset.shown);
  times.push(performance.now() - started);
  if (complaints.length > 0) throw new Error(complaints[0]);
  await browser.close();
}
times.sort((a, b) => a - b);
console.log(`opens in ${Math.round(times[0])} ms at best, ${Math.round(times[2])} ms in the middle of five (bar: 1500 ms)`);
