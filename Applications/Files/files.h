// What the command's readers and writers share: one kind of error, notes for the user, whole files or none.
#ifndef oversketch_files_files_h
#define oversketch_files_files_h

#include <cstdint>
#include <functional>
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

// The text with a space for every control character, so that a name from a file cannot steer a terminal.
std::string printable(std::string text);

// Lower-case extension with its dot, "" if there is none.
std::string extensionOf(const std::string& path);
// Size of the file in bytes. Throws Failed for an absent, unreadable or empty file and for a folder.
std::uintmax_t requireReadable(const std::string& path);
// The content of a file; empty where it is absent or no regular file, which may never end.
std::string wholeFile(const std::string& path);
// Throws Failed unless a file of this name can be made or replaced.
void requireWritable(const std::string& path);
// Calls write with the name of a temporary file beside path (same extension), and renames it to path. The
// temporary file is removed when write throws, so that no half-written file is left.
void writeWhole(const std::string& path, const std::function<void(const std::string& temporary)>& write);
// Writes text to the path, whole or not at all.
void writeText(const std::string& path, const std::string& text);

} // namespace oversketch_files
#endif
