// Why not vtkGLTFWriter: in VTK 9.1 it has no binary container (.glb) and leaves out normals and colours.
#include "colours.h"
#include "mesh_file.h"
#include "point_normals.h"
#include "sharp_edges.h"
#include "texture.h"

#include "vtkBase64Utilities.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtk_jsoncpp.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

namespace oversketch_files
{

namespace
{

// One buffer and the JSON that describes it.
struct Builder
{
  std::string buffer, views, accessors, attributes;
  int viewCount = 0, accessorCount = 0;

  // target: 34962 vertices, 34963 indices, 0 for what is neither.
  int addView(const void* data, std::size_t bytes, int target = 0)
  {
    std::ostringstream view;
    view << (this->viewCount > 0 ? "," : "") << R"({"buffer":0,"byteOffset":)" << this->buffer.size()
         << R"(,"byteLength":)" << bytes;
    if (target)
    {
      view << R"(,"target":)" << target;
    }
    this->views += view.str() + '}';
    this->buffer.append(static_cast<const char*>(data), bytes);
    this->buffer.resize((this->buffer.size() + 3) / 4 * 4, '\0');
    return this->viewCount++;
  }

  // componentType: 5121 unsigned byte, 5125 unsigned int, 5126 float.
  int add(const void* data,
    std::size_t bytes,
    std::size_t elements,
    int componentType,
    const char* type,
    int target,
    const std::string& more = "")
  {
    const int view = this->addView(data, bytes, target);
    std::ostringstream accessor;
    accessor << (this->accessorCount > 0 ? "," : "") << R"({"bufferView":)" << view << R"(,"componentType":)"
             << componentType << R"(,"count":)" << elements << R"(,"type":")" << type << '"' << more << '}';
    this->accessors += accessor.str();
    return this->accessorCount++;
  }

  void addFloats(const char* attribute,
    const std::vector<float>& values,
    int components,
    const std::string& more = "")
  {
    const int accessor = this->add(values.data(),
      values.size() * sizeof(float),
      values.size() / static_cast<std::size_t>(components),
      5126,
      components == 2   ? "VEC2"
      : components == 3 ? "VEC3"
                        : "VEC4",
      34962,
      more);
    this->attribute(attribute, accessor);
  }

  void attribute(const char* name, int accessor)
  {
    this->attributes +=
      (this->attributes.empty() ? "\"" : ",\"") + std::string(name) + "\":" + std::to_string(accessor);
  }
};

template <typename Numbers>
std::string jsonOf(const Numbers& values)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<typename Numbers::value_type>::max_digits10);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    text << (i ? "," : "[") << values[i];
  }
  return text.str() + ']';
}

std::vector<float> floatsOf(vtkDataArray* array, int components)
{
  std::vector<float> values;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      values.push_back(static_cast<float>(array->GetComponent(i, c)));
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

void put32(std::string& out, std::size_t value)
{
  for (int k = 0; k < 4; ++k)
  {
    out += static_cast<char>((value >> (8 * k)) & 0xff);
  }
}

std::vector<float> positionsOf(vtkPolyData* mesh, const std::array<double, 3>& origin)
{
  std::vector<float> values;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    for (std::size_t k = 0; k < 3; ++k)
    {
      values.push_back(static_cast<float>(p[k] - origin[k]));
    }
  }
  return values;
}

// With normals, without which a reader has to show each triangle flat; where the mesh has none, with points
// of their own for both sides of its sharp edges.
vtkSmartPointer<vtkPolyData> litMesh(vtkPolyData* mesh)
{
  const bool has = mesh->GetPointData()->GetNormals() || mesh->GetNumberOfPolys() == 0;
  return has ? vtkSmartPointer<vtkPolyData>(mesh) : SharpEdges().look(withPointNormals(mesh));
}

// The JSON of a primitive with a material, which it says; what it holds goes into the buffer, positions from
// that origin.
std::string primitiveOf(Builder& builder,
  vtkPolyData* mesh,
  const std::array<double, 3>& origin,
  const std::string& material)
{
  builder.attributes.clear();
  const std::vector<float> positions = positionsOf(mesh, origin);
  std::vector<float> low(3, FLT_MAX), high(3, -FLT_MAX);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    low[i % 3] = std::min(low[i % 3], positions[i]);
    high[i % 3] = std::max(high[i % 3], positions[i]);
  }
  builder.addFloats("POSITION", positions, 3, ",\"min\":" + jsonOf(low) + ",\"max\":" + jsonOf(high));
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
    builder.addFloats("NORMAL", values, 3);
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
    builder.addFloats("TEXCOORD_0", values, 2);
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
    if (areBytes(colours))
    {
      builder.attribute("COLOR_0",
        builder.add(
          bytes.data(), bytes.size(), bytes.size() / 4, 5121, "VEC4", 34962, ",\"normalized\":true"));
    }
    else
    {
      builder.addFloats("COLOR_0", floats, 4);
    }
  }
  std::vector<std::uint32_t> indices;
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      indices.push_back(static_cast<std::uint32_t>(ids[k]));
    }
  }
  const int indexAccessor =
    builder.add(indices.data(), indices.size() * 4, indices.size(), 5125, "SCALAR", 34963);

  return R"({"attributes":{)" + builder.attributes + R"(},"indices":)" + std::to_string(indexAccessor) +
         material + R"(,"mode":4})";
}

