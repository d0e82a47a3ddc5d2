// Examines the handbook for `cargo xtask handbook --check`. The request is JSON on standard input, what was found is printed
// as JSON. `search SEARCH INDEX`: ids of the first three analyses of each query. `widths`: pages that are wider than the
// window of a headless Chromium, which is spoken to through a pipe. `solver`: problem files solved by the page and by the
// program, compared, and errors as a page shows them.
import { readFileSync, mkdtempSync, rmSync } from "node:fs";
import { createInterface } from "node:readline";
import { brotliCompressSync, gzipSync } from "node:zlib";
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

/** A tab: what opens a page in it, and what is asked of it. */
async function tab({ call, event }) {
  const { targetId } = await call("Target.createTarget", { url: "about:blank" });
  const { sessionId } = await call("Target.attachToTarget", { targetId, flatten: true });
  const ask = (method, params) => call(method, params, sessionId);
  await ask("Page.enable");
  const open = async (page) => {
    const loaded = event("Page.loadEventFired", sessionId);
    await ask("Page.navigate", { url: pathToFileURL(page).href });
    await loaded;
  };
  /** Value of an expression in the page, of its promise where it is one. */
  const value = async (expression) => {
    const params = { expression, awaitPromise: true, returnByValue: true };
    const { result, exceptionDetails } = await ask("Runtime.evaluate", params);
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  };
  const sized = (width) =>
    ask("Emulation.setDeviceMetricsOverride", { width, height: 800, deviceScaleFactor: 1, mobile: false });
  return { open, value, sized, ask };
}

