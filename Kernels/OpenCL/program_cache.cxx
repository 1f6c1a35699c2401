#include "OpenCL/program_cache.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fcntl.h>
#include <stdlib.h> // mkstemp
#include <sys/file.h>
#include <unistd.h>

namespace oversketch
{

namespace
{

// First bytes of a file; the number changes with the layout: this line, the sizes of key and binary, their
// checksum, the key, the binary.
// Files of layout 1 may hold what PoCL wrote while another process built the same program (see OneAtATime).
constexpr char layout[16] = "oversketch-cl 2";

// FNV-1a over 64 bits: it tells damage, not malice; the folder is the user's own.
class Checksum
{
public:
  void add(const void* data, std::size_t size)
  {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i)
    {
      this->Value = (this->Value ^ bytes[i]) * 1099511628211u;
    }
  }
  std::uint64_t value() const { return this->Value; }

private:
  std::uint64_t Value = 14695981039346656037u;
};

struct Header
{
  char layout[sizeof(oversketch::layout)];
  std::uint64_t keySize, binarySize, checksum;
};

Header headerOf(const std::string& key, const std::vector<unsigned char>& binary)
{
  Checksum checksum;
  checksum.add(key.data(), key.size());
  checksum.add(binary.data(), binary.size());
  Header header{};
  std::memcpy(header.layout, layout, sizeof(layout));
  header.keySize = key.size();
  header.binarySize = binary.size();
  header.checksum = checksum.value();
  return header;
}

std::filesystem::path folder()
{
  const auto absolute = [](const char* variable)
  {
    const char* value = std::getenv(variable);
    const std::filesystem::path path = value ? value : "";
    return path.is_absolute() ? path : std::filesystem::path();
  };
  if (const auto cache = absolute("XDG_CACHE_HOME"); !cache.empty())
  {
    return cache / "oversketch";
  }
  const auto home = absolute("HOME");
  return home.empty() ? home : home / ".cache" / "oversketch";
}

// Held while a program is built and its binary taken or read: by one thread of one process at a time. PoCL
// measures its own cache folder, then copies it into the binary; a process that adds files to that folder in
// between makes a binary on which PoCL's reader aborts, in this process and in each later one. The lock is
// the folder's own, so it leaves no file, and it ends with the process that holds it. Where there is no
// folder to lock, nothing is kept either.
class OneAtATime
{
public:
  OneAtATime()
  {
    const std::filesystem::path path = folder();
    if (path.empty())
    {
      return;
    }
    std::error_code failed;
    std::filesystem::create_directories(path, failed);
    this->Folder = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    while (this->Folder >= 0 && flock(this->Folder, LOCK_EX) != 0 && errno == EINTR)
    {
    }
  }
  ~OneAtATime()
  {
    if (this->Folder >= 0)
    {
      close(this->Folder);
    }
  }
  OneAtATime(const OneAtATime&) = delete;
  OneAtATime& operator=(const OneAtATime&) = delete;

private:
  int Folder = -1;
};

} // namespace

std::string programKey(const cl::Device& device, const std::string& source, const std::string& options)
{
  const cl::Platform platform(device.getInfo<CL_DEVICE_PLATFORM>());
  std::string key = layout;
  for (const std::string& part : { platform.getInfo<CL_PLATFORM_NAME>(),
         platform.getInfo<CL_PLATFORM_VERSION>(),
         device.getInfo<CL_DEVICE_VENDOR>(),
         device.getInfo<CL_DEVICE_NAME>(),
         device.getInfo<CL_DEVICE_VERSION>(),
         device.getInfo<CL_DRIVER_VERSION>(),
         options,
         source })
  {
    key += '\n';
    key += part.c_str(); // some drivers count the terminating zero
  }
  return key;
}

std::filesystem::path programFile(const std::string& key)
{
  std::filesystem::path path = folder();
  if (path.empty())
  {
    return path;
  }
  Checksum checksum;
  checksum.add(key.data(), key.size());
  char name[32];
  std::snprintf(name, sizeof(name), "%016llx.cl", static_cast<unsigned long long>(checksum.value()));
  return path / name;
}

std::vector<unsigned char> loadProgram(const std::string& key)
{
  const std::filesystem::path path = programFile(key);
  if (path.empty())
  {
    return {};
  }
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(file), {} };
  Header header{};
  if (bytes.size() <= sizeof(header) + key.size() || bytes.compare(sizeof(header), key.size(), key) != 0)
  {
    return {};
  }
  std::memcpy(&header, bytes.data(), sizeof(header));
  const std::vector<unsigned char> binary(
    bytes.begin() + std::ptrdiff_t(sizeof(header) + key.size()), bytes.end());
  const Header expected = headerOf(key, binary);
  return std::memcmp(&header, &expected, sizeof(header)) == 0 ? binary : std::vector<unsigned char>();
}

void storeProgram(const std::string& key, const std::vector<unsigned char>& binary)
{
  const std::filesystem::path path = programFile(key);
  if (path.empty() || binary.empty())
  {
    return;
  }
  std::error_code failed;
  std::filesystem::create_directories(path.parent_path(), failed);
  std::string temporary = path.string() + ".XXXXXX";
  const int file = mkstemp(temporary.data());
  if (file < 0)
  {
    return;
  }
  const Header header = headerOf(key, binary);
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof(header));
  bytes += key;
  bytes.append(binary.begin(), binary.end());
  std::size_t written = 0;
  while (written < bytes.size())
  {
    const ssize_t count = write(file, bytes.data() + written, bytes.size() - written);
    if (count <= 0)
    {
      break;
    }
    written += std::size_t(count);
  }
  const bool closed = close(file) == 0;
  if (!closed || written < bytes.size() || rename(temporary.c_str(), path.c_str()) != 0)
  {
    unlink(temporary.c_str());
  }
}

cl::Program buildProgram(const cl::Context& context,
  const cl::Device& device,
  const std::string& source,
  const std::string& options,
  bool& compiled)
{
  const OneAtATime alone;
  const std::string key = programKey(device, source, options);
  const std::vector<unsigned char> known = loadProgram(key);
  if (!known.empty())
  {
    try
    {
      cl::Program program(context, { device }, { known });
      program.build({ device }, options.c_str());
      compiled = false;
      return program;
    }
    catch (const cl::Error&)
    {
      // The driver wants it no more; the source is at hand.
    }
  }
  cl::Program program(context, source);
  program.build({ device }, options.c_str());
  compiled = true;
  try
  {
    const std::vector<std::vector<unsigned char>> binaries = program.getInfo<CL_PROGRAM_BINARIES>();
    if (binaries.size() == 1)
    {
      storeProgram(key, binaries.front());
    }
  }
  catch (const cl::Error&)
  {
    // A driver that gives no binaries; the program itself is fine.
  }
  return program;
}

} // namespace oversketch
