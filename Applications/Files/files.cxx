#include "files.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>

namespace fs = std::filesystem;

namespace oversketch_files
{

namespace
{

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

std::string printable(std::string text)
{
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const auto c = static_cast<unsigned char>(text[i]);
    // Those of one byte, and those that UTF-8 writes as C2 80 to C2 9F.
    const bool isLong = c == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (isLong)
    {
      text.erase(i, 1);
    }
    if (isLong || std::iscntrl(c) != 0)
    {
      text[i] = ' ';
    }
  }
  return text;
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

void requireWritable(const std::string& path)
{
  std::error_code error;
  const fs::path folder = fs::absolute(path).parent_path();
  if (!fs::is_directory(folder, error))
  {
    throw Failed(path + ": there is no folder " + folder.string());
  }
  if (fs::is_directory(path, error))
  {
    throw Failed(path + ": is a folder");
  }
  if (fs::exists(path, error) && !fs::is_regular_file(path, error))
  {
    throw Failed(path + ": is not a file that can be replaced");
  }
  if (::access(folder.c_str(), W_OK) != 0)
  {
    throw Failed(path + ": the folder may not be written to");
  }
}

void writeWhole(const std::string& path, const std::function<void(const std::string&)>& write)
{
  requireWritable(path);
  const fs::path target = fs::absolute(path);
  const fs::path temporary = target.parent_path() / ("." + target.stem().string() + "." +
                                                      std::to_string(::getpid()) + extensionOf(path));
  std::error_code ignored;
  try
  {
    write(temporary.string());
    if (fs::file_size(temporary) == 0)
    {
      throw Failed(path + ": could not be written (is the disk full?)");
    }
    toDisk(temporary);
    fs::rename(temporary, target);
    toDisk(target.parent_path());
  }
  catch (const Failed& failed)
  {
    fs::remove(temporary, ignored);
    std::string message = failed.what();
    const std::size_t at = message.find(temporary.string());
    throw Failed(at == std::string::npos ? message : message.replace(at, temporary.string().size(), path));
  }
  catch (const fs::filesystem_error& error)
  {
    fs::remove(temporary, ignored);
    throw Failed(path + ": could not be written: " + error.code().message());
  }
  catch (...)
  {
    fs::remove(temporary, ignored);
    throw;
  }
}

void writeText(const std::string& path, const std::string& text)
{
  writeWhole(path,
    [&](const std::string& temporary)
    {
      std::ofstream stream(temporary, std::ios::binary);
      stream << text;
      stream.close();
      if (!stream)
      {
        throw Failed(path + ": could not be written (is the disk full?)");
      }
    });
}

} // namespace oversketch_files