/** Does something with a browser, which is ended then. */
async function browsing(browser, act) {
  const profile = mkdtempSync(join(tmpdir(), "handbook-"));
  const running = started(browser, profile);
  try {
    return await act(running);
  } finally {
    const ended = new Promise((done) => running.process.on("exit", done));
    running.call("Browser.close").catch(() => {});
    await ended;
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

/** Takes each item in one of two tabs. */
const inTabs = (running, items, begin) => {
  const waiting = [...items];
  const work = async () => {
    const take = await begin(await tab(running));
    for (let item = waiting.shift(); item !== undefined; item = waiting.shift()) await take(item);
  };
  return Promise.all([work(), work()]);
};

function widths({ browser, pages, widths }) {
  return browsing(browser, async (running) => {
    const wide = [];
    let measured = 0;
    await inTabs(running, pages, ({ open, value, sized }) => async (page) => {
      await open(page);
      for (const width of widths) {
        await sized(width);
        const is = await value("document.documentElement.scrollWidth");
        if (is > width) wide.push({ page, at: width, is });
      }
      measured += 1;
    });
    return { measured, wide };
  });
}

/** A program that answers requests line by line: the texts of its results. */
function served(program, language) {
  const running = spawn(program, ["--lang", language, "serve", "--stdio"], { stdio: ["pipe", "pipe", "inherit"] });
  const lines = createInterface({ input: running.stdout })[Symbol.asyncIterator]();
  const ask = async (request) => {
    running.stdin.write(`${JSON.stringify(request)}\n`);
    const { value } = await lines.next();
    const begin = '{"id":null,"result":';
    return value.startsWith(begin) ? value.slice(begin.length, -1) : value;
  };
  return { ask, end: () => running.stdin.end() };
}

/** Numbers of two answers, or inputs, that are not the same, and how far the farthest are apart. */
function apart(ours, theirs) {
  const numbers = (value) => (Array.isArray(value) ? value.flatMap(numbers) : [value]);
  const [a, b] = [ours, theirs].map(({ si }) => numbers(si));
  const off = a.map((x, n) => (x === b[n] ? 0 : Math.abs(x - b[n]) / Math.max(Math.abs(x), Math.abs(b[n]))));
  return { count: off.filter((share) => share > 0).length, most: Math.max(0, ...off) };
}

/** What a reader sees of a result: answers as they are printed but for some, inputs as they are written, and every sentence. */
function seen({ answers, inputs, refusal, warnings, notes, errors, statement }, left) {
  const all = (of) => Object.entries(of ?? {}).filter(([name]) => !left.includes(name));
  const each = (of, see) => all(of).map(([name, one]) => [name, ...see(one)]);
  return { answers: each(answers, ({ label, shown }) => [label, shown]), inputs: each(inputs, ({ text }) => [text]),
    refusal, warnings, notes, errors, statement };
}

/** Result of the page beside that of the program, but for answers that are left out. */
function compared(ours, theirs, left = []) {
  const result = { same: ours === theirs, off: 0, most: 0, wrong: [] };
  if (result.same) return result;
  const [a, b] = [ours, theirs].map((text) => JSON.parse(text));
  const [page, program] = [seen(a, left), seen(b, left)];
  for (const key of Object.keys(program)) {
    const [x, y] = [page[key], program[key]].map((what) => JSON.stringify(what) ?? "nothing");
    if (x === y) continue;
    const at = [...x].findIndex((letter, n) => letter !== y[n]);
    const part = (text) => text.slice(Math.max(0, at - 60), at + 40);
    result.wrong.push(`${key}: …${part(x)}…, and by the program …${part(y)}…`);
  }
  for (const key of ["answers", "inputs"]) {
    for (const [name, one] of Object.entries(b[key] ?? {})) {
      if (!a[key]?.[name] || left.includes(name)) continue;
      const { count, most } = apart(a[key][name], one);
      result.off += count;
      // Of what is printed as zero the last bits say nothing.
      if (!/^[−-]?0(?![.,\d])/.test(one.shown ?? "")) result.most = Math.max(result.most, most);
    }
  }
  return result;
}

/** Every problem file solved by the page and by the program; what a page says to wrong inputs. */
async function solver({ browser, program, script, languages, rounding, widths }) {
  const sizes = { file: readFileSync(script).length, gzip: gzipSync(readFileSync(script), { level: 9 }).length,
    brotli: brotliCompressSync(readFileSync(script)).length };
  return browsing(browser, async (running) => {
    const found = [];
    for (const { language, files } of languages) {
      const begin = performance.now();
      const ends = [];
      const total = { language, count: 0, same: 0, shown: 0, papers: 0, off: 0, most: 0, where: "", faults: [] };
      await inTabs(running, files, async ({ open, value }) => {
        const { ask, end } = served(program, language);
        ends.push(end);
        await open(files[0].replace(/toml$/, "html"));
        await value(`loaded(document.querySelector("#solve").dataset.up + "../solver.js")`);
        return async (file) => {
          const text = readFileSync(file, "utf8");
          const given = JSON.stringify(text);
          const asked = (call) => value(`solver.ask("${call}", ${given}, "${language}")`);
          try {
            const theirs = await ask({ solve: { problem_file: text } });
            const left = rounding.filter(([id]) => file.includes(`${id}/`)).map(([, answer]) => answer);
            const result = compared(await asked("solved"), theirs, left);
            const paper = JSON.parse(await ask({ report: { problem_file: text, format: "html_fragment" } }));
            const { html } = JSON.parse(await asked("opened"));
            total.count += 1;
            total.same += Number(result.same);
            total.papers += Number(html === paper);
            total.shown += Number(!result.wrong.length);
            total.off += result.off;
            if (result.most > total.most) [total.most, total.where] = [result.most, file];
            total.faults.push(...result.wrong.map((what) => `${file}: ${what}`));
          } catch (fault) {
            total.faults.push(`${file}: ${fault.message}`);
          }
        };
      });
      ends.forEach((end) => end());
      found.push({ ...total, seconds: (performance.now() - begin) / 1000 });
    }
    const pages = languages.map(({ files }) => files[0].replace(/toml$/, "html"));
    const shown = [];
    for (const page of pages) shown.push(await typed(await tab(running), page, widths));
    return { sizes, found, shown };
  });
}

/** Widths of a page while it solves, and what it says to a wrong unit, a missing value and a wrong answer. */
async function typed({ open, value, sized }, page, widths) {
  await open(page);
  await value(`document.querySelector("#solve .begin").click()`);
  const settled = `new Promise((done) => {
    const look = () => (document.querySelector("#solve .inputs .line") && !document.querySelector("#solve[aria-busy]") ? done() : setTimeout(look, 50));
    setTimeout(look, 50);
  })`;
  await value(settled);
  const first = `document.querySelector("#solve .line.text input")`;
  const unit = (text) => `(() => {
    const field = ${first};
    field.value = ${JSON.stringify(text)};
    field.dispatchEvent(new Event("change"));
  })()`;
  const said = async (text) => {
    await value(unit(text));
    await value(settled);
    return value(`document.querySelector("#solve .line .error")?.textContent ?? ""`);
  };
  const wide = [];
  for (const width of widths) {
    await sized(width);
    const is = await value("document.documentElement.scrollWidth");
    if (is > width) wide.push({ at: width, is });
  }
  const before = await value(`${first}.value`);
  const errors = [await said("12 furlongz"), await said("")];
  const repaired = await said(before);
  return { page, wide, errors, repaired, answers: await value(`document.querySelectorAll("#solve .found tr").length`) };
}

const tasks = { search: () => search(files), widths: () => widths(request), solver: () => solver(request) };
const found = await tasks[task]();
process.stdout.write(JSON.stringify(found));
