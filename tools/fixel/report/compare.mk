# SPDX-License-Identifier: MIT
# make compare answers 0 equal, 1 different, 2 cannot be compared. A recipe
# cannot do that: make itself answers 2 to whatever a recipe answers. So the
# comparison runs while make brings its makefiles up to date, and leaves one
# behind; make starts over (same process), finds it, and where the frames
# differ becomes "make -q", which answers 1 for a goal that is not up to date.
# Set-up is a target of its own, before that. Make brings makefiles up to date
# even with -n: then there is none to bring up to date, and the goal shows the steps.

# Without one of them there is nothing to set up; the tool says so too, but make would add two lines.
ifneq ($(if $(filter PY,$(GIVEN_BY_TESTS)),,$(if $(value A),,A)$(if $(value B),,B)),)
$(error make compare takes two PNGs, folders of PNGs, or frame dumps: make compare A=... B=...)
endif

VERDICT := $(BUILD)/compare/verdict.mk
COMPARE := $(TOOL) compare --out $(BUILD)/compare

.PHONY: set-up-tools
set-up-tools:
	@$(call LOOK_AT,compare) tools/setup.sh tools

ifneq ($(findstring n,$(filter-out --%,$(firstword -$(MAKEFLAGS)))),)
compare: set-up-tools
	@$(COMPARE)
else

ifdef MAKE_RESTARTS
-include $(VERDICT)
endif

ifeq ($(COMPARED_BY),$(shell echo $$PPID))
ifeq ($(COMPARED_EQUAL),no)
MAKEFLAGS += -q
endif
compare:
	@:
else
include $(VERDICT)
$(VERDICT): FORCE | set-up-tools
	$(MAKE_FOLDER)
	@code=0; $(COMPARE) || code=$$?; \
	case $$code in 0) equal=yes ;; 1) equal=no ;; *) exit $$code ;; esac; \
	printf 'COMPARED_BY := %s\nCOMPARED_EQUAL := %s\n' "$$PPID" "$$equal" >$@
compare: ;
endif

endif
