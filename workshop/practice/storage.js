// What this browser keeps of a page. It may refuse, be full, or hold what nobody can read.

const memory = { // a browser may refuse to keep anything: then the page alone remembers
  data: {},
  kept: true, // whether all that was to be kept is
  get: (key) => { try { return localStorage.getItem(key) ?? memory.data[key]; } catch { return memory.data[key]; } },
  set: (key, value) => { // whether the browser keeps it
    memory.data[key] = value;
    try { localStorage.setItem(key, value); } catch { memory.kept = false; }
    return memory.kept;
  },
};

// What is kept under a key; what cannot be read is laid aside.
const parsed = (key) => {
  const text = memory.get(key);
  try {
    const found = JSON.parse(text || "{}");
    if (found && typeof found === "object") return found;
  } catch { /* as below */ }
  memory.set(`${key} unreadable`, text);
  memory.set(key, "{}");
  memory.broken = true;
  return {};
};

Object.assign(part, { memory, parsed });
