// Python (Pyodide) in a worker: loads it, and what a cell needs, runs cells, tells what they show.
//
// In: { settings }, then { cell, source, name } for each run; { stored } of a program that is to be
// judged. Out: { loading: [what, MB] }, { ready }, { cell, kind, text } for each output,
// { cell, ended: true or false }, { failed: words }.

const PATIENCE = 15_000; // ms for the first answer; the page shall say within 20 s that none comes

let pyodide, cells, settings, packages, katex, running;

const postOutput = (kind, text) => postMessage({ cell: running, kind, text });
const MEGABYTES = { python: 6.4, numpy: 3, sympy: 6.5, matplotlib: 9 }; // as sent, about

const fetchBytes = async (address) => {
  const answer = await fetch(address, { cache: "no-cache" }); // asked again: a release may be newer
  if (!answer.ok) throw new Error(`${address} answers ${answer.status}`);
  return answer.arrayBuffer();
};

const loadPython = async () => {
  postMessage({ loading: ["Python", MEGABYTES.python] });
  const { python, wheels } = settings;
  const answer = await fetch(`${python}pyodide-lock.json`, { signal: AbortSignal.timeout(PATIENCE) });
  if (!answer.ok) throw new Error(`it answers ${answer.status}`);
  const lock = await answer.json();
  packages = Object.fromEntries(Object.values(lock.packages).flatMap(({ name, imports }) =>
    imports.map((each) => [each, name])));
  const own = Promise.all([settings.cells, ...wheels].map(fetchBytes));
  const { loadPyodide } = await import(`${python}pyodide.mjs`);
  pyodide = await loadPyodide({
    indexURL: python, lockFileContents: lock, packageBaseUrl: python, stderr: () => {},
  });
  const [code, ...archives] = await own;
  archives.forEach((wheel) => pyodide.unpackArchive(wheel, "wheel"));
  pyodide.FS.writeFile("page_cells.py", new Uint8Array(code));
  cells = pyodide.pyimport("page_cells").start(
    (kind, text) => kind === "text/latex" && katex ? renderFormula(text) : postOutput(kind, text),
    pyodide.toPy(Object.keys(packages)));
  postMessage({ ready: true });
};

const renderFormula = (text) => {
  const tex = text.replace(/^\$+|\$+$/g, "").replace(/\\tag\{[^}]*\}/, "");
  const shown = katex.renderToString(tex, { displayMode: true, throwOnError: false });
  postOutput("text/html", `<div class="math"><div class="math-scroll">${shown}</div></div>`);
};

// Load what a cell imports, and KaTeX once something could be shown as a formula.
const loadPackages = async (source) => {
  const wanted = cells.needs(source).toJs();
  for (const name of wanted.map((each) => packages[each])) {
    if (name in pyodide.loadedPackages) continue;
    postMessage({ loading: [name, MEGABYTES[name]] });
    await pyodide.loadPackage(name, { messageCallback: () => {}, errorCallback: () => {} });
    if (!(name in pyodide.loadedPackages)) throw new Error(`${name} cannot be loaded`);
  }
  if (!katex && settings.katex && "sympy" in pyodide.loadedPackages) {
    await import(settings.katex);
    katex = self.katex;
  }
};

onmessage = async ({ data }) => {
  try {
    if (data.settings) {
      settings = data.settings;
      return await loadPython();
    }
    running = data.cell;
    await loadPackages(data.stored ? `import numpy\n${data.source}` : data.source);
    const { source, name, stored } = data;
    postMessage({ cell: running, ended: stored ? cells.check(source, name, stored) : cells.run(source, name) });
  } catch (error) {
    postMessage({ failed: error.message });
  }
};
