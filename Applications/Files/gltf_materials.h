// What a glTF document's materials leave of themselves in a mesh: the picture of the base colour.
#ifndef oversketch_files_gltf_materials_h
#define oversketch_files_gltf_materials_h

#include "gltf_document.h"

#include <set>
#include <string>

namespace oversketch_files
{

// What the base colours of all primitives have in common.
struct GltfSkin
{
  std::set<Json::Value> pictures; // of the primitives; null for one without
  std::set<std::string> dropped;  // properties of materials that are not kept
};

GltfSkin skinOf(const GltfDocument& document);

// The bytes of a picture. Throws Failed where it cannot be read.
std::string soundPicture(GltfDocument& document, const Json::Value& index);

} // namespace oversketch_files
#endif
