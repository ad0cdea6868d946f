# make book    set everything up and build the site        make test          all tests
# make serve   look at the site                            make test T=motion   one topic
# make lab     open the notebooks in JupyterLab            make test-slow     what takes long
# make paper   the book and a poster as PDF; make book after it links them
# make notebooks, check, lock, bench, test-install, clean: see CONTRIBUTING.md

PYTHON ?= python3
T ?=

BIN := .venv/bin
# uv asks the index that pip is set to, if there is one
INDEX = UV_DEFAULT_INDEX="$${UV_DEFAULT_INDEX:-$$($(BIN)/python -m pip config list | \
	sed -n "s/.*\.index-url='\(.*\)'/\1/p" | head -n 1)}"
INSTALL = $(INDEX) $(BIN)/uv pip install --python $(@D)/bin/python
READY := .venv/.ready
SITE := _build/html/.built
SOURCES := _config.yml _toc.yml $(shell find book robokin courseware -type f \
	-not -path '*/__pycache__/*' -not -path '*/.ipynb_checkpoints/*') \
	$(wildcard _build/robokin*.pdf)

# what other projects have set would change what is installed here, and what runs
unexport PIP_PREFIX PIP_REQUIRE_HASHES PIP_TARGET PIP_USER UV_NO_BUILD UV_REQUIRE_HASHES
unexport MPLBACKEND PYTHONHOME PYTHONOPTIMIZE PYTHONPATH PYTHONWARNINGS SOURCE_DATE_EPOCH
unexport PYTHONDONTWRITEBYTECODE  # or each of many processes compiles SymPy and all else again
export LC_ALL = C.UTF-8

.PHONY: book serve lab paper test test-slow test-install check notebooks lock bench clean FORCE
.DEFAULT_GOAL := book

# .venv/.ready holds the folder and the Python: set up again after a move, for a copy, for another
STAMP := -IS -c 'import os, sys; print(os.getcwd(), sys.base_prefix, *sys.version_info[:2])'
ASKED := $(if $(filter file,$(origin PYTHON)),$(BIN)/python,$(PYTHON))
ifneq ($(shell cat .venv/.ready 2>/dev/null),$(shell $(ASKED) $(STAMP) 2>/dev/null))
$(READY): FORCE
endif

$(READY): requirements.txt $(wildcard pyproject.toml */pyproject.toml)
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
		echo "$(PYTHON) is not there, or older than Python 3.11: make PYTHON=python3.12"; exit 1; }
	@echo "Setting up .venv, once; most of the time is downloading"
	$(PYTHON) -m venv --clear .venv
	@awk '/^[a-z]/ {on = /^uv==/} on' requirements.txt > .venv/uv.txt  # as locked, with its hashes
	$(BIN)/python -m pip install -q --disable-pip-version-check --require-hashes -r .venv/uv.txt
	$(INSTALL) --require-hashes -r requirements.txt || { \
		test -w "$$HOME" || echo "$$HOME cannot be written to: make HOME=/tmp"; exit 1; }
	$(INSTALL) --no-deps --no-build-isolation -e . -e courseware -e book
	@$(BIN)/python $(STAMP) > $(READY)

$(SITE): $(READY) $(SOURCES) requirements.txt pyproject.toml
	rm -rf _build/html
	PYTHONPATH="$$PWD" "$(BIN)/jupyter-book" build book --all \
		--config _config.yml --toc "$$PWD/_toc.yml" --path-output . -W -n --keep-going
	@touch $(SITE)

book: $(SITE)
	@echo "The site is built: open _build/html/index.html, or run: make serve"

serve: $(SITE)
	@echo "Stop with Ctrl-C"
	@serve="$(BIN)/python -u -m http.server -b 127.0.0.1 -d _build/html"; \
		$$serve 8000 2>/dev/null || $$serve 0  # 8000 is taken: any other port

lab: $(READY)
	$(BIN)/jupyter lab book

paper: $(SITE)
	PYTHONPATH=tools $(BIN)/python -m paper

# The library's tests run once, against the wheel that a user installs.
LIBRARY := _build/library
UNDER_TEST := PYTHONPATH="$$PWD/$(LIBRARY)" ROBOKIN_UNDER_TEST="$$PWD/$(LIBRARY)"
PYTEST := $(UNDER_TEST) $(BIN)/pytest -n 2 --durations=10 --dist
# a worker takes a whole file, as a notebook needs it, in the order of conftest.py
FILES := loadfile --no-loadscope-reorder --nbval

$(LIBRARY)/.ready: $(READY) pyproject.toml $(wildcard robokin/*.py)
	@rm -rf $(LIBRARY)
	$(BIN)/uv pip install -q --python $(BIN)/python --no-deps --no-build-isolation \
		--target $(LIBRARY) .
	@touch $@

test: $(if $(T),,check) $(LIBRARY)/.ready
	$(PYTEST) $(FILES) $(if $(T),-k "$(T)") tests courseware/tests book

test-slow: $(LIBRARY)/.ready $(if $(filter-out paper,$(T)),,paper)
	$(PYTEST) worksteal -m slow -rs $(if $(T),-k "$(T)") tests courseware/tests book

test-install: $(LIBRARY)/.ready .venv-lowest/.ready
	$(PYTEST) worksteal -m install -rs tests
	.venv-lowest/bin/pytest -n 2 --dist $(FILES) \
		--ignore tests/robokin/test_in_pyodide.py tests/robokin book

check: $(READY)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/codespell
	$(BIN)/oxlint courseware book/_assets

notebooks: $(READY)
	$(BIN)/python tools/notebooks.py $(T)

# With their extras: pip takes a pin without them for none, as soon as there is a newer version.
LOCKED = $(BIN)/uv pip compile --universal --python-version 3.11 --generate-hashes --no-annotate \
	--no-strip-extras --custom-compile-command "make lock" $(LOCK) --no-emit-package robokin \
	--no-emit-package robokin-courseware --no-emit-package robokin-book

lock: $(READY)
	$(LOCKED) requirements.in -o requirements.txt
	$(LOCKED) -c requirements.txt requirements-light.in -o requirements-light.txt

# Two environments of their own, from the dependency groups in pyproject.toml: the peers that
# robokin is timed against, and the lowest versions that the wheels say they work with.

.venv-bench/.ready: $(READY)
	$(PYTHON) -m venv --clear .venv-bench
	$(INSTALL) --group bench
	$(INSTALL) --no-deps -e .
	@touch $@

bench: .venv-bench/.ready
	.venv-bench/bin/pytest benchmarks

.venv-lowest/.ready: $(READY) $(SOURCES)
	$(PYTHON) -m venv --clear .venv-lowest
	$(INSTALL) --resolution lowest-direct --refresh --reinstall "./[draw]" ./courseware ./book \
		"pyparsing>=3.2,<3.3"  # newer ones warn of what the lowest Matplotlib does
	@$(BIN)/uv pip freeze --python $(@D)/bin/python | grep -v "file:" > .venv-lowest/found.txt
	$(INSTALL) -c .venv-lowest/found.txt --group lowest
	@touch $@

clean:
	rm -rf _build .venv .venv-* .*_cache
	find . -name __pycache__ -prune -exec rm -rf {} +
