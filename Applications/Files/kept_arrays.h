// Which arrays of a mesh a format is asked to keep, and what they are called to who reads a note.
#ifndef oversketch_applications_files_kept_arrays_h
#define oversketch_applications_files_kept_arrays_h

#include "files.h"

#include "vtkPolyData.h"

#include <set>
#include <string>

class vtkAbstractArray;

namespace oversketch_files
{

// Arrays that a system made for itself, such as those of a 4-8 mesh or of an inflated drawing: nobody misses
// them in a file that holds the surface alone.
std::set<vtkAbstractArray*> ownArrays(vtkPolyData* mesh);

// Says, in a user's words, what of the mesh is neither a system's own nor among the arrays that are kept.
void noteDropped(vtkPolyData* mesh,
  const std::string& format,
  std::set<vtkAbstractArray*> kept,
  Notes& notes);

} // namespace oversketch_files
#endif
