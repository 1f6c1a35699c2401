// Session files, `.oversketch`: see README.md beside this for the format.
#ifndef oversketch_applications_session_file_session_file_h
#define oversketch_applications_session_file_session_file_h

#include "look.h"
#include "package.h"
#include "session.h"
#include "systems.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace oversketch_session
{

// The things that a result's bits depend on besides the session.
struct Origin
{
  std::string version;   // of Oversketch
  std::string backend;   // "opencl" or "embree": what the rays ran on
  std::string device;    // the OpenCL device; empty for embree
  std::string processor; // of the machine
};

// Those of this program on this machine, for results that ran on that backend
// (vtkOversketchSystem::BackendType).
Origin originHere(int backendUsed);

// Says what differs between two, in words for the user; empty when nothing does.
std::vector<std::string> differences(const Origin& recorded, const Origin& here);

// The result of a model's steps, as it was saved.
struct Record
{
  Origin origin;
  // Digest of the mesh: see digestOf. Empty when it was saved before the first result.
  std::string digest;
};

struct SessionFile
{
  Session session;
  Origin origin;
  std::string digest;
  // As it was saved; absent where nobody looked, and of programs that did not keep it.
  std::optional<Look> look = {};
  // Results of the other models of the scene, in their order; absent where nothing is known.
  std::vector<Record> others = {};
};

// Hexadecimal MD5 of points (their type and bits) and polygons of a mesh: equal digests, equal meshes.
std::string digestOf(vtkPolyData* mesh);

// Makes what the format holds, of version 1 where that can tell all of the session, else of version 2;
// strokes, meshes and pictures are named by their content. What the session before shared with this one is
// not encoded again.
class Encoder
{
public:
  // For steps of the systems of that list, which must outlive it.
  explicit Encoder(const std::vector<SystemRow>& rows = systems())
    : Rows(rows)
  {
  }
  Package encode(const SessionFile& file);

private:
  struct Entry
  {
    std::string name;
    std::shared_ptr<const std::string> bytes;
  };
  using Entries = std::map<std::shared_ptr<const void>, Entry>; // by the identity of what they hold
  const std::vector<SystemRow>& Rows;
  Entries Last;
};
// Throws Failed, naming the path and the entry.
SessionFile decode(const Package& package,
  const std::string& path,
  const std::vector<SystemRow>& rows = systems());

// Both at once. A path of a folder is read as one. Entries that the session does not name are not read.
SessionFile readSession(const std::string& path);
void writeSession(const std::string& path, const SessionFile& file);

// The entry that names the others (for writeFolder).
extern const char* const sessionEntry;

} // namespace oversketch_session
#endif
