// First exits of rays from a triangle mesh: one work-item per ray, the rays of a vertex side by side. Walks the tree of
// bvh.h with a short stack, no recursion. Triangles are tested as Woop, Benthin and Wald do ("Watertight ray/triangle
// intersection", 2013): edge functions of shared edges are exact negatives of each other, so no ray slips between two
// triangles; contraction would break that.
#pragma OPENCL FP_CONTRACT OFF

// Sizes of Bvh::Node and Bvh::Pack in float4.
#define NODE 8
#define PACK 10
// As in ray_caster.h.
#define NEAREST_EXIT 1e-6f

kernel void cast_rays(global const float4* nodes, global const float4* packs, global const float4* facets, global const float4* points, global const int* places, global const int* vertices, global const float* starts,
  global const float* directions, const int raysPerVertex, const int rays, global float* distances,
  global int* hits)
{
  const int ray = (int)get_global_id(0);
  if (ray >= rays)
  {
    return;
  }
  const int origin = vertices[ray / raysPerVertex];
  const float start = starts[ray / raysPerVertex];
  const int place = places[origin];
  const float4 from = points[origin];
  const float o[3] = { from.x, from.y, from.z };
  const float d[3] = { directions[3 * ray], directions[3 * ray + 1], directions[3 * ray + 2] };

  // For boxes: reciprocals, kept finite, and which bound comes first along each axis.
  float inverse[3];
  int first[3];
  for (int k = 0; k < 3; ++k)
  {
    inverse[k] = 1.0f / (fabs(d[k]) > 1e-20f ? d[k] : copysign(1e-20f, d[k]));
    first[k] = inverse[k] < 0.0f ? 3 : 0; // not d: it may be -0
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
  int stack[STACK_SIZE];
  float stackNear[STACK_SIZE];
  int top = 0;
  int at = 0;
  while (true)
  {
    if (at >= 0)
    {
      global const float4* node = nodes + NODE * at;
      const float4 near4 = max(max((node[first[0]] - o[0]) * inverse[0], (node[1 + first[1]] - o[1]) * inverse[1]),
        max((node[2 + first[2]] - o[2]) * inverse[2], (float4)(start)));
      // Widened by the rounding of the products, so that no box is missed that holds a hit.
      const float4 far4 = 1.000001f *
        min(min((node[3 - first[0]] - o[0]) * inverse[0], (node[4 - first[1]] - o[1]) * inverse[1]),
          min((node[5 - first[2]] - o[2]) * inverse[2], (float4)(best)));
      const int4 entered = near4 <= far4;
      if (any(entered))
      {
        const int bottom = top;
        const int4 child4 = as_int4(node[6]);
        const float nears[4] = { near4.x, near4.y, near4.z, near4.w };
        const int children[4] = { child4.x, child4.y, child4.z, child4.w };
        const int in[4] = { entered.x, entered.y, entered.z, entered.w };
        for (int i = 0; i < 4; ++i)
        {
          if (in[i] && children[i] != -1)
          {
            // Farther children below nearer ones.
            int slot = top++;
            for (; slot > bottom && stackNear[slot - 1] < nears[i]; --slot)
            {
              stack[slot] = stack[slot - 1];
              stackNear[slot] = stackNear[slot - 1];
            }
            stack[slot] = children[i];
            stackNear[slot] = nears[i];
          }
        }
      }
    }
    else
    {
      const int leaf = -2 - at;
      global const float4* pack = packs + PACK * (leaf >> 2);
      for (int p = 0; p <= (leaf & 3); ++p, pack += PACK)
      {
        const float4 az = pack[kz] - okz;
        const float4 bz = pack[3 + kz] - okz;
        const float4 cz = pack[6 + kz] - okz;
        const float4 ax = (pack[kx] - okx) - sx * az;
        const float4 bx = (pack[3 + kx] - okx) - sx * bz;
        const float4 cx = (pack[6 + kx] - okx) - sx * cz;
        const float4 ay = (pack[ky] - oky) - sy * az;
        const float4 by = (pack[3 + ky] - oky) - sy * bz;
        const float4 cy = (pack[6 + ky] - oky) - sy * cz;
        const float4 u = cx * by - cy * bx;
        const float4 v = ax * cy - ay * cx;
        const float4 w = bx * ay - by * ax;
        const int4 inside = (u >= 0.0f & v >= 0.0f & w >= 0.0f) | (u <= 0.0f & v <= 0.0f & w <= 0.0f);
        if (!any(inside))
        {
          continue;
        }
        // A triangle seen edge on divides zero by zero; comparisons with the result are false.
        const float4 distance4 = (u * az + v * bz + w * cz) * sz / (u + v + w);
        const int4 found = inside & (distance4 > NEAREST_EXIT) & (distance4 <= best);
        if (!any(found))
        {
          continue;
        }
        const int4 triangle4 = as_int4(pack[9]);
        const float candidates[4] = { distance4.x, distance4.y, distance4.z, distance4.w };
        const int ids[4] = { triangle4.x, triangle4.y, triangle4.z, triangle4.w };
        const int is[4] = { found.x, found.y, found.z, found.w };
        for (int i = 0; i < 4; ++i)
        {
          if (is[i] && (candidates[i] < best || (candidates[i] == best && ids[i] < bestTriangle)))
          {
            // leavesThrough() of ray_caster.h, in the same order of operations.
            const float4 a = facets[4 * ids[i]], b = facets[4 * ids[i] + 1];
            if (a.x * d[0] + a.y * d[1] + a.z * d[2] > 0.0f && as_int(a.w) != place && as_int(b.x) != place &&
              as_int(b.y) != place)
            {
              best = candidates[i];
              bestTriangle = ids[i];
            }
          }
        }
      }
    }
    // Skip what lies behind the hit found meanwhile.
    do
    {
      --top;
    } while (top >= 0 && stackNear[top] > best);
    if (top < 0)
    {
      break;
    }
    at = stack[top];
  }
  distances[ray] = best;
  hits[ray] = bestTriangle;
}
