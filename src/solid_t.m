#import "solid_t.h"
#import "compiler_t.h"
#import "diag_t.h"
#import "material_t.h"
#import "open_solids_t.h"
#import "polygon_t.h"
#include "grow.h"
#include "shell.h"

// Clipping asks every face of a convex solid; past this many it is no faster
// than asking which face is hit.
#define CLIPPED_FACES 256

@implementation solid_t

- (BOOL) isOfOneKind: (diag_t *)diag
{
  for (polygon_t *face in faces)
    {
      material_t *m = face->material;
      if (m->alpha != material->alpha || m->ior != material->ior)
        {
          [diag fault: face->material_place : @"solid '%@' has faces of alpha"
            @" %.6g and ior %.6g and this one of alpha %.6g and ior %.6g;"
            @" a solid is of one kind", name, material->alpha, material->ior,
                m->alpha, m->ior];
          return NO;
        }
    }
  return YES;
}

+ (struct shell_face *) newShellFaces: (NSArray *)polygons
{
  struct shell_face *f = new_array([polygons count], sizeof *f), *next = f;

  for (polygon_t *face in polygons)
    {
      next->n = face->count;
      next->vertex = (const double *const *)face->vertex;
      next++;
    }
  return f;
}

/** Checks that the faces close a volume and turns them outwards. */
- (BOOL) close: (open_solids_t *)open_solids
{
  unsigned count = [faces count], i;
  struct shell_face *f = [solid_t newShellFaces: faces];
  struct shell_edge open;
  int shells = shells_close(f, count, &open);

  if (shells < 0)
    {
      raise_no_memory(count);
    }
  for (i = 0; i < count; i++)
    {
      if (shells > 0 && f[i].is_turned)
        {
          [(polygon_t *)[faces objectAtIndex: i] turn];
        }
    }
  free(f);
  if (shells == 0)
    {
      [open_solids add: faces edge: open];
    }
  return shells > 0;
}

/** Whether every vertex lies behind every face or, as near as can be told, on
    it, and no two faces lie in one plane: then the planes alone say which face
    a ray meets. */
- (BOOL) isGivenByPlanes
{
  for (polygon_t *face in faces)
    {
      for (polygon_t *other in faces)
        {
          BOOL lies_in_it = other != face;
          for (unsigned i = 0; i < other->count; i++)
            {
              struct k_vec v = k_sub([other vertexAt: i], face->plane.q);
              double ahead = k_dot(face->plane.n, v);
              if (ahead > 4 * slack)
                {
                  return NO;
                }
              lies_in_it &= ahead >= -4 * slack;
            }
          if (lies_in_it)
            {
              return NO;
            }
        }
    }
  return YES;
}

/** nil if the faces do not make a solid, and a fault in diag or one more of
    the open solids. */
- (id) initWithFaces: (NSArray *)polygons diag: (diag_t *)diag
                open: (open_solids_t *)open_solids
{
  if ((self = [super init]))
    {
      polygon_t *first = [polygons objectAtIndex: 0];

      name = [first->solid_name copy];
      faces = [polygons retain];
      material = first->material;
      number = first->number;
      box = k_nothing();
      for (polygon_t *face in faces)
        {
          struct k_bounds b = [face bounds];
          box = k_bounds_include(k_bounds_include(box, b.least), b.most);
          slack = k_max2(slack, face->slack);
        }
      if (![self isOfOneKind: diag] || ![self close: open_solids])
        {
          [self release];
          return nil;
        }
      is_convex = [faces count] <= CLIPPED_FACES && [self isGivenByPlanes];
      for (polygon_t *face in faces)
        {
          if (material->alpha > 0)
            {
              face->solid = self;
              face->slack = slack;
            }
        }
    }
  return self;
}

- (void) dealloc
{
  [name release];
  [faces release];
  [super dealloc];
}

- (NSString *) name
{
  return name;
}

- (struct k_bounds) bounds
{
  return box;
}

- (BOOL) compile: (compiler_t *)compiler
{
  NSUInteger count = [faces count], i = 0;

  if (!is_convex)
    {
      for (polygon_t *face in faces)
        {
          [face compile: compiler];
        }
      return YES;
    }
  struct k_surface surfaces[count];
  struct k_plane planes[count];
  for (polygon_t *face in faces)
    {
      surfaces[i] = [compiler surfaceOf: face];
      planes[i++] = face->plane;
    }
  k_add_convex(compiler->scene, count, surfaces, planes, box,
               [compiler mediumOf: self]);
  return YES;
}

+ (void) joinFaces: (NSArray *)polygons
             model: (model_t *)model
              diag: (diag_t *)diag
{
  NSMutableDictionary *by_name = [NSMutableDictionary dictionary];
  NSMutableArray *names = [NSMutableArray array];
  open_solids_t *open = [[open_solids_t new] autorelease];

  for (polygon_t *polygon in polygons)
    {
      if (polygon->solid_name == nil)
        {
          continue;
        }
      NSMutableArray *group = [by_name objectForKey: polygon->solid_name];
      if (group == nil)
        {
          group = [NSMutableArray array];
          [by_name setObject: group forKey: polygon->solid_name];
          [names addObject: polygon->solid_name];
        }
      [group addObject: polygon];
    }
  for (NSString *each in names)
    {
      NSArray *group = [by_name objectForKey: each];
      solid_t *solid = [[solid_t alloc] initWithFaces: group diag: diag
                                                  open: open];
      if (solid)
        {
          if (solid->material->alpha > 0)
            {
              [model replace: group by: solid];
            }
          [solid release];
        }
    }
  [open tell: diag];
}

@end
