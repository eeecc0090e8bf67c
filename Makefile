# On a fresh Debian machine with Python 3.10 or newer: `make demo`, `make test`, `make test-ros` and `make test-page`; all
# tests, as .ci/run has them: `make --keep-going --jobs 4 --output-sync=target test test-ros test-page`.

PYTHON ?= python3
VENV   := .venv
BIN    := $(VENV)/bin
STAMP  := $(VENV)/.installed-$(shell cksum < pyproject.toml | tr -d ' ')

# Debian packages, where we may install some: one target at a time, since apt does not wait for another one.
define APT
	sudo=; test "$$(id -u)" = 0 || sudo=sudo; \
	flock /tmp/archlint-apt.lock sh -c "$$sudo apt-get update -qq && $$sudo apt-get install -qq -y $(1)"
endef

.PHONY: demo test test-page test-ros test-ros-full fuzz fuzz-readers mutants adoption adoption-public editors docs check style types layers suite clean

# A Debian without python3-venv cannot make an environment with pip in it: install that package where we may.
$(STAMP): pyproject.toml
	@test -x $(BIN)/python && $(BIN)/python -m pip --version >/dev/null 2>&1 || { rm -rf $(VENV); \
	  $(PYTHON) -m venv $(VENV) 2>/dev/null || { rm -rf $(VENV); \
	    echo "installing python3-venv, which Debian's Python lacks" >&2; \
	    sudo=; test "$$(id -u)" = 0 || sudo=sudo; \
	    $$sudo apt-get update -qq && $$sudo apt-get install -qq -y python3-venv && $(PYTHON) -m venv $(VENV); }; }
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --upgrade "pip>=25.1"
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[pictures]' --group dev
	@rm -f $(VENV)/.installed-* && touch $@

demo: $(STAMP)  ## lint a small robot and its broken twin, draw the graph
	@./scripts/demo $(BIN)/archlint

test: style types layers suite  ## all of it

style: $(STAMP)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check --quiet .

types: $(STAMP)
	$(BIN)/mypy

layers: $(STAMP)
	$(BIN)/lint-imports --no-cache

suite: $(STAMP)  ## as many tests at a time as there are processors
	$(BIN)/python -m pytest -n auto --dist worksteal

test-ros: $(STAMP)  ## against running nodes, on the ROS 2 distributions that PyPI has wheels of: two at a time
	@command -v cmake >/dev/null && command -v c++ >/dev/null || { \
	  echo "installing cmake and g++, which build interfaces" >&2; \
	  $(call APT,cmake g++); } || true
	@$(MAKE) --no-print-directory $(if $(findstring jobserver,$(MAKEFLAGS)),,--jobs 2) --keep-going --output-sync=target \
	  test-ros-jazzy test-ros-kilted

test-page: $(STAMP)  ## the HTML page in a real Chromium, which is installed where it is missing
	@command -v chromium >/dev/null || { echo "installing chromium, which opens the HTML page" >&2; \
	  $(call APT,chromium) >/dev/null; } || true
	$(BIN)/python -m pytest tests_page -rs

test-ros-full:  ## the same, each program started in every way and recorded, too
	@$(MAKE) --no-print-directory test-ros TESTS_ROS=--full

test-ros-%: $(STAMP)
	@$(BIN)/python scripts/ros_environment $*
	@test ! -d .venv-ros-$* || $(BIN)/python -m pytest tests_ros --distro $* -rs $(TESTS_ROS)

MINUTES ?= 60

fuzz: $(STAMP)  ## made-up workspaces for MINUTES=60; what fails becomes a case in tests/fuzz/cases
	$(BIN)/python -m benchmarks.fuzz --minutes $(MINUTES)

fuzz-readers: $(STAMP)  ## the readers of files under atheris, for MINUTES=60
	scripts/fuzz_readers $(BIN)/python $(MINUTES)

mutants: $(STAMP)  ## an hour: do the tests of the modules that say "wrong" notice each change of them?
	scripts/mutants $(BIN)/python

adoption: $(STAMP)  ## what a team does, with pre-commit and colcon from PyPI; WORKSPACES="…": not on the fixtures
	$(BIN)/python -m benchmarks.adoption --install $(WORKSPACES)

PUBLIC := https://github.com/BYUMarsRover/Autonomy-ROS2@bb1e719266d86001d7f1c4a05838ffdcf8c5d242 \
  https://github.com/smarc-project/smarc2@c2bd1d0ddc0217126699f87bfe7fdb2999c9c2ee

adoption-public:  ## the same on two public repositories, which git brings
	@$(MAKE) --no-print-directory adoption WORKSPACES="$(PUBLIC)"

editors: $(STAMP)  ## the snippets of editors/README.md in the editors that are here; the VS Code extension, once it is built
	$(BIN)/python -m benchmarks.editors

# The documentation site: the sources in build/docs, what a browser opens in build/docs/site.  Broken links fail.
DOCS_STAMP := .venv-docs/.installed-$(shell cksum < pyproject.toml | tr -d ' ')

$(DOCS_STAMP): $(STAMP)
	$(BIN)/python -m venv .venv-docs
	.venv-docs/bin/python -m pip install --quiet --disable-pip-version-check --upgrade "pip>=25.1"
	.venv-docs/bin/python -m pip install --quiet --disable-pip-version-check -e . --group docs
	@rm -f .venv-docs/.installed-* && touch $@

docs: $(DOCS_STAMP)
	.venv-docs/bin/python -m website build/docs
	@rm -rf build/docs/site
	cd build/docs && ../../.venv-docs/bin/zensical build --strict --config-file mkdocs.yml
	@echo "open build/docs/site/index.html"

check: test

clean:
	rm -rf $(VENV) .venv-docs .venv-ros-* .venv-adoption .venv-mutants .venv-readers demo-output dist build .pytest_cache .mypy_cache .ruff_cache .hypothesis .import_linter_cache
