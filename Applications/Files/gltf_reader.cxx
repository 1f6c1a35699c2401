// vtkGLTFReader reads the geometry; what it leaves of materials, the picture of the base colour, is taken
// from the document itself, with its own bytes.
#include "mesh_file.h"
#include "texture.h"

#include "vtkAppendPolyData.h"
#include "vtkBase64Utilities.h"
#include "vtkCompositeDataIterator.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkGLTFReader.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtk_jsoncpp.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace oversketch_files
{

namespace
{

std::string wholeFile(const fs::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

std::uint32_t word(const std::string& bytes, std::size_t at)
{
  std::uint32_t value = 0;
  if (at + 4 <= bytes.size())
  {
    std::memcpy(&value, bytes.data() + at, 4);
  }
  return value;
}

// "%20" to " ".
std::string unescaped(const std::string& uri)
{
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i)
  {
    if (uri[i] == '%' && i + 2 < uri.size())
    {
      text += static_cast<char>(std::strtol(uri.substr(i + 1, 2).c_str(), nullptr, 16));
      i += 2;
    }
    else
    {
      text += uri[i];
    }
  }
  return text;
}

// The JSON and the binary part of a .gltf or .glb.
class Document
{
public:
  explicit Document(const std::string& path)
    : Folder(fs::absolute(path).parent_path())
  {
    std::string text = wholeFile(path);
    if (text.compare(0, 4, "glTF") == 0)
    {
      const std::string all = std::move(text);
      const std::size_t length = word(all, 12), next = 20 + length;
      text = all.substr(std::min<std::size_t>(20, all.size()), length);
      if (next + 8 <= all.size())
      {
        this->Binary = all.substr(next + 8, word(all, next));
      }
    }
    const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder().newCharReader());
    std::string why;
    if (!reader->parse(text.data(), text.data() + text.size(), &this->Root, &why) || !this->Root.isObject())
    {
      throw Failed(path + ": is not glTF");
    }
  }

  const Json::Value& json() const { return this->Root; }

  // One of a list's members; null where it is not there.
  Json::Value at(const char* list, const Json::Value& index) const
  {
    const Json::Value& all = this->Root[list];
    return all.isArray() && index.isUInt() && index.asUInt() < all.size() ? all[index.asUInt()]
                                                                          : Json::Value();
  }

  // The bytes of a picture; empty where they cannot be had.
  std::string picture(const Json::Value& index) const
  {
    const Json::Value image = this->at("images", index);
    if (image["uri"].isString())
    {
      return this->resolved(image["uri"].asString());
    }
    const Json::Value view = this->at("bufferViews", image["bufferView"]);
    const Json::Value buffer = this->at("buffers", view["buffer"]);
    if (!view.isObject() || !buffer.isObject())
    {
      return {};
    }
    const std::string bytes =
      buffer["uri"].isString() ? this->resolved(buffer["uri"].asString()) : this->Binary;
    const std::size_t from = view.get("byteOffset", 0).asUInt(), length = view["byteLength"].asUInt();
    return from <= bytes.size() ? bytes.substr(from, length) : std::string();
  }

private:
  std::string resolved(const std::string& uri) const
  {
    if (uri.rfind("data:", 0) != 0)
    {
      return wholeFile(this->Folder / unescaped(uri));
    }
    const std::size_t comma = uri.find(',');
    if (comma == std::string::npos)
    {
      return {};
    }
    const std::string code = uri.substr(comma + 1);
    std::string bytes(code.size(), '\0');
    bytes.resize(vtkBase64Utilities::DecodeSafely(reinterpret_cast<const unsigned char*>(code.data()),
      code.size(),
      reinterpret_cast<unsigned char*>(bytes.data()),
      bytes.size()));
    return bytes;
  }

  fs::path Folder;
  Json::Value Root;
  std::string Binary;
};

// What the base colours of all primitives have in common.
struct Skin
{
  std::set<Json::Value> pictures; // of the primitives; null for one without
  std::set<std::string> dropped;  // properties of materials that are not kept
};

Skin skinOf(const Document& document)
{
  Skin skin;
  for (const Json::Value& mesh : document.json()["meshes"])
  {
    for (const Json::Value& primitive : mesh["primitives"])
    {
      const Json::Value material = document.at("materials", primitive["material"]);
      Json::Value picture;
      if (material.isObject())
      {
        const Json::Value& base = material["pbrMetallicRoughness"];
        const Json::Value texture = document.at("textures", base["baseColorTexture"]["index"]);
        picture = texture["source"];
        const Json::Value sampler = document.at("samplers", texture["sampler"]);
        if (sampler.get("wrapS", 10497) != 10497 || sampler.get("wrapT", 10497) != 10497)
        {
          skin.dropped.insert("wrapping of textures");
        }
        if (base["baseColorTexture"].get("texCoord", 0) != 0)
        {
          picture = Json::Value(); // other coordinates than those that are read
          skin.dropped.insert("baseColorTexture on a second set of coordinates");
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
      }
      skin.pictures.insert(picture);
    }
  }
  return skin;
}

// Colours as bytes, which the other formats and the window take; VTK reads them as floats.
void makeColoursBytes(vtkPointData* data, const std::string& path, Notes& notes)
{
  auto* colours = vtkFloatArray::SafeDownCast(data->GetArray("COLOR_0"));
  if (!colours || colours->GetNumberOfComponents() < 3)
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetName("COLOR_0");
  bytes->SetNumberOfComponents(colours->GetNumberOfComponents());
  bytes->SetNumberOfTuples(colours->GetNumberOfTuples());
  bool rounded = false;
  for (vtkIdType i = 0; i < colours->GetNumberOfValues(); ++i)
  {
    const float value = 255.0F * std::clamp(colours->GetValue(i), 0.0F, 1.0F);
    bytes->SetValue(i, static_cast<unsigned char>(std::lround(value)));
    rounded = rounded || std::abs(value - std::round(value)) > 1e-3F;
  }
  data->RemoveArray("COLOR_0");
  data->AddArray(bytes);
  if (rounded)
  {
    notes.push_back(path + ": COLOR_0 is rounded to 8 bits");
  }
}

std::set<std::string> arraysOf(vtkPointData* data)
{
  std::set<std::string> names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    names.insert(data->GetArrayName(i) ? data->GetArrayName(i) : "(no name)");
  }
  return names;
}

std::string joined(const std::set<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

// VTK's reader reads all pictures, and crashes on some that are damaged.
void requirePictures(const Document& document, const std::string& path)
{
  const Json::Value& images = document.json()["images"];
  for (Json::ArrayIndex i = 0; i < images.size(); ++i)
  {
    const Json::Value& uri = images[i]["uri"];
    const std::string name = uri.isString() ? uri.asString().substr(0, 60) : std::to_string(i);
    if (!pictureOf(document.picture(i)))
    {
      throw Failed(path + ": its picture " + name +
                   " is absent, damaged or neither PNG nor JPEG; mend it or take it out of the file");
    }
    if (name.rfind("data:", 0) != 0 && name.find('%') != std::string::npos)
    {
      throw Failed(path + ": its picture " + name + " has a name that is not read; rename it without spaces");
    }
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> readGltf(const std::string& path, Notes& notes)
{
  const Document document(path);
  Skin skin;
  std::string picture;
  try
  {
    requirePictures(document, path);
    skin = skinOf(document);
    if (skin.pictures.size() == 1 && !skin.pictures.begin()->isNull())
    {
      picture = document.picture(*skin.pictures.begin());
    }
  }
  catch (const Json::Exception& damage)
  {
    throw Failed(path + ": is damaged: " + damage.what());
  }
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(fs::absolute(path).c_str());
  takeError();
  reader->Update();
  const std::string error = takeError();
  if (!error.empty())
  {
    throw Failed(path + ": could not be read: " + error);
  }
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  vtkNew<vtkAppendPolyData> append;
  int parts = 0;
  std::set<std::string> lost;
  if (blocks)
  {
    auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      if (auto* part = vtkPolyData::SafeDownCast(it->GetCurrentDataObject()))
      {
        append->AddInputData(part);
        lost.merge(arraysOf(part->GetPointData()));
        ++parts;
      }
    }
  }
  if (parts == 0)
  {
    throw Failed(path + ": holds no mesh");
  }
  append->Update();
  takeError();
  vtkSmartPointer<vtkPolyData> mesh = append->GetOutput();
  mesh->GetFieldData()->Initialize(); // numbers of single parts
  if (parts > 1)
  {
    notes.push_back(path + ": its " + std::to_string(parts) + " parts are read as one mesh");
  }
  for (const std::string& name : arraysOf(mesh->GetPointData()))
  {
    lost.erase(name);
  }
  if (!lost.empty())
  {
    notes.push_back(path + ": arrays that only some of its parts have are dropped: " + joined(lost));
  }
  makeColoursBytes(mesh->GetPointData(), path, notes);
  if (vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords())
  {
    auto flipped = vtkSmartPointer<vtkDataArray>::Take(coordinates->NewInstance());
    flipped->DeepCopy(coordinates);
    for (vtkIdType i = 0; i < flipped->GetNumberOfTuples(); ++i)
    {
      flipped->SetComponent(i, 1, 1.0 - flipped->GetComponent(i, 1)); // glTF counts v from the top
    }
    mesh->GetPointData()->SetTCoords(flipped);
  }

  if (!picture.empty() && mesh->GetPointData()->GetTCoords())
  {
    setTexture(mesh, picture);
  }
  else if (skin.pictures.size() > 1)
  {
    skin.dropped.insert("baseColorTexture (one mesh has one picture, and its parts have several or none)");
  }
  else if (!skin.pictures.empty() && !skin.pictures.begin()->isNull())
  {
    skin.dropped.insert("baseColorTexture (it has no coordinates)");
  }
  for (const char* what : { "animations", "skins", "cameras", "extensionsUsed" })
  {
    if (document.json()[what].size() > 0)
    {
      skin.dropped.insert(what);
    }
  }
  if (!skin.dropped.empty())
  {
    notes.push_back(path + ": not kept: " + joined(skin.dropped));
  }
  return mesh;
}

} // namespace oversketch_files
