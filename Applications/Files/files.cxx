#include "files.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <tuple>

namespace fs = std::filesystem;

namespace oversketch_files
{

namespace
{

thread_local const std::atomic<bool>* givenUpHere = nullptr;

std::mutex messageMutex;
std::string firstError;

// Keeps the first error; drops warnings and repetitions. Called from any thread.
class MessageCatcher : public vtkOutputWindow
{
public:
  static MessageCatcher* New();
  vtkTypeMacro(MessageCatcher, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    const std::lock_guard<std::mutex> lock(messageMutex);
    if (firstError.empty())
    {
      firstError = text;
    }
  }
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
};
vtkStandardNewMacro(MessageCatcher);

// Waits until the file or folder is on the disk, so that a power cut leaves the old file or the new.
void toDisk(const fs::path& path)
{
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && ::fsync(file) == 0;
  const int error = errno;
  if (file >= 0)
  {
    ::close(file);
  }
  // Some file systems cannot, and say so.
  if (!done && error != EINVAL && error != EACCES)
  {
    throw fs::filesystem_error("fsync", path, std::error_code(error, std::generic_category()));
  }
}

} // namespace

void catchMessages()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<MessageCatcher> catcher;
  vtkOutputWindow::SetInstance(catcher);
}

std::string takeError()
{
  const std::lock_guard<std::mutex> lock(messageMutex);
  // "ERROR: In file, line n\nvtkClass (0x...): the message\n\n"
  std::string text;
  std::swap(text, firstError);
  const std::size_t colon = text.find("): ");
  if (colon != std::string::npos)
  {
    text.erase(0, colon + 3);
  }
  return text.substr(0, text.find('\n'));
}

