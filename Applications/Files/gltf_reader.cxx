// The meshes of a glTF scene as one: nodes with their transforms, skins in their pose, morph targets by their
// weights; and the picture of the base colour.
#include "gltf_document.h"
#include "mesh_file.h"
#include "text.h"

#include "vtkPointData.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <set>

namespace oversketch_files
{

namespace
{

using Matrix = Eigen::Matrix4d;

std::vector<double> numbersOf(const Json::Value& list, std::size_t count)
{
  std::vector<double> numbers;
  if (list.isArray() && list.size() == count)
  {
    for (const Json::Value& number : list)
    {
      numbers.push_back(number.isNumeric() ? number.asDouble() : 0.0);
    }
  }
  return numbers;
}

Matrix transformOf(const Json::Value& node)
{
  const std::vector<double> matrix = numbersOf(node["matrix"], 16);
  if (!matrix.empty())
  {
    return Eigen::Map<const Matrix>(matrix.data());
  }
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (const std::vector<double> t = numbersOf(node["translation"], 3); !t.empty())
  {
    transform.translate(Eigen::Vector3d(t[0], t[1], t[2]));
  }
  if (const std::vector<double> q = numbersOf(node["rotation"], 4); !q.empty())
  {
    transform.rotate(Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized());
  }
  if (const std::vector<double> s = numbersOf(node["scale"], 3); !s.empty())
  {
    transform.scale(Eigen::Vector3d(s[0], s[1], s[2]));
  }
  return transform.matrix();
}

// A scene's nodes in their order, with their transforms to the world.
class Scene
{
public:
  explicit Scene(GltfDocument& document)
    : Document(document)
    , ToWorld(document.json()["nodes"].size(), Matrix::Identity())
    , Seen(document.json()["nodes"].size(), false)
  {
    const Json::Value& json = document.json();
    const Json::Value scene = json["scene"].isNull() ? Json::Value(0U) : json["scene"];
    if (json["scenes"].size() > 0)
    {
      this->visitAll(document.at("scenes", scene)["nodes"]);
      return;
    }
    std::set<unsigned> children;
    for (const Json::Value& node : json["nodes"])
    {
      for (const Json::Value& child : node["children"])
      {
        children.insert(child.isUInt() ? child.asUInt() : 0);
      }
    }
    Json::Value roots(Json::arrayValue);
    for (unsigned i = 0; i < this->Seen.size(); ++i)
    {
      if (children.count(i) == 0)
      {
        roots.append(i);
      }
    }
    this->visitAll(roots);
  }

  const std::vector<unsigned>& nodes() const { return this->Order; }
  const Matrix& toWorld(const Json::Value& node) const
  {
    this->Document.at("nodes", node);
    return this->ToWorld[node.asUInt()];
  }

private:
  void visitAll(const Json::Value& roots)
  {
    struct Waiting
    {
      Json::Value node;
      Matrix parent;
    };
    std::vector<Waiting> waiting;
    const auto push = [&](const Json::Value& nodes, const Matrix& parent)
    {
      for (Json::ArrayIndex i = nodes.size(); i > 0; --i)
      {
        waiting.push_back({ nodes[i - 1], parent });
      }
    };
    push(roots, Matrix::Identity());
    while (!waiting.empty())
    {
      const Waiting next = waiting.back();
      waiting.pop_back();
      const Json::Value& node = this->Document.at("nodes", next.node);
      const unsigned at = next.node.asUInt();
      if (this->Seen[at])
      {
        this->Document.refuse("its nodes " + std::to_string(at) +
                              " is its own ancestor, or the child of two nodes; the file is damaged");
      }
      this->Seen[at] = true;
      this->Order.push_back(at);
      this->ToWorld[at] = next.parent * transformOf(node);
      push(node["children"], this->ToWorld[at]);
    }
  }

