# The set-up of a machine, then CMake; `make test SETUP=:` leaves the machine's packages alone.
# `make bench BENCH=--quick` has options for bench/table.py.
SETUP ?= tools/setup.sh
BUILD := build/release

all: configure
	cmake --build --preset release

demo: configure
	cmake --build --preset release --target tristim_command examples
	tools/demo.sh $(BUILD) demo

test: setup
	@tests/run.sh release

bench: configure
	cmake --build --preset release --target bench
	bench/table.py $(BUILD)/bin/tristim $(BENCH)

format: setup
	tests/lint/format.sh --fix

lint:
	$(SETUP) clang-tidy-14
	cmake --preset release -B build/lint -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON
	run-clang-tidy-14 -quiet -extra-arg=-Wno-unknown-warning-option -p build/lint \
	  '$(CURDIR)/(lib|tools|tests|bench|examples)/'

clean:
	rm -rf build demo

setup:
	@$(SETUP)

configure: setup
	cmake --preset release

.PHONY: all demo test bench format lint clean setup configure
