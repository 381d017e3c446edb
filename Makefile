# SPDX-License-Identifier: MIT
# Two commands do everything: `make biaxial` and `make test`. `make help` lists all targets, from the texts after ##.
#
# The public targets first check what the machine has (.ci/packages installs what is missing). Then they call make
# again, because the compiler flags below ask pkg-config, and pkg-config may be one of the missing packages.

# As many jobs as processors, JOBS=1 for one. V=1 shows the commands of the build.
JOBS ?= $(shell nproc)
ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(JOBS)
endif
step = $(if $(V),,@printf '%-4s %s\n' $(1) $@ &&)

BUILD  ?= build/release
CFLAGS ?= -O3 -g
PREFIX ?= /usr/local
DESTDIR ?=

PKGS  := yaml-0.1 muparser jansson box2d cairo freetype2 libpng libisal
FLAGS := -Isrc -Itests -Wall -Wextra -Wpedantic -ffp-contract=off -pthread -fPIC -fvisibility=hidden -MMD -MP $(shell pkg-config --cflags $(PKGS) 2>/dev/null)
# -fno-math-errno -fno-trapping-math let square roots and comparisons become vector code; they change no value.
C_FLAGS   := -std=c17 -D_GNU_SOURCE -Werror=implicit-function-declaration -fno-math-errno -fno-trapping-math $(FLAGS) $(CFLAGS)
CXX_FLAGS := -std=c++17 -fvisibility-inlines-hidden $(FLAGS) $(CFLAGS)
# libcsv has no pkg-config file.
LIBS  := $(shell pkg-config --libs $(PKGS) 2>/dev/null) -lcsv -lm -pthread

# The commit that summary.json names. The directory is named to git, so that the repository around a tarball is not
# taken for this one.
COMMIT := $(shell git --git-dir=.git describe --always --dirty --abbrev=12 --exclude='*' 2>/dev/null || echo unknown)

