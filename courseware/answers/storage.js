// The browser's storage, which may refuse or be full.

export const memory = { // a browser may refuse to keep anything: then the page alone remembers
  data: {},
  kept: true, // whether all that was to be kept is
  get: (key) => { // a page from disk may find nothing after it is loaded again: so this tab remembers, too
    const here = memory.data[key] ?? history.state?.[key];
    try { return memory.kept || here === undefined ? localStorage.getItem(key) ?? here : here; } catch { return here; }
  },
  set: (key, value) => { // whether the browser keeps it
    memory.data[key] = value;
    try { history.replaceState({ ...history.state, [key]: value }, ""); } catch { /* too often */ }
    try { // the stand-in of layout.html says false where it stores nothing
      if (localStorage.setItem(key, value) === false) memory.kept = false;
    } catch { memory.kept = false; }
    return memory.kept;
  },
};

// Parse what is stored under a key; what cannot be parsed is nothing.
export const readStored = (key) => {
  try { return JSON.parse(memory.get(key)) ?? {}; } catch { return {}; }
};
