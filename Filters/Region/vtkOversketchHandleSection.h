/**
 * The matched section as vtkOversketchMixtureRegion reads it of the handles. For use in the .cxx of filters;
 * not wrapped.
 */
#ifndef vtkOversketchHandleSection_h
#define vtkOversketchHandleSection_h

#include <array>
#include <vector>

class vtkPolyData;

namespace oversketch
{

class MeshData;

/**
 * Vertices and lengths of the section.
 */
struct Section
{
  std::vector<int> seeds; // the vertices that the section's edges end at, ascending
  std::array<std::vector<int>, 2>
    ends;                // of each margin those that the stroke moves, and the seeds next to it
  double chord = 0.0;    // between its ends [model length]
  double movement = 0.0; // the largest, where it was asked for
  double depth = 0.0;    // the largest into the surface, likewise
};

/**
 * The field array SectionLength; throws Error(MissingArray) without it.
 */
double SectionLengthOf(vtkPolyData* handles);

/**
 * The section of some handles; moved: whether it matters how far the stroke moves it. Throws Error(BadRegion)
 * without handles, Error(MissingArray).
 */
Section SectionOf(vtkPolyData* handles, const MeshData& mesh, double margin, bool reachEnds, bool moved);

/**
 * Whether the section is one of a limb of such a diameter, which moves as a whole.
 */
bool OfLimb(const Section& section, double length, double diameter);

/**
 * The distance within which a body moves with the section [model length].
 */
double NearOf(const Section& section, double length, double diameter);

} // namespace oversketch
#endif