LIB_SRC  := $(filter-out src/cli/% src/live/%,$(wildcard src/*/*.c)) $(wildcard src/*/*.cpp)
CLI_SRC  := $(wildcard src/cli/*.c)
TEST_SRC := $(wildcard tests/*/test_*.c)
LIB_OBJ  := $(LIB_SRC:%=$(BUILD)/%.o) $(BUILD)/src/base/math.o
CLI_OBJ  := $(CLI_SRC:%=$(BUILD)/%.o)
TESTS    := $(TEST_SRC:%.c=$(BUILD)/%)

.PHONY: all live biaxial creep definitions figures wang kuhn kuhn-film bands replay spread features bench bench-peers interop demos gallery man install-man manual verify test mutate faults random test-slurm install asan tsan fuzz lint format clean help packages-% build-all build-faults build-random run-demos run-install run-tests run-tsan
.SECONDARY:

all: packages-build ## builds ./trundle (make without a target)
	@$(MAKE) --no-print-directory build-all

biaxial: packages-build ## the 400-disk biaxial test: curves, frames, film in out/biaxial/, and beside it mu_r = 0
	@$(MAKE) --no-print-directory build-all
	./trundle run cases/biaxial.yaml -o out/biaxial --force
	./trundle run cases/biaxial.yaml -o out/biaxial-mu_r-0 --force --set contact.mu_r=0
	figures/beside/beside.sh out/biaxial-mu_r-0 out/biaxial out/biaxial-beside
	@echo "both:   out/biaxial-beside.mp4: the same sample with mu_r = 0 and 0.5 (needs ffmpeg)"
	@echo "curve:  out/biaxial/biaxial.svg and .png (needs gnuplot), numbers in out/biaxial/history.csv"
	@echo "frames: out/biaxial/frames/*.png"
	@echo "video:  out/biaxial/biaxial.mp4 (needs ffmpeg)"

# Two kinds of rolling resistance in the biaxial test, 24 samples: curves, film, verdicts. Stopped and started again it
# goes on.
creep: packages-build ## what Kuhn's two kinds of rolling resistance do, 24 samples: page in out/creep/ (2 min)
	@$(MAKE) --no-print-directory build-all
	figures/creep/creep.sh ./trundle out/creep
	@echo "page: out/creep/index.html (pictures need gnuplot, the film ffmpeg), tables: out/creep/*.csv"

# Ten seconds. Finished runs of the assembly are not run again.
definitions: packages-build ## the definitions of rolling compared: page in out/definitions/ (10 s)
	@$(MAKE) --no-print-directory build-all
	figures/definitions/definitions.sh ./trundle out/definitions
	@echo "page: out/definitions/index.html (pictures need gnuplot), tables: out/definitions/*.csv"

# Half a minute. Longer studies have their own targets: wang, bands, kuhn, replay, verify.
figures: packages-build ## the figures of figures/*.gp in out/figures/ (half a minute)
	@$(MAKE) --no-print-directory build-all $(patsubst figures/%.sh,out/figures/%.png,$(wildcard figures/*.sh))

# Wang's Figs. 5 and 6 with a verdict on each claim. Continues with the finished runs; SEEDS=4 is quick.
SEEDS ?= 32
wang: packages-build ## Wang's Figs. 5 and 6 with verdicts: out/wang/ (20 min; SEEDS=3 is quick)
	@$(MAKE) --no-print-directory build-all
	figures/wang/wang.sh ./trundle out/wang $(SEEDS)

# Kuhn's assemblies with a verdict on each trend. Continues with the finished runs; DISKS=400 is quicker than 4096,
# Kuhn's number. Two runs at a time; the four runs of disks take less than half an hour on two processors, small spheres
# take hours.
DISKS ?= 4096
kuhn: packages-build ## Kuhn's assemblies with verdicts: out/kuhn-4096/ (hours; DISKS=400 is quicker)
	@$(MAKE) --no-print-directory build-all
	figures/kuhn/kuhn.sh ./trundle out/kuhn-$(DISKS) $(DISKS)

# Two or three minutes. Runs that are there are not run again.
kuhn-film: packages-build ## how contacts of Kuhn's assemblies slip, roll and creep: out/kuhn-film/ (3 min)
	@$(MAKE) --no-print-directory build-all
	figures/kuhn/film.sh ./trundle out/kuhn-film
	@echo "film: out/kuhn-film/slip-fields.mp4 (needs ffmpeg), still: slip-fields.png (needs gnuplot), numbers: classes.csv, correlations.csv"

# Measures again each time. It is not part of `figures`, because it takes a quarter of a minute and its result differs
# between runs.
features: packages-build ## what each feature and each law costs: out/figures/features.png (15 s)
	@$(MAKE) --no-print-directory build-all
	@$(MAKE) --no-print-directory --what-if figures/features.gp out/figures/features.png

# Minutes.
bands: packages-build ## 10,000 disks without and with rolling resistance: shear bands (minutes)
	@$(MAKE) --no-print-directory build-all
	@$(MAKE) --no-print-directory out/figures/shear-bands.png

# Some 25 minutes of a processor. Measures the table of src/study/spread.c again, and tests its intervals. Continues
# with the finished runs.
spread: packages-build ## how strength scatters between seeds: the table for the +- of a run (25 min of a processor)
	@$(MAKE) --no-print-directory build-all
	figures/spread/spread.sh ./trundle out/spread

# What each number of the shipped cases is good to, as a block of comment at the end of the case. Continues with the finished runs.
BUDGET ?= 10min
converge: packages-build ## the errors of the shipped cases, written into cases/*.yaml as comments (half an hour; BUDGET=10min of each)
	@$(MAKE) --no-print-directory build-all
	@mkdir -p out/converge
	figures/converge/comments.sh ./trundle out/converge $(BUDGET) $(patsubst %,cases/%.yaml,$(filter-out $(SLOPES),$(DEMOS))) cases/biaxial.yaml

# Many minutes. Continues with the finished runs.
replay: packages-build ## contacts of three assemblies compared with the exact half-plane: out/replay/ (10 min or more)
	@$(MAKE) --no-print-directory build-all
	figures/replay/replay.sh ./trundle out/replay

# Minutes. Measures again each time, too.
bench: packages-build ## time of a step of 100 to 1,000,000 disks: out/figures/bench.png (minutes)
	@$(MAKE) --no-print-directory build-all
	@$(MAKE) --no-print-directory --what-if figures/bench.gp out/figures/bench.png

# One or two minutes. LAMMPS is not installed for it.
bench-peers: packages-build ## the same packing here and in LAMMPS, if that is installed (2 min)
	@$(MAKE) --no-print-directory build-all
	@mkdir -p out/figures
	tests/bench/peers.sh ./trundle out/figures/peers.csv

# None of them is installed for it.
interop: packages-build ## what other codes compute that are installed (LAMMPS, LIGGGHTS, YADE): out/interop/ (1 min)
	@$(MAKE) --no-print-directory build-all
	tests/interop/interop.sh ./trundle out/interop

# What fails does not keep the others away, and is tried again the next time.
demos: packages-build ## all cases of a few bodies into out/demos/, those that have changed
	@$(MAKE) --no-print-directory -k run-demos

# The page shows what failed too, so it is made in any case. A second make: only then the results are there to be listed.
gallery: packages-gallery ## the demos as one page for a lecture: out/gallery/index.html; GALLERY_LANG=de: in German
	@$(MAKE) --no-print-directory -k run-demos run-experts $(RUNS)/map.json; code=$$?; \
	    $(MAKE) --no-print-directory $(GALLERY)/index.html || code=$$?; exit $$code
	@echo "page: $(GALLERY)/index.html, to take along: $(GALLERY).zip (needs zip)"

man: packages-man ## man pages of trundle and each command: out/man/*.1
	@$(MAKE) --no-print-directory build-all
	@$(MAKE) --no-print-directory $(OUT)/man/trundle.1
	@echo "pages: $(OUT)/man/*.1, to read one: man -l $(OUT)/man/trundle-run.1"

manual: packages-manual ## one book of all pages with pictures: out/manual/index.html
	@$(MAKE) --no-print-directory build-all
	figures/manual/build.sh ./$(TRUNDLE) $(OUT)/manual
	@echo "book: $(OUT)/manual/index.html"

live: packages-live ## one page to touch, with the same laws inside: out/live/index.html
	@$(MAKE) --no-print-directory $(OUT)/live/index.html
	@echo "page: $(OUT)/live/index.html, to take along: $(OUT)/live.zip (needs zip)"

# Minutes. The figures show what failed too.
verify: packages-build ## comparison with answers from elsewhere, error against run time: out/verify/ (minutes)
	@$(MAKE) --no-print-directory build-all
	./trundle verify exact precision stability -o out/verify; code=$$?; \
	    gnuplot -d -e 'dir = "out/verify"' figures/verify/precision.gp; \
	    gnuplot -d -e 'dir = "out/verify"' figures/verify/precision-page.gp; \
	    gnuplot -d -e 'set output "out/verify/stability.png"; set terminal pngcairo size 1350,1080 font "DejaVu Sans,20" enhanced' \
	        figures/verify/stability.gp; exit $$code
	@echo "tables: out/verify/verify.csv, points.csv; figures: out/verify/precision*.png, stability.png (need gnuplot)"

test: packages-test ## all tests; last line: N passed, N failed
	@$(MAKE) --no-print-directory run-tests

# Does a change of the code go unseen? Some 150 of them one at a time, in a copy of the tree; half an hour.
mutate: packages-test ## changes signs and factors one at a time: which test sees it? (half an hour)
	@$(MAKE) --no-print-directory build-all
	tests/mutate/mutate.sh

# Every allocation and every call to the system that fails, one at a time: half an hour on two cores. STRIDE=10 takes a
# tenth of them; make test a part.
STRIDE ?= 1
faults: packages-test ## every allocation and system call fails in turn (half an hour; STRIDE=10 for a tenth)
	@$(MAKE) --no-print-directory build-all build-faults
	tests/faults/faults.sh $(TRUNDLE) $(BUILD)/tests/faults $(STRIDE)

# N random scenes with threads and stops; of what goes wrong the scene and its files stay in out/random/. Another SEED,
# other scenes.
N    ?= 200
SEED ?= 1
random: packages-test ## N=200 random scenes, SEED=1; what goes wrong stays in out/random/ (1 min)
	@$(MAKE) --no-print-directory build-random
	@mkdir -p $(OUT)/random
	$(BUILD)/random $(OUT)/random $(N) $(SEED)

# The job array of cases/cluster/ on a Slurm of one node that the test brings up; needs root.
test-slurm: packages-slurm ## a sweep as a job array on a Slurm of one node; needs root
	@$(MAKE) --no-print-directory build-all
	TRUNDLE=$(abspath $(TRUNDLE)) tests/cluster/slurm.sh

# The same tests under the address and undefined-behaviour sanitizers: of gcc, and of clang where it is, which sees
# other faults.
SANITIZE := CFLAGS='-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=undefined'
asan: packages-test ## the tests under the address and undefined-behaviour sanitizers
	@$(MAKE) --no-print-directory run-tests BUILD=build/asan TRUNDLE=build/asan/trundle $(SANITIZE)
	@if .ci/packages has clang clang:asan; then \
	    $(MAKE) --no-print-directory run-tests BUILD=build/asan-clang TRUNDLE=build/asan-clang/trundle CC=clang CXX=clang++ $(SANITIZE); \
	else echo 'without clang: it or libclang-rt-dev is not installed'; fi

# Races of threads, told by clang's sanitizer.
tsan: packages-tsan ## threads under the thread sanitizer
	@$(MAKE) --no-print-directory build-all
	@$(MAKE) --no-print-directory run-tsan BUILD=build/tsan PLAIN=$(TRUNDLE) CC=clang CXX=clang++ CFLAGS='-O1 -g -fsanitize=thread'

# Each reader is fed with what libFuzzer makes of the inputs in tests/fuzz/corpus, for so many seconds.
SECONDS ?= 60
fuzz: packages-fuzz ## hostile input for every reader, SECONDS=60 each; inputs that fail are kept in build/fuzz/found/
	@$(MAKE) --no-print-directory run-fuzz BUILD=build/fuzz CC=clang CXX=clang++ \
	    CFLAGS='-O1 -g -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined'

# Without help2man there are no man pages; the rest is installed all the same.
install: all ## PREFIX=/usr/local DESTDIR=: trundle, the library, the cases, man pages, completion for bash
	@$(MAKE) --no-print-directory run-install
	@if .ci/packages man; then $(MAKE) --no-print-directory install-man; else echo 'without man pages: no help2man'; fi
run-install: $(TRUNDLE) $(BUILD)/api/libtrundle.so $(BUILD)/api/libtrundle.a
	install -D -m 755 $(TRUNDLE) $(DESTDIR)$(PREFIX)/bin/trundle
	install -d $(DESTDIR)$(PREFIX)/share/trundle/cases $(DESTDIR)$(PREFIX)/lib/pkgconfig
	install -m 644 cases/*.yaml $(DESTDIR)$(PREFIX)/share/trundle/cases/
	install -D -m 644 src/cli/completion.bash $(DESTDIR)$(PREFIX)/share/bash-completion/completions/trundle
	install -D -m 644 src/trundle.h $(DESTDIR)$(PREFIX)/include/trundle.h
	install -m 644 $(BUILD)/api/libtrundle.a $(DESTDIR)$(PREFIX)/lib/
	install -m 755 $(BUILD)/api/libtrundle.so $(DESTDIR)$(PREFIX)/lib/libtrundle.so.0
	ln -sf libtrundle.so.0 $(DESTDIR)$(PREFIX)/lib/libtrundle.so
	@[ -n "$(DESTDIR)" ] || ldconfig 2>/dev/null || true
	printf '%s\n' 'prefix=$(PREFIX)' 'Name: trundle' 'Description: 2D disks with laws of friction, rolling resistance and creep' \
	    'Version: $(VERSION)' 'Cflags: -I$${prefix}/include' 'Libs: -L$${prefix}/lib -ltrundle' 'Requires.private: $(API_PKGS)' \
	    'Libs.private: -lstdc++ -lm -lpthread' >$(DESTDIR)$(PREFIX)/lib/pkgconfig/trundle.pc

lint: packages-lint ## clang-tidy and cppcheck
	clang-tidy --quiet $(LIB_SRC) $(CLI_SRC) -- -D_GNU_SOURCE -Isrc $(shell pkg-config --cflags $(PKGS) 2>/dev/null)
	cppcheck --quiet --enable=warning,performance,portability --inline-suppr --error-exitcode=1 \
	    --suppress=missingIncludeSystem -D_GNU_SOURCE -DTR_LINT -Isrc src

format: ## clang-format on all sources
	clang-format -i $(wildcard src/*/*.[ch] src/*/*.cpp tests/*.h tests/*/*.[ch] src/live/page/*.mjs tests/live/*.mjs)

clean: ## removes build/, out/ and ./trundle
	rm -rf build out trundle

help: ## this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / {printf "make %-12s %s\n", $$1, $$2}' $(firstword $(MAKEFILE_LIST))
	@echo 'Missing Debian packages are installed. make V=1 shows the commands of the build.'

packages-%:
	@.ci/packages $*

# ---- the steps of the targets above --------------------------------------------------------------------------------

TRUNDLE ?= trundle
build-all: $(TRUNDLE)

trundle: $(BUILD)/trundle
	@cp $< $@
$(BUILD)/trundle: $(CLI_OBJ) $(BUILD)/libtrundle.a
	$(call step,LINK) $(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)
# The functions of src/base/math.h out of musl, and what they need, in one object that shows nothing else.
MUSL := $(firstword $(wildcard /usr/lib/$(shell uname -m)-linux-musl*/libc.a))
MATH := $(shell sed -n '/^double tr_/ { s///; s/[^a-z0-9].*//; p; }' src/base/math.h)
$(BUILD)/src/base/math.o: src/base/math.h $(MUSL)
	@mkdir -p $(@D)
	$(call step,LD) $(LD) -r --gc-sections $(MATH:%=-u %) -o $@ $(MUSL) && \
	    objcopy $(foreach f,$(MATH),--redefine-sym $f=tr_$f) $@ && objcopy --wildcard --keep-global-symbol='tr_*' $@
$(BUILD)/libtrundle.a: $(LIB_OBJ)
	@rm -f $@
	$(call step,AR) ar rcs $@ $^
# The public library: only the names of src/trundle.h are seen, in the archive too.
API_PKGS := yaml-0.1 muparser box2d
API_OBJ  := $(filter $(foreach part,api base broad core laws patch scene,$(BUILD)/src/$(part)/%),$(LIB_OBJ))
VERSION  := $(shell sed -n 's/.*TR_VERSION "\(.*\)".*/\1/p' src/base/version.h)
$(BUILD)/api/libtrundle.so: $(API_OBJ) src/api/names.map
	@mkdir -p $(@D)
	$(call step,LINK) $(CXX) $(CFLAGS) $(LDFLAGS) -shared -Wl,-soname,libtrundle.so.0 -Wl,--version-script=src/api/names.map -Wl,--no-undefined \
	    -o $@ $(API_OBJ) $(shell pkg-config --libs $(API_PKGS) 2>/dev/null) -lm -pthread
$(BUILD)/api/libtrundle.a: $(API_OBJ)
	@mkdir -p $(@D) && rm -f $@
	$(call step,AR) $(LD) -r -o $(@:.a=.o) $^ && objcopy --wildcard --keep-global-symbol='trundle_*' $(@:.a=.o) && ar rcs $@ $(@:.a=.o)
$(BUILD)/%.c.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(call step,CC) $(CC) $(C_FLAGS) -c -o $@ $<
$(BUILD)/%.cpp.o: %.cpp $(BUILD)/flags
	@mkdir -p $(@D)
	$(call step,CXX) $(CXX) $(CXX_FLAGS) -c -o $@ $<
# Other compiler flags: all objects are compiled again.
FLAGS_NOW := $(strip $(CC) $(C_FLAGS) $(CXX) $(CXX_FLAGS))
$(BUILD)/flags:
	@mkdir -p $(@D)
	@printf '%s\n' '$(subst ','\'',$(FLAGS_NOW))' >$@
