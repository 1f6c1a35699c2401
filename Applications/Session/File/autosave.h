// Keeps the session on the disk while a person works, so that a crash or a power cut loses at most the stroke
// being drawn.
#ifndef oversketch_applications_session_file_autosave_h
#define oversketch_applications_session_file_autosave_h

#include "session_file.h"

#include <condition_variable>
#include <ctime>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace oversketch_session
{

// Where autosaves go: $XDG_STATE_HOME/oversketch/autosave, else ~/.local/state/oversketch/autosave.
std::string autosaveRoot();

// The origin of an autosave: the session's own file, empty before it has one, and whether anything is not in
// it.
struct KeptOf
{
  std::string path;
  bool modified = true;
};

// One running program's autosave: a folder of the session format under a root, locked while the program
// lives.
class Autosave
{
public:
  // Makes the folder and locks it. Throws Failed.
  explicit Autosave(const std::string& root);
  // Waits for what is being written. The folder stays, to be found by the next program, unless discard was
  // called.
  ~Autosave();

  // Returns at once; a thread writes, and of several sessions in a row perhaps only the newest. Data of the
  // session must not be changed afterwards. `kept` is called on that thread once it is on the disk.
  void keep(SessionFile file, const KeptOf& of = {});
  void onKept(std::function<void()> kept);
  // Waits until the newest is on the disk. Returns why it is not, or an empty string.
  std::string wait();
  // Why the last one is not on the disk, or an empty string; does not wait.
  std::string failure();
  // The work is saved elsewhere or given up: removes the folder.
  void discard();
  const std::string& folder() const { return this->Folder; }

private:
  void work();

  std::string Folder;
  int Lock = -1;
  std::mutex Mutex;
  std::condition_variable Wake, Idle;
  std::optional<SessionFile> Next;
  KeptOf NextOf;
  std::function<void()> Kept;
  bool Writing = false, Stop = false;
  std::string Failure;
  Encoder Encode;
  std::thread Thread;
};

// A session that a program left behind when it ended without saving or discarding it.
struct LeftBehind
{
  std::string folder;
  std::string path; // of the session's own file; empty where it had none
  std::string meshName;
  std::size_t strokes = 0;
  std::time_t time = 0; // that it was kept at
};

// Those under the root that no living program holds and that can be read, the newest first. Removes what a
// program left before its first session was whole, and where nothing was not saved.
std::vector<LeftBehind> leftBehind(const std::string& root);
// Opened or not wanted: removes it.
void removeLeftBehind(const LeftBehind& left);

} // namespace oversketch_session
#endif
