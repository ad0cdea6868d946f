"""Lighthouse on the built site: its phone profile, the median of three runs, a row a page.

    PYTHONPATH=tests .venv/bin/python tools/lighthouse.py          every page of the book
    PYTHONPATH=tests .venv/bin/python tools/lighthouse.py euler    pages with that in their names

It needs Node 18 or newer, whose `npx` fetches Lighthouse, and Chromium. The site is served as by
any host of the web: texts compressed, over HTTP/1.1, whose connections stay open. Lighthouse counts
the time of a new connection on a phone, which HTTP/1.0 would need for each file.
"""

import functools
import gzip
import io
import json
import os
import statistics
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

import chromium
from browser import SITE, Quiet, Server, listed

LIGHTHOUSE = "lighthouse@12.8.2"
RUNS = 3
FLAGS = "--headless=new --no-sandbox --disable-gpu"
SCORES = ("performance", "accessibility", "best-practices", "seo")
TIMES = {
    "largest paint": "largest-contentful-paint",
    "blocked": "total-blocking-time",
    "shift": "cumulative-layout-shift",
}
TEXTS = (".html", ".css", ".js", ".svg", ".json", ".txt")


class Compressing(Quiet):
    """Serves texts compressed, over connections that stay open."""

    protocol_version = "HTTP/1.1"
    disable_nagle_algorithm = True  # head and body leave one after the other, without a wait

    def send_head(self):
        """Send the head, and return the compressed file."""
        file = Path(self.translate_path(self.path))
        if file.suffix not in TEXTS or not file.is_file():
            return super().send_head()
        data = gzip.compress(file.read_bytes())
        self.send_response(200)
        self.send_header("Content-Type", self.guess_type(str(file)))
        self.send_header("Content-Encoding", "gzip")
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        return io.BytesIO(data)


def run_lighthouse(address):
    """Run Lighthouse once: scores of 100, times in milliseconds."""
    with tempfile.NamedTemporaryFile(suffix=".json") as output:
        command = ["npx", "--yes", LIGHTHOUSE, address, "--quiet", "--output=json"]
        command += [f"--output-path={output.name}", f"--chrome-flags={FLAGS}"]
        environment = {**os.environ, "CHROME_PATH": chromium.find_path() or ""}
        subprocess.run(command, check=True, env=environment)
        report = json.loads(Path(output.name).read_text("utf-8"))
    found = {name: 100 * report["categories"][name]["score"] for name in SCORES}
    found |= {name: report["audits"][audit]["numericValue"] for name, audit in TIMES.items()}
    return found


def main():
    """Print a row for each page."""
    part = sys.argv[1] if len(sys.argv) > 1 else ""
    handler = functools.partial(Compressing, directory=str(SITE))
    print(f"{'':42}{''.join(f'{name:>16}' for name in (*SCORES, *TIMES))}", flush=True)
    with Server(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        for name in filter(lambda name: part in name, listed()):
            page = "index" if name == "intro" else name
            runs = [
                run_lighthouse(f"http://127.0.0.1:{server.server_port}/{page}.html")
                for _ in range(RUNS)
            ]
            row = [statistics.median(run[key] for run in runs) for key in runs[0]]
            shown = [f"{number:.2f}" if number < 2 else f"{number:.0f}" for number in row]
            print(f"{page:42}{''.join(f'{number:>16}' for number in shown)}", flush=True)
        server.shutdown()


if __name__ == "__main__":
    main()
