// Search of the handbook, the one of crates/core/src/search.rs: the same texts, weights and order. The texts come from the
// program, in search-index.js; the queries of tests/data/queries.toml are asked of both by `cargo xtask handbook --check`.
"use strict";

const NAMES = 8, KEYWORD_ALONE = 7, CASE = 4, DESCRIPTION = 3, INPUTS = 1, TOGETHER = 9, WHOLE = 4, ENOUGH = 3;

const LETTERS = { á: "a", à: "a", â: "a", ã: "a", ä: "a", å: "a", ç: "c", é: "e", è: "e", ê: "e", ë: "e", í: "i", ì: "i",
  î: "i", ï: "i", ñ: "n", ó: "o", ò: "o", ô: "o", õ: "o", ö: "o", ú: "u", ù: "u", û: "u", ü: "u" };

const bytes = (text) => new TextEncoder().encode(text).length;
const isAlphanumeric = (letter) => /^[\p{Alphabetic}\p{N}]$/u.test(letter);
const sum = (numbers) => numbers.reduce((all, number) => all + number, 0);

/** Lower case without accents; a hyphen within a word is a space. */
const folded = (text) => Array.from(text.toLowerCase(), (letter) => LETTERS[letter] ?? letter).join("")
  .replace(/(?<=[\p{Alphabetic}\p{N}])-(?=[\p{Alphabetic}\p{N}])/gu, " ");

/** The last character before, or the first at a place of a text; empty at its ends. */
const before = (text, at) => Array.from(text.slice(Math.max(0, at - 2), at)).pop() ?? "";
const behind = (text, at) => Array.from(text.slice(at, at + 2))[0] ?? "";

/** The places at which a word stands in a text, one after the other. */
function* places(text, word) {
  for (let at = text.indexOf(word); at >= 0 && word; at = text.indexOf(word, at + word.length)) yield at;
}

/** Score of a word in a text, in the better of its spellings; the name of a standard counts as a whole alone. */
function place(index, text, { whole, parted, stem, isExact }) {
  const written = placeOf(index, text, whole, isExact ? "" : stem);
  if (isExact) return written === WHOLE ? WHOLE : 0;
  return written < WHOLE && parted && placeOf(index, text, parted, "") === WHOLE ? WHOLE : written;
}

/** Score of letters in a text: 4 as a whole word, 3 as the beginning of one, 2 with its stem alone, 1 within one. */
function placeOf(index, text, whole, stem) {
  const begins = (at) => !isAlphanumeric(before(text, at));
  let best = 0;
  for (const at of places(text, whole)) {
    const ends = !isAlphanumeric(behind(text, at + whole.length));
    if (begins(at) && ends) return WHOLE;
    best = Math.max(best, begins(at) ? 3 : Number(bytes(whole) >= index.within));
  }
  return best < 2 && stem && [...places(text, stem)].some(begins) ? 2 : best;
}

/** True if an analysis has these words together, whole. */
function isKnown(index, words) {
  const has = (text) => placeOf(index, text, words, "") === WHOLE;
  return index.analyses.some((analysis) => texts(analysis).some(([text]) => has(text)) || analysis.cases.some(has));
}

