# Needs git, make and python3 >= 3.11 with its venv module; everything else comes from PyPI, pinned by uv.lock.
#   make PYTHON=python3.12 test     another interpreter (after `make distclean`, if there is a .venv already)
#   make ARGS="-k walls -x" test    more arguments for pytest

PYTHON ?= python3
JOBS ?= 2
ARGS ?=
OUT ?= out/demo

UV_VERSION := 0.13.8
UV := .uv/bin/uv
BIN := .venv/bin
PYTEST := $(BIN)/python -m pytest
CODE := sceneweaver kernels optimizers tools tests benchmarks notebooks docs

# The environment is always .venv, made with the interpreter chosen here; uv never downloads one.
export UV_PROJECT_ENVIRONMENT := .venv
export UV_PYTHON_DOWNLOADS := never

# uv keeps what it fetches in the user's cache folder; where that cannot be written, beside itself.
UV_CACHE := $(or $(XDG_CACHE_HOME),$(HOME)/.cache)/uv
ifndef UV_CACHE_DIR
ifneq ($(shell mkdir -p "$(UV_CACHE)" 2>/dev/null && test -w "$(UV_CACHE)" && echo yes),yes)
export UV_CACHE_DIR := .uv/cache
endif
endif

# Written last, so that an interrupted install is not taken for a finished one; named by what was installed.
UV_READY := .uv/ready-$(UV_VERSION)
READY := .venv/ready-$(shell cat uv.lock pyproject.toml | cksum | cut -d ' ' -f 1)

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.PHONY: help install demo test bench lint format docs build clean distclean

help: ## Show this list
	@awk -F ':.*## ' '/^[a-z]+:.*## / { printf "  make %-10s %s\n", $$1, $$2 }' $(firstword $(MAKEFILE_LIST))

install: $(READY) ## Make .venv from uv.lock (the other targets do it when needed)

demo: $(READY) ## Design the demo room; results in out/demo
	$(BIN)/python -m sceneweaver.cli demo --out $(OUT)

# Tests start many programs: without bytecode each would compile all sources of the library anew.
test: export PYTHONDONTWRITEBYTECODE :=
# Workers are as many as cores: linear algebra in several threads of each would only wait for them.
test: export OPENBLAS_NUM_THREADS := 1
test: $(READY) ## Run the tests except the long ones
	$(PYTEST) -n $(JOBS) --dist loadfile $(ARGS)

bench: $(READY) ## Run the long tests and the benchmarks
	$(PYTEST) -m "slow or bench" $(ARGS) || [ $$? -eq 5 ]  # 5: there are none
	$(PYTEST) -m "hypothesis and not slow and not bench" --hypothesis-profile=whole $(ARGS) || [ $$? -eq 5 ]
	@if [ -f benchmarks/__main__.py ]; then $(BIN)/python -m benchmarks; else echo "No benchmarks yet."; fi

lint: $(READY) ## Check style, floors and types
	$(BIN)/ruff check $(wildcard $(CODE))
	$(BIN)/ruff format --check $(wildcard $(CODE))
	$(BIN)/lint-imports --no-logo
	$(BIN)/pyright

format: $(READY) ## Mend what ruff can mend by itself
	$(BIN)/ruff check --fix $(wildcard $(CODE))
	$(BIN)/ruff format $(wildcard $(CODE))

docs: $(READY) ## Build the documentation site into out/site
	NO_MKDOCS_2_WARNING=1 $(BIN)/python -m mkdocs build --strict

build: $(READY) ## Build the wheel and the source archive into dist/
	rm -rf dist
	$(BIN)/python -m build --no-isolation

clean: ## Remove what the other targets made, except .venv
	rm -rf out dist build .pytest_cache .ruff_cache .hypothesis .import_linter_cache
	find $(wildcard $(CODE)) -type d -name __pycache__ -prune -exec rm -rf {} +

distclean: clean ## Remove .venv and uv as well
	rm -rf .venv .uv

$(UV_READY):
	@command -v $(PYTHON) >/dev/null || \
	  { echo "$(PYTHON) is not installed: sceneweaver needs Python 3.11 or newer."; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo "$(PYTHON) is older than 3.11: install a newer one, then run make PYTHON=python3.12 (or its name)."; exit 1; }
	@$(PYTHON) -c 'import venv, ensurepip' 2>/dev/null || \
	  { echo "$(PYTHON) lacks the venv module: install it (Debian, Ubuntu: apt install python3-venv)."; exit 1; }
	$(PYTHON) -m venv --clear .uv
	.uv/bin/python -m pip install --quiet uv==$(UV_VERSION)
	@touch $@

$(READY): | $(UV_READY)
	@rm -f .venv/ready-*
	$(UV) sync --frozen --python "$$($(PYTHON) -c 'import sys; print(sys.executable)')"
	@touch $@
