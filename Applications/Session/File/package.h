// A set of named byte strings in one place: a zip file, or a folder of files.
#ifndef oversketch_applications_session_file_package_h
#define oversketch_applications_session_file_package_h

#include "zip_file.h"

#include <functional>
#include <string>

namespace oversketch_session
{

using oversketch_files::Package;
using oversketch_files::writeZip;

// Reads those entries of either form that are wanted, all where no choice is given. Throws Failed, naming the
// path: absent, damaged, names that leave the folder, a name twice, or more bytes than 16 MiB and 200 times
// those of the zip file.
Package readPackage(const std::string& path,
  const std::function<bool(const std::string& name)>& isWanted = {});

// Writes a folder, made if it is not there, so that a crash at any moment leaves the old package or the new:
// the entry `last` names the others and is replaced after they are on the disk; entries that are there with
// the same size are not written again, so their names must tell their content. Afterwards files that no entry
// names are removed. Throws Failed.
void writeFolder(const std::string& path, const Package& package, const std::string& last);

} // namespace oversketch_session
#endif
