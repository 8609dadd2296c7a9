#import "open_solids_t.h"
#import "diag_t.h"
#import "polygon_t.h"
#import "solid_t.h"

// Closing solids by way of trial ends where it takes seconds: so many faces
// times the square of the number of solids.
#define MOST_TRIALS 4000000

/** One of them. */
@interface open_solid_t : NSObject
{
@public
  NSArray *faces;
  NSString *name;       // the faces'
  struct shell_edge edge;
  BOOL is_told;
}
@end

@implementation open_solid_t

- (void) dealloc
{
  [faces release];
  [super dealloc];
}

@end

@implementation open_solids_t

- (id) init
{
  if ((self = [super init]))
    {
      solids = [NSMutableArray new];
    }
  return self;
}

- (void) dealloc
{
  [solids release];
  [super dealloc];
}

- (void) add: (NSArray *)faces edge: (struct shell_edge)edge
{
  open_solid_t *solid = [open_solid_t new];

  solid->faces = [faces retain];
  solid->name = ((polygon_t *)[faces objectAtIndex: 0])->solid_name;
  solid->edge = edge;
  [solids addObject: solid];
  [solid release];
}

static BOOL
are_closed(NSArray *faces)
{
  struct shell_edge open;
  struct shell_face *f = [solid_t newShellFaces: faces];
  BOOL are_closed = shells_close(f, [faces count], &open) > 0;

  free(f);
  return are_closed;
}

/** Tells that a face which names one solid was meant for another one. */
- (void) tellSlip: (polygon_t *)face from: (open_solid_t *)from
               to: (open_solid_t *)to diag: (diag_t *)diag
{
  from->is_told = to->is_told = YES;
  [diag fault: face->solid_place : @"solid '%@' is not closed, nor is '%@'"
    @" without polygon '%@'; did you mean '%@'?", from->name, to->name,
        [face name], to->name];
}

/** Whether the face with the open edge is all that is wrong: without it there
    is nothing left or a closed solid, and with it the other one is closed. */
- (BOOL) isSlip: (polygon_t *)face from: (open_solid_t *)from
             to: (open_solid_t *)to
{
  NSMutableArray *rest = [NSMutableArray arrayWithArray: from->faces];

  [rest removeObjectIdenticalTo: face];
  return ([rest count] == 0 || are_closed(rest))
    && are_closed([to->faces arrayByAddingObject: face]);
}

/** Of smaller solids `parts` that together close a solid, all faces were meant
    for that. */
- (void) join: (NSArray *)parts to: (open_solid_t *)whole diag: (diag_t *)diag
{
  NSMutableArray *all = [NSMutableArray arrayWithArray: whole->faces];

  for (open_solid_t *part in parts)
    {
      [all addObjectsFromArray: part->faces];
    }
  if ([parts count] > 0 && are_closed(all))
    {
      for (open_solid_t *part in parts)
        {
          [self tellSlip: [part->faces objectAtIndex: 0] from: part to: whole
                    diag: diag];
        }
    }
}

/** The solids that are smaller, not told, and have a similar name if that is
    asked for. */
- (NSArray *) partsOf: (open_solid_t *)whole areNear: (BOOL)are_near
{
  NSMutableArray *parts = [NSMutableArray array];
  NSArray *names = [NSArray arrayWithObject: whole->name];

  for (open_solid_t *other in solids)
    {
      if (!other->is_told && [other->faces count] < [whole->faces count]
          && (!are_near || [diag_t nearestTo: other->name among: names]))
        {
          [parts addObject: other];
        }
    }
  return parts;
}

- (void) tellSlips: (diag_t *)diag
{
  for (open_solid_t *from in solids)
    {
      polygon_t *face = [from->faces objectAtIndex: from->edge.face];
      for (open_solid_t *to in solids)
        {
          if (from != to && !from->is_told && !to->is_told
              && [self isSlip: face from: from to: to])
            {
              [self tellSlip: face from: from to: to diag: diag];
            }
        }
    }
  for (open_solid_t *whole in solids)
    {
      if (!whole->is_told)
        {
          [self join: [self partsOf: whole areNear: YES] to: whole diag: diag];
        }
      for (open_solid_t *part in [self partsOf: whole areNear: NO])
        {
          if (!whole->is_told)
            {
              [self join: [NSArray arrayWithObject: part] to: whole diag: diag];
            }
        }
    }
}

- (void) tellEdge: (open_solid_t *)solid diag: (diag_t *)diag
{
  struct shell_edge open = solid->edge;
  polygon_t *face = [solid->faces objectAtIndex: open.face];
  NSString *how = open.faces == 1 ? @"belongs to no other face"
    : open.faces == 2 ? @"has its two faces the wrong way round"
    : [NSString stringWithFormat: @"is in %u faces", open.faces];

  [diag fault: face->solid_place : @"solid '%@' is not closed: the edge"
    @" from (%.6g %.6g %.6g) to (%.6g %.6g %.6g) of polygon '%@' %@",
        solid->name, open.a.x, open.a.y, open.a.z, open.b.x, open.b.y,
        open.b.z, [face name], how];
}

- (void) tell: (diag_t *)diag
{
  double faces = 0, count = [solids count];

  for (open_solid_t *solid in solids)
    {
      faces += [solid->faces count];
    }
  if (faces * count * count <= MOST_TRIALS)
    {
      [self tellSlips: diag];
    }
  for (open_solid_t *solid in solids)
    {
      if (!solid->is_told)
        {
          [self tellEdge: solid diag: diag];
        }
    }
}

@end
