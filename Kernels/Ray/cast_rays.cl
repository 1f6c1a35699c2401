// First exits of rays from a triangle mesh: one work-item per ray, the rays of a vertex side by side. Walks the tree of
// bvh.h with a short stack, no recursion. Whole subtrees are left out whose facets all face the ray. Triangles are tested
// as Woop, Benthin and Wald do ("Watertight ray/triangle intersection", 2013): edge functions of shared edges are exact
// negatives of each other, so no ray slips between two triangles; contraction would break that.
#pragma OPENCL FP_CONTRACT OFF

// Sizes of Bvh::Node and Bvh::Pack in float8, and where children and normals stand in a node, in int and char8.
#define NODE 9
#define CHILDREN 48
#define NORMALS 28
#define PACK 10
// As in ray_caster.h.
#define NEAREST_EXIT 1e-6f

int least(int8 x)
{
  const int4 a = min(x.lo, x.hi);
  const int2 b = min(a.lo, a.hi);
  return min(b.x, b.y);
}

float leastOf(float8 x)
{
  const float4 a = min(x.lo, x.hi);
  const float2 b = min(a.lo, a.hi);
  return min(b.x, b.y);
}

// As in ray_caster.h, in the same order of operations.
int leavesThrough(global const float4* facet, const float* d, int place)
{
  const float4 a = facet[0], b = facet[1];
  return a.x * d[0] + a.y * d[1] + a.z * d[2] > 0.0f && as_int(a.w) != place && as_int(b.x) != place &&
    as_int(b.y) != place;
}

// As in ray_caster.h.
int comesBefore(global const float4* facets, int a, int b)
{
  global const ulong* first = (global const ulong*)(facets + 4 * a) + 3;
  global const ulong* second = (global const ulong*)(facets + 4 * b) + 3;
  for (int k = 0; k < 4; ++k)
  {
    if (first[k] != second[k])
    {
      return first[k] < second[k];
    }
  }
  return a < b;
}

// One step of a sorting network: each lane with its partner, the lanes of `lower` get the greater.
int8 step8(int8 x, int8 partner, int8 lower)
{
  return select(min(x, partner), max(x, partner), lower);
}

// Descending.
int8 sorted(int8 x)
{
  x = step8(x, x.s10325476, (int8)(-1, 0, 0, -1, -1, 0, 0, -1));
  x = step8(x, x.s23016745, (int8)(-1, -1, 0, 0, 0, 0, -1, -1));
  x = step8(x, x.s10325476, (int8)(-1, 0, -1, 0, 0, -1, 0, -1));
  x = step8(x, x.s45670123, (int8)(-1, -1, -1, -1, 0, 0, 0, 0));
  x = step8(x, x.s23016745, (int8)(-1, -1, 0, 0, -1, -1, 0, 0));
  return step8(x, x.s10325476, (int8)(-1, 0, -1, 0, -1, 0, -1, 0));
}

