// k_bvh_wide.c - k_best_cut and k_split with several threads, for the lists at
// the top of the tree. What they do with the pieces of a list is put together
// without regard to who did it: the result is the same to the last bit.

#include "k_bvh_cut.h"
#include "k_parallel.h"
#include <pthread.h>
#include <string.h>

struct wide
{
  const struct k_range *range;
  struct k_binning binning;
  struct k_bins bins;                   // of all pieces
  uint32_t counts[K_PIECES][3][K_BINS]; // of each
  const struct k_cut *cut;
  struct k_box centers[2];              // of the parts
  uint32_t next;                        // piece, atomic
  pthread_mutex_t lock;                 // of bins and centers
};

/** Where a piece starts. */
static uint32_t
start_of(const struct k_range *r, uint32_t piece)
{
  return (uint64_t)r->count * piece / K_PIECES;
}

static void
add_pieces(void *context, unsigned thread)
{
  struct wide *w = context;
  struct k_bins sum, bins;
  uint32_t i;

  (void)thread;
  k_bins_clear(&sum);
  while ((i = k_take(&w->next, K_PIECES)) < K_PIECES)
    {
      uint32_t start = start_of(w->range, i);
      k_bins_clear(&bins);
      k_bins_add(&bins, &w->binning, w->range->items + start,
                 start_of(w->range, i + 1) - start);
      memcpy(w->counts[i], bins.counts, sizeof bins.counts);
      k_bins_join(&sum, &bins);
    }
  pthread_mutex_lock(&w->lock);
  k_bins_join(&w->bins, &sum);
  pthread_mutex_unlock(&w->lock);
}

void
k_wide_cut(const struct k_range *r, unsigned threads, struct k_cut *cut)
{
  struct wide w = { .range = r, .binning = k_binning_of(r),
                    .lock = PTHREAD_MUTEX_INITIALIZER };
  uint32_t before = 0;

  k_bins_clear(&w.bins);
  k_in_parallel(threads, add_pieces, &w);
  cut->binning = w.binning;
  k_cut_bins(&w.bins, cut);
  for (int i = 0; cut->axis >= 0 && i < K_PIECES; i++)
    {
      cut->before[i] = before;
      for (int bin = 0; bin < cut->at; bin++)
        {
          before += w.counts[i][cut->axis][bin];
        }
    }
}

static void
part_pieces(void *context, unsigned thread)
{
  struct wide *w = context;
  const struct k_range *r = w->range;
  struct k_box centers[2] = { k_no_box(), k_no_box() };
  uint32_t i;

  (void)thread;
  while ((i = k_take(&w->next, K_PIECES)) < K_PIECES)
    {
      uint32_t start = start_of(r, i), left = w->cut->before[i];
      k_part(r->items + start, start_of(r, i + 1) - start, w->cut,
             r->spare + left, r->spare + w->cut->left_count + start - left,
             centers);
    }
  pthread_mutex_lock(&w->lock);
  w->centers[0] = k_join(w->centers[0], centers[0]);
  w->centers[1] = k_join(w->centers[1], centers[1]);
  pthread_mutex_unlock(&w->lock);
}

void
k_wide_split(const struct k_range *whole, const struct k_cut *cut,
             unsigned threads, struct k_range *left, struct k_range *right)
{
  struct k_range r = *whole;    // left or right may be the same
  struct wide w = { .range = &r, .cut = cut,
                    .centers = { k_no_box(), k_no_box() },
                    .lock = PTHREAD_MUTEX_INITIALIZER };

  if (cut->axis < 0)
    {
      k_split(whole, cut, left, right);
      return;
    }
  k_in_parallel(threads, part_pieces, &w);
  k_halves(&r, cut, left, right);
  left->centers = w.centers[0];
  right->centers = w.centers[1];
}