std::string printable(const std::string& text)
{
  std::string made;
  for (std::size_t i = 0; i < text.size();)
  {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t size = lead < 0x80         ? 1
                             : lead >> 5 == 0x6  ? 2
                             : lead >> 4 == 0xe  ? 3
                             : lead >> 3 == 0x1e ? 4
                                                 : 0;
    std::uint32_t code = size < 2 ? lead : lead & (0xff >> (size + 1));
    bool good = size > 0 && i + size <= text.size();
    for (std::size_t k = 1; good && k < size; ++k)
    {
      const auto next = static_cast<unsigned char>(text[i + k]);
      good = next >> 6 == 0x2;
      code = code << 6 | (next & 0x3f);
    }
    // Each code in its shortest form, none of the halves of UTF-16.
    const std::uint32_t least[] = { 0, 0, 0x80, 0x800, 0x10000 };
    good = good && code >= least[size] && code <= 0x10ffff && !(code >= 0xd800 && code < 0xe000);
    const bool isControl = code < 0x20 || (code >= 0x7f && code < 0xa0) ||
                           (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
    made += !good ? "?" : isControl ? " " : text.substr(i, size);
    i += good ? size : 1;
  }
  return made;
}

std::string plainName(const std::string& name)
{
  std::string plain = printable(name);
  std::replace_if(
    plain.begin(), plain.end(), [](char c) { return std::strchr("\"<>&", c) != nullptr; }, '_');
  return plain;
}

std::string extensionOf(const std::string& path)
{
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(),
    extension.end(),
    extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::uintmax_t requireReadable(const std::string& path)
{
  std::error_code error;
  if (!fs::exists(path, error))
  {
    throw Failed(path + ": there is no such file");
  }
  if (!fs::is_regular_file(path, error))
  {
    throw Failed(path + ": is not a file");
  }
  if (::access(path.c_str(), R_OK) != 0)
  {
    throw Failed(path + ": may not be read");
  }
  const std::uintmax_t size = fs::file_size(path, error);
  if (error || size == 0)
  {
    throw Failed(path + ": is empty");
  }
  return size;
}

std::string wholeFile(const std::string& path)
{
  std::error_code error;
  if (!fs::is_regular_file(path, error))
  {
    return {};
  }
  std::ifstream stream(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

namespace
{

// Where links lead, also to a file that is not there yet.
fs::path followed(const std::string& path)
{
  fs::path target = fs::absolute(path);
  std::error_code error;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target, error)); ++links)
  {
    const fs::path next = fs::read_symlink(target, error);
    if (error || links == 40)
    {
      throw Failed(path + ": is a link that leads nowhere");
    }
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target;
}

// Names of temporary files, for a signal handler, which may neither lock nor allocate.
std::array<std::atomic<char*>, 2048> temporaries;
std::atomic<int> committing{ 0 };
std::atomic<int> pendingSignal{ 0 };

int remember(const std::string& name)
{
  char* copy = ::strdup(name.c_str());
  for (std::size_t i = 0; copy && i < temporaries.size(); ++i)
  {
    char* empty = nullptr;
    if (temporaries[i].compare_exchange_strong(empty, copy))
    {
      return static_cast<int>(i);
    }
  }
  std::free(copy);
  throw Failed(name + ": too many files are written at once");
}

void forget(int slot)
{
  if (slot >= 0)
  {
    std::free(temporaries[static_cast<std::size_t>(slot)].exchange(nullptr));
  }
}

// Lets a signal wait while it lives.
struct Committing
{
  Committing() { ++committing; }
  ~Committing()
  {
    if (--committing == 0 && pendingSignal != 0)
    {
      endBySignal(pendingSignal);
    }
  }
  Committing(const Committing&) = delete;
  Committing& operator=(const Committing&) = delete;
};

// An empty file of a new name beside the target, that others may not read if they may not read the target;
// and its place in the list.
std::pair<std::string, int> temporaryBeside(const fs::path& target, const std::string& path, mode_t mode)
{
  static std::atomic<unsigned> count{ 0 };
  for (;;)
  {
    const std::string name =
      ".oversketch." + std::to_string(::getpid()) + '.' + std::to_string(count++) + extensionOf(path);
    const std::string temporary = (target.parent_path() / name).string();
    const int slot = remember(temporary);
    const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    const int error = errno;
    if (file >= 0)
    {
      ::close(file);
      return { temporary, slot };
    }
    forget(slot);
    if (error != EEXIST)
    {
      throw Failed(path + ": could not be written: " + std::generic_category().message(error));
    }
  }
}

// Mode and, where it may be had, owner of the file that is replaced.
void keepMode(const fs::path& target, const std::string& temporary)
{
  struct stat old = {}, made = {};
  if (::stat(target.c_str(), &old) != 0 || ::stat(temporary.c_str(), &made) != 0)
  {
    return; // a new file
  }
  const bool isOwners = (old.st_uid == made.st_uid && old.st_gid == made.st_gid) ||
                        ::chown(temporary.c_str(), old.st_uid, old.st_gid) == 0;
  // Rights of another owner's program are not for what was made by this one.
  const mode_t mode = old.st_mode & (isOwners ? 07777 : 0777);
  if (::chmod(temporary.c_str(), mode) != 0)
  {
    throw fs::filesystem_error("chmod", temporary, std::error_code(errno, std::generic_category()));
  }
}

} // namespace

bool isSameFile(const std::string& a, const std::string& b)
{
  std::error_code error;
  return fs::equivalent(a, b, error) || followed(a).lexically_normal() == followed(b).lexically_normal();
}

void requireWritable(const std::string& path)
{
  std::error_code error;
  const fs::path target = followed(path);
  const fs::path folder = target.parent_path();
  if (!fs::is_directory(folder, error))
  {
    throw Failed(path + ": there is no folder " + folder.string());
  }
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status))
  {
    throw Failed(path + ": is a folder");
  }
  if (fs::exists(status))
  {
    constexpr fs::perms write = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    if (!fs::is_regular_file(status))
    {
      throw Failed(path + ": is not a file that can be replaced");
    }
    if ((status.permissions() & write) == fs::perms::none || ::access(target.c_str(), W_OK) != 0)
    {
      throw Failed(path + ": may not be written to; choose another name or change its mode");
    }
  }
  if (::access(folder.c_str(), W_OK) != 0)
  {
    throw Failed(path + ": the folder may not be written to");
  }
}

NewFiles::~NewFiles()
{
  while (!this->Files.empty())
  {
    this->dropLast();
  }
}

void NewFiles::dropLast()
{
  ::unlink(this->Files.back().temporary.c_str());
  forget(this->Files.back().slot);
  this->Files.pop_back();
}

