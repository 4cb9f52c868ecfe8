# radcomp: what a person or CI does with this repository. `make` alone lists the targets.

CARGO ?= cargo
# The control profiles that `make certify` runs the built-in device against.
PROFILES ?= $(basename $(notdir $(wildcard spec/profiles/*.toml)))
# Profiles in which any two values of two parameters meet.
COMBINATIONS := $(wildcard tests/combinations/*.toml)
LEVEL ?= 1
TARGET_DIR := $(or $(CARGO_TARGET_DIR),target)
# Reports name the commit of the toolkit that wrote them.
build certify: export RADCOMP_COMMIT ?= $(shell git describe --always --dirty --abbrev=40 --exclude '*' 2>/dev/null || echo unknown)
# CI never rewrites Cargo.lock.
LOCKED := $(if $(CI),--locked)

.DEFAULT_GOAL := help
.PHONY: help setup build book test prove fuzz-smoke nightly mutants certify certify-pairs bench lint doc

help: ## List the targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  make \1\t\2/p' $(MAKEFILE_LIST) | expand -t 22

setup: ## Install the system packages that the build needs, if any is missing
	@scripts/setup

build: setup ## Build the command and every library, optimised
	$(CARGO) build $(LOCKED) --workspace --release

book: setup ## Build the specification as a book, book/index.html (BOOK=…)
	$(CARGO) build $(LOCKED) --release --bin radcomp
	"$(TARGET_DIR)/release/radcomp" book --output $(or $(BOOK),book)

test: lint doc ## Everything CI checks: format, lints, documentation, dependencies, every test
	@scripts/setup --test
	scripts/check
	scripts/test $(LOCKED)
	scripts/fuzz smoke-if-installed

prove: ## Lemmas and exhaustive searches of proofs/, with what they visited; Kani too where it is installed
	@scripts/setup --test
	scripts/prove $(LOCKED)

fuzz-smoke: ## Each fuzz target on its seeds and corpus, and 30 s more; a planted fault must be found
	@scripts/setup --test
	scripts/fuzz smoke

nightly: setup ## What takes hours: new cases for every property; every fuzz target for half an hour, findings promoted
	@scripts/setup --test
	@status=0; export PROPTEST_RNG_SEED=$$(date +%s); echo "PROPTEST_RNG_SEED=$$PROPTEST_RNG_SEED scripts/test"; \
		scripts/test || status=1; scripts/fuzz long || status=1; exit $$status

mutants: setup ## Count which small changes of the code the suite catches (PART=implementation|reader, SHARD=0/8); hours
	scripts/mutants $(or $(PART),implementation) $(if $(SHARD),--shard $(SHARD))

certify: setup ## Certify the built-in device against each profile (PROFILES=…, LEVEL=…)
	$(CARGO) build $(LOCKED) --release --bin radcomp
	@status=0; for profile in $(PROFILES); do \
		echo "$(TARGET_DIR)/release/radcomp certify builtin --profile $$profile --level $(LEVEL)"; \
		"$(TARGET_DIR)/release/radcomp" certify builtin --profile $$profile --level $(LEVEL) || status=1; \
	done; exit $$status

certify-pairs: ## The same for each profile of tests/combinations, in which any two values of parameters meet
	@$(MAKE) --no-print-directory certify PROFILES="$(COMBINATIONS)" LEVEL=$(LEVEL)

bench: setup ## Print the table of speed and size, each figure beside its reference
	$(CARGO) bench $(LOCKED) --bench speed

lint: ## Check the format and deny every lint
	@scripts/setup --lint
	@color=never; if [ -t 1 ]; then color=auto; fi; set -x; $(CARGO) fmt --all --check -- --color $$color
	$(CARGO) clippy $(LOCKED) --release --workspace --all-targets -- -D warnings

doc: setup ## Build the documentation, without warnings
	RUSTDOCFLAGS="-D warnings" $(CARGO) doc $(LOCKED) --release --workspace --no-deps
