// Where curve points hang on the mesh: their triangles, and the triangles round a vertex. A part of the
// snake.
#ifndef oversketch_kernels_silhouette_fan_h
#define oversketch_kernels_silhouette_fan_h

#include "Silhouette/curves.h"

#include <algorithm>
#include <vector>

namespace oversketch
{

// The vertices that hold up a point, each once.
struct Support
{
  int vertices[9];
  int count = 0;
  void add(const Binding& binding)
  {
    for (int v : binding.vertices)
    {
      if (!this->holds(v))
      {
        this->vertices[this->count++] = v;
      }
    }
  }
  bool holds(int v) const
  {
    return std::find(this->vertices, this->vertices + this->count, v) != this->vertices + this->count;
  }
};

// The first triangle that has all of these vertices, or -1.
int triangleWith(const Mesh& mesh, const Adjacency& adjacency, const Support& support);

// The neighbours of a vertex in order round it, as far as they can be reached over edges of two triangles.
// Places in it are numbered: 2k is the spoke to link[k], 2k + 1 lies between the spokes k and k + 1.
struct Fan
{
  int centre;
  std::vector<int> link;
  bool closed = false;

  int places() const { return 2 * static_cast<int>(this->link.size()); }

  // The place of what hangs on the centre, its neighbours or both; -1 where that is none.
  int placeOf(const Binding& binding) const;
};

// The fan round a corner of a triangle.
Fan fanOf(const Mesh& mesh, const Adjacency& adjacency, int centre, int triangle);

} // namespace oversketch
#endif
