# flags.mk - the builds and their flags: for the GNUmakefile, which makes the
# library and the tool, and for tests/programs.mk, which makes the tests.
#
# BUILD is the name of a build; each has a folder of its own, build/NAME:
#
#   default     gcc -O3: what is installed
#   sanitize    gcc with the address and undefined behaviour sanitizers
#   gcc-O0      gcc without optimisation; so gcc-O2, gcc-O3
#   clang-O2    clang 16; so clang-O0, clang-O3
#   gcc-O2-v3   for processors with AVX2 only; so the others
#   fuzz        clang 16 with the sanitizers, for tests/fuzz
#
# CC=…, OPT=… and SANITIZE=… on the command line change any of them.

BUILD ?= default

ifeq ($(BUILD),sanitize)
  # Where each variable lies is for debuggers, and a minute for k_trace.inc.c.
  OPT = -O1 -fno-omit-frame-pointer -fno-var-tracking
  SANITIZE = address,undefined
else ifneq ($(filter gcc-% clang-%,$(BUILD)),)
  parts := $(subst -, ,$(BUILD))
  CC = $(if $(filter clang,$(word 1,$(parts))),clang-16,gcc)
  OPT = -$(word 2,$(parts)) $(if $(filter v3,$(parts)),-march=x86-64-v3)
else ifeq ($(BUILD),fuzz)
  CC = clang-16
  OPT = -O1 -fno-omit-frame-pointer
  SANITIZE = fuzzer-no-link,address,undefined
endif

ifeq ($(origin CC),default)
  CC = gcc
endif
OPT ?= -O3

PACKAGES = OpenEXR libpng nettle
ifneq ($(shell pkg-config --exists $(PACKAGES) && echo found),found)
  $(error pkg-config does not find all of: $(PACKAGES); see README.md)
endif

# OpenEXR is used through its C library only.
LIBS := $(filter -lOpenEXRCore%,$(shell pkg-config --libs OpenEXR)) \
  $(shell pkg-config --libs libpng nettle) -lm
INCLUDES := -Isrc $(filter -I%,$(shell pkg-config --cflags $(PACKAGES)))

# No flag here may change the value of a floating-point operation: every
# compiler and every level has to give the same picture.
#
# Two warnings of -Wextra are off: unused-parameter, since a method or callback
# has the parameters that its caller gives whether it needs them or not, and
# expansion-to-defined, of which GNUstep's headers are full.
FLAGS := -std=gnu11 $(OPT) -g \
  -ffp-contract=off -fno-fast-math -fno-math-errno \
  -Wall -Wextra -Werror -Wno-unused-parameter -Wno-expansion-to-defined
LINK_FLAGS :=

ifneq ($(findstring clang,$(CC)),)
  # GNUstep's libraries are made for gcc's runtime; its headers come with gcc.
  FLAGS += -fobjc-runtime=gcc \
    -idirafter $(shell gcc -print-file-name=include)
endif

ifneq ($(SANITIZE),)
  FLAGS += -fsanitize=$(SANITIZE) -fno-sanitize-recover=undefined
  LINK_FLAGS += -fsanitize=$(SANITIZE)
endif

# Shapes are found by name at run time: the library is linked whether or not
# a program names anything in it.
LIBRARY := -Wl,--no-as-needed -lraytrace -Wl,--as-needed

# What was made with other flags is made again: it depends on this file.
BUILD_DIR := build/$(BUILD)
FLAGS_FILE := $(BUILD_DIR)/flags
FLAGS_NOW := $(strip $(CC) $(FLAGS) $(INCLUDES) $(LINK_FLAGS) $(LIBS))
$(shell mkdir -p $(BUILD_DIR))
ifneq ($(file <$(FLAGS_FILE)),$(FLAGS_NOW))
  $(file >$(FLAGS_FILE),$(FLAGS_NOW))
endif
