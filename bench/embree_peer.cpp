/* embree_peer.cpp - what this program computes, done with Embree.

   usage: embree_peer SCENE.nff OUT.ppm THREADS [FOCUS FSTOP EXPOSURE]

   The yardstick of the fast engine: a ray tracer as one would write it on
   Embree, in single precision, for speed. Spheres are Embree's own sphere
   points, polygons are triangles; what is clear is masked out of feelers.
   The colours are those of docs/formulas.md with NFF's materials, which have
   no ambient light, and lights without falloff. Nothing is allocated per ray.
   A ray past the depth is counted and black, as in the program's own counts.
   EMBREE_ISA=avx2 and the like hold Embree back to an instruction set.
   Prints seconds and rays as one JSON object, as --stats=json does. */

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <vector>

#include <embree3/rtcore.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include "peers/nff.h"

namespace
{

constexpr int maxDepth = 5;
constexpr int tileSide = 16;
constexpr unsigned opaqueMask = 1, clearMask = 2;

struct vec
{
  float x, y, z;
};

inline vec operator+ (vec a, vec b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline vec operator- (vec a, vec b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline vec operator* (vec a, vec b)
{
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline vec operator* (vec a, float s) { return {a.x * s, a.y * s, a.z * s}; }
inline vec operator- (vec a) { return {-a.x, -a.y, -a.z}; }
inline float dot (vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline vec unit (vec a) { return a * (1 / std::sqrt (dot (a, a))); }
inline vec make (const float *p) { return {p[0], p[1], p[2]}; }
inline vec make (const double *p)
{
  return {float (p[0]), float (p[1]), float (p[2])};
}

struct material
{
  vec diffuse, specular;
  float shine, clear, ior;
  bool isMirror;
};

/* What a geometry's primitives are: of spheres their centres and radii. */
struct geometry
{
  const float *sphere = nullptr;
  std::vector<float> spheres;           /* x y z radius */
  std::vector<float> corners;           /* x y z */
  std::vector<uint32_t> indices;
  std::vector<uint32_t> material;       /* of each primitive */
  std::vector<uint32_t> object;         /* 0 for a thin sheet */
};

/* The media the ray is in, innermost first. */
struct medium
{
  const medium *outer;
  uint32_t object;
  float ior;
};

struct rays
{
  uint64_t eye = 0, reflection = 0, refraction = 0, feeler = 0;
};

struct scene
{
  nff file;
  std::vector<material> materials;
  std::vector<nff_light> lights;
  geometry parts[4];
  RTCScene embree;
  vec from, right, up, ahead, background;
  float focus = 0, aperture = 0;
  int exposure = 1;
};

double
now ()
{
  using namespace std::chrono;
  return duration<double> (steady_clock::now ().time_since_epoch ()).count ();
}

/* One thread's work. */
struct tracer
{
  const scene &s;
  rays count;
  RTCIntersectContext context;

  explicit tracer (const scene &scene) : s (scene)
  {
    rtcInitIntersectContext (&context);
  }

  vec trace (vec origin, vec dir, int depth, const medium *media);
  bool lit (vec point, vec toward, float distance);
};

inline float
margin (vec p)
{
  return 1e-5f * std::max (1.0f, std::max (std::fabs (p.x),
                           std::max (std::fabs (p.y), std::fabs (p.z))));
}

inline void
aim (RTCRay &ray, vec origin, vec dir, float near, float far, unsigned mask)
{
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.dir_x = dir.x;
  ray.dir_y = dir.y;
  ray.dir_z = dir.z;
  ray.tnear = near;
  ray.tfar = far;
  ray.time = 0;
  ray.mask = mask;
  ray.id = 0;
  ray.flags = 0;
}

bool
tracer::lit (vec point, vec toward, float distance)
{
  RTCRay ray;

  count.feeler++;
  aim (ray, point, toward, margin (point), distance, opaqueMask);
  rtcOccluded1 (s.embree, &context, &ray);
  return ray.tfar >= 0;
}

inline vec
reflect (vec d, vec n)
{
  return d - n * (2 * dot (d, n));
}

/* The nearest entry of the object, and the stack without it. */
const medium *
without (const medium *media, uint32_t object, medium *copy, int room)
{
  if (media == nullptr || room == 0)
    return media;
  if (media->object == object)
    return media->outer;
  *copy = *media;
  copy->outer = without (media->outer, object, copy + 1, room - 1);
  return copy;
}

inline bool
holds (const medium *media, uint32_t object)
{
  for (; media != nullptr; media = media->outer)
    if (media->object == object)
      return true;
  return false;
}

vec
tracer::trace (vec origin, vec dir, int depth, const medium *media)
{
  RTCRayHit hit;

  aim (hit.ray, origin, dir, depth == 0 ? 0 : margin (origin), INFINITY,
       opaqueMask | clearMask);
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1 (s.embree, &context, &hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID)
    return s.background;

  const geometry &part = s.parts[hit.hit.geomID];
  const uint32_t id = hit.hit.primID;
  const material &m = s.materials[part.material[id]];
  vec point, normal;

  if (part.sphere != nullptr)
    {
      /* On the sphere, where float keeps it. */
      const float *c = part.sphere + 4 * size_t (id);

      normal = unit (origin + dir * hit.ray.tfar - make (c));
      point = make (c) + normal * c[3];
    }
  else
    {
      normal = unit ({hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z});
      point = origin + dir * hit.ray.tfar;
    }

  const bool entering = dot (normal, dir) < 0;
  const vec facing = entering ? normal : -normal;
  vec color = {0, 0, 0}, highlight = {0, 0, 0};

  for (const nff_light &light : s.lights)
    {
      const vec way = make (light.place) - point;
      const float r = std::sqrt (dot (way, way));
      const vec toward = way * (1 / r);
      const float slant = dot (facing, toward);

      if (slant <= 0 || !lit (point, toward, r))
        continue;
      color = color + m.diffuse * make (light.color) * slant;
      if (m.isMirror)
        {
          const float h = -dot (facing * (2 * slant) - toward, dir);

          if (h > 0)
            highlight = highlight
                        + make (light.color) * std::pow (h, m.shine);
        }
    }
  if (!m.isMirror && m.clear == 0)
    return color;

  vec reflected = {0, 0, 0}, refracted = {0, 0, 0};
  float share = 0;                      /* reflected, of what is clear */

  if (m.clear > 0)
    {
      const uint32_t object = part.object[id];
      const float outside = media != nullptr ? media->ior : 1;
      medium entered = {media, object, m.ior}, copy[16];
      const medium *next = media;
      float n_i = outside, n_t = m.ior;

      if (object == 0)
        ;                               /* a thin sheet: straight on */
      else if (entering)
        next = &entered;
      else if (holds (media, object))
        {
          next = without (media, object, copy, 16);
          n_i = m.ior;
          n_t = next != nullptr ? next->ior : 1;
        }
      else
        n_i = n_t = outside;

      vec onward = dir;
      const float n = n_t / n_i, c = -dot (dir, facing);
      const float k = 1 - (1 - c * c) / (n * n);

      if (object != 0 && k < 0)
        share = 1;
      else
        {
          if (object != 0 && n_i != n_t)
            onward = unit ((dir + facing * c) * (1 / n)
                           - facing * std::sqrt (k));
          if (n_i != n_t)
            {
              const float r = (n_t - n_i) / (n_t + n_i), r0 = r * r;
              const float x = 1 - (n_i < n_t ? c : -dot (onward, facing));

              share = r0 + (1 - r0) * x * x * x * x * x;
            }
        }
      if (share < 1)
        {
          count.refraction++;
          if (depth < maxDepth)
            refracted = trace (point, onward, depth + 1, next);
        }
    }
  if (m.isMirror || share > 0)
    {
      count.reflection++;
      if (depth < maxDepth)
        reflected = trace (point, reflect (dir, facing), depth + 1, media);
    }
  if (m.isMirror)
    color = m.diffuse * color + m.specular * reflected;
  if (m.clear > 0)
    color = color * (1 - m.clear)
            + (refracted * (1 - share) + reflected * share) * m.clear;
  return color + m.specular * highlight;
}

/* 0 to 1, from the pixel and which of its rays this is. */
inline float
noise (uint32_t pixel, uint32_t index)
{
  uint32_t h = pixel * 0x9e3779b1u ^ index * 0x85ebca6bu;

  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  h ^= h >> 12;
  h *= 0x297a2d39u;
  h ^= h >> 15;
  return h * 0x1p-32f;
}

vec
pixel (tracer &t, int i, int j)
{
  const scene &s = t.s;
  const float x = 2.0f * i / (s.file.columns - 1) - 1;
  const float y = 1 - 2.0f * j / (s.file.rows - 1);
  const vec dir = unit (s.ahead + s.right * x + s.up * y);

  if (s.focus == 0)
    {
      t.count.eye++;
      return t.trace (s.from, dir, 0, nullptr);
    }
  const vec right = unit (s.right), up = unit (s.up);
  vec sum = {0, 0, 0};

  for (int k = 0; k < s.exposure; k++)
    {
      const uint32_t number = uint32_t (j) * s.file.columns + i;
      const vec lens = right * ((2 * noise (number, 2 * k) - 1) * s.aperture)
                       + up * ((2 * noise (number, 2 * k + 1) - 1)
                               * s.aperture);

      t.count.eye++;
      sum = sum + t.trace (s.from + lens, unit (dir * s.focus - lens), 0,
                           nullptr);
    }
  return sum * (1.0f / s.exposure);
}

/* Sorts the shapes into four parts: spheres and triangles, opaque and
   clear. */
void
sort_shapes (scene &s)
{
  const nff &f = s.file;
  uint32_t solids = f.polygons + 1;
  std::vector<uint32_t> triangles;

  for (size_t i = 0; i < f.materials; i++)
    {
      const nff_material &m = f.material[i];
      const vec color = make (m.color);

      s.materials.push_back ({color * m.kd, color * m.ks, m.shine, m.clear,
                              m.ior > 0 ? m.ior : 1, m.ks > 0});
    }
  s.lights.assign (f.light, f.light + f.lights);
  for (size_t i = 0; i < f.spheres; i++)
    {
      const uint32_t m = f.sphereMaterial[i];
      geometry &g = s.parts[s.materials[m].clear > 0 ? 1 : 0];

      g.spheres.insert (g.spheres.end (), f.sphere + 4 * i,
                        f.sphere + 4 * i + 4);
      g.material.push_back (m);
      if (s.materials[m].clear > 0)
        g.object.push_back (solids + i);
    }
  for (size_t i = 0; i < f.polygons; i++)
    {
      const nff_polygon &p = f.polygon[i];
      const bool isClear = s.materials[p.material].clear > 0;
      geometry &g = s.parts[isClear ? 3 : 2];
      const uint32_t first = g.corners.size () / 3;
      const float *c = f.corner + 3 * size_t (p.first);

      g.corners.insert (g.corners.end (), c, c + 3 * size_t (p.count));
      triangles.resize (3 * size_t (p.count));
      nff_clip (c, p.count,
                reinterpret_cast<uint32_t (*)[3]> (triangles.data ()));
      for (uint32_t k = 0; k < 3 * (p.count - 2); k++)
        g.indices.push_back (first + triangles[k]);
      g.material.insert (g.material.end (), p.count - 2, p.material);
      if (isClear)
        g.object.insert (g.object.end (), p.count - 2, p.solid);
    }
}

void
attach (RTCDevice device, scene &s, unsigned part)
{
  geometry &g = s.parts[part];
  const size_t count = g.material.size ();
  RTCGeometry to;

  if (count == 0)
    return;
  if (part < 2)
    {
      g.sphere = g.spheres.data ();
      to = rtcNewGeometry (device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
      rtcSetSharedGeometryBuffer (to, RTC_BUFFER_TYPE_VERTEX, 0,
                                  RTC_FORMAT_FLOAT4, g.sphere, 0, 16, count);
    }
  else
    {
      g.corners.push_back (0);          /* Embree reads 16 bytes a corner */
      to = rtcNewGeometry (device, RTC_GEOMETRY_TYPE_TRIANGLE);
      rtcSetSharedGeometryBuffer (to, RTC_BUFFER_TYPE_VERTEX, 0,
                                  RTC_FORMAT_FLOAT3, g.corners.data (), 0,
                                  12, g.corners.size () / 3);
      rtcSetSharedGeometryBuffer (to, RTC_BUFFER_TYPE_INDEX, 0,
                                  RTC_FORMAT_UINT3, g.indices.data (), 0,
                                  12, count);
    }
  rtcSetGeometryMask (to, part % 2 ? clearMask : opaqueMask);
  rtcCommitGeometry (to);
  rtcAttachGeometryByID (s.embree, to, part);
  rtcReleaseGeometry (to);
}

/* For an Embree that was built without masks: clear things do not count. */
void
pass (const RTCFilterFunctionNArguments *arguments)
{
  arguments->valid[0] = 0;
}

void
build (RTCDevice device, scene &s)
{
  s.embree = rtcNewScene (device);
  for (unsigned part = 0; part < 4; part++)
    {
      attach (device, s, part);
      if (part % 2 && !s.parts[part].material.empty ()
          && !rtcGetDeviceProperty (device,
                                    RTC_DEVICE_PROPERTY_RAY_MASK_SUPPORTED))
        {
          RTCGeometry g = rtcGetGeometry (s.embree, part);

          rtcSetGeometryOccludedFilterFunction (g, pass);
          rtcCommitGeometry (g);
        }
    }
  rtcCommitScene (s.embree);
}

void
trace_tiles (const scene &s, std::atomic<int> &next, unsigned char *out,
             rays &total)
{
  const int across = (s.file.columns + tileSide - 1) / tileSide;
  const int down = (s.file.rows + tileSide - 1) / tileSide;
  tracer t (s);

  _MM_SET_FLUSH_ZERO_MODE (_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE (_MM_DENORMALS_ZERO_ON);
  for (int tile; (tile = next++) < across * down;)
    {
      const int x0 = tile % across * tileSide, y0 = tile / across * tileSide;
      const int x1 = std::min (x0 + tileSide, s.file.columns);
      const int y1 = std::min (y0 + tileSide, s.file.rows);

      for (int j = y0; j < y1; j++)
        for (int i = x0; i < x1; i++)
          {
            const vec c = pixel (t, i, j);
            unsigned char *to = out + 3 * (size_t (j) * s.file.columns + i);

            to[0] = 255 * std::min (std::max (c.x, 0.0f), 1.0f) + 0.5f;
            to[1] = 255 * std::min (std::max (c.y, 0.0f), 1.0f) + 0.5f;
            to[2] = 255 * std::min (std::max (c.z, 0.0f), 1.0f) + 0.5f;
          }
    }
  total = t.count;
}

}

int
main (int argc, char **argv)
{
  if (argc != 4 && argc != 7)
    return 2;
  const int threads = std::atoi (argv[3]);
  static scene s;
  double right[3], up[3], ahead[3], time[5];

  time[0] = now ();
  nff_read (&s.file, argv[1]);
  nff_solids (&s.file);
  nff_window (&s.file, right, up, ahead);
  s.from = make (s.file.from);
  s.right = make (right);
  s.up = make (up);
  s.ahead = make (ahead);
  s.background = make (s.file.background);
  if (argc == 7)
    {
      s.focus = std::atof (argv[4]);
      s.aperture = 1 / std::atof (argv[5]);
      s.exposure = std::atoi (argv[6]);
    }
  sort_shapes (s);
  nff_free_shapes (&s.file);

  time[1] = now ();
  char config[64];
  const char *isa = std::getenv ("EMBREE_ISA");
  std::snprintf (config, sizeof config, "threads=%d%s%.20s", threads,
                 isa != nullptr ? ",isa=" : "", isa != nullptr ? isa : "");
  RTCDevice device = rtcNewDevice (config);
  build (device, s);

  time[2] = now ();
  std::vector<unsigned char> out (3 * size_t (s.file.columns) * s.file.rows);
  std::vector<std::thread> pool;
  std::vector<rays> count (threads);
  std::atomic<int> next (0);
  for (int k = 0; k < threads; k++)
    pool.emplace_back (trace_tiles, std::cref (s), std::ref (next),
                       out.data (), std::ref (count[k]));
  for (std::thread &thread : pool)
    thread.join ();

  time[3] = now ();
  FILE *to = std::fopen (argv[2], "wb");
  if (to == nullptr)
    return 4;
  std::fprintf (to, "P6\n%d %d\n255\n", s.file.columns, s.file.rows);
  std::fwrite (out.data (), 1, out.size (), to);
  if (std::fclose (to) != 0)
    return 4;
  time[4] = now ();

  for (int k = 1; k < threads; k++)
    {
      count[0].eye += count[k].eye;
      count[0].reflection += count[k].reflection;
      count[0].refraction += count[k].refraction;
      count[0].feeler += count[k].feeler;
    }
  std::printf ("{\"seconds\": {\"load\": %.6f, \"build\": %.6f, "
               "\"trace\": %.6f, \"write\": %.6f}, \"rays\": {\"eye\": %llu, "
               "\"reflection\": %llu, \"refraction\": %llu, "
               "\"feeler\": %llu}}\n", time[1] - time[0], time[2] - time[1],
               time[3] - time[2], time[4] - time[3],
               (unsigned long long) count[0].eye,
               (unsigned long long) count[0].reflection,
               (unsigned long long) count[0].refraction,
               (unsigned long long) count[0].feeler);
  rtcReleaseScene (s.embree);
  rtcReleaseDevice (device);
  return 0;
}
