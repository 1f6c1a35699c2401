// Faults that keep a triangle mesh from being printed, and how thick its walls are.
#ifndef oversketch_kernels_print_print_check_h
#define oversketch_kernels_print_print_check_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace oversketch
{

// Bits of a face's faults.
enum PrintFault : std::uint8_t
{
  OpenFault = 1,      // an edge of it has no other face
  TurnedFault = 2,    // the face beyond an edge of it faces the other way
  CrowdedFault = 4,   // an edge of it has more than two faces
  CrossingFault = 8,  // it passes through another face
  InsideOutFault = 16 // it is of a body that is inside out
};

// Faces that edges and points join. One whose volume is less than zero is hollow where other bodies enclose
// it, and else inside out; neither is said of one with an open edge.
struct PrintBody
{
  int faces = 0;
  double volume = 0.0; // [length^3], positive where faces look outward
  bool isOpen = false, isHollow = false, isInsideOut = false;
};

struct PrintCheck
{
  // Edges with one face; holes are runs of such edges that points join. Of the longest: its length and the
  // middle of its edges.
  int openEdges = 0, holes = 0;
  double holeLength = 0.0;
  Vector3 holePlace = Vector3::Zero();
  int turnedEdges = 0;            // with two faces that both run along them the same way
  int crowdedEdges = 0;           // with more than two faces
  std::vector<PrintBody> bodies;  // in the order of their first faces
  int hollows = 0, insideOut = 0; // of the bodies
  double volume = 0.0;            // of all bodies, hollows taken off
  int crossings = 0;              // pairs of faces that pass through each other (crossingFaces)
  // Per face the length from its middle straight inward to where that leaves the body, hollows of it too;
  // -1 where it does not, and for faces without area. Other bodies that lie in the body do not count.
  std::vector<double> walls;
  std::vector<std::uint8_t> faults; // per face, bits of PrintFault
  std::vector<double> areas;        // per face
  double leastWall = -1.0;          // -1: none
  Vector3 size = Vector3::Zero();   // of the box round all faces

  // Area of the faces whose walls are thinner, or are sheets of no thickness.
  double thinArea(double wall) const;
  // Tells whether no face has a fault, no wall is thinner, and there is a body.
  bool isReady(double wall) const;
};

// Points with equal places count as one, and faces that then have a corner twice as none.
//
// Walls are single rays, not the cones of the shape diameter (Ray/shape_diameter.h): the median of a cone
// tells parts of a body apart, but is wider than the wall that a nozzle has to lay. Walls are exact at the
// middles of faces, so that a thin place within a large face may be missed.
//
// The answer is the same for any number of threads. Throws Error(Cancelled).
PrintCheck checkPrint(const Mesh& mesh, const Context& context = Context());

} // namespace oversketch
#endif
