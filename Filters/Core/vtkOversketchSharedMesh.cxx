#include "vtkOversketchSharedMesh.h"

#include "Mesh/match.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

struct MeshData::Links
{
  std::once_flag Once;
  Adjacency Neighbours;
};

namespace
{

// The normals that a polydata brings along; null where it brings none.
std::shared_ptr<const std::vector<Vector3>> OwnNormals(vtkPolyData* polyData)
{
  vtkDataArray* array = polyData->GetPointData()->GetNormals();
  if (!array || array->GetNumberOfComponents() != 3 ||
      array->GetNumberOfTuples() != polyData->GetNumberOfPoints())
  {
    return nullptr;
  }
  std::vector<Vector3> normals(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    array->GetTuple(static_cast<vtkIdType>(i), normals[i].data());
    const double length = normals[i].norm();
    if (!std::isfinite(length))
    {
      throw Error(Failure::BadMesh,
        "Normal %1 of the mesh is not finite; remove the point normals or recompute them.",
        i);
    }
    if (length > 0.0)
    {
      normals[i] /= length;
    }
  }
  return std::make_shared<const std::vector<Vector3>>(std::move(normals));
}

// Key that tells meshes apart, and their parts.
struct Key
{
  explicit Key(vtkPolyData* polyData)
    : Whole(polyData, { polyData->GetPointData()->GetNormals() })
    , Shape(polyData)
    , Polys(polyData->GetPolys(), polyData->GetPolys()->GetMTime())
  {
  }

  MeshKey Whole, Shape; // with and without point normals
  std::pair<const void*, vtkMTimeType> Polys;
};

struct Register
{
  std::mutex Mutex;
  std::vector<std::pair<Key, std::weak_ptr<const MeshData>>> Entries;

  // The first that somebody holds and that fits. With the mutex locked.
  template <class Fits>
  std::shared_ptr<const MeshData> Find(const Fits& fits) const
  {
    for (const auto& [key, data] : this->Entries)
    {
      if (fits(key))
      {
        if (auto found = data.lock())
        {
          return found;
        }
      }
    }
    return nullptr;
  }
};

Register& TheRegister()
{
  static Register instance;
  return instance;
}

using Normals = std::vector<Vector3>;

// Normals that were computed, of meshes that somebody holds; the latest last.
struct KnownNormals
{
  std::mutex Mutex;
  std::vector<std::pair<std::weak_ptr<const Mesh>, std::weak_ptr<const Normals>>> Entries;
};

// After those of a mesh that has most of the same triangles, where there is one.
std::shared_ptr<const Normals> ComputedNormals(const std::shared_ptr<const Mesh>& mesh, const Lists& around)
{
  static KnownNormals known;
  constexpr std::size_t most = 3; // that are looked at
  std::vector<std::pair<std::shared_ptr<const Mesh>, std::shared_ptr<const Normals>>> held;
  {
    const std::lock_guard<std::mutex> lock(known.Mutex);
    auto& entries = known.Entries;
    const auto isGone = [](const auto& one) { return one.first.expired() || one.second.expired(); };
    entries.erase(std::remove_if(entries.begin(), entries.end(), isGone), entries.end());
    for (auto one = entries.rbegin(); one != entries.rend() && held.size() < most; ++one)
    {
      held.emplace_back(one->first.lock(), one->second.lock());
    }
  }
  std::shared_ptr<const Normals> made;
  for (auto one = held.begin(); one != held.end() && !made; ++one)
  {
    Normals normals;
    if (one->first && one->second && normalsAfter(*one->first, *one->second, *mesh, around, normals))
    {
      made = std::make_shared<const Normals>(std::move(normals));
    }
  }
  if (!made)
  {
    made = std::make_shared<const Normals>(vertexNormals(*mesh, around, ThreadsOnly()));
    ++MeshWorkDone().Normals;
  }
  const std::lock_guard<std::mutex> lock(known.Mutex);
  known.Entries.emplace_back(mesh, made);
  return made;
}

} // namespace

const Adjacency& MeshData::Neighbours() const
{
  std::call_once(this->Linked->Once,
    [this]
    {
      this->Linked->Neighbours = buildAdjacency(*this->Shape, ThreadsOnly());
      ++MeshWorkDone().Linkings;
    });
  return this->Linked->Neighbours;
}

std::shared_ptr<const std::vector<Vector3>> MeshData::KeptNormals() const
{
  std::call_once(this->NormalsOnce,
    [this]
    {
      if (!this->VertexNormals)
      {
        this->VertexNormals = ComputedNormals(this->Shape, this->Neighbours().vertexTriangles);
      }
    });
  return this->VertexNormals;
}

const std::vector<Vector3>& MeshData::Normals() const
{
  return *this->KeptNormals();
}

std::shared_ptr<const MeshData> SharedMesh(vtkPolyData* polyData)
{
  RequirePolygonsOnly(polyData); // the key does not see other cells
  const Key key(polyData);
  Register& known = TheRegister();
  const auto same = [&key](const Key& other) { return other.Whole == key.Whole; };
  std::unique_lock<std::mutex> lock(known.Mutex);
  if (auto found = known.Find(same))
  {
    return found;
  }
  const auto sameShape = known.Find([&key](const Key& other) { return other.Shape == key.Shape; });
  const auto samePolys =
    sameShape ? sameShape : known.Find([&key](const Key& other) { return other.Polys == key.Polys; });
  lock.unlock(); // another thread's mesh need not wait
  const std::shared_ptr<MeshData> data(new MeshData);
  data->VertexNormals = OwnNormals(polyData); // before anybody can change them
  data->Shape = sameShape ? sameShape->Shape : std::make_shared<const Mesh>(MeshOf(polyData));
  // Polygons that were changed without Modified() show here.
  const bool sameLinks = samePolys && samePolys->Surface().vertexCount() == data->Shape->vertexCount() &&
                         samePolys->Surface().triangles == data->Shape->triangles;
  data->Linked = sameLinks ? samePolys->Linked : std::make_shared<MeshData::Links>();
  lock.lock();
  if (auto found = known.Find(same))
  {
    return found; // another thread was quicker
  }
  auto& entries = known.Entries;
  entries.erase(
    std::remove_if(entries.begin(), entries.end(), [](const auto& entry) { return entry.second.expired(); }),
    entries.end());
  entries.emplace_back(key, data);
  return data;
}

} // namespace oversketch
