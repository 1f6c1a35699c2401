// A glTF primitive in the world, and many of them as one mesh.
#ifndef oversketch_applications_files_gltf_part_h
#define oversketch_applications_files_gltf_part_h

#include "gltf_document.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace oversketch_files
{

struct GltfPart
{
  std::map<std::string, GltfNumbers> attributes; // POSITION among them
  std::vector<vtkIdType> corners;                // three a triangle
  Json::Value material;                          // materialOf
};

// All parts as one mesh, with the attributes that all have; `lost` are the others. What has no colour is
// white, what has no place on a picture is at (-1, -1).
vtkSmartPointer<vtkPolyData> joinedMesh(const std::vector<GltfPart>& parts, std::set<std::string>& lost);

} // namespace oversketch_files
#endif
