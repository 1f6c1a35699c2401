// A surface made of a drawing's mesh: its front, its back and the walls between them. Inflation pushes the
// mesh out to both sides and seals it at its rim; extrusion moves it to both sides, with walls between.
// Tunnels are regions cut out of it, front and back.
#ifndef oversketch_kernels_inflate_solid_h
#define oversketch_kernels_inflate_solid_h

#include "Inflate/sheet.h"
#include "Mesh/mesh.h"
#include "Planar/planar_mesh.h"
#include "Raster/distance_maps.h"

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

// Joins a border of the front to that of the back by `rows` rows of quads, each two triangles where the face
// that the wall hangs on is one. Points between are equally spaced; all diagonals run the same way, so that
// points within the wall have six edges, four with quads. twins: of each point of the border that of the
// back.
void addWall(Solid& solid, const std::vector<BorderEdge>& border, const std::vector<int>& twins, int rows);

// Source: image-assisted modelling, section 12: M_front = M_p + heights and M_back = M_p - heights with its
// faces turned, no faces between them; points of a rim are shared. Points come in M_p's order, front and rim
// first, then the back; faces likewise. Points without a face are left out. heights: of heightsOf.
//
// Throws Error(Failure::BadMesh), naming points, for a mesh whose borders are not its rims (a hole that is
// not trimmed, a border of another kind), for an edge or face inside it whose corners all lie on rims and for
// a quad with two opposite corners on rims: front and back would coincide there, of the quad when it is cut
// into triangles; one more refinement removes the former, mergeQuads after repairTerminals makes none.
Solid inflate(const PlanarMesh& mesh, const std::vector<double>& heights);

enum class WallRows
{
  Refined, // 2^k rows after k refinements: 2 4^k triangles, 4^k quads for each border edge of the coarse mesh
  One
};

// Source: image-assisted modelling, section 13: all points at +depth and -depth, not shared, joined by walls
// at all rims. The printed count of the walls' faces, "2k triangles (k quads)", is 0 for k = 0: exponents
// were lost in print; what refinement makes of 2 triangles (1 quad) is meant here. One is the other reading
// of it, 2 2^k. Points: the front's, the back's, the walls'. Throws Error(Failure::BadStroke) for a depth
// that is not above 0, Error(Failure::BadMesh) as borderOf and edgesBetweenBasePoints do.
Solid extrude(const PlanarMesh& mesh, double depth, WallRows rows);

// Regions, each with 1 where its stroke is a tunnel, or that of a region round it.
std::vector<char> regionsInTunnels(const Classification& classification,
  const std::vector<Treatment>& treatments);

// Source: image-assisted modelling, section 14: the faces are removed after the surface has been made, so the
// tunnel's rim stands where it would without. That leaves two open loops, which the paper does not close;
// with `wall` they are joined as section 13 does, by 2^k rows. removed: 1 for faces to go, walls that hang on
// them among these. Points without a face go too; walls' points come last.
//
// Throws Error(Failure::BadMesh) for a tunnel that reaches a rim, takes other faces of the front than of the
// back, or leaves none.
Solid tunnel(const Solid& solid, const std::vector<char>& removed, bool wall);

} // namespace oversketch
#endif
