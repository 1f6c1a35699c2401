// A PLY file: its header, and its rows one after the other.
#ifndef oversketch_applications_files_ply_document_h
#define oversketch_applications_files_ply_document_h

#include "number_file.h"

#include <initializer_list>
#include <vector>

namespace oversketch_files
{

// A type of numbers: its two names, and VTK's.
struct PlyType
{
  const char *name, *other;
  int type;
};
constexpr PlyType plyTypes[] = { { "char", "int8", VTK_SIGNED_CHAR },
  { "uchar", "uint8", VTK_UNSIGNED_CHAR },
  { "short", "int16", VTK_SHORT },
  { "ushort", "uint16", VTK_UNSIGNED_SHORT },
  { "int", "int32", VTK_INT },
  { "uint", "uint32", VTK_UNSIGNED_INT },
  { "float", "float32", VTK_FLOAT },
  { "double", "float64", VTK_DOUBLE } };

struct PlyProperty
{
  std::string name;
  int type = VTK_VOID;  // VTK's
  int count = VTK_VOID; // of a list; so for a single value

  bool isList() const { return this->count != VTK_VOID; }
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

class PlyDocument : public NumberFile
{
public:
  // Reads the header; throws Failed, as all members do.
  explicit PlyDocument(const std::string& path);

  const std::vector<PlyElement>& elements() const { return this->Elements; }
  // The names of pictures that the header gives (comment TextureFile).
  const std::vector<std::string>& pictures() const { return this->Pictures; }

  void readRow(const PlyElement& element, PlyRow& row);

private:
  int typeOf(std::string_view name) const;
  void readElement(Words& words);

  std::vector<PlyElement> Elements;
  std::vector<std::string> Pictures;
};

} // namespace oversketch_files
#endif