  GltfDocument& Document;
  std::vector<Matrix> ToWorld;
  std::vector<char> Seen;
  std::vector<unsigned> Order;
};

// Triangles of a list, a strip or a fan of vertices; none of points and lines.
std::vector<vtkIdType> trianglesOf(const std::vector<vtkIdType>& ids, int mode)
{
  std::vector<vtkIdType> corners;
  const std::size_t count = ids.size() < 3 ? 0 : mode == 4 ? ids.size() / 3 : ids.size() - 2;
  for (std::size_t i = 0; i < count && mode >= 4; ++i)
  {
    const std::size_t first = mode == 4 ? 3 * i : mode == 5 ? i : 0;
    const std::size_t second = mode == 4 ? 3 * i + 1 : mode == 5 && i % 2 == 1 ? i + 2 : i + 1;
    const std::size_t third = mode == 4 ? 3 * i + 2 : mode == 5 && i % 2 == 1 ? i + 1 : i + 2;
    corners.insert(corners.end(), { ids[first], ids[second], ids[third] });
  }
  return corners;
}

void addMorphs(GltfDocument& document,
  const Json::Value& primitive,
  const Json::Value& weights,
  GltfPart& part)
{
  for (Json::ArrayIndex i = 0; i < std::min(primitive["targets"].size(), weights.size()); ++i)
  {
    const double weight = weights[i].isNumeric() ? weights[i].asDouble() : 0.0;
    for (const char* name : { "POSITION", "NORMAL" })
    {
      const Json::Value& target = primitive["targets"][i][name];
      const auto it = part.attributes.find(name);
      if (weight == 0.0 || target.isNull() || it == part.attributes.end())
      {
        continue;
      }
      const GltfNumbers moves = document.numbers(target);
      if (moves.values.size() != it->second.values.size())
      {
        document.refuse("a morph target has another number of points than its mesh; the file is damaged");
      }
      for (std::size_t k = 0; k < moves.values.size(); ++k)
      {
        it->second.values[k] += weight * moves.values[k];
      }
    }
  }
}

// Positions by a matrix, normals by the inverse of its transpose; where that mirrors, triangles are wound the
// other way.
void transform(GltfPart& part, const std::vector<Matrix>& matrices)
{
  const auto apply = [&](const char* name, const auto& move)
  {
    const auto it = part.attributes.find(name);
    if (it == part.attributes.end())
    {
      return;
    }
    for (std::size_t i = 0; i < it->second.count; ++i)
    {
      Eigen::Map<Eigen::Vector3d> vector(&it->second.values[3 * i]);
      vector = move(matrices[matrices.size() == 1 ? 0 : i], Eigen::Vector3d(vector));
    }
  };
  apply("POSITION",
    [](const Matrix& m, const Eigen::Vector3d& p) -> Eigen::Vector3d
    { return (m * p.homogeneous()).head<3>(); });
  apply("NORMAL",
    [](const Matrix& m, const Eigen::Vector3d& n) -> Eigen::Vector3d
    {
      const Eigen::Vector3d moved = (m.topLeftCorner<3, 3>().inverse().transpose() * n).normalized();
      return moved.allFinite() ? moved : n; // where a scale is zero nothing is told
    });
  const auto mirrors = [&matrices](vtkIdType point)
  {
    const std::size_t at = matrices.size() == 1 ? 0 : static_cast<std::size_t>(point);
    return matrices[at].topLeftCorner<3, 3>().determinant();
  };
  for (std::size_t i = 0; i < part.corners.size(); i += 3)
  {
    vtkIdType* corners = &part.corners[i];
    if (mirrors(corners[0]) + mirrors(corners[1]) + mirrors(corners[2]) < 0.0)
    {
      std::swap(corners[1], corners[2]);
    }
  }
}

// The coordinates that a part's picture lies on, moved as its material says, become its first ones.
void placeCoordinates(GltfPart& part, const GltfTexture& texture)
{
  if (texture.picture.isNull())
  {
    return;
  }
  const auto own = part.attributes.find("TEXCOORD_" + std::to_string(texture.set));
  if (own == part.attributes.end() || own->second.components != 2)
  {
    part.attributes.erase("TEXCOORD_0"); // they are another picture's
    return;
  }
  GltfNumbers coordinates = own->second;
  for (std::size_t i = 0; i < coordinates.count; ++i)
  {
    Eigen::Map<Eigen::Vector2d> at(&coordinates.values[2 * i]);
    at = texture.placed * Eigen::Vector2d(at);
  }
  part.attributes["TEXCOORD_0"] = std::move(coordinates);
}

// The matrix of each point of a skin: joints by their weights.
std::vector<Matrix> skinned(GltfDocument& document,
  const Scene& scene,
  const Json::Value& index,
  const GltfPart& part)
{
  const Json::Value& skin = document.at("skins", index);
  std::vector<Matrix> joints;
  document.spend(16 * skin["joints"].size());
  for (const Json::Value& joint : skin["joints"])
  {
    joints.push_back(scene.toWorld(joint));
  }
  if (skin.isMember("inverseBindMatrices"))
  {
    const GltfNumbers bind = document.numbers(skin["inverseBindMatrices"]);
    if (bind.components != 16 || bind.count < joints.size())
    {
      document.refuse(
        "its skins " + std::to_string(index.asUInt()) + " lacks matrices of joints; the file is damaged");
    }
    for (std::size_t i = 0; i < joints.size(); ++i)
    {
      joints[i] = joints[i] * Eigen::Map<const Matrix>(&bind.values[16 * i]);
    }
  }
  const GltfNumbers& names = part.attributes.at("JOINTS_0");
  const GltfNumbers& weights = part.attributes.at("WEIGHTS_0");
  std::vector<Matrix> matrices(names.count, Matrix::Zero());
  for (std::size_t i = 0; i < names.count; ++i)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      const double joint = names.values[4 * i + k], weight = weights.values[4 * i + k];
      if (weight != 0.0 && !(joint >= 0.0 && joint < static_cast<double>(joints.size())))
      {
        document.refuse("a point of its skins " + std::to_string(index.asUInt()) +
                        " hangs on a joint that is not there; the file is damaged");
      }
      if (weight != 0.0)
      {
        matrices[i] += weight * joints[static_cast<std::size_t>(joint)];
      }
    }
  }
  return matrices;
}

