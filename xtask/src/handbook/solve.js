// The page that solves: the problem file of a case as a form, its answers and worked solution, and a check of the reader's
// own answers. The program does all of it, as WebAssembly in a worker; it is loaded when the reader asks for it. A page keeps
// the text of the problem file and what the program says of it. WORDS stands before this text.
"use strict";

/** The worker: answers each request with the text that the function of that name returns. */
function work() {
  self.onmessage = ({ data: { id, module, call, given } }) => {
    try {
      if (module) wasm_bindgen.initSync({ module });
      self.postMessage({ id, text: call ? wasm_bindgen[call](...given) : "" });
    } catch (fault) {
      self.postMessage({ id, fault: String(fault) });
    }
  };
}

/** The program. One that has panicked, or is stopped, is started anew when it is asked again. */
const solver = {
  worker: null,
  waiting: new Map(),
  count: 0,

  async bytes() {
    const gzip = Uint8Array.from(atob(SOLVER.module), (letter) => letter.charCodeAt(0));
    const unpacked = new Blob([gzip]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Uint8Array(await new Response(unpacked).arrayBuffer());
  },

  async start() {
    this.module ??= await this.bytes();
    if (this.worker) return;
    const source = new Blob([`${SOLVER.bindings}\n(${work})();`], { type: "text/javascript" });
    this.worker = new Worker(URL.createObjectURL(source));
    this.worker.onmessage = ({ data: { id, text, fault } }) => {
      const { done, failed } = this.waiting.get(id) ?? {};
      this.waiting.delete(id);
      if (fault === undefined) return done?.(text);
      this.stop();
      failed?.(new Error(fault));
    };
    this.worker.onerror = ({ message }) => this.stop(message);
    await this.send({ module: this.module });
  },

  send(request) {
    const id = (this.count += 1);
    return new Promise((done, failed) => {
      this.waiting.set(id, { done, failed });
      this.worker.postMessage({ id, ...request });
    });
  },

  /** Text that a function of the program returns. */
  async ask(call, ...given) {
    await this.start();
    return this.send({ call, given });
  },

  stop(why = WORDS.stopped) {
    this.worker?.terminate();
    this.worker = null;
    this.waiting.forEach(({ failed }) => failed(new Error(why)));
    this.waiting.clear();
  },
};

/** Loads the script of the program, once. */
const loaded = (address) => new Promise((done, failed) => {
  if (typeof SOLVER !== "undefined") return done();
  const script = document.createElement("script");
  script.onload = done;
  script.onerror = () => failed(new Error(WORDS.missing));
  script.src = address;
  document.head.append(script);
});

/** An element with properties, and what stands in it. */
function made(name, properties = {}, ...within) {
  const element = Object.assign(document.createElement(name), properties);
  element.append(...within.filter((part) => part !== null && part !== ""));
  return element;
}

const button = (words, act, name = "") => made("button", { type: "button", textContent: words, className: name, onclick: act });

/** A page with a problem. */
class Page {
  constructor(place) {
    this.place = place;
    this.language = document.documentElement.lang;
    this.published = document.querySelector("#problem-file").textContent;
    this.solution = document.querySelector("#worked");
    this.typed = {};
    this.open = new Set();
    this.made = Promise.resolve();
  }

  async begin() {
    this.place.replaceChildren(made("p", { textContent: WORDS.loading, role: "status" }));
    try {
      await loaded(`${this.place.dataset.up}../solver.js`);
      this.parts = {
        status: made("p", { className: "status", role: "status" }),
        form: made("div", { className: "inputs" }),
        answers: made("div", { className: "found" }),
        check: made("div", { className: "check" }),
        file: made("p", { className: "links" }),
      };
      await this.show("opened", this.published);
      const { status, form, answers, check, file } = this.parts;
      const columns = made("div", { className: "columns" }, form, made("div", {}, answers, check));
      this.place.replaceChildren(status, columns, file);
    } catch (fault) {
      this.place.replaceChildren(made("p", { className: "error", role: "alert", textContent: fault.message }));
    }
  }

  /** Asks the program for a page and shows it; an error of the request itself stands above the form. */
  async show(call, file, ...more) {
    const { status } = this.parts;
    this.place.setAttribute("aria-busy", "true");
    status.replaceChildren(WORDS.solving, " ", button(WORDS.stop, () => solver.stop()));
    let errors = [];
    try {
      const reply = JSON.parse(await solver.ask(call, file, ...more, this.language));
      if (reply.form) this.reply = reply;
      errors = reply.errors.filter(({ path }) => !reply.form?.some((line) => line.path === path && line.error));
    } catch (fault) {
      errors = [{ path: "", message: `${WORDS.fault}: ${fault.message}` }];
    }
    this.place.removeAttribute("aria-busy");
    const shown = errors.map(({ message }) => made("span", { className: "error", role: "alert", textContent: message }));
    status.replaceChildren(...shown);
    if (this.reply) this.draw();
  }

  /** Makes a change, after those that are being made. */
  change(change) {
    this.made = this.made.then(() => this.show("changed", this.reply.file, JSON.stringify(change)));
    return this.made;
  }

  draw() {
    const { form, html } = this.reply;
    const active = document.activeElement;
    const own = form.filter((line) => !line.common), common = form.filter((line) => line.common);
    const lines = (of) => of.map((line) => this.line(line));
    // A text that is being typed is a change to come, after which the form is drawn.
    if (!active?.dataset.path || active.value === active.drawn) {
      this.parts.form.replaceChildren(made("h2", { textContent: WORDS.inputs }), ...lines(own),
        this.details("common", WORDS.common, ...lines(common)));
    }
    this.drawAnswers();
    this.drawCheck();
    this.drawFile();
    if (active?.id) document.getElementById(active.id)?.focus();
    this.solution.classList.toggle("old", html === null);
    if (html !== null) this.solution.innerHTML = html;
  }

  details(name, words, ...within) {
    const element = made("details", { open: this.open.has(name) }, made("summary", { textContent: words }), ...within);
    element.ontoggle = () => (element.open ? this.open.add(name) : this.open.delete(name));
    return element;
  }

  /** A line of the form. */
  line(line) {
    const { path, label, symbol, help, error } = line;
    const id = `input-${path}`;
    const properties = line.text === undefined ? { title: help } : { htmlFor: id, title: help };
    const name = made("htmlFor" in properties ? "label" : "span", properties, label, symbol && made("i", { textContent: ` ${symbol}` }));
    const element = made("div", { className: `line ${line.role}` }, name, ...this.control(line, id));
    element.style.setProperty("--depth", line.depth);
    if (line.takes && line.role !== "rows") element.append(made("small", { textContent: line.takes }));
    if (error) {
      const repair = (text) => button(text, () => this.change({ do: "write", path, text }), "repair");
      element.append(made("p", { className: "error", id: `${id}-error`, role: "alert" }, error.message, ...error.repairs.map(repair)));
    }
    return element;
  }

  /** What is typed in or chosen from, and the buttons of a line. */
  control({ path, role, text, alternatives, optional, row, count, most, least, error }, id) {
    const write = ({ target }) => {
      target.drawn = target.value;
      this.change({ do: role === "choice" ? "choose" : "write", path, text: target.value });
    };
    const common = { id, onchange: write, ariaInvalid: error ? "true" : null };
    const mark = (element) => {
      element.dataset.path = path;
      element.drawn = text ?? "";
      if (error) element.setAttribute("aria-describedby", `${id}-error`);
      return element;
    };
    const list = path.slice(0, path.lastIndexOf("["));
    const parts = [];
    if (alternatives) {
      const known = alternatives.some(({ name }) => name === text);
      const options = alternatives.map(({ name, label, help }) =>
        made("option", { value: name, textContent: label, title: help ?? "", selected: name === text }));
      if (!known) options.unshift(made("option", { value: text ?? "", textContent: text ?? "", selected: true }));
      parts.push(mark(made("select", common, ...options)));
    } else if (role === "table") {
      parts.push(mark(made("textarea", { ...common, value: text, rows: Math.min(12, text.split("\n").length + 1), spellcheck: false })));
    } else if (role === "text") {
      parts.push(mark(made("input", { ...common, value: text, autocomplete: "off", spellcheck: false })));
    }
    if (role === "rows" && count < (most ?? Infinity)) parts.push(button(WORDS.add, () => this.change({ do: "add", path })));
    if (row) parts.push(button(WORDS.takeOut, () => this.change({ do: "take-out", path: list, row })));
    if (role === "absent") parts.push(button(WORDS.putIn, () => this.change({ do: "put-in", path })));
    else if (optional && role !== "text") parts.push(button(WORDS.leaveOut, () => this.change({ do: "leave-out", path })));
    return parts;
  }

  drawAnswers() {
    const { answers, refusal, errors } = this.reply;
    const rows = answers.map(({ label, shown }) => made("tr", {}, made("th", { textContent: label }), made("td", { textContent: shown })));
    const why = refusal ?? (errors.length ? WORDS.wrong : null);
    this.parts.answers.replaceChildren(made("h2", { textContent: WORDS.answers }),
      why === null ? made("table", {}, made("tbody", {}, ...rows)) : made("p", { className: "error", textContent: why }));
  }

  /** Fields for the reader's own answers, and the verdicts on them. */
  drawCheck() {
    const { answers } = this.reply;
    const field = ({ name, label, example }) => {
      const input = made("input", { id: `answer-${name}`, value: this.typed[name] ?? "", placeholder: example, autocomplete: "off" });
      input.oninput = () => (this.typed[name] = input.value);
      return made("div", { className: "line" }, made("label", { htmlFor: input.id, textContent: label }), input);
    };
    const verdicts = made("div", { className: "verdicts", role: "status" });
    const check = async () => {
      try {
        verdicts.replaceChildren(WORDS.searching, " ", button(WORDS.stop, () => solver.stop()));
        const given = JSON.stringify(this.typed);
        const reply = JSON.parse(await solver.ask("checked", this.reply.file, given, this.language));
        const shown = (reply.answers ?? []).map(({ verdict, lines }) => made("pre", { className: verdict, textContent: lines.join("\n") }));
        verdicts.replaceChildren(...shown, ...(reply.errors ?? []).map(({ message }) => made("p", { className: "error", textContent: message })));
      } catch (fault) {
        verdicts.replaceChildren(made("p", { className: "error", textContent: `${WORDS.fault}: ${fault.message}` }));
      }
    };
    const parts = [made("p", { textContent: WORDS.checking }), ...answers.map(field), button(WORDS.check, check), verdicts];
    this.parts.check.replaceChildren(...(answers.length ? [this.details("check", WORDS.ownAnswers, ...parts)] : []));
  }

  drawFile() {
    const { file } = this.reply;
    if (this.address) URL.revokeObjectURL(this.address);
    this.address = URL.createObjectURL(new Blob([file], { type: "application/toml" }));
    const link = made("a", { href: this.address, download: "problem.toml", textContent: WORDS.file });
    this.parts.file.replaceChildren(link, " · ", button(WORDS.again, () => this.show("opened", this.published)));
  }
}

for (const place of document.querySelectorAll("#solve")) {
  const page = new Page(place);
  place.append(button(WORDS.solve, () => page.begin(), "begin"), " ", made("small", { textContent: WORDS.size }));
  place.hidden = false;
}
