#include "ply_document.h"

#include <cmath>

namespace oversketch_files
{

PlyDocument::PlyDocument(const std::string& path)
  : NumberFile(path)
{
  Words lines(this->Bytes);
  std::string_view line;
  if (!lines.line(line) || line.rfind("ply", 0) != 0)
  {
    this->refuse("is not a PLY file");
  }
  std::string_view format = "none";
  for (bool ended = false; !ended;)
  {
    if (!lines.line(line))
    {
      this->refuse("its PLY header does not end; the file is damaged");
    }
    Words words(line);
    const std::string_view word = words.next();
    ended = word == "end_header";
    if (word == "comment" && words.next() == "TextureFile")
    {
      this->Pictures.emplace_back(words.rest());
    }
    else if (word == "format")
    {
      format = words.next();
    }
    else if (word == "element")
    {
      this->readElement(words);
    }
    else if (word == "property" && !this->Elements.empty())
    {
      std::string_view type = words.next();
      PlyProperty property;
      if (type == "list")
      {
        property.count = this->typeOf(words.next());
        type = words.next();
      }
      property.type = this->typeOf(type);
      property.name = words.next();
      this->Elements.back().properties.push_back(property);
    }
  }
  if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
  {
    this->refuse("its PLY header names the unknown format " + inQuotes(format));
  }
  for (const PlyElement& element : this->Elements)
  {
    if (element.count > 0 && element.properties.size() > this->Bytes.size() / element.count)
    {
      this->refuse("announces more elements than a file of its size can hold");
    }
  }
  this->Binary = format != "ascii";
  this->BigEndian = format == "binary_big_endian";
  this->At = lines.at();
}

void PlyDocument::readRow(const PlyElement& element, PlyRow& row)
{
  row.resize(element.properties.size());
  for (std::size_t k = 0; k < row.size(); ++k)
  {
    const PlyProperty& property = element.properties[k];
    const double count = property.isList() ? this->number(property.count) : 1.0;
    if (!(count >= 0.0 && count <= static_cast<double>(this->Bytes.size() - this->At)))
    {
      this->refuseEnd();
    }
    row[k].resize(static_cast<std::size_t>(count));
    for (double& value : row[k])
    {
      value = this->number(property.type);
    }
  }
}

int PlyDocument::typeOf(std::string_view name) const
{
  const auto* const it = std::find_if(std::begin(plyTypes),
    std::end(plyTypes),
    [name](const PlyType& type) { return name == type.name || name == type.other; });
  if (it == std::end(plyTypes))
  {
    this->refuse("its PLY header names the unknown type " + inQuotes(name));
  }
  return it->type;
}

void PlyDocument::readElement(Words& words)
{
  PlyElement element;
  element.name = words.next();
  const double count = numberOf(words.next()).value_or(-1.0);
  if (!(count >= 0.0 && count <= static_cast<double>(this->Bytes.size())) || count != std::floor(count))
  {
    this->refuse("announces more elements than a file of its size can hold");
  }
  element.count = static_cast<std::size_t>(count);
  for (const PlyElement& other : this->Elements)
  {
    if (other.name == element.name)
    {
      this->refuse("its PLY header names the element " + inQuotes(element.name) + " twice");
    }
  }
  this->Elements.push_back(element);
}

} // namespace oversketch_files
