// The triangle x point test (SEED, Sec. 3.2) for one triangle and the points of the grid cells that its box
// touches. REAL is double or float; the host does the same operations in the same order, so both decide
// alike.
#ifdef USE_DOUBLE
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
typedef double REAL;
#else
typedef float REAL;
#endif
#pragma OPENCL FP_CONTRACT OFF

REAL cross2(REAL ax, REAL ay, REAL bx, REAL by)
{
  return ax * by - ay * bx;
}

int cellOf(REAL value, REAL origin, REAL perUnit, int count)
{
  const REAL cell = (value - origin) * perUnit;
  return cell <= 0 ? 0 : cell >= (REAL)(count - 1) ? count - 1 : (int)cell;
}

// grid: x and y of the least and the greatest point, cells per unit in x and y.
kernel void occlude(int triangleCount,
  global const int* triangles,
  global const REAL* screen,
  constant REAL* grid,
  int columns,
  int rows,
  global const int* cellStarts,
  global const int* cellPoints,
  global const REAL* points,
  global const int* pointVertices,
  global uchar* occluded)
{
  const int triangle = get_global_id(0);
  if (triangle >= triangleCount)
  {
    return;
  }
  const int ia = triangles[3 * triangle], ib = triangles[3 * triangle + 1], ic = triangles[3 * triangle + 2];
  const REAL ax = screen[3 * ia], ay = screen[3 * ia + 1], az = screen[3 * ia + 2];
  const REAL bx = screen[3 * ib], by = screen[3 * ib + 1], bz = screen[3 * ib + 2];
  const REAL cx = screen[3 * ic], cy = screen[3 * ic + 1], cz = screen[3 * ic + 2];
  if (az == -INFINITY || bz == -INFINITY || cz == -INFINITY)
  {
    return;
  }
  const REAL left = min(ax, min(bx, cx)), right = max(ax, max(bx, cx));
  const REAL low = min(ay, min(by, cy)), high = max(ay, max(by, cy));
  if (right < grid[0] || left > grid[2] || high < grid[1] || low > grid[3])
  {
    return;
  }
  REAL area = cross2(bx - ax, by - ay, cx - ax, cy - ay);
  const REAL side = area < 0 ? (REAL)-1 : (REAL)1;
  area *= side;
  const REAL extent = max(right - left, high - low);
  if (!(area > (REAL)1e-12 * extent * extent))
  {
    return;
  }
  const int firstColumn = cellOf(left, grid[0], grid[4], columns),
            lastColumn = cellOf(right, grid[0], grid[4], columns);
  const int firstRow = cellOf(low, grid[1], grid[5], rows), lastRow = cellOf(high, grid[1], grid[5], rows);
  for (int row = firstRow; row <= lastRow; ++row)
  {
    const int end = cellStarts[row * columns + lastColumn + 1];
    for (int k = cellStarts[row * columns + firstColumn]; k < end; ++k)
    {
      const int p = cellPoints[k];
      const REAL px = points[3 * p], py = points[3 * p + 1], pz = points[3 * p + 2];
      if (px < left || px > right || py < low || py > high)
      {
        continue;
      }
      const REAL wa = side * cross2(bx - px, by - py, cx - px, cy - py);
      const REAL wb = side * cross2(cx - px, cy - py, ax - px, ay - py);
      const REAL wc = side * cross2(ax - px, ay - py, bx - px, by - py);
      if (wa < 0 || wb < 0 || wc < 0 || !(wa * (az - pz) + wb * (bz - pz) + wc * (cz - pz) > 0))
      {
        continue;
      }
      const int u = pointVertices[3 * p], v = pointVertices[3 * p + 1], w = pointVertices[3 * p + 2];
      if (ia != u && ia != v && ia != w && ib != u && ib != v && ib != w && ic != u && ic != v && ic != w)
      {
        occluded[p] = 1; // whoever writes, writes this
      }
    }
  }
}
