// The pictures of base colours that a glTF document's materials give to a mesh, and how these lie on it.
#ifndef oversketch_applications_files_gltf_materials_h
#define oversketch_applications_files_gltf_materials_h

#include "gltf_document.h"

#include <Eigen/Geometry>

#include <map>
#include <set>
#include <string>

namespace oversketch_files
{

// The picture of a material: which, on which set of texture coordinates, and what moves those
// (KHR_texture_transform).
struct GltfTexture
{
  Json::Value picture; // null for none
  unsigned set = 0;
  Eigen::Affine2d placed = Eigen::Affine2d::Identity();
};

struct GltfSkin
{
  std::map<Json::Value, GltfTexture> textures; // of the primitives' materials; null for none
  std::set<std::string> dropped;               // what is not kept, in a user's words
};

// What stands for a primitive's material in them.
Json::Value materialOf(const GltfDocument& document, const Json::Value& primitive);

GltfSkin skinOf(const GltfDocument& document);

// Throws Failed where the document requires an extension that is not read, as its standard asks.
void requireKnownExtensions(const GltfDocument& document);

// Adds what the document has beside meshes and materials.
void addDropped(const GltfDocument& document, std::set<std::string>& dropped);

// The bytes of a picture. Throws Failed where it cannot be read.
std::string soundPicture(GltfDocument& document, const Json::Value& index);

} // namespace oversketch_files
#endif
