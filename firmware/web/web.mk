# SPDX-License-Identifier: MIT
# The walk as a WebAssembly module: firmware/web/web.c in the place of a board and of main. clang and wasm-ld are enough: it
# has no C library and imports nothing.
#   $(WEB_MODULE)  the module
# And the reference renderer with its verdict, host_tests/judges/web, by the C library of WASI, of which it imports nothing either.
#   $(WEB_JUDGE)   the module
# And what make predict counts.
#   $(WEB_COUNTER) the module
# And what a program of examples/ links beside its own object: tools/fixel/site/programs.py compiles and links each.
#   $(WEB_OWN)     the objects, in a list; beside it a header of the functions that own.c stands before

WEB_OUT := $(BUILD)/web
WEB_MODULE := $(WEB_OUT)/walk.wasm
WEB_CC := clang --target=wasm32 -O2 -std=c11 -ffreestanding -fno-builtin -Wall -Wextra -Werror
# The room of a board: two bands of a frame of 1024 x 1024 pixels of two bytes, with a depth buffer of 32 bits.
WEB_ROOM := WALK_IN_PARTS WALK_BAND_BYTES=1048576 WALK_ORDER_ENTRIES=131072 WALK_LIST_BYTES=12582912 WALK_CACHE_ENTRIES=1024
WEB_SOURCES := $(filter-out %/main.c,$(PROGRAM_SOURCES.walk)) firmware/web/web.c firmware/web/page.c boards/parts/memory_functions.c
WEB_OBJECTS = $(patsubst %.c,$(WEB_OUT)/%.o,$(WEB_SOURCES) $(filter $(LIB_SOURCES),$(patsubst %,lib/%.c,$(call LIB_NEEDED,$(WEB_SOURCES)))))

$(WEB_OUT)/%.o: %.c firmware/web/web.mk
	$(MAKE_FOLDER)
	$(SAY)
	$(FIRMWARE_QUIET)$(WEB_CC) -MMD -MP $(WEB_ROOM:%=-D%) -Ilib/include -Ilib -Iboards -Ifirmware/walk -c $< -o $@

$(WEB_MODULE): $(WEB_OBJECTS)
	$(SAY)
	$(FIRMWARE_QUIET)wasm-ld --no-entry --gc-sections --strip-all --fatal-warnings --stack-first -z stack-size=65536 $^ -o $@

WEB_JUDGE := $(WEB_OUT)/judge.wasm
WEB_JUDGE_CC := clang --target=wasm32-wasi -O2 -std=c11 -ffp-contract=off -Wall -Wextra -Werror
WEB_JUDGE_LINK := -mexec-model=reactor -nostartfiles -Wl,--no-entry,--gc-sections,--strip-all,--fatal-warnings,--stack-first,-z,stack-size=1048576
WEB_JUDGE_SOURCES := host_tests/judges/web/judge.c $(wildcard host_tests/judges/reference/*.c) \
    $(addprefix host_tests/judges/,live/answer.c judge/explain.c judge/beneath.c frames/moving_reference.c)
WEB_JUDGE_OBJECTS = $(patsubst %.c,$(WEB_OUT)/%.o,$(WEB_JUDGE_SOURCES) $(filter $(LIB_SOURCES),$(patsubst %,lib/%.c,$(call LIB_NEEDED,$(WEB_JUDGE_SOURCES)))))

$(WEB_OUT)/host_tests/%.o: host_tests/%.c firmware/web/web.mk
	$(MAKE_FOLDER)
	$(SAY)
	$(FIRMWARE_QUIET)$(WEB_JUDGE_CC) -MMD -MP $(JUDGES_SEE) -c $< -o $@

$(WEB_JUDGE): $(WEB_JUDGE_OBJECTS)
	$(SAY)
	$(FIRMWARE_QUIET)$(WEB_JUDGE_CC) $(WEB_JUDGE_LINK) $^ -o $@

# wasm-ld's --wrap would also take calls within a file, and takes no records, so the compiler gives the names: __real_ where a function that is
# counted is defined, and __wrap_ where others call it. What puts its own in the place of one has both.
WEB_COUNTER := $(WEB_OUT)/counter.wasm
WEB_COUNTER_SOURCES := $(addprefix host_tests/judges/,web/predict.c frames/session.c \
    $(addprefix predict/,$(filter-out main.c,$(notdir $(wildcard host_tests/judges/predict/*.c)))))
WEB_COUNTER_OBJECTS = $(patsubst %.c,$(WEB_OUT)/counted/%.o,$(WEB_COUNTER_SOURCES) \
    $(filter $(LIB_SOURCES),$(patsubst %,lib/%.c,$(call LIB_NEEDED,$(WEB_COUNTER_SOURCES)))))
WEB_DEFINED = sed -n -e 's/^define [^@]*@\([a-z0-9_]*\)(.*/\1/p' -e 's/^@\([a-z0-9_]*\) = [^e].*/\1/p'

# $(1): a compiler, $(2): what is wrapped.
define WEB_WRAPPED
$(MAKE_FOLDER)
$(SAY)
$(FIRMWARE_QUIET)set -e; names=; defined=" $$($(1) -Xclang -disable-llvm-passes -S -emit-llvm $< -o - | $(WEB_DEFINED) | tr '\n' ' ') "; \
for name in $(2); do \
    case "$$defined" in *" $$name "*) names="$$names -D$$name=__real_$$name" ;; *" __wrap_$$name "*) ;; *) names="$$names -D$$name=__wrap_$$name" ;; esac; done; \
$(1) -MMD -MP $$names -c $< -o $@
endef

$(WEB_OUT)/counted/%.o: %.c firmware/web/web.mk
	$(call WEB_WRAPPED,$(WEB_JUDGE_CC) $(JUDGES_SEE),$(PREDICT_WRAPPED))

$(WEB_COUNTER): $(WEB_COUNTER_OBJECTS)
	$(SAY)
	$(FIRMWARE_QUIET)$(WEB_JUDGE_CC) $(WEB_JUDGE_LINK) $^ -o $@

WEB_OWN := $(WEB_OUT)/own/objects.txt
WEB_OWN_WRAPPED := $(filter-out main,$(OWN_WRAPPED))
WEB_OWN_SOURCES := $(addprefix firmware/web/,page.c frames.c) $(filter-out %/watched.c,$(wildcard firmware/own/*.c)) boards/parts/memory_functions.c
# An exported header names more than a program of examples/ does.
WEB_OWN_OBJECTS := $(patsubst %.c,$(WEB_OUT)/own/%.o,$(WEB_OWN_SOURCES) $(filter-out lib/study/% lib/draw/offsets.c %.S,$(LIB_SOURCES)))

$(WEB_OUT)/own/%.o: %.c firmware/web/web.mk
	$(call WEB_WRAPPED,$(WEB_CC) -Oz -flto -Ilib/include -Ilib -Iboards,$(WEB_OWN_WRAPPED))

$(WEB_OWN): $(WEB_OWN_OBJECTS)
	@printf '#define %s\n' $(foreach name,$(WEB_OWN_WRAPPED),'$(name) __wrap_$(name)') >$(@D)/wrapped.h
	@printf '%s\n' $^ >$@
