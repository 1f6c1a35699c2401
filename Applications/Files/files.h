// What the command's readers and writers share: one kind of error, notes for the user, whole files or none.
#ifndef oversketch_applications_files_files_h
#define oversketch_applications_files_files_h

#include <atomic>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

namespace oversketch_files
{

// Something that could not be done; the message names the file and the remedy. Exit code 1.
struct Failed : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// What the user should know though it went well, such as what a format drops.
using Notes = std::vector<std::string>;

// Sends VTK's messages here instead of to the terminal, for the rest of the process. VTK's readers report
// trouble through many objects; its output window sees them all.
void catchMessages();
// First line of the first error since the last call, "" if there was none.
std::string takeError();

// The text with a space for every control character, also those that turn the direction of writing, and '?'
// for bytes that are no UTF-8, so that a name from a file cannot steer a terminal.
std::string printable(const std::string& text);

// The name of an array as any file can keep it: VTK writes names into XML as they are.
std::string plainName(const std::string& name);

// Lower-case extension with its dot, "" if there is none.
std::string extensionOf(const std::string& path);
// Size of the file in bytes. Throws Failed for an absent, unreadable or empty file and for a folder.
std::uintmax_t requireReadable(const std::string& path);
// The content of a file; empty where it is absent or no regular file, which may never end.
std::string wholeFile(const std::string& path);
// Whether both names are of one file, which need not be there yet.
bool isSameFile(const std::string& a, const std::string& b);
// Throws Failed unless a file of this name can be made or replaced. A file without permission to write is not
// replaced, not even by root.
void requireWritable(const std::string& path);

// While it lives, what this thread writes comes to its place only if nobody has given the work up.
class GiveUp
{
public:
  explicit GiveUp(const std::atomic<bool>& givenUp);
  ~GiveUp();
  GiveUp(const GiveUp&) = delete;
  GiveUp& operator=(const GiveUp&) = delete;
};

// Files that appear together, each whole, or not at all. A file that is replaced keeps its mode and, where
// that may be had, its owner; a symbolic link is followed.
class NewFiles
{
public:
  NewFiles() = default;
  // What is not committed is removed.
  ~NewFiles();
  NewFiles(const NewFiles&) = delete;
  NewFiles& operator=(const NewFiles&) = delete;

  // Calls write with the name of an empty temporary file beside path (same extension), which it fills. Throws
  // what write throws, with path in place of the temporary name, and Failed where it cannot be made, stays
  // empty, or path was written before.
  void write(const std::string& path, const std::function<void(const std::string& temporary)>& write);
  void writeText(const std::string& path, const std::string& text);
  // Puts all into their places, the first one first. Throws Failed; files that were not there before are then
  // gone.
  void commit();

private:
  struct File
  {
    std::string path, target; // as it was named, and where links lead
    std::string temporary;
    int slot = -1; // in the list that a signal empties
  };
  void dropLast();
  void fill(File& file, const std::function<void(const std::string&)>& write);

  std::vector<File> Files;
};

// One file alone.
void writeWhole(const std::string& path, const std::function<void(const std::string& temporary)>& write);
// Closes a file that was written. Throws Failed, naming the path, where not all of it has come to the disk.
void closeWhole(std::ofstream& stream, const std::string& path);
// Writes text to the path, whole or not at all.
void writeText(const std::string& path, const std::string& text);

// Ends the program by that signal, without temporary files; where files are just being put into their places,
// after that. Safe in a signal handler.
void endBySignal(int signal);
// From now on SIGTERM and SIGHUP end the program so, unless they are ignored.
void endCleanly();

} // namespace oversketch_files
#endif
