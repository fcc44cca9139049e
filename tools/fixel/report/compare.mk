# SPDX-License-Identifier: MIT
# make compare answers 0 equal, 1 different, 2 cannot be compared. A recipe
# cannot do that: make itself answers 2 to whatever a recipe answers. So the
# comparison runs while make brings its makefiles up to date, and leaves one
# behind; make starts over (same process), finds it, and where the frames
# differ becomes "make -q", which answers 1 for a goal that is not up to date.
# Where nothing could be compared the recipe leaves none, and the goal fails. Make brings makefiles up to date
# even with -n: then there is none to bring up to date, and the goal shows the steps.

# Without one of them there is nothing to set up; the tool says so too, but make would add a line.
COMPARED_LACKS := $(if $(filter PY,$(GIVEN_BY_TESTS)),,$(if $(value A),$(if $(value B),,B),A))
ifneq ($(COMPARED_LACKS),)
$(error $(COMPARED_LACKS)= is missing: make compare A=... B=... takes two PNGs, folders of PNGs, or frame dumps)
endif

VERDICT := $(BUILD)/compare/verdict.mk
COMPARE := $(TOOL) compare --out $(BUILD)/compare

ifneq ($(findstring n,$(filter-out --%,$(firstword -$(MAKEFLAGS)))),)
compare:
	@$(SET_UP) tools
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
-include $(VERDICT)
$(VERDICT): FORCE
	@$(call LOOK_AT,compare) tools/setup.sh tools || exit 0; code=0; $(COMPARE) || code=$$?; \
	case $$code in 0) equal=yes ;; 1) equal=no ;; *) exit 0 ;; esac; \
	mkdir -p $(@D); printf 'COMPARED_BY := %s\nCOMPARED_EQUAL := %s\n' "$$PPID" "$$equal" >$@
compare:
	@exit 2
endif

endif
