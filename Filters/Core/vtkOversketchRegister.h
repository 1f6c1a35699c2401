/**
 * Register of what was made of a polydata, to be found again as long as somebody holds it. For use in the
 * .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchRegister_h
#define vtkOversketchRegister_h

#include "vtkOversketchFilterTools.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace oversketch
{

/**
 * Weak pointers only: memory goes with the last holder. Callable from any thread.
 */
template <class Thing, class Key = MeshKey>
class Register
{
public:
  std::shared_ptr<const Thing> Find(const Key& key)
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
  void Add(const Key& key, const std::shared_ptr<const Thing>& thing)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Entries.erase(
      std::remove_if(
        this->Entries.begin(), this->Entries.end(), [](const auto& entry) { return entry.second.expired(); }),
      this->Entries.end());
    this->Entries.emplace_back(key, thing);
  }

  /**
   * A thing that nobody else holds, for its last holder to change: it is no longer found. Null, and the
   * holder keeps it, where somebody does.
   */
  std::shared_ptr<Thing> Take(std::shared_ptr<const Thing>& thing)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (thing.use_count() != 1)
    {
      return nullptr;
    }
    const auto isIt = [&thing](const auto& entry)
    { return !entry.second.owner_before(thing) && !thing.owner_before(entry.second); };
    this->Entries.erase(
      std::remove_if(this->Entries.begin(), this->Entries.end(), isIt), this->Entries.end());
    // A copy that goes counts down as the others did, and sees what they read before; a fence alone is not
    // seen by the thread sanitizer.
    std::shared_ptr<const Thing>(thing).reset();
    return std::const_pointer_cast<Thing>(std::move(thing));
  }

private:
  std::mutex Mutex;
  std::vector<std::pair<Key, std::weak_ptr<const Thing>>> Entries;
};

} // namespace oversketch
#endif
