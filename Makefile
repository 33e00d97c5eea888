# A thin front: every target can also be run by hand, see README.md.
PYTHON     ?= /usr/bin/python3
FREECADCMD ?= freecadcmd
JOBS       ?= $(shell nproc)
# Given to CMake's configure step, e.g. CMAKE_FLAGS=-DANISOQUAD_WERROR=ON
CMAKE_FLAGS ?=

PACKAGES = g++ cmake libeigen3-dev libtbb-dev pybind11-dev libgtest-dev libbenchmark-dev \
           libocct-foundation-dev libocct-modeling-data-dev libocct-modeling-algorithms-dev libocct-data-exchange-dev \
           python3 python3-dev python3-numpy python3-meshio python3-matplotlib python3-pivy freecad freecad-python3 \
           xvfb xauth libgl1-mesa-dri calculix-ccx gmsh qttools5-dev-tools
# Of the fuzz target only.
FUZZ_PACKAGES = clang libclang-rt-14-dev
SUDO := $(shell [ "$$(id -u)" = 0 ] || echo sudo)

# Where `make install-addon` links the workbench: FreeCAD's own folder for add-ons.
ADDONS     ?= $(shell $(FREECADCMD) -c "import FreeCAD; print('addons=' + FreeCAD.getUserAppDataDir() + 'Mod')" </dev/null 2>/dev/null \
                | sed -n 's/.*addons=//p')

.PHONY: deps build translations install-addon docs demo test test-core test-python test-freecad test-gui bench bench-gmsh format fuzz-build fuzz fuzz-short test-long

# Installs packages that are not there yet: $(call install,packages)
define install
	@if dpkg-query -W -f='$${db:Status-Status} ' $(1) 2>/dev/null | tr ' ' '\n' | grep -c '^installed$$' \
	    | grep -qx $(words $(1)); then echo "deps: all installed"; else \
	    export DEBIAN_FRONTEND=noninteractive; \
	    $(SUDO) apt-get update -q && $(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install -q -y \
	        --no-install-recommends $(1) </dev/null; fi
endef

deps:
	$(call install,$(PACKAGES))

build:
	cmake --preset release $(CMAKE_FLAGS)
	cmake --build --preset release --parallel $(JOBS)
	$(MAKE) --no-print-directory translations

# Qt's compiled translations; where lrelease is missing the workbench speaks English.
translations:
	@if command -v lrelease >/dev/null; then lrelease -silent resources/translations/*.ts; \
	    else echo "translations: no lrelease (qttools5-dev-tools), left out"; fi

install-addon: build
	@test -n "$(ADDONS)" || { echo "install-addon: $(FREECADCMD) does not tell its folder; give ADDONS=…"; exit 1; }
	mkdir -p "$(ADDONS)"
	ln -sfnT "$(CURDIR)" "$(ADDONS)/AnisoQuad"

# The user's guide with the table of options, in build/docs.
docs: build
	$(PYTHON) docs/make_docs.py

demo: deps build
	$(FREECADCMD) resources/examples/wing_demo.py </dev/null

test: deps build
	ctest --preset release --parallel $(JOBS)
	$(MAKE) --no-print-directory test-core test-python test-freecad test-gui fuzz-short

# The core's tests again, with assertions and validate() after every stage.
test-core:
	cmake --preset debug $(CMAKE_FLAGS)
	cmake --build --preset debug --parallel $(JOBS)
	ctest --preset debug --parallel $(JOBS)

fuzz-build:
	$(call install,$(FUZZ_PACKAGES))
	cmake --preset fuzz $(CMAKE_FLAGS)
	cmake --build --preset fuzz --parallel $(JOBS)

# Short call stacks of allocations, or recording them takes a tenth of the time. Cases that run fast are mutated more often, or a
# few of seconds take nearly all of it.
RUN_FUZZ = ASAN_OPTIONS=malloc_context_size=4:quarantine_size_mb=16 tests/fuzz/anisoquad_fuzz \
    -max_len=200 -timeout=60 -rss_limit_mb=4096 -print_final_stats=1 -entropic_scale_per_exec_time=1

# Hours: crashes are kept in build/fuzz, the corpus that grows too. FUZZ_SECONDS=3600 ends it.
FUZZ_SECONDS ?= 28800
fuzz: fuzz-build
	mkdir -p build/fuzz/corpus
	cd build/fuzz && $(RUN_FUZZ) -fork=$(JOBS) -ignore_crashes=1 \
	    -max_total_time=$(FUZZ_SECONDS) corpus $(CURDIR)/tests/data/fuzz

# A minute from the corpus in tests/data/fuzz, of which every surface that once failed is part.
fuzz-short: fuzz-build
	mkdir -p build/fuzz/short
	cd build/fuzz && $(RUN_FUZZ) -max_total_time=60 short $(CURDIR)/tests/data/fuzz

# The property tests over thousands of generated surfaces.
test-long: build
	ANISOQUAD_CASES=400 ctest --preset release --parallel $(JOBS) -L property

test-python:
	PYTHONPATH=Mod PYTHONDONTWRITEBYTECODE=1 $(PYTHON) -m unittest discover -s tests/python -p 'test_*.py'

# -t has to come before -M: the other way round crashes Debian's FreeCAD.
test-freecad:
	PYTHONPATH=tests/freecad $(FREECADCMD) -t anisoquad_freecad_tests -M $(CURDIR) </dev/null

# In a window on a virtual screen; TESTS names a module, class or method of tests/gui.
test-gui: translations
	$(PYTHON) tests/gui/run_gui_tests.py $(TESTS)

# Surfaces of a folder beside this one are run on too, and judged by its script, where they are (see surfaces.py).
bench: deps build
	build/release/tests/benchmark/anisoquad_benchmark
	PYTHONPATH=Mod $(PYTHON) tests/benchmark/paper_table1.py
	PYTHONPATH=Mod $(PYTHON) tests/benchmark/surfaces.py
	$(FREECADCMD) tests/benchmark/cad.py </dev/null

# Against Gmsh on the same triangles, at SIZES of them: Gmsh may take long.
SIZES ?= 10000 100000
bench-gmsh: deps build
	PYTHONPATH=Mod $(PYTHON) tests/benchmark/against_gmsh.py --sizes $(SIZES)

format:
	git ls-files '*.cpp' '*.h' | xargs clang-format -i