// Attributes of the same number of points, with the components that they must have.
GltfPart attributesOf(GltfDocument& document, const Json::Value& primitive, const std::string& where)
{
  static const std::map<std::string, std::size_t> components = {
    { "POSITION", 3 }, { "NORMAL", 3 }, { "TANGENT", 4 }, { "JOINTS_0", 4 }, { "WEIGHTS_0", 4 }
  };
  const Json::Value& attributes = primitive["attributes"];
  if (!attributes.isObject() || !attributes.isMember("POSITION"))
  {
    document.refuse(where + " has no attribute POSITION; the file is damaged");
  }
  if (!document.find("accessors", attributes["POSITION"]).isMember("bufferView"))
  {
    document.refuseCompressed(primitive); // the numbers that anybody could read are not there
  }
  GltfPart part;
  for (const std::string& name : attributes.getMemberNames())
  {
    part.attributes[plainName(name)] = document.numbers(attributes[name]);
  }
  for (const auto& [name, numbers] : part.attributes)
  {
    const auto known = components.find(name);
    if (numbers.count != part.attributes["POSITION"].count ||
        (known != components.end() && numbers.components != known->second))
    {
      std::string why = where + ": its attribute ";
      why += name;
      document.refuse(
        why + " has another number of elements or components than it must have; the file is damaged");
    }
  }
  return part;
}

GltfPart partOf(GltfDocument& document, const Json::Value& primitive, const std::string& where)
{
  GltfPart part = attributesOf(document, primitive, where);
  const std::size_t points = part.attributes["POSITION"].count;
  std::vector<vtkIdType> ids;
  if (primitive.isMember("indices"))
  {
    const GltfNumbers indices = document.numbers(primitive["indices"]);
    for (const double id : indices.values)
    {
      if (!(id >= 0.0 && id < static_cast<double>(points)))
      {
        document.refuse(where + " names a point that is not there; the file is damaged");
      }
      ids.push_back(static_cast<vtkIdType>(id));
    }
  }
  else
  {
    ids.resize(points);
    std::iota(ids.begin(), ids.end(), vtkIdType{ 0 });
  }
  part.corners = trianglesOf(ids, primitive["mode"].isInt() ? primitive["mode"].asInt() : 4);
  return part;
}

