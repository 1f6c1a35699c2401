// Two closed bodies as one, with a crease where they meet.
#ifndef oversketch_kernels_join_unite_h
#define oversketch_kernels_join_unite_h

#include "Join/body.h"
#include "Mesh/context.h"

namespace oversketch
{

enum class JoinKind : int
{
  Join = 0,  // what either of them fills
  Cut = 1,   // what the first one fills and the second one does not
  Common = 2 // what both fill
};

struct United
{
  Body body;
  std::vector<char> isNew;   // per point: it lies where the bodies meet
  std::vector<char> changed; // per triangle: it is none of theirs
  bool meet = false;         // whether any faces of theirs cut each other
};

// Faces away from where the bodies meet keep their points, and those their bits: first those of the first
// body, then of the second one, in their order. Faces that are cut are triangulated anew. Two points nearer
// than `least` become one there, and triangles lower than that go into their neighbours.
//
// Bodies that touch within a quarter of that [model length] meet: points of the one at most so far from the
// other are taken to lie half of it further out (of what is cut away from, or common to both: further in)
// while the question is what is inside what.
//
// Throws Error(BadMesh) where a body is not closed, or goes through itself where the other one meets it, with
// its number from `first` on.
United unite(const Body& a, const Body& b, JoinKind kind, double least, const Context& context);

} // namespace oversketch
#endif
