#include "vtkOversketchSharedMesh.h"

#include "vtkOversketchFilterTools.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <mutex>

namespace oversketch
{

namespace
{

struct Entry
{
  MeshKey Key;
  std::weak_ptr<const MeshData> Data;
};

struct Register
{
  std::mutex Mutex;
  std::vector<Entry> Entries;

  std::shared_ptr<const MeshData> Find(const MeshKey& key)
  {
    for (const Entry& entry : this->Entries)
    {
      if (entry.Key == key)
      {
        return entry.Data.lock();
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

} // namespace

std::shared_ptr<const MeshData> SharedMesh(vtkPolyData* polyData)
{
  RequirePolygonsOnly(polyData); // the key does not see other cells
  const MeshKey key(polyData, { polyData->GetPointData()->GetNormals() });
  Register& known = TheRegister();
  {
    const std::lock_guard<std::mutex> lock(known.Mutex);
    if (auto found = known.Find(key))
    {
      return found;
    }
  }
  // Built outside the lock: another thread's mesh need not wait.
  auto data = std::make_shared<MeshData>();
  data->Surface = MeshOf(polyData);
  data->Normals = NormalsOf(polyData, data->Surface);
  data->Neighbours = buildAdjacency(data->Surface);
  const std::lock_guard<std::mutex> lock(known.Mutex);
  if (auto found = known.Find(key))
  {
    return found;
  }
  auto& entries = known.Entries;
  entries.erase(
    std::remove_if(entries.begin(), entries.end(), [](const Entry& entry) { return entry.Data.expired(); }),
    entries.end());
  entries.push_back({ key, data });
  return data;
}

} // namespace oversketch