ifneq ($(FLAGS_NOW),$(file <$(BUILD)/flags))
.PHONY: $(BUILD)/flags
endif
# Another commit: only this object is compiled again.
$(BUILD)/src/base/commit.c.o: $(BUILD)/commit
$(BUILD)/src/base/commit.c.o: C_FLAGS += -DTR_COMMIT='"$(COMMIT)"'
$(BUILD)/commit:
	@mkdir -p $(@D)
	@echo $(COMMIT) >$@
ifneq ($(COMMIT),$(file <$(BUILD)/commit))
.PHONY: $(BUILD)/commit
endif

$(BUILD)/tests/%: $(BUILD)/tests/%.c.o $(BUILD)/libtrundle.a
	$(call step,LINK) $(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS) -lcmocka

# The tests of the reader of cases, with what the page has in place of libyaml and muParser.
PAGE_TESTS := $(patsubst %,$(BUILD)/tests/live/page_%,scene expression bad_cases)
TESTS      += $(PAGE_TESTS)
$(BUILD)/live/tree.o: src/scene/tree.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(call step,CC) $(CC) -Isrc/live $(C_FLAGS) -c -o $@ $<
$(PAGE_TESTS): $(BUILD)/tests/live/page_%: $(BUILD)/tests/scene/test_%.c.o $(BUILD)/live/tree.o $(BUILD)/src/live/yaml.c.o \
        $(BUILD)/src/live/formula.c.o $(BUILD)/libtrundle.a
	$(call step,LINK) $(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS) -lcmocka

