#include "zip_file.h"

#include "files.h"

#include <archive.h>
#include <archive_entry.h>

namespace oversketch_files
{

void fillZip(const std::string& path, const Package& package, Packing packing)
{
  const std::unique_ptr<archive, decltype(&archive_write_free)> zip(archive_write_new(), &archive_write_free);
  const auto check = [&](int state)
  {
    if (state < ARCHIVE_OK)
    {
      throw Failed(path + ": could not be written (is the disk full?)");
    }
  };
  check(archive_write_set_format_zip(zip.get()));
  check(archive_write_set_options(
    zip.get(), packing == Packing::Stored ? "zip:compression=store" : "zip:compression=deflate"));
  check(archive_write_open_filename(zip.get(), path.c_str()));
  for (const auto& [name, bytes] : package)
  {
    const std::unique_ptr<archive_entry, decltype(&archive_entry_free)> entry(
      archive_entry_new(), &archive_entry_free);
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes->size()));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_mtime(entry.get(), 315532800, 0); // 1980, where zip's clock begins
    check(archive_write_header(zip.get(), entry.get()));
    if (archive_write_data(zip.get(), bytes->data(), bytes->size()) != static_cast<la_ssize_t>(bytes->size()))
    {
      check(ARCHIVE_FATAL);
    }
  }
  check(archive_write_close(zip.get()));
}

void writeZip(const std::string& path, const Package& package)
{
  writeWhole(path, [&](const std::string& temporary) { fillZip(temporary, package, Packing::Stored); });
}

} // namespace oversketch_files
