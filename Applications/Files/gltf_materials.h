// What a glTF document's materials leave of themselves in a mesh: the pictures of their base colours.
#ifndef oversketch_applications_files_gltf_materials_h
#define oversketch_applications_files_gltf_materials_h

#include "gltf_document.h"

#include <map>
#include <set>
#include <string>

namespace oversketch_files
{

struct GltfSkin
{
  std::map<Json::Value, Json::Value> pictures; // of the primitives' materials; null for none of either
  std::set<std::string> dropped;               // properties of materials that are not kept
};

// What stands for a primitive's material in them.
Json::Value materialOf(const GltfDocument& document, const Json::Value& primitive);

GltfSkin skinOf(const GltfDocument& document);

// The bytes of a picture. Throws Failed where it cannot be read.
std::string soundPicture(GltfDocument& document, const Json::Value& index);

} // namespace oversketch_files
#endif