kernel void cast_rays(global const float8* nodes, global const float8* packs, global const float4* facets,
  global const float4* points, global const int* places, global const int* vertices,
  global const float* directions, const int raysPerVertex, const int rays, global float2* hits)
{
  const int ray = (int)get_global_id(0);
  if (ray >= rays)
  {
    return;
  }
  const int group = ray / raysPerVertex;
  const int origin = vertices[group];
  const int place = places[origin];
  const float4 from = points[origin];
  const float o[3] = { from.x, from.y, from.z };
  const float d[3] = { directions[3 * ray], directions[3 * ray + 1], directions[3 * ray + 2] };

  // For boxes: reciprocals, kept finite, and which bound comes first along each axis.
  float inverse[3];
  int first[3];
  int facing[3]; // which bound of the normals is the farther one along the ray
  for (int k = 0; k < 3; ++k)
  {
    inverse[k] = 1.0f / (fabs(d[k]) > 1e-20f ? d[k] : copysign(1e-20f, d[k]));
    first[k] = inverse[k] < 0.0f ? 3 : 0; // not d: it may be -0
    facing[k] = inverse[k] < 0.0f ? k : 3 + k;
  }
  // For triangles: the axis of the largest component, and the shear that lays the ray along it.
  int kz = fabs(d[0]) > fabs(d[1]) ? 0 : 1;
  kz = fabs(d[2]) > fabs(d[kz]) ? 2 : kz;
  int kx = kz == 2 ? 0 : kz + 1;
  int ky = kx == 2 ? 0 : kx + 1;
  if (d[kz] < 0.0f)
  {
    const int swap = kx;
    kx = ky;
    ky = swap;
  }
  const float sx = d[kx] / d[kz];
  const float sy = d[ky] / d[kz];
  const float sz = 1.0f / d[kz];
  const float okx = o[kx], oky = o[ky], okz = o[kz];

  float best = MAXFLOAT;
  int bestTriangle = -1;
  // A waiting child: how near it is, its last bits replaced by its place in the node; and the node.
  int keys[STACK_SIZE];
  int parents[STACK_SIZE];
  int top = 0;
  int at = 0;
  while (true)
  {
    if (at >= 0)
    {
      global const float8* node = nodes + NODE * at;
      const float8 near8 = max(max((node[first[0]] - o[0]) * inverse[0], (node[1 + first[1]] - o[1]) * inverse[1]),
        max((node[2 + first[2]] - o[2]) * inverse[2], (float8)(NEAREST_EXIT)));
      // Widened by the rounding of the products, so that no box is missed that holds a hit.
      const float8 far8 = 1.000001f *
        min(min((node[3 - first[0]] - o[0]) * inverse[0], (node[4 - first[1]] - o[1]) * inverse[1]),
          min((node[5 - first[2]] - o[2]) * inverse[2], (float8)(best)));
      // In the order of operations of leavesThrough(): rounding keeps the bound a bound.
      global const char8* normal = (global const char8*)node + NORMALS;
      const float8 leaving = convert_float8(normal[facing[0]]) * d[0] + convert_float8(normal[facing[1]]) * d[1] +
        convert_float8(normal[facing[2]]) * d[2];
      const int8 entered = (near8 <= far8) & (leaving > 0.0f);
      const int8 key = (as_int8(near8) & ~7) | (int8)(0, 1, 2, 3, 4, 5, 6, 7);
      const int nearest = least(select((int8)(INT_MAX), key, entered));
      if (nearest != INT_MAX)
      {
        // The others wait, nearer ones above farther ones; the nearest, and what was not entered, end up above the top.
        vstore8(sorted(select((int8)(INT_MIN), key, entered)), 0, keys + top);
        vstore8((int8)(at), 0, parents + top);
        const int4 count4 = entered.lo + entered.hi;
        const int2 count2 = count4.lo + count4.hi;
        top -= count2.x + count2.y + 1;
        at = ((global const int*)node)[CHILDREN + (nearest & 7)];
        continue;
      }
    }
    else
    {
      global const float8* pack = packs + PACK * (-2 - at);
      const float8 az = pack[kz] - okz;
      const float8 bz = pack[3 + kz] - okz;
      const float8 cz = pack[6 + kz] - okz;
      const float8 ax = (pack[kx] - okx) - sx * az;
      const float8 bx = (pack[3 + kx] - okx) - sx * bz;
      const float8 cx = (pack[6 + kx] - okx) - sx * cz;
      const float8 ay = (pack[ky] - oky) - sy * az;
      const float8 by = (pack[3 + ky] - oky) - sy * bz;
      const float8 cy = (pack[6 + ky] - oky) - sy * cz;
      const float8 u = cx * by - cy * bx;
      const float8 v = ax * cy - ay * cx;
      const float8 w = bx * ay - by * ax;
      // A triangle seen edge on divides zero by zero, and one that touches the origin has the distance zero; comparisons
      // are false for both.
      const float8 area = u + v + w;
      const float8 distance8 = (u * az + v * bz + w * cz) * sz / area;
      int8 found = ((u >= 0.0f & v >= 0.0f & w >= 0.0f) | (u <= 0.0f & v <= 0.0f & w <= 0.0f)) &
        (distance8 > NEAREST_EXIT) & (distance8 <= best);
      float distance = leastOf(select((float8)(MAXFLOAT), distance8, found));
      if (distance < MAXFLOAT)
      {
        // Seen from behind, where the ray leaves, the corners run the other way round. That settles it unless the ray
        // all but grazes the facet; only then is the facet's normal fetched.
        const float8 abx = bx - ax, aby = by - ay, abz = (bz - az) * sz;
        const float8 acx = cx - ax, acy = cy - ay, acz = (cz - az) * sz;
        const float8 doubt = 1e-3f * (fabs(aby * acz - abz * acy) + fabs(abz * acx - abx * acz)) +
          1e-6f * (fabs(abx) + fabs(aby) + fabs(acx) + fabs(acy));
        found &= area < doubt;
        const int8 sure = area < -doubt;
        const int8 ids = as_int8(pack[9]);
        distance = leastOf(select((float8)(MAXFLOAT), distance8, found));
        while (distance < MAXFLOAT & distance <= best)
        {
          // The nearest; of several one after the other.
          const int8 chosen = found & (distance8 == distance);
          const int id = least(select((int8)(INT_MAX), ids, chosen));
          const int settled = least(select((int8)(0), sure, chosen & (ids == id)));
          found &= ids != id;
          if (settled || leavesThrough(facets + 4 * id, d, place))
          {
            if (distance < best || bestTriangle < 0 || comesBefore(facets, id, bestTriangle))
            {
              best = distance;
              bestTriangle = id;
            }
            if (!any(found & (distance8 == distance)))
            {
              break;
            }
          }
          distance = leastOf(select((float8)(MAXFLOAT), distance8, found));
        }
      }
    }
    // Skip what lies behind the hit found meanwhile.
    do
    {
      --top;
    } while (top >= 0 && as_float(keys[top] & ~7) > best);
    if (top < 0)
    {
      break;
    }
    at = ((global const int*)(nodes + NODE * parents[top]))[CHILDREN + (keys[top] & 7)];
  }
  hits[ray] = (float2)(best, as_float(bestTriangle));
}