std::vector<GltfPart> gltfPartsOf(GltfDocument& document, GltfSkin& skin)
{
  const Scene scene(document);
  std::vector<GltfPart> parts;
  for (const unsigned at : scene.nodes())
  {
    const Json::Value& node = document.json()["nodes"][at];
    if (node["mesh"].isNull())
    {
      continue;
    }
    const Json::Value& mesh = document.at("meshes", node["mesh"]);
    for (Json::ArrayIndex i = 0; i < mesh["primitives"].size(); ++i)
    {
      const Json::Value& primitive = mesh["primitives"][i];
      GltfPart part = partOf(
        document, primitive, "its meshes " + node["mesh"].asString() + ", primitive " + std::to_string(i));
      addMorphs(document, primitive, node["weights"].isArray() ? node["weights"] : mesh["weights"], part);
      const bool isSkinned = !node["skin"].isNull() && part.attributes.count("JOINTS_0") == 1 &&
                             part.attributes.count("WEIGHTS_0") == 1;
      transform(part,
        isSkinned ? skinned(document, scene, node["skin"], part) : std::vector<Matrix>{ scene.toWorld(at) });
      part.material = materialOf(document, primitive);
      placeCoordinates(part, skin.textures[part.material]);
      if (primitive["targets"].size() > 0)
      {
        skin.dropped.insert("its morph targets (the shape is kept as it is posed)");
      }
      if (primitive["mode"].isInt() && primitive["mode"].asInt() < 4)
      {
        skin.dropped.insert("its lines and points");
      }
      if (!part.corners.empty())
      {
        parts.push_back(std::move(part));
      }
    }
  }
  return parts;
}

void turnCoordinates(vtkPointData* data)
{
  vtkDataArray* coordinates = data->GetTCoords();
  for (vtkIdType i = 0; coordinates && i < coordinates->GetNumberOfTuples(); ++i)
  {
    if (!isNowhere(coordinates, i))
    {
      coordinates->SetComponent(i, 1, 1.0 - coordinates->GetComponent(i, 1)); // glTF counts v from the top
    }
  }
}

// The pictures of the parts' materials, each read once.
void dress(GltfDocument& document, const std::vector<GltfPart>& parts, GltfSkin& skin, vtkPolyData* mesh)
{
  std::vector<int> worn; // per triangle
  std::vector<std::string> pictures;
  std::map<Json::Value, int> known;
  for (const GltfPart& part : parts)
  {
    const Json::Value& picture = skin.textures[part.material].picture;
    if (!picture.isNull() && !mesh->GetPointData()->GetTCoords())
    {
      skin.dropped.insert("its picture (it has no texture coordinates)");
      return;
    }
    const auto [number, isNew] = known.try_emplace(picture, static_cast<int>(pictures.size()));
    if (isNew)
    {
      pictures.push_back(picture.isNull() ? "" : soundPicture(document, picture));
    }
    worn.insert(worn.end(), part.corners.size() / 3, number->second);
  }
  wearPictures(mesh, worn, pictures);
}

vtkSmartPointer<vtkPolyData> read(GltfDocument& document, const std::string& path, Notes& notes)
{
  requireKnownExtensions(document);
  GltfSkin skin = skinOf(document);
  const std::vector<GltfPart> parts = gltfPartsOf(document, skin);
  if (parts.empty())
  {
    document.refuse("holds no mesh");
  }
  std::set<std::string> lost;
  vtkSmartPointer<vtkPolyData> mesh = joinedMesh(parts, lost);
  if (parts.size() > 1)
  {
    notes.push_back(path + ": its " + std::to_string(parts.size()) + " parts are read as one mesh");
  }
  if (!lost.empty())
  {
    notes.push_back(path + ": what only some of its parts have is dropped: " + listed(lost));
  }
  turnCoordinates(mesh->GetPointData());
  dress(document, parts, skin, mesh);
  addDropped(document, skin.dropped);
  if (!skin.dropped.empty())
  {
    notes.push_back(path + ": not kept: " + listed(skin.dropped));
  }
  return mesh;
}

} // namespace

vtkSmartPointer<vtkPolyData> readGltf(const std::string& path, Notes& notes)
{
  GltfDocument document(path);
  try
  {
    return read(document, path, notes);
  }
  catch (const Json::Exception&) // a member of another type than it must be
  {
    throw Failed(path + ": a member of its JSON is of another type than it must be; the file is damaged");
  }
}

} // namespace oversketch_files
