# programs.mk - makes test programs, with the flags of the library: tests/run
# calls it. What the compiler says of a program stands in PROGRAM.log.

include tools/flags.mk

OBJC_FLAGS := $(filter-out -MMD -MP,$(shell gnustep-config --objc-flags))
BASE_LIBS := $(shell gnustep-config --base-libs)

# A program lies two folders deep in tests/, a fixture of the runner three.
RPATH = -Wl,-rpath,'$$ORIGIN/../..:$$ORIGIN/../../..'

$(BUILD_DIR)/tests/%: tests/%.c $(FLAGS_FILE)
	@mkdir -p $(@D)
	@$(CC) $(FLAGS) $(INCLUDES) -MMD -MP -MF $@.d $< -o $@ \
	  $(LINK_FLAGS) $(LIBS) >$@.log 2>&1 || { rm -f $@; exit 1; }

$(BUILD_DIR)/tests/%: tests/%.m $(FLAGS_FILE)
	@mkdir -p $(@D)
	@$(CC) $(OBJC_FLAGS) $(FLAGS) $(INCLUDES) -Itests -MMD -MP -MF $@.d \
	  $< -o $@ $(LINK_FLAGS) $(RPATH) -L$(BUILD_DIR) $(LIBRARY) \
	  $(LIBS) $(BASE_LIBS) >$@.log 2>&1 || { rm -f $@; exit 1; }

# bench/trade/coverage.m is such a program too.
$(BUILD_DIR)/bench/%: bench/%.m $(FLAGS_FILE)
	@mkdir -p $(@D)
	@$(CC) $(OBJC_FLAGS) $(FLAGS) $(INCLUDES) -MMD -MP -MF $@.d $< -o $@ \
	  $(LINK_FLAGS) $(RPATH) -L$(BUILD_DIR) $(LIBRARY) $(LIBS) $(BASE_LIBS) >$@.log 2>&1 \
	  || { rm -f $@; exit 1; }

# With libFuzzer's main, in the build `fuzz` only.
$(BUILD_DIR)/fuzz: tests/fuzz/harness/fuzz.m $(BUILD_DIR)/libraytrace.so
	@$(CC) $(OBJC_FLAGS) $(FLAGS) $(INCLUDES) $< -o $@ $(LINK_FLAGS) \
	  -fsanitize=fuzzer -Wl,-rpath,'$$ORIGIN' -L$(BUILD_DIR) $(LIBRARY) \
	  $(LIBS) $(BASE_LIBS)

-include $(wildcard $(BUILD_DIR)/tests/*/*.d $(BUILD_DIR)/bench/*/*.d)
