// A zip file of named byte strings.
#ifndef oversketch_applications_files_zip_file_h
#define oversketch_applications_files_zip_file_h

#include <map>
#include <memory>
#include <string>

namespace oversketch_files
{

// By name; names are relative paths of plain parts ("strokes/1.vtp").
using Package = std::map<std::string, std::shared_ptr<const std::string>>;

enum class Packing
{
  Stored, // as it is: a .vtp file hardly shrinks, and saving must not wait
  Deflated
};

// Fills a file; a new one whole or not at all. Equal packages give equal files. Both throw Failed.
void fillZip(const std::string& path, const Package& package, Packing packing);
void writeZip(const std::string& path, const Package& package);

} // namespace oversketch_files
#endif
