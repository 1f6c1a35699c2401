#include "package.h"

#include "files.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <filesystem>

namespace fs = std::filesystem;

namespace oversketch_session
{

using oversketch_files::Failed;

namespace
{

// Deflate makes up to a thousand bytes of one, but not of meshes and strokes.
constexpr std::uintmax_t mostInflation = 200, leastRoom = std::uintmax_t(1) << 24;

using EntryChoice = std::function<bool(const std::string& name)>;

void requirePlain(const std::string& path, const std::string& name)
{
  const fs::path parts(name);
  if (name.empty() || parts.is_absolute() ||
      std::any_of(
        parts.begin(), parts.end(), [](const fs::path& part) { return part == ".." || part == "."; }))
  {
    throw Failed(path + ": holds the name '" + name + "', which a session does not; the file is damaged");
  }
}

Package readZip(const std::string& path, const EntryChoice& isWanted)
{
  const std::uintmax_t most = std::max(leastRoom, mostInflation * oversketch_files::requireReadable(path));
  const std::unique_ptr<archive, decltype(&archive_read_free)> zip(archive_read_new(), &archive_read_free);
  archive_read_support_format_zip(zip.get());
  const auto refuse = [&]
  { throw Failed(path + ": is no session, or a damaged one: it is no whole zip file"); };
  if (archive_read_open_filename(zip.get(), path.c_str(), 1 << 20) != ARCHIVE_OK)
  {
    refuse();
  }
  Package package;
  std::uintmax_t all = 0;
  for (archive_entry* entry = nullptr;;)
  {
    const int state = archive_read_next_header(zip.get(), &entry);
    if (state == ARCHIVE_EOF)
    {
      return package;
    }
    if (state != ARCHIVE_OK)
    {
      refuse();
    }
    const char* pathname = archive_entry_pathname(entry);
    const std::string name = pathname ? pathname : "";
    requirePlain(path, name);
    if (archive_entry_filetype(entry) == AE_IFDIR || (isWanted && !isWanted(name)))
    {
      continue;
    }
    if (package.count(name) == 1)
    {
      std::string why = path + ": holds two entries ";
      why += name;
      throw Failed(why + "; the file is damaged");
    }
    auto bytes = std::make_shared<std::string>();
    const void* block = nullptr;
    std::size_t size = 0;
    la_int64_t at = 0;
    int read = ARCHIVE_OK;
    while ((read = archive_read_data_block(zip.get(), &block, &size, &at)) == ARCHIVE_OK)
    {
      if ((all += size) > most || at != static_cast<la_int64_t>(bytes->size()))
      {
        throw Failed(path + ": holds more than a file of its size can; the file is damaged");
      }
      bytes->append(static_cast<const char*>(block), size);
    }
    if (read != ARCHIVE_EOF)
    {
      refuse();
    }
    package[name] = std::move(bytes);
  }
}

Package readFolder(const std::string& path, const EntryChoice& isWanted)
{
  Package package;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path))
  {
    const std::string name = entry.path().lexically_relative(path).generic_string();
    if (entry.is_regular_file() && (!isWanted || isWanted(name)))
    {
      package[name] = std::make_shared<std::string>(oversketch_files::wholeFile(entry.path().string()));
    }
  }
  return package;
}

} // namespace

Package readPackage(const std::string& path, const EntryChoice& isWanted)
{
  try
  {
    return fs::is_directory(path) ? readFolder(path, isWanted) : readZip(path, isWanted);
  }
  catch (const fs::filesystem_error& error)
  {
    throw Failed(path + ": could not be read: " + error.code().message());
  }
}

void writeFolder(const std::string& path, const Package& package, const std::string& last)
{
  try
  {
    fs::create_directories(path);
    const auto write = [&](const std::string& name, const std::string& bytes)
    {
      const fs::path file = fs::path(path) / name;
      fs::create_directories(file.parent_path());
      oversketch_files::writeText(file.string(), bytes);
    };
    for (const auto& [name, bytes] : package)
    {
      std::error_code absent;
      if (name != last && fs::file_size(fs::path(path) / name, absent) != bytes->size())
      {
        write(name, *bytes);
      }
    }
    write(last, *package.at(last));
    std::vector<fs::path> unnamed;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path))
    {
      if (entry.is_regular_file() &&
          package.count(entry.path().lexically_relative(path).generic_string()) == 0)
      {
        unnamed.push_back(entry.path());
      }
    }
    for (const fs::path& file : unnamed)
    {
      fs::remove(file);
    }
  }
  catch (const fs::filesystem_error& error)
  {
    throw Failed(path + ": could not be written: " + error.code().message());
  }
}

} // namespace oversketch_session
