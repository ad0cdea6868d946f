# make book    set everything up and build the site        make test          all tests
# make serve   look at the site                            make test T=motion   one topic
# make lab     open the notebooks in JupyterLab            make test-slow     what takes long
# make paper   the book as PDF and EPUB; make book after it links them
# make notebooks, check, lock, bench, test-install, clean: see CONTRIBUTING.md

PYTHON ?= python3
T ?=
PYODIDE ?=

BIN := .venv/bin
INSTALL = $(BIN)/uv pip install --python $(@D)/bin/python
READY := .venv/.ready
SITE := _build/html/.built
SOURCES := _config.yml _toc.yml $(shell find book robokin workshop -type f \
	-not -path '*/__pycache__/*' -not -path '*/.ipynb_checkpoints/*') \
	$(wildcard _build/robokin*.pdf _build/robokin.epub)
NOTEBOOKS = $(wildcard book/*/*$(T)*.ipynb)
unexport PYTHONDONTWRITEBYTECODE  # or each of many processes compiles SymPy and all else again

.PHONY: book serve lab paper test test-slow test-install check notebooks lock bench clean FORCE
.DEFAULT_GOAL := book

$(READY): requirements.txt pyproject.toml workshop/pyproject.toml book/pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
		echo "Python 3.11 or newer is needed, $(PYTHON) is older: make PYTHON=python3.12"; exit 1; }
	@echo "Setting up .venv, once; most of the time is downloading"
	$(PYTHON) -m venv .venv
	@awk '/^[a-z]/ {on = /^uv==/} on' requirements.txt > .venv/uv.txt  # as locked, with its hashes
	$(BIN)/python -m pip install -q --disable-pip-version-check --require-hashes -r .venv/uv.txt
	$(INSTALL) --require-hashes -r requirements.txt
	$(INSTALL) --no-deps --no-build-isolation -e . -e workshop -e book
	@touch $(READY)

# which Python the pages load, if not from its public address; changes with it
_build/pyodide: FORCE
	@mkdir -p _build; echo "$(PYODIDE)" | cmp -s - $@ || echo "$(PYODIDE)" > $@

$(SITE): $(READY) $(SOURCES) requirements.txt pyproject.toml _build/pyodide
	PYODIDE="$(PYODIDE)" "$(BIN)/jupyter-book" build book --config _config.yml \
		--toc "$(CURDIR)/_toc.yml" --path-output . -W -n --keep-going
	@touch $(SITE)

book: $(SITE)
	@echo "The site is built: open _build/html/index.html, or run: make serve"

serve: $(SITE)
	@echo "http://127.0.0.1:8000 - stop with Ctrl-C"
	$(BIN)/python -m http.server -b 127.0.0.1 -d _build/html 8000

lab: $(READY)
	$(BIN)/jupyter lab book

paper: $(SITE)
	PYTHONPATH=tools $(BIN)/python -m paper

# The library's tests run once, against the wheel that a user installs.
LIBRARY := _build/library
UNDER_TEST := PYTHONPATH="$(CURDIR)/$(LIBRARY)" ROBOKIN_UNDER_TEST="$(CURDIR)/$(LIBRARY)"
PYTEST := $(UNDER_TEST) $(BIN)/pytest -n 2 --dist

$(LIBRARY)/.ready: $(READY) pyproject.toml $(wildcard robokin/*.py)
	@rm -rf $(LIBRARY)
	$(BIN)/uv pip install -q --python $(BIN)/python --no-deps --no-build-isolation \
		--target $(LIBRARY) .
	@touch $@

test: check $(LIBRARY)/.ready
	$(PYTEST) worksteal $(if $(T),-k $(T)) tests book
	$(if $(NOTEBOOKS),$(PYTEST) loadfile --nbval $(NOTEBOOKS))

test-slow: $(LIBRARY)/.ready $(if $(filter-out paper,$(T)),,paper)
	$(PYTEST) worksteal -m slow -rs $(if $(T),-k $(T)) tests book

test-install: $(LIBRARY)/.ready .venv-lowest/.ready
	$(PYTEST) worksteal -m install -rs tests
	.venv-lowest/bin/pytest -n 2 book
	.venv-lowest/bin/pytest -n 2 --dist loadfile --nbval $(wildcard book/*/*.ipynb)

check: $(READY)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/codespell

notebooks: $(READY)
	$(BIN)/python tools/notebooks.py $(T)

# With their extras: pip takes a pin without them for none, as soon as there is a newer version.
LOCKED = $(BIN)/uv pip compile --universal --python-version 3.11 --generate-hashes --no-annotate \
	--no-strip-extras --custom-compile-command "make lock" $(LOCK) --no-emit-package robokin \
	--no-emit-package robokin-workshop --no-emit-package robokin-book

lock: $(READY)
	$(LOCKED) requirements.in -o requirements.txt
	$(LOCKED) -c requirements.txt requirements-light.in -o requirements-light.txt

# Two environments of their own, from the dependency groups in pyproject.toml: the peers that
# robokin is timed against, and the lowest versions that the wheels say they work with.

.venv-bench/.ready: $(READY)
	$(PYTHON) -m venv .venv-bench
	$(INSTALL) --group bench
	$(INSTALL) --no-deps -e .
	@touch $@

bench: .venv-bench/.ready
	.venv-bench/bin/pytest benchmarks

.venv-lowest/.ready: $(READY) $(SOURCES)
	$(PYTHON) -m venv .venv-lowest
	$(INSTALL) --resolution lowest-direct --refresh --reinstall "./[draw]" "./workshop[engine]" ./book
	@$(BIN)/uv pip freeze --python $(@D)/bin/python | grep -v "file:" > .venv-lowest/found.txt
	$(INSTALL) -c .venv-lowest/found.txt --group lowest
	@touch $@

clean:
	rm -rf _build .venv .venv-*
