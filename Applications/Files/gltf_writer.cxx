// Why not vtkGLTFWriter: in VTK 9.1 it has no binary container (.glb) and leaves out normals and colours.
#include "colours.h"
#include "mesh_file.h"
#include "point_normals.h"
#include "sharp_edges.h"
#include "text.h"
#include "texture.h"

#include "vtkBase64Utilities.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtk_jsoncpp.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <fstream>
#include <map>
#include <type_traits>

namespace oversketch_files
{

namespace
{

// The document and its one buffer.
struct Builder
{
  Json::Value json;
  std::string buffer;
  std::map<std::string, int> pictures; // the textures of those that are there

  // Adds to one of the document's lists; gives the place in it.
  int append(const char* list, const Json::Value& one)
  {
    this->json[list].append(one);
    return static_cast<int>(this->json[list].size()) - 1;
  }

  // target: 34962 vertices, 34963 indices, 0 for what is neither.
  int addView(const void* data, std::size_t bytes, int target = 0)
  {
    Json::Value view;
    view["buffer"] = 0;
    view["byteOffset"] = Json::UInt64(this->buffer.size());
    view["byteLength"] = Json::UInt64(bytes);
    if (target)
    {
      view["target"] = target;
    }
    this->buffer.append(static_cast<const char*>(data), bytes);
    this->buffer.resize((this->buffer.size() + 3) / 4 * 4, '\0');
    return this->append("bufferViews", view);
  }

  // An accessor. componentType: 5121 unsigned byte, 5125 unsigned int, 5126 float.
  template <typename T>
  int add(const std::vector<T>& values, std::size_t components, int target = 34962)
  {
    static const char* const types[] = { "SCALAR", "VEC2", "VEC3", "VEC4" };
    Json::Value accessor;
    accessor["bufferView"] = this->addView(values.data(), values.size() * sizeof(T), target);
    accessor["componentType"] = std::is_same_v<T, float> ? 5126 : sizeof(T) == 1 ? 5121 : 5125;
    accessor["count"] = Json::UInt64(values.size() / components);
    accessor["type"] = types[components - 1];
    if (sizeof(T) == 1) // colours
    {
      accessor["normalized"] = true;
    }
    return this->append("accessors", accessor);
  }
};

// The first components of an array, from an origin.
std::vector<float> floatsOf(vtkDataArray* array, int components, const std::array<double, 3>& origin = {})
{
  std::vector<float> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      values.push_back(static_cast<float>(array->GetComponent(i, c) - origin[static_cast<std::size_t>(c)]));
    }
  }
  return values;
}

std::string base64(const std::string& bytes)
{
  std::vector<unsigned char> text(bytes.size() * 2 + 8);
  const auto length = vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()),
    static_cast<unsigned long>(bytes.size()),
    text.data());
  return std::string(reinterpret_cast<const char*>(text.data()), length);
}

// With normals, without which a reader has to show each triangle flat; where the mesh has none, with points
// of their own for both sides of its sharp edges.
vtkSmartPointer<vtkPolyData> litMesh(vtkPolyData* mesh)
{
  const bool has = mesh->GetPointData()->GetNormals() || mesh->GetNumberOfPolys() == 0;
  return has ? vtkSmartPointer<vtkPolyData>(mesh) : SharpEdges().look(withPointNormals(mesh));
}

