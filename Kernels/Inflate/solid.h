// A surface made of a drawing's mesh: its front, its back and the walls between them.
#ifndef oversketch_kernels_inflate_solid_h
#define oversketch_kernels_inflate_solid_h

#include "Mesh/mesh.h"

#include <array>
#include <vector>

namespace oversketch
{

struct SolidPoint
{
  Vector3 place = Vector3::Zero(); // world
  int side = 0;                    // 1 front, -1 back, 0 on a seam or a wall
  int planar = -1;                 // the point of the drawing's mesh that it is made of
  bool isBase = false;             // that one is of the coarse mesh
  int source = -1;                 // the point of the step's input whose other values it has
};

// A triangle, corner[3] < 0, or a quad; counter-clockwise seen from outside.
struct SolidFace
{
  std::array<int, 4> corners{ -1, -1, -1, -1 };
  int side = 0;    // as of points; 0 of a wall
  int source = -1; // the face of the step's input that it is, or that a wall hangs on

  int count() const { return this->corners[3] < 0 ? 3 : 4; }
};

struct Solid
{
  std::vector<SolidPoint> points;
  std::vector<SolidFace> faces;
};

} // namespace oversketch
#endif
