// A glTF document, .gltf or .glb: its JSON, and the numbers and pictures that it names. Why not
// vtkGLTFReader: it trusts indices, counts and offsets of the file, follows nodes in a circle, and opens what
// is no file.
#ifndef oversketch_applications_files_gltf_document_h
#define oversketch_applications_files_gltf_document_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtk_jsoncpp.h"

#include <Eigen/Geometry>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace oversketch_files
{

// The numbers of an accessor, those that are normalized from 0 or -1 to 1.
struct GltfNumbers
{
  std::size_t count = 0;
  std::size_t components = 0;
  std::vector<double> values; // count times components
};

class GltfDocument
{
public:
  // All members throw Failed, which names file and member.
  explicit GltfDocument(const std::string& path);

  const Json::Value& json() const { return this->Root; }
  // A member of one of the document's lists, such as ("accessors", 3).
  const Json::Value& at(const std::string& list, const Json::Value& index) const;
  // The same; null where it is not there.
  const Json::Value& find(const std::string& list, const Json::Value& index) const;
  // The numbers of an accessor.
  GltfNumbers numbers(const Json::Value& accessor);
  // The bytes of a picture; empty where they cannot be had.
  std::string picture(const Json::Value& index);
  // Takes so many numbers of what the file may ask for, which is counted against its size and that of the
  // buffers that were read: many nodes may name one mesh.
  void spend(std::size_t numbers);

  [[noreturn]] void refuse(const std::string& why) const;
  // Refuses an object with an extension that compresses what it names, such as Draco's or meshopt's.
  void refuseCompressed(const Json::Value& object) const;

private:
  const std::string& buffer(const Json::Value& index);
  std::string resolved(const std::string& uri) const;
  std::size_t whole(const Json::Value& object, const char* member, const std::string& where) const;
  // The bytes [offset, offset + length) of a buffer view.
  const char* viewed(const Json::Value& view,
    std::size_t offset,
    std::size_t length,
    const std::string& where);
  // count elements of `components` numbers each, from a buffer view.
  void readInto(const Json::Value& description,
    int type,
    bool isNormalized,
    std::size_t components,
    std::size_t count,
    const std::string& where,
    std::vector<double>& values);

  std::string Path;
  std::filesystem::path Folder;
  Json::Value Root;
  std::string Binary;
  std::map<unsigned, std::string> Buffers;
  std::size_t Size = 0, Spent = 0;
};

// The picture of a material's base colour: which, on which set of texture coordinates, and what moves those
// (KHR_texture_transform). This and what follows up to soundPicture: gltf_materials.cxx.
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

// The words that stand for a primitive's material in them.
Json::Value materialOf(const GltfDocument& document, const Json::Value& primitive);

GltfSkin skinOf(const GltfDocument& document);

// Throws Failed where the document requires an extension that is not read, as its standard asks.
void requireKnownExtensions(const GltfDocument& document);

// Adds what the document has beside meshes and materials.
void addDropped(const GltfDocument& document, std::set<std::string>& dropped);

// The bytes of a picture. Throws Failed where it cannot be read.
std::string soundPicture(GltfDocument& document, const Json::Value& index);

// A primitive in the world, and many of them as one mesh (gltf_part.cxx).
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
