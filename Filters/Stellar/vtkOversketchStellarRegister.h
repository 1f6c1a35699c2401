// What was made of a polydata, found again as long as somebody holds it, for the filters of this module. Not
// installed.
#ifndef vtkOversketchStellarRegister_h
#define vtkOversketchStellarRegister_h

#include "vtkOversketchFilterTools.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace oversketch
{

// Callable from any thread.
template <class Thing>
class Register
{
public:
  std::shared_ptr<const Thing> Find(const MeshKey& key)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    for (const auto& [known, thing] : this->Entries)
    {
      auto found = known == key ? thing.lock() : nullptr;
      if (found)
      {
        return found;
      }
    }
    return nullptr;
  }
  void Add(const MeshKey& key, const std::shared_ptr<const Thing>& thing)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Entries.erase(
      std::remove_if(
        this->Entries.begin(), this->Entries.end(), [](const auto& entry) { return entry.second.expired(); }),
      this->Entries.end());
    this->Entries.emplace_back(key, thing);
  }

private:
  std::mutex Mutex;
  std::vector<std::pair<MeshKey, std::weak_ptr<const Thing>>> Entries;
};

} // namespace oversketch
#endif
