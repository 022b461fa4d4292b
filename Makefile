# One command each, the same on a laptop and in CI.  `make help` lists them.
SHELL := /bin/bash
.DELETE_ON_ERROR:
.DEFAULT_GOAL := help

DEMO_SECONDS ?= 0
MODBUS_PORT  ?= 1502
MODE         ?= led
FUZZ_SECONDS ?= 20
JOBS         ?= $(shell nproc)
RUN          := build/host-venv/bin
# One compiler cache for every checkout of this machine.
export CCACHE_DIR ?= $(HOME)/.cache/tripoint/ccache
export CCACHE_BASEDIR := $(CURDIR)
export CCACHE_NOHASHDIR := true

.PHONY: help
help: ## list the commands
	@grep -hE '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/^([a-z-]+):.*## (.*)/  make \1\t\2/' | expand -t 24

.PHONY: setup
setup: ## install what is missing to build and run (deploy/dev/packages.txt)
	@deploy/dev/install build python
	@deploy/dev/python

.PHONY: build
build: setup ## build tripointd and host-tool into build/bin
	@cmake --preset release >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }
	@cmake --build build/release -j $(JOBS) --target tripointd tripoint-render
	@ln -sfn ../release/bin/tripointd build/bin/tripointd
	@ln -sfn ../release/bin/tripoint-render build/bin/tripoint-render

.PHONY: demo
demo: build ## watch a measured pose follow the truth on simulated cameras (DEMO_SECONDS=20 ends by itself; MODE=apriltag: tags)
	@deploy/dev/demo $(MODBUS_PORT) $(DEMO_SECONDS) $(MODE)

.PHONY: check
check: setup ## the quick loop: format, lint, types, layers, sizes, register map
	@deploy/dev/install test
	@deploy/dev/check

.PHONY: test
test: build check ## everything that needs no special machine
	@tests/run unit
	@tests/run host
	@tests/run system
	@tests/run tidy
	@tests/run asan
	@tests/run tsan
	@FUZZ_SECONDS=$(FUZZ_SECONDS) tests/run fuzz
	@tests/run summary

.PHONY: fuzz
fuzz: setup ## fuzz every outside door for FUZZ_SECONDS each
	@deploy/dev/install test
	@FUZZ_SECONDS=$(FUZZ_SECONDS) tests/run fuzz

.PHONY: coverage
coverage: setup ## the share of lines that the unit tests reach, room by room
	@deploy/dev/install coverage
	@tests/run coverage

.PHONY: bench
bench: build ## measure the figures of the product; writes build/bench.json
	@deploy/dev/install bench
	@cmake --build build/release -j $(JOBS) >build/build-bench.log || { tail -n 40 build/build-bench.log; exit 1; }
	@$(RUN)/python firmware/bench/run.py build/release/bin build/bench.json

.PHONY: hardware-test
hardware-test: build ## real V4L2 drivers in a virtual machine
	@deploy/dev/install hardware
	@cmake --build build/release -j $(JOBS) --target uvc_camera
	@ln -sfn ../release/bin/uvc_camera build/bin/uvc_camera
	@tests/run hardware

.PHONY: test-trixie
test-trixie: ## build and test the C++ in a Debian 13 chroot
	@deploy/dev/install trixie
	@tests/run trixie

.PHONY: docs
docs: setup ## make the generated reference pages anew
	@$(RUN)/python cmake/registers.py docs

.PHONY: pictures
pictures: build ## draw the plots of docs/pictures anew, from what the programs measure in rendered pictures
	@deploy/dev/python pictures
	@cmake --build build/release -j $(JOBS) --target draw_calibrations >build/build-pictures.log || { tail -n 40 build/build-pictures.log; exit 1; }
	@build/pictures-venv/bin/python deploy/dev/pictures/draw.py build/release/bin docs/pictures

.PHONY: hook
hook: setup ## from now on run make check before each commit (pre-commit)
	@deploy/dev/install hook
	@pre-commit install

.PHONY: format
format: setup ## format everything
	@deploy/dev/install test
	@git ls-files '*.cpp' '*.h' | xargs clang-format-14 -i
	@$(RUN)/ruff format --quiet host tests cmake firmware/bench deploy/dev/pictures

.PHONY: clean
clean: ## remove what was built
	@rm -rf build
