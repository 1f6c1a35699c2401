// What single precision, which some formats hold alone, costs far from the origin.
#ifndef oversketch_applications_files_precision_h
#define oversketch_applications_files_precision_h

#include "pieces.h"

#include "vtkPolyData.h"

#include <array>
#include <string>
#include <vector>

namespace oversketch_files
{

// How far points move where they are rounded to single precision [the mesh's units], as words with the share
// of the mesh's size; "" up to 1e-4 of that, which nobody sees.
std::string lostInSingle(vtkPolyData* mesh);

// How far apart numbers of single precision lie where a mesh of such points is, alike; "" for other points.
std::string singleSteps(vtkPolyData* mesh);

// The middle of meshes that lie so far from the origin that single precision would round them by more than
// 1e-6 of their size; zeros for others.
std::array<double, 3> nearOrigin(const std::vector<Piece>& pieces);

} // namespace oversketch_files
#endif