// A primitive; what it holds goes into the buffer, positions from that origin.
Json::Value primitiveOf(Builder& builder, vtkPolyData* mesh, const std::array<double, 3>& origin)
{
  Json::Value primitive;
  primitive["mode"] = 4;
  Json::Value& attributes = primitive["attributes"];
  const std::vector<float> positions =
    floatsOf(mesh->GetPoints() ? mesh->GetPoints()->GetData() : nullptr, 3, origin);
  const int places = builder.add(positions, 3);
  attributes["POSITION"] = places;
  std::array<float, 3> low{ FLT_MAX, FLT_MAX, FLT_MAX }, high{ -FLT_MAX, -FLT_MAX, -FLT_MAX };
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    low[i % 3] = std::min(low[i % 3], positions[i]);
    high[i % 3] = std::max(high[i % 3], positions[i]);
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    builder.json["accessors"][places]["min"].append(low[k]);
    builder.json["accessors"][places]["max"].append(high[k]);
  }
  if (vtkDataArray* normals = mesh->GetPointData()->GetNormals())
  {
    std::vector<float> values = floatsOf(normals, 3);
    for (std::size_t i = 0; i < values.size(); i += 3) // glTF wants unit length
    {
      const float length = std::hypot(values[i], values[i + 1], values[i + 2]);
      const float zero[3] = { 0.0f, 0.0f, 1.0f };
      for (std::size_t c = 0; c < 3; ++c)
      {
        values[i + c] = length > 0.0f ? values[i + c] / length : zero[c];
      }
    }
    attributes["NORMAL"] = builder.add(values, 3);
  }
  vtkDataArray* textures = mesh->GetPointData()->GetTCoords();
  bool isTextured = false;
  for (vtkIdType i = 0; textures && !isTextured && i < textures->GetNumberOfTuples(); ++i)
  {
    isTextured = !isNowhere(textures, i);
  }
  if (isTextured)
  {
    std::vector<float> values = floatsOf(textures, 2);
    for (std::size_t i = 1; i < values.size(); i += 2)
    {
      values[i] = 1.0f - values[i]; // glTF counts v from the top
    }
    attributes["TEXCOORD_0"] = builder.add(values, 2);
  }
  if (vtkDataArray* colours = coloursOf(mesh))
  {
    std::vector<unsigned char> bytes;
    std::vector<float> floats;
    for (vtkIdType i = 0; i < colours->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < 4; ++c)
      {
        areBytes(colours) ? bytes.push_back(colourByte(colours, i, c))
                          : floats.push_back(static_cast<float>(colourShare(colours, i, c)));
      }
    }
    attributes["COLOR_0"] = areBytes(colours) ? builder.add(bytes, 4) : builder.add(floats, 4);
  }
  std::vector<std::uint32_t> indices;
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    for (const vtkIdType id : *ids)
    {
      indices.push_back(static_cast<std::uint32_t>(id));
    }
  }
  primitive["indices"] = builder.add(indices, 1, 34963);
  return primitive;
}

// The material of a piece; its picture goes into the buffer, once where pieces wear the same.
Json::Value materialFor(Builder& builder, const Piece& piece, const std::string& title)
{
  Json::Value material;
  material["name"] = piece.name.empty() ? title : piece.name;
  material["pbrMetallicRoughness"]["metallicFactor"] = 0;
  if (!piece.picture.empty())
  {
    const auto [picture, isNew] =
      builder.pictures.try_emplace(piece.picture, static_cast<int>(builder.pictures.size()));
    if (isNew)
    {
      Json::Value image, texture;
      image["bufferView"] = builder.addView(piece.picture.data(), piece.picture.size());
      image["mimeType"] = "image/" + pictureFormatOf(piece.picture);
      texture["source"] = builder.append("images", image);
      builder.append("textures", texture);
    }
    material["pbrMetallicRoughness"]["baseColorTexture"]["index"] = picture->second;
  }
  return material;
}

} // namespace

void writeGltf(const std::vector<Piece>& pieces,
  const std::string& name,
  const std::string& path,
  bool binary)
{
  Builder builder;
  Json::Value& json = builder.json;
  json["asset"]["version"] = "2.0";
  json["asset"]["generator"] = "Oversketch";
  json["scene"] = 0;
  json["scenes"][0]["nodes"][0] = 0;
  json["nodes"][0]["mesh"] = 0;
  json["nodes"][0]["name"] = json["meshes"][0]["name"] = name;
  // A mesh far from the origin hangs on a node that moves it there, in double precision.
  const std::array<double, 3> origin = nearOrigin(pieces);
  for (std::size_t k = 0; origin != std::array<double, 3>{} && k < 3; ++k)
  {
    json["nodes"][0]["translation"].append(origin[k]);
  }
  for (const Piece& piece : pieces)
  {
    Json::Value primitive = primitiveOf(builder, litMesh(piece.mesh), origin);
    if (!piece.picture.empty() || !piece.name.empty())
    {
      primitive["material"] = builder.append("materials", materialFor(builder, piece, name));
    }
    json["meshes"][0]["primitives"].append(primitive);
  }
  json["buffers"][0]["byteLength"] = Json::UInt64(builder.buffer.size());
  if (!binary)
  {
    json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(builder.buffer);
  }
  Json::StreamWriterBuilder compact;
  compact["indentation"] = "";
  std::string text = Json::writeString(compact, json);
  std::ofstream stream(path, std::ios::binary);
  if (binary)
  {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string header = "glTF", chunk;
    put<std::uint32_t>(header, 2);
    put(header, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + builder.buffer.size()));
    put(header, static_cast<std::uint32_t>(text.size()));
    put(chunk, static_cast<std::uint32_t>(builder.buffer.size()));
    stream << header << "JSON" << text << chunk << std::string("BIN\0", 4) << builder.buffer;
  }
  else
  {
    stream << text << '\n';
  }
  closeWhole(stream, path);
}

} // namespace oversketch_files
