// k_dispatch.c - which instruction set this machine gets.

#include "k_scene.h"
#include <string.h>

extern const struct k_isa k_isa_base;
#if defined(__x86_64__)
extern const struct k_isa k_isa_avx2;
#endif

const struct k_isa *
k_isa_find(const char *name)
{
#if defined(__x86_64__)
  if ((name == NULL || !strcmp(name, "avx2"))
      && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    {
      return &k_isa_avx2;
    }
#endif
  return name == NULL || !strcmp(name, "base") ? &k_isa_base : NULL;
}

const char *
k_isa_best(void)
{
  return k_isa_find(NULL)->name;
}