bool hasMaterial(const Piece& piece)
{
  return !piece.picture.empty() || !piece.name.empty();
}

// The document's members of materials and pictures, empty where there are none; the pictures go into the
// buffer.
std::string looksOf(Builder& builder, const std::vector<Piece>& pieces, const std::string& title)
{
  std::string materials, textures, images;
  std::map<std::string, std::string> known; // the place of a picture: pieces may wear the same one
  for (const Piece& piece : pieces)
  {
    if (!hasMaterial(piece))
    {
      continue;
    }
    std::string base;
    if (!piece.picture.empty())
    {
      const auto [picture, isNew] = known.try_emplace(piece.picture, std::to_string(known.size()));
      if (isNew)
      {
        const int view = builder.addView(piece.picture.data(), piece.picture.size());
        textures += (textures.empty() ? "" : ",") + (R"({"source":)" + picture->second + "}");
        images += (images.empty() ? "" : ",") +
                  (R"({"bufferView":)" + std::to_string(view) + R"(,"mimeType":"image/)" +
                    pictureFormatOf(piece.picture) + R"("})");
      }
      base = R"("baseColorTexture":{"index":)" + picture->second + "},";
    }
    const std::string name = piece.name.empty() ? title : '"' + piece.name + '"';
    materials += (materials.empty() ? R"({"name":)" : R"(,{"name":)") + name;
    materials += R"(,"pbrMetallicRoughness":{)" + base + R"("metallicFactor":0}})";
  }
  if (materials.empty())
  {
    return {};
  }
  materials = R"("materials":[)" + materials + "],";
  return images.empty() ? materials
                        : materials + R"("textures":[)" + textures + R"(],"images":[)" + images + "],";
}

} // namespace

void writeGltf(const std::vector<Piece>& pieces,
  const std::string& name,
  const std::string& path,
  bool binary)
{
  const std::string title = Json::valueToQuotedString(name.c_str());
  Builder builder;
  std::string primitives;
  std::size_t count = 0; // of materials
  // A mesh far from the origin hangs on a node that moves it there, in double precision.
  const std::array<double, 3> origin = nearOrigin(pieces);
  const bool isMoved = origin != std::array<double, 3>{};
  const std::string moved = isMoved ? ",\"translation\":" + jsonOf(origin) : "";
  for (const Piece& piece : pieces)
  {
    const std::string material = hasMaterial(piece) ? R"(,"material":)" + std::to_string(count++) : "";
    primitives +=
      (primitives.empty() ? "" : ",") + primitiveOf(builder, litMesh(piece.mesh), origin, material);
  }
  const std::string looks = looksOf(builder, pieces, title);

  std::ostringstream json;
  json
    << R"({"asset":{"version":"2.0","generator":"Oversketch"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"name":)"
    << title << moved << R"(}],"meshes":[{"name":)" << title << R"(,"primitives":[)" << primitives
    << R"(]}],)" << looks << R"("accessors":[)" << builder.accessors << R"(],"bufferViews":[)"
    << builder.views << R"(],"buffers":[{"byteLength":)" << builder.buffer.size();
  if (!binary)
  {
    json << R"(,"uri":"data:application/octet-stream;base64,)" << base64(builder.buffer) << '"';
  }
  json << "}]}";
  std::string text = json.str();
  std::ofstream stream(path, std::ios::binary);
  if (binary)
  {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string header = "glTF";
    put32(header, 2);
    put32(header, 12 + 8 + text.size() + 8 + builder.buffer.size());
    put32(header, text.size());
    header += "JSON";
    std::string chunk;
    put32(chunk, builder.buffer.size());
    chunk += std::string("BIN\0", 4);
    stream << header << text << chunk << builder.buffer;
  }
  else
  {
    stream << text << '\n';
  }
  closeWhole(stream, path);
}

} // namespace oversketch_files
