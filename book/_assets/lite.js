// JupyterLite opens the notebook of this release, and says what it waits for: `jupyterlite.py` adds
// this script to its pages.
{
  const PATIENCE = 120_000; // ms, for all of Python
  const root = new URL("../", location), asked = new URLSearchParams(location.search).get("path");
  const read = async (name) => (await fetch(new URL(name, root), { cache: "no-cache" })).json();

  // A notebook's name ends with letters of its digest. A link without them, or with those of an
  // earlier release, leads to the present one, unless this browser keeps a file of that name.
  const isKept = async (database) => {
    const known = await indexedDB.databases?.() ?? [];
    if (!known.some(({ name }) => name === database)) return false;
    const opened = await new Promise((done, failed) => {
      Object.assign(indexedDB.open(database), { onsuccess: ({ target }) => done(target.result), onerror: failed });
    });
    const key = opened.objectStoreNames.contains("files") && await new Promise((done, failed) => {
      const request = opened.transaction("files").objectStore("files").getKey(asked);
      Object.assign(request, { onsuccess: () => done(request.result), onerror: failed });
    });
    opened.close();
    return Boolean(key);
  };
  const follow = async (database) => {
    const names = (await read("api/contents/all.json")).content.map(({ name }) => name);
    const stem = asked.replace(/(-[0-9a-f]{6})?\.ipynb$/, "");
    const present = names.find((name) => name.startsWith(`${stem}-`));
    if (names.includes(asked) || !present || await isKept(database)) return;
    location.replace(`${location.pathname}?path=${present}`);
  };

  const line = document.createElement("p");
  line.setAttribute("role", "status");
  line.style = "position: fixed; z-index: 9999; bottom: 0; left: 0; margin: 0; padding: .6rem 1rem; "
    + "max-width: 40rem; background: #fff3d6; color: #1f2730; border: 1px solid #a34d00; font: 15px/1.4 sans-serif";
  const say = (words) => {
    line.textContent = words;
    (document.body ?? document.documentElement).append(line);
  };
  const isReady = () => document.querySelector(".jp-Notebook-ExecutionIndicator[data-status='idle']");
  const followPython = async (address) => {
    const { host } = new URL(address), from = host === location.host ? "this site" : host;
    const why = `Python cannot be loaded from ${from}: the network here may block it. No cell runs here; `
      + "the stored results stand. Load this page again to try once more.";
    say(`Loading Python from ${from}, a large download the first time …`);
    try {
      const answer = await fetch(address, { signal: AbortSignal.timeout(PATIENCE / 6) });
      if (!answer.ok) throw new Error(answer.status);
    } catch {
      return say(why);
    }
    const end = performance.now() + PATIENCE, timer = setInterval(() => {
      if (isReady()) line.remove();
      else if (performance.now() > end) say(why);
      else return;
      clearInterval(timer);
    }, 500);
  };

  (async () => {
    const settings = (await read("jupyter-lite.json"))["jupyter-config-data"];
    if (!asked) return;
    await follow(settings.contentsStorageName);
    const plugins = Object.entries(settings.litePluginSettings);
    const [, { pyodideUrl }] = plugins.find(([name]) => name.endsWith(":kernel"));
    await followPython(new URL(pyodideUrl, root).href);
  })();
}
