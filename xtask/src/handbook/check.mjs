// Examines the handbook for `cargo xtask handbook --check`. The request is JSON on standard input, what was found is printed
// as JSON. `search SEARCH INDEX`: ids of the first three analyses of each query. `widths`: pages that are wider than the
// window of a headless Chromium, which is spoken to through a pipe.
import { readFileSync, mkdtempSync, rmSync } from "node:fs";
import { spawn } from "node:child_process";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [task, ...files] = process.argv.slice(1).filter((argument) => argument !== "--");
const request = JSON.parse(readFileSync(0, "utf8"));

function search([script, index]) {
  const texts = [script, index].map((file) => readFileSync(file, "utf8"));
  const { find, SEARCH_INDEX } = new Function(`${texts.join("\n")}; return { find, SEARCH_INDEX };`)();
  return request.map((words) => find(SEARCH_INDEX, words).slice(0, 3).map(({ id }) => id));
}

/** A browser, and a function that calls its methods. */
function started(browser, profile) {
  const options = ["--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", `--user-data-dir=${profile}`];
  const process = spawn(browser, options, { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
  const [, , , requests, replies] = process.stdio;
  const waiting = new Map();
  const listeners = [];
  let text = "", count = 0;
  replies.setEncoding("utf8");
  replies.on("data", (more) => {
    text += more;
    for (let end = text.indexOf("\0"); end >= 0; end = text.indexOf("\0")) {
      const message = JSON.parse(text.slice(0, end));
      text = text.slice(end + 1);
      waiting.get(message.id)?.(message);
      waiting.delete(message.id);
      listeners.forEach((listener) => listener(message));
    }
  });
  const call = (method, params = {}, sessionId = undefined) => new Promise((done, failed) => {
    const id = (count += 1);
    waiting.set(id, ({ result, error }) => (error ? failed(new Error(`${method}: ${error.message}`)) : done(result)));
    requests.write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
  });
  const event = (name, sessionId) => new Promise((done) => {
    const listener = (message) => {
      if (message.method !== name || message.sessionId !== sessionId) return;
      listeners.splice(listeners.indexOf(listener), 1);
      done(message.params);
    };
    listeners.push(listener);
  });
  return { process, call, event };
}

/** A tab that measures pages. */
async function tab({ call, event }) {
  const { targetId } = await call("Target.createTarget", { url: "about:blank" });
  const { sessionId } = await call("Target.attachToTarget", { targetId, flatten: true });
  const ask = (method, params) => call(method, params, sessionId);
  await ask("Page.enable");
  return async (page, widths) => {
    const loaded = event("Page.loadEventFired", sessionId);
    await ask("Page.navigate", { url: pathToFileURL(page).href });
    await loaded;
    const wide = [];
    for (const width of widths) {
      const view = { width, height: 800, deviceScaleFactor: 1, mobile: false };
      await ask("Emulation.setDeviceMetricsOverride", view);
      const { result } = await ask("Runtime.evaluate", { expression: "document.documentElement.scrollWidth" });
      if (result.value > width) wide.push({ page, at: width, is: result.value });
    }
    return wide;
  };
}

async function widths({ browser, pages, widths }) {
  const profile = mkdtempSync(join(tmpdir(), "handbook-"));
  const running = started(browser, profile);
  const waiting = [...pages];
  const wide = [];
  let measured = 0;
  const work = async () => {
    const measure = await tab(running);
    for (let page = waiting.shift(); page !== undefined; page = waiting.shift()) {
      wide.push(...(await measure(page, widths)));
      measured += 1;
    }
  };
  await Promise.all([work(), work()]);
  const ended = new Promise((done) => running.process.on("exit", done));
  running.call("Browser.close").catch(() => {});
  await ended;
  rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  return { measured, wide };
}

const found = task === "search" ? search(files) : await widths(request);
process.stdout.write(JSON.stringify(found));
