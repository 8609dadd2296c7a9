// A clear solid whose front is two triangles in one plane: a ray meets the one
// whose outline it passes through, as it would if the solid were opaque.

#import "support.h"

static const char scene[] =
  "camera c { pixeldim 21 21 worlddim 2 2 viewpoint 1 1 5 }\n"
  "material red { ambient 1 0 0 alpha %s }\n"
  "material blue { ambient 0 0 1 alpha %s }\n"
  "polygon f1 { material red solid s vertex 0 0 -1 vertex 2 0 -1"
  " vertex 2 2 -1 }\n"
  "polygon f2 { material blue solid s vertex 0 0 -1 vertex 2 2 -1"
  " vertex 0 2 -1 }\n"
  "polygon b { material red solid s vertex 0 0 -3 vertex 0 2 -3"
  " vertex 2 2 -3 vertex 2 0 -3 }\n"
  "polygon l { material red solid s vertex 0 0 -1 vertex 0 2 -1"
  " vertex 0 2 -3 vertex 0 0 -3 }\n"
  "polygon r { material red solid s vertex 2 0 -1 vertex 2 0 -3"
  " vertex 2 2 -3 vertex 2 2 -1 }\n"
  "polygon t1 { material red solid s vertex 0 2 -1 vertex 2 2 -1"
  " vertex 2 2 -3 }\n"
  "polygon t2 { material red solid s vertex 0 2 -1 vertex 2 2 -3"
  " vertex 0 2 -3 }\n"
  "polygon u1 { material red solid s vertex 0 0 -1 vertex 0 0 -3"
  " vertex 2 0 -3 }\n"
  "polygon u2 { material red solid s vertex 0 0 -1 vertex 2 0 -3"
  " vertex 2 0 -1 }\n";

int
main(void)
{
  NSAutoreleasePool *pool = [[NSAutoreleasePool alloc] init];
  model_t *clear = support_model(scene, ".5", ".5");
  model_t *opaque = support_model(scene, "0", "0");
  unsigned wrong = 0, other = 0;

  for (unsigned i = 0; i < 10000; i++)
    {
      struct support_random random = support_seed(i);
      double x = support_between(&random, .01, 1.99);
      double y = support_between(&random, .01, 1.99);
      unsigned want = y < x ? 1 : 2;
      struct k_vec o = k_vec(x, y, 2), d = k_vec(0, 0, -1);
      wrong += fabs(x - y) > 1e-9 && support_number(clear, o, d) != want;
      other += support_number(clear, o, d) != support_number(opaque, o, d);
    }
  PASS(wrong == 0, "%u of 10000 rays meet the other triangle", wrong);
  PASS(other == 0, "%u of 10000 rays meet another face than if it were opaque",
       other);
  support_picture(clear, support_render_options());
  [pool release];
  return test_done();
}
