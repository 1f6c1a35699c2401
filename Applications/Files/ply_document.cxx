#include "ply_document.h"

#include "files.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <sstream>

namespace oversketch_files
{

PlyDocument::PlyDocument(const std::string& path)
  : Path(path)
  , Bytes(wholeFile(path))
{
  this->readHeader();
}

void PlyDocument::readRow(const PlyElement& element, PlyRow& row)
{
  row.resize(element.properties.size());
  for (std::size_t k = 0; k < row.size(); ++k)
  {
    const PlyProperty& property = element.properties[k];
    double count = 1.0;
    if (property.count.size > 0)
    {
      count = this->value(property.count);
      if (!(count >= 0.0 && count <= static_cast<double>(this->Bytes.size() - this->At)))
      {
        this->refuseEnd();
      }
    }
    row[k].resize(static_cast<std::size_t>(count));
    for (double& value : row[k])
    {
      value = this->value(property.type);
    }
  }
}

void PlyDocument::refuseEnd() const
{
  this->refuse("ends before all that its header announces; the file is truncated or damaged");
}

std::string PlyDocument::line()
{
  const std::size_t end = std::min(this->Bytes.find('\n', this->At), this->Bytes.size());
  std::string text = this->Bytes.substr(this->At, end - this->At);
  this->At = std::min(end + 1, this->Bytes.size());
  return text;
}

PlyType PlyDocument::typeOf(const std::string& name) const
{
  static const std::map<std::string, PlyType> types = { { "char", { 'i', 1 } },
    { "int8", { 'i', 1 } },
    { "uchar", { 'u', 1 } },
    { "uint8", { 'u', 1 } },
    { "short", { 'i', 2 } },
    { "int16", { 'i', 2 } },
    { "ushort", { 'u', 2 } },
    { "uint16", { 'u', 2 } },
    { "int", { 'i', 4 } },
    { "int32", { 'i', 4 } },
    { "uint", { 'u', 4 } },
    { "uint32", { 'u', 4 } },
    { "float", { 'f', 4 } },
    { "float32", { 'f', 4 } },
    { "double", { 'f', 8 } },
    { "float64", { 'f', 8 } } };
  const auto it = types.find(name);
  if (it == types.end())
  {
    this->refuse("its PLY header names the unknown type '" + name.substr(0, 24) + "'");
  }
  return it->second;
}

void PlyDocument::readHeader()
{
  if (this->line().rfind("ply", 0) != 0)
  {
    this->refuse("is not a PLY file");
  }
  std::string format = "none";
  for (bool ended = false; !ended;)
  {
    if (this->At == this->Bytes.size())
    {
      this->refuse("its PLY header does not end; the file is damaged");
    }
    std::istringstream words(this->line());
    std::string word;
    words >> word;
    ended = word == "end_header";
    if (word == "comment" && words >> word && word == "TextureFile")
    {
      std::getline(words >> std::ws, word);
      this->Pictures.push_back(word.substr(0, word.find_last_not_of(" \t\r") + 1));
    }
    else if (word == "format")
    {
      words >> format;
    }
    else if (word == "element")
    {
      this->readElement(words);
    }
    else if (word == "property" && !this->Elements.empty())
    {
      std::string type;
      words >> type;
      PlyProperty property;
      if (type == "list")
      {
        std::string count;
        words >> count >> type;
        property.count = this->typeOf(count);
      }
      property.type = this->typeOf(type);
      words >> property.name;
      this->Elements.back().properties.push_back(property);
    }
  }
  if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
  {
    this->refuse("its PLY header names the unknown format '" + format.substr(0, 24) + "'");
  }
  for (const PlyElement& element : this->Elements)
  {
    if (element.count > 0 && element.properties.size() > this->Bytes.size() / element.count)
    {
      this->refuse("announces more elements than a file of its size can hold");
    }
  }
  this->Ascii = format == "ascii";
  this->BigEndian = format == "binary_big_endian";
}

void PlyDocument::readElement(std::istream& words)
{
  PlyElement element;
  double count = -1.0;
  if (!(words >> element.name >> count) || !(count >= 0.0) || count != std::floor(count) ||
      !(count <= static_cast<double>(this->Bytes.size())))
  {
    this->refuse("announces more elements than a file of its size can hold");
  }
  element.count = static_cast<std::size_t>(count);
  for (const PlyElement& other : this->Elements)
  {
    if (other.name == element.name)
    {
      this->refuse("its PLY header names the element '" + element.name.substr(0, 24) + "' twice");
    }
  }
  this->Elements.push_back(element);
}

double PlyDocument::word()
{
  const char* const end = this->Bytes.data() + this->Bytes.size();
  const char* from = this->Bytes.data() + this->At;
  from = std::find_if(from, end, [](char c) { return std::strchr(" \t\r\n", c) == nullptr || c == '\0'; });
  if (from == end)
  {
    this->refuseEnd();
  }
  const char* const number = from + (*from == '+' ? 1 : 0);
  double value = 0.0;
  const std::from_chars_result done = std::from_chars(number, end, value);
  if (done.ec == std::errc::invalid_argument)
  {
    this->refuse("holds '" +
                 std::string(from, std::min<std::size_t>(16, static_cast<std::size_t>(end - from))) +
                 "' where a number should be; the file is damaged");
  }
  if (done.ec == std::errc::result_out_of_range) // too small counts as zero, too large is not finite
  {
    value = std::strtod(std::string(number, done.ptr).c_str(), nullptr);
  }
  this->At = static_cast<std::size_t>(done.ptr - this->Bytes.data());
  return value;
}

double PlyDocument::binary(PlyType type)
{
  const auto size = static_cast<std::size_t>(type.size);
  if (this->Bytes.size() - this->At < size)
  {
    this->refuseEnd();
  }
  std::uint64_t whole = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::size_t at = this->At + (this->BigEndian ? i : size - 1 - i);
    whole = whole << 8 | static_cast<unsigned char>(this->Bytes[at]);
  }
  this->At += size;
  if (type.kind == 'u')
  {
    return static_cast<double>(whole);
  }
  if (type.kind == 'i')
  {
    const auto half = std::uint64_t(1) << (8 * size - 1);
    return static_cast<double>(static_cast<std::int64_t>(whole ^ half) - static_cast<std::int64_t>(half));
  }
  if (size == 8)
  {
    double value;
    std::memcpy(&value, &whole, 8);
    return value;
  }
  const auto bits = static_cast<std::uint32_t>(whole);
  float value;
  std::memcpy(&value, &bits, 4);
  return value;
}

} // namespace oversketch_files
