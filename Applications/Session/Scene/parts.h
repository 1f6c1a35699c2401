// Parts of a model: meshes that are put beside each other, each at its place.
#ifndef oversketch_applications_session_scene_parts_h
#define oversketch_applications_session_scene_parts_h

#include "outcome.h"
#include "session.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Core>

#include <map>
#include <set>
#include <vector>

namespace oversketch_session
{

// Left, bottom, right and top of what is placed: the canvas that it was drawn on (field array Canvas), else
// what it covers in x and y.
Eigen::Vector4d rectangleOf(vtkPolyData* mesh);

// The mesh with its placement, as vtkOversketchAssemble takes it. Materials of the file that it was read from
// mean nothing in the whole.
vtkSmartPointer<vtkPolyData> placedBy(const Eigen::Matrix4d& matrix, vtkPolyData* mesh);

// A mesh with one more part: its PartId is the next after those of the mesh. Throws oversketch::Error where
// it cannot be put there.
vtkSmartPointer<vtkPolyData> withPart(vtkPolyData* mesh, vtkPolyData* part, const PartPlace& place);

// Tells what made the parts of the mesh that a model shows, by their numbers (cell array PartId; a mesh
// without that is one part, 0). Of outcomes of its nodes, or the first of them.
using PartSources = std::map<int, PartSource>;
PartSources sourcesOf(const Model& model, const std::vector<Outcome>& outcomes);
// Which part that is: one of which nothing is known by its number alone.
PartSource sourceOf(const PartSources& parts, int number);
// The numbers of those that are hidden. None of a mesh that is one part: the model itself is seen or hidden.
std::set<int> hiddenOf(const Model& model, const PartSources& parts);

// Says what is wrong with a place, in words; empty where nothing is.
std::string faultOf(const PartPlace& place);

} // namespace oversketch_session
#endif
