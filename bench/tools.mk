# tools.mk - builds what bench/run uses, into build/bench.
#
#   make -f bench/tools.mk

to = build/bench
CFLAGS = -std=gnu11 -O2 -Wall -Wextra
CXXFLAGS = -std=c++17 -O3 -march=native -Wall -Wextra

tools = generate measure difference pov_scene tachyon_scene
reader = bench/peers/nff.c bench/peers/clip.c bench/peers/solids.c

.PHONY: all tools
all: $(addprefix $(to)/,$(tools) embree_peer)
tools: $(addprefix $(to)/,$(tools))

$(to):
	mkdir -p $@

$(to)/generate: $(wildcard bench/scenes/*.[ch]) | $(to)
	gcc $(CFLAGS) -o $@ $(filter %.c,$^) -lm

$(to)/measure $(to)/difference: $(to)/%: bench/%.c | $(to)
	gcc $(CFLAGS) -o $@ $< -lm

$(to)/%_scene: bench/peers/%_scene.c $(reader) bench/peers/nff.h | $(to)
	gcc $(CFLAGS) -o $@ $(filter %.c,$^) -lm

# The reader is part of the peer, so it is as fast as the rest.
$(to)/reader/%.o: bench/peers/%.c bench/peers/nff.h
	mkdir -p $(@D)
	gcc -std=gnu11 -O3 -march=native -Wall -Wextra -c -o $@ $<

$(to)/embree_peer: bench/embree_peer.cpp \
    $(reader:bench/peers/%.c=$(to)/reader/%.o)
	g++ $(CXXFLAGS) -Ibench -o $@ $^ -lembree3 -lpthread
.SECONDARY:
