#include "gltf_document.h"

#include "number_file.h"

#include <cstdlib>
#include <memory>

namespace fs = std::filesystem;

namespace oversketch_files
{

namespace
{

// "%20" to " ".
std::string unescaped(const std::string& uri)
{
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i)
  {
    if (uri[i] == '%' && i + 2 < uri.size())
    {
      text += static_cast<char>(std::strtol(uri.substr(i + 1, 2).c_str(), nullptr, 16));
      i += 2;
    }
    else
    {
      text += uri[i];
    }
  }
  return text;
}

// VTK's type of a component, VTK_VOID for an unknown one.
int gltfTypeOf(const Json::Value& component)
{
  constexpr int first = 5120, types[] = {
    VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_VOID, VTK_UNSIGNED_INT, VTK_FLOAT
  };
  const int at = component.isInt() ? component.asInt() - first : -1;
  return at >= 0 && at < static_cast<int>(std::size(types)) ? types[at] : VTK_VOID;
}

} // namespace

GltfDocument::GltfDocument(const std::string& path)
  : Path(path)
  , Folder(fs::absolute(path).parent_path())
{
  std::string text = wholeFile(path);
  this->Size = text.size();
  if (text.compare(0, 4, "glTF") == 0)
  {
    const std::string all = std::move(text);
    const std::size_t length = wholeAt(all, 12, 4, false), next = 20 + length;
    text = all.substr(std::min<std::size_t>(20, all.size()), length);
    if (next + 8 <= all.size())
    {
      this->Binary = all.substr(next + 8, wholeAt(all, next, 4, false));
    }
  }
  std::string why;
  bool parsed = false;
  try
  {
    const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder().newCharReader());
    parsed = reader->parse(text.data(), text.data() + text.size(), &this->Root, &why);
  }
  catch (const Json::Exception&) // nested too deep
  {
  }
  if (!parsed || !this->Root.isObject())
  {
    this->refuse("is not glTF");
  }
}

void GltfDocument::refuse(const std::string& why) const
{
  throw Failed(this->Path + ": " + why);
}

void GltfDocument::refuseCompressed(const Json::Value& object) const
{
  for (const std::string& name :
    object["extensions"].isObject() ? object["extensions"].getMemberNames() : Json::Value::Members())
  {
    if (name.find("compression") != std::string::npos)
    {
      this->refuse("is compressed by the glTF extension " + printable(name.substr(0, 60)) +
                   ", which is not read; save the file uncompressed");
    }
  }
}

void GltfDocument::spend(std::size_t numbers)
{
  this->Spent += numbers;
  if (this->Spent > 16 * this->Size + 1000000)
  {
    this->refuse("asks for more numbers than a file of its size should; the file is damaged");
  }
}

const Json::Value& GltfDocument::find(const std::string& list, const Json::Value& index) const
{
  const Json::Value& all = this->Root[list];
  return all.isArray() && index.isUInt() && index.asUInt() < all.size() ? all[index.asUInt()]
                                                                        : Json::Value::nullSingleton();
}

const Json::Value& GltfDocument::at(const std::string& list, const Json::Value& index) const
{
  const Json::Value& found = this->find(list, index);
  if (!found.isObject())
  {
    this->refuse("names " + (index.isUInt() ? std::to_string(index.asUInt()) : "no number") + " of its " +
                 list + ", which is not there; the file is damaged");
  }
  return found;
}

std::size_t GltfDocument::whole(const Json::Value& object, const char* member, const std::string& where) const
{
  const Json::Value& value = object[member];
  if (!value.isUInt64())
  {
    this->refuse(where + ": " + member + " is no whole number; the file is damaged");
  }
  return value.asUInt64();
}

const std::string& GltfDocument::buffer(const Json::Value& index)
{
  const Json::Value& buffer = this->at("buffers", index);
  const auto [it, isNew] = this->Buffers.emplace(index.asUInt(), std::string());
  if (isNew)
  {
    it->second = buffer["uri"].isString() ? this->resolved(buffer["uri"].asString())
                 : index.asUInt() == 0    ? this->Binary
                                          : std::string(); // of what stands in for compressed numbers
    this->Size += buffer["uri"].isString() ? it->second.size() : 0;
  }
  return it->second;
}

std::string GltfDocument::resolved(const std::string& uri) const
{
  if (uri.rfind("data:", 0) != 0)
  {
    return wholeFile((this->Folder / unescaped(uri)).string());
  }
  const std::size_t comma = uri.find(',');
  if (comma == std::string::npos)
  {
    return {};
  }
  return bytesOfBase64(std::string_view(uri).substr(comma + 1), uri.size());
}

const char* GltfDocument::viewed(const Json::Value& index,
  std::size_t offset,
  std::size_t length,
  const std::string& where)
{
  const Json::Value& view = this->at("bufferViews", index);
  const std::string name = "its bufferViews " + std::to_string(index.asUInt());
  const std::string& bytes = this->buffer(view["buffer"]);
  const std::size_t from = view.isMember("byteOffset") ? this->whole(view, "byteOffset", name) : 0;
  const std::size_t size = this->whole(view, "byteLength", name);
  if (from > bytes.size() || size > bytes.size() - from)
  {
    this->refuseCompressed(view);
    this->refuse(name + " reaches beyond the " + std::to_string(bytes.size()) +
                 " bytes of its buffer; the file or its buffer is absent, truncated or damaged");
  }
  if (offset > size || length > size - offset)
  {
    this->refuse(where + " reaches beyond its buffer view; the file is damaged");
  }
  return bytes.data() + from + offset;
}

void GltfDocument::readInto(const Json::Value& description,
  int type,
  bool isNormalized,
  std::size_t components,
  std::size_t count,
  const std::string& where,
  std::vector<double>& values)
{
  const auto size = static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(type)), bytes = size * components;
  const double largest = isNormalized && type != VTK_FLOAT ? vtkDataArray::GetDataTypeMax(type) : 0.0;
  const Json::Value& view = this->at("bufferViews", description["bufferView"]);
  const std::size_t stride = view.isMember("byteStride") ? this->whole(view, "byteStride", where) : bytes;
  const std::size_t offset =
    description.isMember("byteOffset") ? this->whole(description, "byteOffset", where) : 0;
  if (stride < bytes || stride > 255 + bytes)
  {
    this->refuse(where + ": byteStride does not fit its type; the file is damaged");
  }
  if (count == 0)
  {
    return;
  }
  const char* const first =
    this->viewed(description["bufferView"], offset, (count - 1) * stride + bytes, where);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t k = 0; k < components; ++k)
    {
      const double number = numberAt(first + i * stride + k * size, type);
      values[i * components + k] = largest > 0.0 ? std::max(number / largest, -1.0) : number;
    }
  }
}

GltfNumbers GltfDocument::numbers(const Json::Value& index)
{
  static const std::map<std::string, std::size_t> types = {
    { "SCALAR", 1 }, { "VEC2", 2 }, { "VEC3", 3 }, { "VEC4", 4 }, { "MAT2", 4 }, { "MAT3", 9 }, { "MAT4", 16 }
  };
  const Json::Value& accessor = this->at("accessors", index);
  const std::string where = "its accessors " + std::to_string(index.asUInt());
  const auto form = types.find(accessor["type"].isString() ? accessor["type"].asString() : "");
  const int type = gltfTypeOf(accessor["componentType"]);
  if (form == types.end() || type == VTK_VOID)
  {
    this->refuse(where + ": type or componentType is unknown; the file is damaged");
  }
  GltfNumbers numbers;
  numbers.components = form->second;
  numbers.count = this->whole(accessor, "count", where);
  const bool hasView = accessor.isMember("bufferView");
  if (hasView)
  {
    this->buffer(this->at("bufferViews", accessor["bufferView"])["buffer"]); // counts for the size
  }
  if (numbers.count > this->Size)
  {
    this->refuse(where + ": announces " + std::to_string(numbers.count) +
                 " elements, more than a file of its size can hold");
  }
  this->spend(numbers.count * numbers.components);
  const bool isNormalized = accessor["normalized"].isBool() && accessor["normalized"].asBool();
  numbers.values.resize(numbers.count * numbers.components);
  if (hasView)
  {
    this->readInto(accessor, type, isNormalized, numbers.components, numbers.count, where, numbers.values);
  }
  const Json::Value& sparse = accessor["sparse"];
  if (sparse.isObject())
  {
    const std::size_t count = this->whole(sparse, "count", where);
    const int indexType = gltfTypeOf(sparse["indices"]["componentType"]);
    if (count > numbers.count || indexType == VTK_VOID)
    {
      this->refuse(where + ": its sparse part does not fit; the file is damaged");
    }
    std::vector<double> places(count), values(count * numbers.components);
    this->readInto(sparse["indices"], indexType, false, 1, count, where, places);
    this->readInto(sparse["values"], type, isNormalized, numbers.components, count, where, values);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!(places[i] >= 0.0 && places[i] < static_cast<double>(numbers.count)))
      {
        this->refuse(where + ": its sparse part names an element that is not there; the file is damaged");
      }
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * numbers.components),
        numbers.components,
        numbers.values.begin() +
          static_cast<std::ptrdiff_t>(static_cast<std::size_t>(places[i]) * numbers.components));
    }
  }
  else if (!hasView)
  {
    this->refuse(where + " has no numbers (no bufferView); it may be compressed: save the file uncompressed");
  }
  return numbers;
}

std::string GltfDocument::picture(const Json::Value& index)
{
  const Json::Value& image = this->find("images", index);
  if (image["uri"].isString())
  {
    return this->resolved(image["uri"].asString());
  }
  const Json::Value& view = this->find("bufferViews", image["bufferView"]);
  if (!view.isObject() || !view["byteLength"].isUInt64())
  {
    return {};
  }
  const std::size_t length = view["byteLength"].asUInt64();
  return { this->viewed(image["bufferView"], 0, length, "its images " + std::to_string(index.asUInt())),
    length };
}

} // namespace oversketch_files
