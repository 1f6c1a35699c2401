// vtkPLYReader of VTK 9.1 frees memory twice on a file that breaks off and allocates what a header announces,
// so a PLY file is walked through once before it is read.
#include "mesh_file.h"

#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

namespace oversketch_files
{

namespace
{

struct Property
{
  int size = 0;      // bytes of a value
  int countSize = 0; // bytes of the count of a list, 0 for a single value
  bool countSigned = false;
};

struct Element
{
  double count = 0.0;
  std::vector<Property> properties;
};

// Reads on through the body of a PLY file; false where it ends too early.
class Walker
{
public:
  Walker(std::ifstream& stream, std::uintmax_t size, bool ascii, bool bigEndian)
    : Stream(stream)
    , Size(size)
    , Ascii(ascii)
    , BigEndian(bigEndian)
  {
  }

  bool skip(double values, int bytes)
  {
    if (!this->Ascii)
    {
      const double to = static_cast<double>(this->Stream.tellg()) + values * bytes;
      return to <= static_cast<double>(this->Size) && this->Stream.seekg(static_cast<std::streamoff>(to));
    }
    std::string word;
    for (double i = 0; i < values; ++i)
    {
      if (!(this->Stream >> word))
      {
        return false;
      }
    }
    return true;
  }

  // The count of a list, -1 where there is none.
  double count(const Property& property)
  {
    double value = -1.0;
    if (this->Ascii)
    {
      return this->Stream >> value ? value : -1.0;
    }
    unsigned char bytes[8];
    if (!this->Stream.read(reinterpret_cast<char*>(bytes), property.countSize))
    {
      return -1.0;
    }
    std::uint64_t whole = 0;
    for (int i = 0; i < property.countSize; ++i)
    {
      whole = (whole << 8) | bytes[this->BigEndian ? i : property.countSize - 1 - i];
    }
    const bool negative = property.countSigned && (whole >> (8 * property.countSize - 1)) != 0;
    return negative ? -1.0 : static_cast<double>(whole);
  }

private:
  std::ifstream& Stream;
  std::uintmax_t Size;
  bool Ascii, BigEndian;
};

} // namespace

void checkPly(const std::string& path)
{
  const std::map<std::string, int> sizes = { { "char", 1 },
    { "uchar", 1 },
    { "short", 2 },
    { "ushort", 2 },
    { "int", 4 },
    { "uint", 4 },
    { "float", 4 },
    { "double", 8 },
    { "int8", 1 },
    { "uint8", 1 },
    { "int16", 2 },
    { "uint16", 2 },
    { "int32", 4 },
    { "uint32", 4 },
    { "float32", 4 },
    { "float64", 8 } };
  const auto sizeOf = [&](const std::string& type)
  {
    const auto it = sizes.find(type);
    if (it == sizes.end())
    {
      throw Failed(path + ": its PLY header names the unknown type '" + type.substr(0, 24) + "'");
    }
    return it->second;
  };
  const std::uintmax_t size = requireReadable(path);
  std::ifstream stream(path, std::ios::binary);
  std::string line, format;
  std::vector<Element> elements;
  const auto next = [&]
  {
    line.clear();
    for (char c = 0; line.size() < 4096 && stream.get(c) && c != '\n';)
    {
      line += c;
    }
    return !line.empty() || stream.good();
  };
  if (!next() || line.rfind("ply", 0) != 0)
  {
    throw Failed(path + ": is not a PLY file");
  }
  while (next() && line.rfind("end_header", 0) != 0)
  {
    std::istringstream words(line);
    std::string word, type, count;
    words >> word;
    if (word == "format")
    {
      words >> format;
    }
    else if (word == "element")
    {
      Element element;
      if (!(words >> type >> element.count) ||
          !(element.count >= 0.0 && element.count <= static_cast<double>(size)))
      {
        throw Failed(path + ": announces more elements than a file of its size can hold");
      }
      elements.push_back(element);
    }
    else if (word == "property" && !elements.empty())
    {
      words >> type;
      Property property;
      if (type == "list")
      {
        words >> count >> type;
        property.countSize = sizeOf(count);
        property.countSigned = count[0] != 'u';
      }
      property.size = sizeOf(type);
      elements.back().properties.push_back(property);
    }
  }
  if (line.rfind("end_header", 0) != 0)
  {
    throw Failed(path + ": its PLY header does not end; the file is damaged");
  }
  Walker walker(stream, size, format == "ascii", format == "binary_big_endian");
  for (const Element& element : elements)
  {
    for (double i = 0; i < element.count; ++i)
    {
      for (const Property& property : element.properties)
      {
        const double values = property.countSize > 0 ? walker.count(property) : 1.0;
        if (values < 0.0 || !walker.skip(values, property.size))
        {
          throw Failed(path + ": ends before all that its header announces; the file is truncated");
        }
      }
    }
  }
}

} // namespace oversketch_files
