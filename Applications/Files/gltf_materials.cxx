#include "gltf_document.h"

#include "files.h"
#include "texture.h"

#include <algorithm>

namespace oversketch_files
{

namespace
{

// Extensions that change neither shapes nor which picture is worn, beside those that are read.
bool isOfLooks(const std::string& extension)
{
  return extension.rfind("KHR_materials_", 0) == 0 || extension == "KHR_lights_punctual" ||
         extension == "KHR_xmp_json_ld";
}

bool isKnown(const std::string& extension)
{
  return extension == "KHR_texture_transform" || extension == "KHR_mesh_quantization";
}

std::string ofExtension(const std::string& name)
{
  return "what the extension " + printable(name) + " adds";
}

// Whether a member says what holds without it.
bool isDefault(const std::string& name, const Json::Value& value)
{
  const double usual = name == "baseColorFactor" ? 1.0 : 0.0;
  return value == false || value == "OPAQUE" ||
         (value.isArray() &&
           std::all_of(value.begin(),
             value.end(),
             [usual](const Json::Value& one) { return one.isNumeric() && one.asDouble() == usual; }));
}

// Adds the members of a material that are not kept, as what they are to who looks at it.
void dropMembers(const Json::Value& object, std::set<std::string>& dropped)
{
  static const std::map<std::string, std::string> known = { { "baseColorFactor",
                                                              "the tint of its materials" },
    { "metallicRoughnessTexture", "the pictures of metal and gloss" },
    { "normalTexture", "the pictures of small bumps (normal maps)" },
    { "occlusionTexture", "the pictures of shade (occlusion)" },
    { "emissiveTexture", "the pictures of what glows" },
    { "emissiveFactor", "what glows" },
    { "alphaMode", "how its materials let light through" },
    { "doubleSided", "that its faces are seen from both sides" },
    { "extras", "other programs' own data" } };
  for (const std::string& name : object.getMemberNames())
  {
    const auto words = known.find(name);
    if (words != known.end() && !isDefault(name, object[name]))
    {
      dropped.insert(words->second);
    }
  }
  for (const std::string& name :
    object["extensions"].isObject() ? object["extensions"].getMemberNames() : Json::Value::Members())
  {
    dropped.insert(ofExtension(name));
  }
}

double numberIn(const Json::Value& list, Json::ArrayIndex at, double otherwise)
{
  return list.isArray() && list.isValidIndex(at) && list[at].isNumeric() ? list[at].asDouble() : otherwise;
}

// How KHR_texture_transform places the picture of a texture's reference. It turns coordinates, which count
// from the top, against the clock as one looks at the picture.
Eigen::Affine2d placedBy(const Json::Value& transform)
{
  Eigen::Affine2d placed = Eigen::Affine2d::Identity();
  placed.translate(
    Eigen::Vector2d(numberIn(transform["offset"], 0, 0.0), numberIn(transform["offset"], 1, 0.0)));
  placed.rotate(-(transform["rotation"].isNumeric() ? transform["rotation"].asDouble() : 0.0));
  placed.scale(Eigen::Vector2d(numberIn(transform["scale"], 0, 1.0), numberIn(transform["scale"], 1, 1.0)));
  return placed;
}

GltfTexture textureNamed(const GltfDocument& document, const Json::Value& material, GltfSkin& skin)
{
  const Json::Value& base = material["pbrMetallicRoughness"];
  const Json::Value& reference = base["baseColorTexture"];
  const Json::Value& texture = document.find("textures", reference["index"]);
  const Json::Value& sampler = document.find("samplers", texture["sampler"]);
  if (sampler.get("wrapS", 10497) != 10497 || sampler.get("wrapT", 10497) != 10497)
  {
    skin.dropped.insert("that its pictures end, or turn round, at their edges (they are repeated)");
  }
  const auto factor = [&base](const char* name, double without)
  { return base[name].isNumeric() ? base[name].asDouble() : without; }; // 0 and 0.0 are two values of JSON
  if (factor("roughnessFactor", 1.0) != 1.0 || factor("metallicFactor", 0.0) != 0.0)
  {
    skin.dropped.insert("metal and gloss");
  }
  dropMembers(base, skin.dropped);
  dropMembers(material, skin.dropped);
  GltfTexture found;
  found.picture = texture["source"];
  if (texture.isObject() && found.picture.isNull())
  {
    dropMembers(texture, skin.dropped); // the picture is of another kind
  }
  const Json::Value& transform = reference["extensions"]["KHR_texture_transform"];
  const Json::Value& set = transform.isMember("texCoord") ? transform["texCoord"] : reference["texCoord"];
  found.set = set.isUInt() ? set.asUInt() : 0;
  found.placed = placedBy(transform);
  return found;
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
      skin.textures[materialOf(document, primitive)];
    }
  }
  for (auto& [index, texture] : skin.textures)
  {
    const Json::Value& material = document.find("materials", index);
    if (material.isObject())
    {
      texture = textureNamed(document, material, skin);
    }
  }
  return skin;
}

void requireKnownExtensions(const GltfDocument& document)
{
  for (const Json::Value& extension : document.json()["extensionsRequired"])
  {
    const std::string name = extension.isString() ? extension.asString() : "";
    if (!isKnown(name) && !isOfLooks(name))
    {
      const bool compressed = name.find("compression") != std::string::npos;
      document.refuse("requires the glTF extension " + printable(name.substr(0, 60)) +
                      ", which is not read; save the file " + (compressed ? "uncompressed" : "without it"));
    }
  }
}

void addDropped(const GltfDocument& document, std::set<std::string>& dropped)
{
  const std::pair<const char*, const char*> members[] = { { "animations", "its animations" },
    { "skins", "its skeleton (the pose is kept)" },
    { "cameras", "its cameras" } };
  for (const auto& [member, words] : members)
  {
    if (document.json()[member].size() > 0)
    {
      dropped.insert(words);
    }
  }
  for (const Json::Value& extension : document.json()["extensionsUsed"])
  {
    const std::string name = extension.isString() ? extension.asString() : "";
    const bool isOfMaterials = name.rfind("KHR_materials_", 0) == 0; // the materials say it
    if (!isKnown(name) && !isOfMaterials)
    {
      dropped.insert(name == "KHR_lights_punctual" ? "its lights" : ofExtension(name));
    }
  }
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
