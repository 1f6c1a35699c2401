// A PLY file: its header, and its rows one after the other.
#ifndef oversketch_applications_files_ply_document_h
#define oversketch_applications_files_ply_document_h

#include "files.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

namespace oversketch_files
{

struct PlyType
{
  char kind = 'f'; // i, u, f: signed, unsigned, floating
  int size = 0;    // bytes
};

struct PlyProperty
{
  std::string name;
  PlyType type;
  PlyType count; // of a list; its size is 0 for a single value
};

struct PlyElement
{
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  // The place of a property in the list, -1 where it is not there.
  int find(const std::string& wanted) const
  {
    const auto it = std::find_if(this->properties.begin(),
      this->properties.end(),
      [&](const PlyProperty& p) { return p.name == wanted; });
    return it == this->properties.end() ? -1 : static_cast<int>(it - this->properties.begin());
  }

  // The places of all these; empty where one is not there.
  std::vector<int> findAll(std::initializer_list<const char*> wanted) const
  {
    std::vector<int> places;
    for (const char* one : wanted)
    {
      places.push_back(this->find(one));
    }
    return std::count(places.begin(), places.end(), -1) == 0 ? places : std::vector<int>();
  }
};

// The values of one row of an element: a single value is a list of one.
using PlyRow = std::vector<std::vector<double>>;

class PlyDocument
{
public:
  // Reads the header; throws Failed, as all members do.
  explicit PlyDocument(const std::string& path);

  const std::vector<PlyElement>& elements() const { return this->Elements; }
  // The names of pictures that the header gives (comment TextureFile).
  const std::vector<std::string>& pictures() const { return this->Pictures; }

  [[noreturn]] void refuse(const std::string& why) const { throw Failed(this->Path + ": " + why); }

  void readRow(const PlyElement& element, PlyRow& row);

private:
  [[noreturn]] void refuseEnd() const;
  std::string line();
  PlyType typeOf(const std::string& name) const;
  void readHeader();
  void readElement(std::istream& words);
  double value(PlyType type) { return this->Ascii ? this->word() : this->binary(type); }

  double word();
  double binary(PlyType type);
  std::string Path;
  std::string Bytes;
  std::size_t At = 0;
  std::vector<PlyElement> Elements;
  std::vector<std::string> Pictures;
  bool Ascii = true, BigEndian = false;
};

} // namespace oversketch_files
#endif
