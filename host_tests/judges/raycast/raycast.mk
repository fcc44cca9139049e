# SPDX-License-Identifier: MIT
# The third judge: rays in double against the twin's frames.

RAYCAST_SOURCES := $(wildcard host_tests/judges/raycast/*.c)

# No fused multiply-add: an edge must give neighbours opposite answers, bit for bit.
$(BUILD)/host/raycast: $(RAYCAST_SOURCES) $(wildcard host_tests/judges/raycast/*.h)
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -O2 -ffp-contract=off $(RAYCAST_SOURCES) -o $@ -lm

# What the test of the three readers links.
$(BUILD)/host/objects/judges/raycast/%.o: host_tests/judges/raycast/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -O2 -MMD -MP -c $< -o $@

HOST_TOOLS += $(BUILD)/host/raycast
