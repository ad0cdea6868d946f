// Search while typing, in the dialog of every page and on the page of results. The data come when
// a reader starts; from then on nothing is loaded.
{
  const ROOT = document.documentElement.dataset.content_root;
  // how much a word counts: in a title, where a chapter explains it, in search_words.toml, in what
  // names a mistake, in prose, in code
  const FIELDS = { title: 9, terms: 9, also: 1, feedback: 3, text: 1.2, code: 0.15 };
  const PAGES = { glossary: 0.55, api: 0.3, declarations: 0.2, notation: 0.4, practice: 0.4, errata: 0.4 };
  const SLIPS = (term) => (term.length > 6 ? 2 : term.length > 4 ? 1 : 0); // letters that may differ
  const MOST_RESULTS = { dialog: 8, page: 30 };
  let index = null, loading = null;

  const EMPTY = new Set(["a", "an", "the", "of", "or", "and", "to", "in", "is", "for", "with", "vs", "how", "what", "why",
    "which", "when", "do", "does", "did", "are", "was", "be", "i", "my", "me", "you", "your", "by", "on", "from", "at"]);
  // one letter for what looks alike: case, Arabic and Persian ya and kaf, joiners, accents; one word
  // for one and many; none for words that say nothing
  const foldTerm = (term) => {
    const folded = term.normalize("NFKD").toLowerCase()
      .replace(/[\p{M}\u200c\u200d]/gu, "").replace(/ي/g, "ی").replace(/ك/g, "ک");
    return EMPTY.has(folded) ? "" : folded.replace(/(?<=[a-z]{3}[^su])s$/, "");
  };
  // the name of a function, and what is written with a hyphen, is a word as well as its parts
  const splitWords = (text) => text.match(/\w+_\w+|[\p{L}\p{M}\p{N}\u200c]+(?:-[\p{L}\p{N}]+)*/gu)
    ?.flatMap((word) => (/[-_]/.test(word) ? [word.replaceAll("-", ""), ...word.split(/[-_]/)] : word)) ?? [];
  const listTerms = (text) => splitWords(text).map(foldTerm).filter(Boolean);

  const loadScript = ({ src }) => new Promise((done, failed) => {
    const script = document.createElement("script");
    Object.assign(script, { src, onload: done, onerror: failed });
    document.head.append(script);
  });
  // named on each page with their versions, but not loaded with it
  const [library, data] = document.querySelectorAll("script[type='text/search']");
  const loadIndex = () => (loading ??= loadScript(library).then(() => loadScript(data))
    .then(() => siteSearch.indexed));

  globalThis.siteSearch = {
    buildIndex(entries) {
      index = new MiniSearch({
        fields: Object.keys(FIELDS),
        storeFields: ["page", "at", "title", "of", "text", "code", "also"],
        tokenize: splitWords,
        processTerm: (term) => foldTerm(term) || null,
        searchOptions: {
          boost: FIELDS,
          prefix: (term) => term.length > 1,
          boostDocument: (id, term, { page }) => (PAGES[page] ?? 1)
            * (page === "notation" && /^\p{Script=Greek}$/u.test(term) ? 20 : 1),
        },
      });
      // piece by piece, or a phone would take no letter meanwhile
      this.indexed = index.addAllAsync(entries.map((entry, id) => ({ id, ...entry })));
    },
    ask(words) {
      const found = index.search(words, { fuzzy: SLIPS, weights: { fuzzy: 0.1, prefix: 0.375 } });
      const asked = listTerms(words).length;
      // what lacks one of the words counts less; what has all of them in its title counts more, a page
      // most; more, too, a section that has the words one after the other, most if search_words.toml has
      // just them; a summary counts less than what it sums up
      const said = words.toLowerCase();
      const weigh = ({ score, queryTerms, terms, match, page, at, title, text = "", also = "" }) => {
        const known = new Set(listTerms(title)), own = terms.filter((term) => match[term].join() !== "also");
        const all = own.length >= asked && own.every((term) => known.has(term));
        const phrase = at && said.includes(" ") && text.toLowerCase().includes(said);
        return score * (queryTerms.length / asked) ** 4 * (!all || page in PAGES ? 1 : at ? 2 : 3)
          * (also.split(", ").includes(said) ? 8 : phrase ? 1.4 : 1)
          * (/^(Recap|Exercise|Program)\b/.test(title) ? 0.5 : 1);
      };
      return found.map((one) => [weigh(one), one]).sort(([a], [b]) => b - a).map(([, one]) => one);
    },
  };

  const addressOf = ({ page, at }) => `${ROOT}${page}.html${at ? `#${at}` : ""}`;

  // The text around the first word that was looked for, this one marked.
  const renderExcerpt = ({ text = "", code = "", terms }) => {
    const letters = terms.map((term) => term.replace(/[^\p{L}\p{N}]/gu, ".")).join("|");
    const source = [text, code].find((each) => new RegExp(letters, "iu").test(each)) ?? text;
    const at = Math.max(0, source.search(new RegExp(letters, "iu")));
    const from = at < 70 ? 0 : source.indexOf(" ", at - 60) + 1;
    const cut = source.slice(from, from + 160);
    const line = document.createElement("p");
    line.append(from ? "… " : "");
    cut.split(new RegExp(`(${letters})`, "iu")).forEach((part, i) => {
      const mark = document.createElement("mark");
      mark.textContent = part;
      line.append(i % 2 ? mark : part);
    });
    line.append(from + 160 < source.length ? " …" : "");
    return line;
  };

  const renderResult = (result) => {
    const li = document.createElement("li"), link = document.createElement("a");
    const of = document.createElement("span");
    Object.assign(link, { href: addressOf(result), textContent: result.title });
    of.textContent = result.of === result.title ? "" : result.of;
    li.append(link, of, renderExcerpt(result));
    return li;
  };

  const showResults = (box, words, most) => {
    const results = words ? siteSearch.ask(words) : [];
    const status = document.createElement("p"), list = document.createElement("ol");
    const more = results.length > most ? `, the best ${most} of them here` : "";
    const count = results.length === 1 ? "1 section" : `${results.length || "No"} sections`;
    status.textContent = words ? `${count} found${more}` : "";
    status.setAttribute("role", "status");
    list.append(...results.slice(0, most).map(renderResult));
    box.replaceChildren(status, list);
  };

  // Up and down go through the results.
  const walkResults = (box, input) => (event) => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    const stops = [input, ...box.querySelectorAll("a")];
    const next = stops[stops.indexOf(document.activeElement) + step];
    if (!next) return;
    event.preventDefault();
    next.focus();
  };

  const addSearch = (form, most) => {
    const input = form.querySelector("input"), box = document.createElement("div");
    box.className = "site-results";
    form.after(box);
    const follow = () => loadIndex().then(
      () => showResults(box, input.value.trim(), most),
      () => { box.textContent = "The search could not be loaded. Try again when you are online."; });
    input.addEventListener("input", follow);
    input.addEventListener("focus", loadIndex, { once: true });
    for (const part of [form, box]) part.addEventListener("keydown", walkResults(box, input));
    return { input, follow };
  };

  const dialog = document.querySelector("#pst-search-dialog form");
  if (dialog) addSearch(dialog, MOST_RESULTS.dialog);
  const page = document.querySelector(".bd-search-container form");
  if (page) {
    const { input, follow } = addSearch(page, MOST_RESULTS.page);
    input.value = new URLSearchParams(location.search).get("q") ?? "";
    page.addEventListener("submit", (event) => {
      event.preventDefault();
      history.replaceState(null, "", `?q=${encodeURIComponent(input.value)}`);
      follow();
    });
    if (input.value) follow();
    input.focus();
  }
}