void NewFiles::fill(File& file, const std::function<void(const std::string&)>& write)
{
  struct stat old = {};
  const bool isThere = ::stat(file.target.c_str(), &old) == 0;
  std::tie(file.temporary, file.slot) =
    temporaryBeside(file.target, file.path, isThere ? (old.st_mode & 0666) | 0600 : 0666);
  write(file.temporary);
  if (fs::file_size(file.temporary) == 0)
  {
    throw Failed(file.path + ": could not be written (is the disk full?)");
  }
  keepMode(file.target, file.temporary);
  toDisk(file.temporary);
}

void NewFiles::write(const std::string& path, const std::function<void(const std::string&)>& write)
{
  requireWritable(path);
  const std::string target = followed(path).lexically_normal().string();
  for (const File& file : this->Files)
  {
    if (file.target == target)
    {
      throw Failed(path + ": would be written twice; choose another name for one of the files");
    }
  }
  this->Files.push_back({ path, target, {}, -1 });
  try
  {
    this->fill(this->Files.back(), write);
  }
  catch (const Failed& failed)
  {
    const std::string temporary = this->Files.back().temporary;
    this->dropLast();
    std::string message = failed.what();
    const std::size_t at = temporary.empty() ? std::string::npos : message.find(temporary);
    throw Failed(at == std::string::npos ? message : message.replace(at, temporary.size(), path));
  }
  catch (const fs::filesystem_error& error)
  {
    this->dropLast();
    throw Failed(path + ": could not be written: " + error.code().message());
  }
  catch (...)
  {
    this->dropLast();
    throw;
  }
}

void NewFiles::writeText(const std::string& path, const std::string& text)
{
  this->write(path,
    [&](const std::string& temporary)
    {
      std::ofstream stream(temporary, std::ios::binary);
      stream << text;
      closeWhole(stream, path);
    });
}

GiveUp::GiveUp(const std::atomic<bool>& givenUp)
{
  givenUpHere = &givenUp;
}

GiveUp::~GiveUp()
{
  givenUpHere = nullptr;
}

void NewFiles::commit()
{
  if (givenUpHere && *givenUpHere)
  {
    throw Failed("given up");
  }
  const Committing wait;
  std::vector<std::string> made;
  try
  {
    for (File& file : this->Files)
    {
      const bool isNew = ::access(file.target.c_str(), F_OK) != 0;
      fs::rename(file.temporary, file.target);
      forget(file.slot);
      file.slot = -1;
      if (isNew)
      {
        made.push_back(file.target);
      }
    }
    for (const File& file : this->Files)
    {
      toDisk(fs::path(file.target).parent_path());
    }
    this->Files.clear();
  }
  catch (const fs::filesystem_error& error)
  {
    for (const std::string& file : made)
    {
      ::unlink(file.c_str());
    }
    throw Failed(this->Files.front().path + ": could not be written: " + error.code().message());
  }
}

void writeWhole(const std::string& path, const std::function<void(const std::string&)>& write)
{
  NewFiles files;
  files.write(path, write);
  files.commit();
}

void closeWhole(std::ofstream& stream, const std::string& path)
{
  stream.close();
  if (!stream)
  {
    throw Failed(path + ": could not be written (is the disk full?)");
  }
}

void writeText(const std::string& path, const std::string& text)
{
  NewFiles files;
  files.writeText(path, text);
  files.commit();
}

void endBySignal(int signal)
{
  if (committing != 0)
  {
    pendingSignal = signal;
    return;
  }
  for (std::atomic<char*>& slot : temporaries)
  {
    if (const char* name = slot.exchange(nullptr))
    {
      ::unlink(name);
    }
  }
  std::signal(signal, SIG_DFL);
  sigset_t only;
  ::sigemptyset(&only);
  ::sigaddset(&only, signal);
  ::pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
  ::raise(signal);
}

void endCleanly()
{
  for (const int signal : { SIGTERM, SIGHUP })
  {
    if (std::signal(signal, endBySignal) == SIG_IGN)
    {
      std::signal(signal, SIG_IGN);
    }
  }
}

} // namespace oversketch_files