# This test counts allocations.
$(BUILD)/tests/core/test_allocation: LDFLAGS += -Wl,--wrap=malloc,--wrap=aligned_alloc,--wrap=calloc,--wrap=realloc

# In this one no thread is to be had.
$(BUILD)/tests/base/test_threads_run: LDFLAGS += -Wl,--wrap=pthread_create

# This one reads what is drawn.
$(BUILD)/tests/study/test_inset_numbers: LDFLAGS += -Wl,--wrap=tr_draw_biaxial

# This one reads the letters of pictures.
$(BUILD)/tests/draw/test_class: LDFLAGS += -Wl,--wrap=cairo_set_font_size,--wrap=cairo_show_text

# In this one calls fail.
$(BUILD)/tests/base/test_checkpoint: LDFLAGS += -Wl,--wrap=openat,--wrap=write,--wrap=fsync,--wrap=close,--wrap=renameat,--wrap=unlinkat

# Random scenes, and how a run is stopped.
RANDOM_OBJ := $(patsubst %,$(BUILD)/%.o,$(wildcard tests/random/*.c) src/cli/stop.c)
build-random: $(BUILD)/random
$(BUILD)/random: $(RANDOM_OBJ) $(BUILD)/libtrundle.a
	$(call step,LINK) $(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)

# What lets calls fail in a program as it is, tests/faults/.
build-faults: $(BUILD)/tests/faults/memory.so $(BUILD)/tests/faults/calls $(BUILD)/tests/faults/one
$(BUILD)/tests/faults/memory.so: tests/faults/memory.c
	@mkdir -p $(@D)
	$(call step,CC) $(CC) -std=c17 -D_GNU_SOURCE -Wall -Wextra -Wpedantic -O1 -shared -fPIC -o $@ $<
$(BUILD)/tests/faults/one: FAULT_LIBS := $(shell pkg-config --libs libpng 2>/dev/null)
$(BUILD)/tests/faults/calls $(BUILD)/tests/faults/one: $(BUILD)/tests/faults/%: tests/faults/%.c
	@mkdir -p $(@D)
	$(call step,CC) $(CC) -std=c17 -D_GNU_SOURCE -Wall -Wextra -Wpedantic -O1 -o $@ $< $(FAULT_LIBS)

# A fuzz target is driven by replay.c, which reads files, or by libFuzzer.
FUZZ := $(patsubst tests/fuzz/fuzz_%.c,%,$(wildcard tests/fuzz/fuzz_*.c))
$(BUILD)/tests/fuzz/replay_%: $(BUILD)/tests/fuzz/fuzz_%.c.o $(BUILD)/tests/fuzz/replay.c.o $(BUILD)/libtrundle.a
	$(call step,LINK) $(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)
$(BUILD)/fuzz_%: $(BUILD)/tests/fuzz/fuzz_%.c.o $(BUILD)/libtrundle.a
	$(call step,LINK) $(CXX) $(CFLAGS) -fsanitize=fuzzer $(LDFLAGS) -o $@ $^ $(LIBS)
# Only threads, then few and many disks with 2 and 3 of them, then whole runs.
TSAN := $(BUILD)/tests/base/test_threads_run $(BUILD)/tests/core/test_threads
run-tsan: $(BUILD)/trundle $(TSAN)
	@for test in $(TSAN); do $$test || exit 1; done
	@tests/tsan/run.sh $(PLAIN) $(BUILD)/trundle

run-fuzz: $(FUZZ:%=$(BUILD)/fuzz_%)
	@tests/fuzz/run.sh $(BUILD) $(SECONDS) $(FUZZ)

# A figure is figures/NAME.sh, which writes its data as CSV, and figures/NAME.gp, which draws them.
define draw
	gnuplot -d -e 'csv = "$(@:.png=.csv)"; set output "$(@:.png=.svg)"' \
	    -e 'set terminal svg size 900,720 font "DejaVu Sans,17" enhanced rounded background "#ffffff"' $(@:out/%.png=%.gp)
	gnuplot -d -e 'csv = "$(@:.png=.csv)"; set output "$@"' \
	    -e 'set terminal pngcairo size 1350,1080 font "DejaVu Sans,20" enhanced rounded linewidth 1.5' $(@:out/%.png=%.gp)
endef
out/figures/%.png: figures/%.sh figures/%.gp $(wildcard figures/*.yaml) $(TRUNDLE)
	@mkdir -p $(@D)
	$< ./$(TRUNDLE) >$(@:.png=.csv)
	$(draw)
out/figures/features.png: figures/features.gp $(TRUNDLE)
	@mkdir -p $(@D)
	./$(TRUNDLE) bench --features -o $(@:.png=.csv)
	$(draw)
out/figures/bench.png: figures/bench.gp $(TRUNDLE)
	@mkdir -p $(@D)
	./$(TRUNDLE) bench --sizes 1000000 -o $(@:.png=.csv)
	$(draw)

out/bands/mu_r-%/summary.json: cases/shear-bands.yaml $(TRUNDLE)
	./$(TRUNDLE) run $< -o $(@D) --force --set contact.mu_r=$*
out/figures/shear-bands.png: $(wildcard figures/bands/*) out/bands/mu_r-0/summary.json out/bands/mu_r-0.5/summary.json
	@mkdir -p $(@D)
	figures/bands/shear-bands.sh out/bands $@

# A demonstration is a case; its mark, NAME.done, says that it ran without an error. DEMO_FLAGS: for trundle run. The slopes are
# made from cases/incline.yaml. The page has the pictures of bodies for an expert too, and a map of slopes. GALLERY_LANG=de: in German.
OUT   := out
GALLERY_LANG ?= en
ifneq ($(GALLERY_LANG),en)
DEMO_FLAGS += --lang $(GALLERY_LANG)
IN := -$(GALLERY_LANG)
endif
RUNS    := $(OUT)/demos$(IN)
GALLERY := $(OUT)/gallery$(IN)
SLOPES  := $(shell figures/gallery/slopes.sh --list)
DEMOS   := $(filter-out biaxial% kuhn% sweep% shear-bands,$(patsubst cases/%.yaml,%,$(wildcard cases/*.yaml))) $(SLOPES)
EXPERTS  = $(filter $(SLOPES) $(patsubst cases/%.yaml,%,$(shell grep -l '^kind: bodies' cases/*.yaml)),$(DEMOS))
run-demos: $(DEMOS:%=$(RUNS)/%.done)
run-experts: $(EXPERTS:%=$(RUNS)/expert/%.done)
$(SLOPES:%=$(RUNS)/%.done): $(RUNS)/%.done: $(RUNS)/cases/%.yaml $(TRUNDLE)
	$(abspath $(TRUNDLE)) run $< -o $(@:.done=) --force $(DEMO_FLAGS)
	@touch $@
$(SLOPES:%=$(RUNS)/expert/%.done): $(RUNS)/expert/%.done: $(RUNS)/cases/%.yaml $(TRUNDLE)
	$(abspath $(TRUNDLE)) run $< -o $(@:.done=) --force $(DEMO_FLAGS) --set output.view=expert
	@touch $@
$(RUNS)/cases/%.yaml: cases/incline.yaml figures/gallery/slopes.sh
	@mkdir -p $(@D)
	figures/gallery/slopes.sh $* >$@
$(RUNS)/%.done: cases/%.yaml $(TRUNDLE)
	$(abspath $(TRUNDLE)) run $< -o $(@:.done=) --force $(DEMO_FLAGS)
	@touch $@
$(RUNS)/expert/%.done: cases/%.yaml $(TRUNDLE)
	$(abspath $(TRUNDLE)) run $< -o $(@:.done=) --force $(DEMO_FLAGS) --set output.view=expert
	@touch $@
$(RUNS)/map.json: cases/incline.yaml figures/gallery/map.sh $(TRUNDLE)
	@mkdir -p $(@D)
	figures/gallery/map.sh $(abspath $(TRUNDLE)) $(@:.json=) >$@.part && mv $@.part $@
$(GALLERY)/index.html: $(wildcard figures/gallery/* src/draw/words_*.h $(RUNS)/*/summary.json $(RUNS)/map.json)
	GALLERY_LANG=$(GALLERY_LANG) figures/gallery/build.sh $(RUNS) $(GALLERY) $(DEMOS)

# The library for WebAssembly, without what a page has not: files, threads, Box2D, libyaml and muParser. src/live/ has what takes
# their place. Of one and the same flags, but those of src/live/wasm.c.
WASM     := $(BUILD)/wasm
WASM_SRC := $(filter-out src/base/program.c src/base/threads.c,$(wildcard $(patsubst %,src/%/*.c,base scene laws core patch api live))) \
            src/broad/pairs.c src/study/inside.c
WASM_OBJ := $(WASM_SRC:%=$(WASM)/%.o)
WASM_CC  := clang-14 --target=wasm32-wasi
$(WASM)/src/live/wasm.c.o: WASM_FLAGS := -fno-builtin
$(WASM)/%.c.o: %.c
	@mkdir -p $(@D)
	$(call step,WASM) $(WASM_CC) -O3 -msimd128 -ffp-contract=off -std=c17 -D_GNU_SOURCE -fno-math-errno -fno-trapping-math -Wall -Wextra -Wpedantic -Isrc -Isrc/live \
	    -include src/live/wasi.h -MMD -MP $(WASM_FLAGS) -c -o $@ $<
$(WASM)/live.wasm: $(WASM_OBJ)
	$(call step,LINK) $(WASM_CC) -mexec-model=reactor -Wl,--gc-sections,--strip-all,-z,stack-size=1048576 -o $(@:.wasm=.big) $^ && \
	    wasm-opt -O3 --enable-simd --enable-sign-ext --enable-bulk-memory -o $@ $(@:.wasm=.big)
$(OUT)/live/index.html: $(WASM)/live.wasm $(wildcard src/live/page/*)
	@mkdir -p $(@D)
	src/live/build.sh $< $@
	@rm -f $(@D).zip && if command -v zip >/dev/null; then cd $(@D) && zip -q ../live.zip index.html; fi

$(OUT)/man/trundle.1: src/cli/man.sh $(TRUNDLE)
	$< $(TRUNDLE) $(@D)
install-man: $(OUT)/man/trundle.1
	install -d $(DESTDIR)$(PREFIX)/share/man/man1
	install -m 644 $(OUT)/man/*.1 $(DESTDIR)$(PREFIX)/share/man/man1/

# Two tests use the page's library. It is made before them, because they may run at the same time.
WASM_TOOLS := clang-14 wasm-ld-14 wasm-opt file:/usr/include/wasm32-wasi/stdio.h wasm-rt
WASM_READY  = $(if $(filter run-tests,$(MAKECMDGOALS)),$(shell .ci/packages has $(WASM_TOOLS) && echo yes))
run-tests: $(TRUNDLE) $(TESTS) $(if $(WASM_READY),$(WASM)/live.wasm) $(BUILD)/tests/live/native build-faults build-random $(FUZZ:%=$(BUILD)/tests/fuzz/replay_%)
	@BUILD=$(abspath $(BUILD)) FAULTS=$(abspath $(BUILD)/tests/faults) RANDOM_SCENES=$(abspath $(BUILD)/random) tests/run $(TRUNDLE) $(TESTS)

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
