// Runs `in_pyodide.py` by Pyodide in Node; what it needs comes as JSON.

import { readFileSync } from "node:fs";

const { python, lock, packages, folders, program, asked } = JSON.parse(readFileSync(0, "utf8"));
const { loadPyodide } = await import(`${python}/pyodide.mjs`);
try {
  const pyodide = await loadPyodide({ lockFileContents: lock, packageCacheDir: python });
  await pyodide.loadPackage(packages, { messageCallback: () => {} });
  folders.forEach((folder) => pyodide.mountNodeFS(folder, folder));
  pyodide.runPython(readFileSync(program, "utf8"));
  process.exitCode = pyodide.globals.get("run")(...asked.map((each) => pyodide.toPy(each)));
} catch (error) {
  console.error(error.message); // Node would print a line of megabytes
  process.exitCode = 2;
}
