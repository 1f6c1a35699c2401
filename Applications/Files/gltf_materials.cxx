#include "gltf_materials.h"

#include "texture.h"

namespace oversketch_files
{

namespace
{

// The picture of a material; null for one without.
Json::Value pictureNamed(const GltfDocument& document, const Json::Value& material, GltfSkin& skin)
{
  const Json::Value& base = material["pbrMetallicRoughness"];
  const Json::Value& texture = document.find("textures", base["baseColorTexture"]["index"]);
  const Json::Value& sampler = document.find("samplers", texture["sampler"]);
  if (sampler.get("wrapS", 10497) != 10497 || sampler.get("wrapT", 10497) != 10497)
  {
    skin.dropped.insert("wrapping of textures");
  }
  for (const char* name : { "baseColorFactor", "metallicRoughnessTexture" })
  {
    if (base.isMember(name))
    {
      skin.dropped.insert(name);
    }
  }
  for (const std::string& name : material.getMemberNames())
  {
    if (name != "pbrMetallicRoughness" && name != "name")
    {
      skin.dropped.insert(name);
    }
  }
  if (base["baseColorTexture"].get("texCoord", 0) != 0)
  {
    skin.dropped.insert("baseColorTexture on a second set of coordinates");
    return {}; // other coordinates than those that are read
  }
  return texture["source"];
}

} // namespace

Json::Value materialOf(const GltfDocument& document, const Json::Value& primitive)
{
  return document.find("materials", primitive["material"]).isObject() ? primitive["material"] : Json::Value();
}

GltfSkin skinOf(const GltfDocument& document)
{
  GltfSkin skin;
  for (const Json::Value& mesh : document.json()["meshes"])
  {
    for (const Json::Value& primitive : mesh["primitives"])
    {
      skin.pictures[materialOf(document, primitive)];
    }
  }
  for (auto& [index, picture] : skin.pictures)
  {
    const Json::Value& material = document.find("materials", index);
    picture = material.isObject() ? pictureNamed(document, material, skin) : Json::Value();
  }
  return skin;
}

std::string soundPicture(GltfDocument& document, const Json::Value& index)
{
  std::string picture = document.picture(index);
  if (!pictureOf(picture))
  {
    const Json::Value& uri = document.find("images", index)["uri"];
    const bool isFile = uri.isString() && uri.asString().rfind("data:", 0) != 0;
    document.refuse("its picture " +
                    (isFile ? uri.asString().substr(0, 60) : index.toStyledString().substr(0, 10)) +
                    " is absent or " + notAPicture + "; mend it or take it out of the file");
  }
  return picture;
}

} // namespace oversketch_files
