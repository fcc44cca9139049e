# SPDX-License-Identifier: MIT
# make compare answers 0 equal, 1 different, 2 cannot be compared. A recipe
# cannot do that: make itself answers 2 to whatever a recipe answers. So the
# comparison runs while make brings its makefiles up to date, and leaves one
# behind; make starts over (same process), finds it, and where the frames
# differ becomes "make -q", which answers 1 for a goal that is not up to date.

VERDICT := $(BUILD)/compare/verdict.mk
COMPARE_OUT := $(if $(filter file,$(origin OUT)),$(BUILD)/compare,$(OUT))
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
$(VERDICT): FORCE
	@mkdir -p $(@D)
	@tools/setup.sh tools
	@code=0; $(PY) tools/compare.py --a '$(A)' --b '$(B)' --tolerance '$(if $(filter undefined,$(origin TOLERANCE)),0,$(TOLERANCE))' \
	    --out '$(COMPARE_OUT)' $(if $(JSON),--json) || code=$$?; \
	case $$code in 0) equal=yes ;; 1) equal=no ;; *) exit $$code ;; esac; \
	printf 'COMPARED_BY := %s\nCOMPARED_EQUAL := %s\n' "$$PPID" "$$equal" >$@
compare: ;
endif