/** The words as they were typed; one with hyphens that none has is its parts, unless one is a letter or a number. */
function* typedWords(index, typed) {
  for (const word of typed.split(/\s+/u).filter(Boolean)) {
    const bare = word.replace(/[,:;?!]+$/u, "") || word;
    const whole = folded(bare).replace(/['’]s$/u, "") || folded(bare);
    const parts = whole.split(" ");
    const isParted = parts.every((part) => /^\p{Alphabetic}{2,}$/u.test(part)) && !isKnown(index, whole);
    yield* isParted ? parts : [whole];
  }
}

/** Two words for one that no analysis has: `run out` for `runout`, `g 2.5` for `g2.5`; empty where none has these. */
function partedOf(index, whole) {
  if (isKnown(index, whole)) return "";
  const letters = Array.from(whole);
  const isLetter = (letter) => /\p{Alphabetic}/u.test(letter);
  const isJoined = letters.length >= index.joined && letters.every(isLetter);
  const isPlace = (at) => isJoined && at > 1 && at + 1 < letters.length
    || isLetter(letters[at - 1]) && /[0-9]/.test(letters[at]);
  const parted = (at) => `${letters.slice(0, at).join("")} ${letters.slice(at).join("")}`;
  const at = letters.findIndex((_, at) => at > 0 && isPlace(at) && isKnown(index, parted(at)));
  return at > 0 ? parted(at) : "";
}

/** A filter: the phrase, and the words that count, each with its other forms and whether it must be found. */
function filterOf(index, typed) {
  const phrase = folded(typed.trim());
  const words = [...typedWords(index, typed)];
  const counting = words.filter((word) => !index.small_words.includes(word));
  const kept = counting.length ? counting : words;
  const isStandard = (word) => index.standards.includes(word);
  const isNumber = (word) => /^[0-9]/.test(word);
  const hasStandard = kept.some(isStandard) && kept.some(isNumber);
  const isOptional = (word) => index.optional_words.includes(word) || (hasStandard && isNumber(word));
  const stem = (word) => index.endings.filter((ending) => word.endsWith(ending))
    .map((ending) => word.slice(0, word.length - ending.length))
    .filter((rest) => bytes(rest) >= index.stem)
    .reduce((best, rest) => (best && best.length <= rest.length ? best : rest), "");
  const made = kept.map((whole) => ({
    whole,
    parted: partedOf(index, whole),
    stem: stem(whole),
    isNeeded: !isOptional(whole) || kept.every(isOptional),
    isExact: hasStandard && isStandard(whole),
  }));
  return { phrase, words: made, needed: made.filter(({ isNeeded }) => isNeeded).length };
}

const texts = (analysis) => [[analysis.names, NAMES], [analysis.keywords, DESCRIPTION], [analysis.words, DESCRIPTION],
  [analysis.inputs, INPUTS]];

/** Number of texts and cases in which the words stand together. */
const mentions = (analysis, phrase) =>
  [...texts(analysis).map(([text]) => text), ...analysis.cases].filter((text) => text.includes(phrase)).length;

/** Score of the match and the case that matches best; null where fewer than `least` words are found together. */
function rank(index, analysis, { phrase, words }, least) {
  const together = (text, weight) =>
    words.length > 1 && placeOf(index, text, phrase, "") > 0 ? TOGETHER * weight : 0;
  const most = (of) => Math.max(0, ...texts(analysis).map(([text, weight]) => of(text, weight)));
  const ofAnalysis = words.map((word) => most((text, weight) => weight * place(index, text, word)));
  const spaced = (text) => text.replaceAll("-", " ");
  const isPhrase = (name) => spaced(name.split("/").pop()) === spaced(phrase);
  const bonus = most(together) + (analysis.names.split("\n").some(isPhrase) ? TOGETHER * NAMES : 0);
  const hasEnough = (scores) => scores.filter((score, at) => score > 0 && words[at].isNeeded).length >= least;
  let best = hasEnough(ofAnalysis) ? { score: sum(ofAnalysis) + bonus, found: null } : null;
  analysis.cases.forEach((text, n) => {
    const scores = words.map((word, at) => {
      const ofCase = CASE * place(index, text, word);
      return Math.max(ofCase, ofAnalysis[at]) + Number(ofCase > ofAnalysis[at] && ofAnalysis[at] > 0);
    });
    if (!hasEnough(scores)) return;
    const score = sum(scores) + Math.max(together(text, CASE), bonus);
    if (!best || score > best.score) best = { score, found: n };
  });
  if (words.length === 1 && best) {
    best.score = Math.max(best.score, KEYWORD_ALONE * place(index, analysis.keywords, words[0]));
  }
  return best;
}

/** The analyses in which at least so many of the words are found, the best match first. */
function withWords(index, filter, least) {
  return index.analyses
    .map((analysis, at) => ({ at, match: rank(index, analysis, filter, least), mentions: mentions(analysis, filter.phrase) }))
    .filter(({ match }) => match)
    .sort((a, b) => b.match.score - a.match.score || b.mentions - a.mentions || a.at - b.at)
    .map(({ at, match }) => ({ id: index.analyses[at].id, found: match.found }));
}

/** The analyses of a search, the best match first: those with every word; where they are few, those with most follow. */
function find(index, typed) {
  const filter = filterOf(index, typed);
  if (!filter.words.length) return [];
  const found = withWords(index, filter, filter.needed);
  if (found.length >= ENOUGH || filter.needed <= 2) return found;
  const others = withWords(index, filter, Math.floor(filter.needed / 2) + 1);
  return [...found, ...others.filter(({ id }) => found.every((known) => known.id !== id))];
}

if (typeof module !== "undefined") module.exports = { find };

/** The field of every page, and on the page with the list the results below it. */
function begin() {
  const form = document.querySelector("form.search");
  form.hidden = false;
  const results = document.querySelector("#results");
  if (!results) return;
  const field = form.querySelector("input");
  const show = () => {
    const found = find(SEARCH_INDEX, field.value).map(({ id, found }) => {
      const item = document.createElement("li");
      const { title, summary, cases } = SEARCH_TITLES[id];
      const link = (href, words) => {
        const made = document.createElement("a");
        made.href = href;
        made.textContent = words;
        return made;
      };
      item.append(link(`${id}.html`, title));
      if (found !== null && cases[found] !== title) item.append(" ▸ ", link(`${id}/${found + 1}.html`, cases[found]));
      item.append(document.createElement("br"), summary);
      return item;
    });
    results.replaceChildren(...found);
    document.querySelector("#nothing").hidden = found.length > 0 || !field.value.trim();
    document.querySelector("#contents").hidden = found.length > 0;
  };
  field.addEventListener("input", show);
  field.value = new URLSearchParams(location.search).get("q") ?? "";
  show();
}

if (typeof document !== "undefined") begin();
