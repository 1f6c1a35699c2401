// XML PolyData (.vtp) and ImageData (.vti), of any encoding, compression and byte order. Why not VTK's own
// readers: they allocate what a file announces, trust offsets and the heads of compressed blocks, and crash
// on two arrays of a name.
#include "heights.h"
#include "mesh_file.h"
#include "text.h"
#include "vtp_document.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkLZ4DataCompressor.h"
#include "vtkLZMADataCompressor.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"
#include "vtkZLibDataCompressor.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>

namespace oversketch_files
{

namespace
{

// What all arrays of a file may take in memory, against its size: deflate makes a thousand bytes of one, but
// of no mesh.
constexpr std::size_t mostInflation = 200, leastRoom = std::size_t(1) << 24;

int typeOf(const VtpDocument::Array& array)
{
  static const std::map<std::string, int> types = { { "Int8", VTK_TYPE_INT8 },
    { "UInt8", VTK_TYPE_UINT8 },
    { "Int16", VTK_TYPE_INT16 },
    { "UInt16", VTK_TYPE_UINT16 },
    { "Int32", VTK_TYPE_INT32 },
    { "UInt32", VTK_TYPE_UINT32 },
    { "Int64", VTK_TYPE_INT64 },
    { "UInt64", VTK_TYPE_UINT64 },
    { "Float32", VTK_TYPE_FLOAT32 },
    { "Float64", VTK_TYPE_FLOAT64 },
    { "Bit", VTK_BIT },
    { "String", VTK_STRING } };
  const auto known = types.find(array["type"]);
  return known == types.end() ? -1 : known->second;
}

class Reader
{
public:
  Reader(const std::string& path, const std::string& bytes, const std::string& type)
    : Xml(path, bytes, type)
    , Room(std::max(leastRoom, mostInflation * bytes.size()))
    , Most(static_cast<double>(this->Room))
    , BigEndian(this->Xml.root("byte_order") == "BigEndian")
    , HeaderSize(this->Xml.root("header_type") == "UInt64" ? 8 : 4)
  {
    const std::string& name = this->Xml.root("compressor");
    if (name == "vtkZLibDataCompressor")
    {
      this->Compressor = vtkSmartPointer<vtkZLibDataCompressor>::New();
    }
    else if (name == "vtkLZ4DataCompressor")
    {
      this->Compressor = vtkSmartPointer<vtkLZ4DataCompressor>::New();
    }
    else if (name == "vtkLZMADataCompressor")
    {
      this->Compressor = vtkSmartPointer<vtkLZMADataCompressor>::New();
    }
    else if (!name.empty())
    {
      this->Xml.refuse("is compressed by " + inQuotes(name) + ", which is not known; save it uncompressed");
    }
  }

  vtkSmartPointer<vtkPolyData> read()
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    const vtkIdType count = this->countOf("NumberOfPoints");
    const VtpDocument::Section& section = this->Xml.section("Points");
    if (count > 0 && (section.arrays.empty() || typeOf(section.arrays[0]) == VTK_BIT ||
                       this->componentsOf(section.arrays[0], "Points") != 3))
    {
      this->Xml.refuse("its Points hold no array of three components; the file is damaged");
    }
    if (count > 0)
    {
      vtkNew<vtkPoints> points;
      points->SetData(this->numbers(section.arrays[0], "Points", count));
      mesh->SetPoints(points);
    }
    mesh->SetVerts(this->cells("Verts", count));
    mesh->SetLines(this->cells("Lines", count));
    mesh->SetPolys(this->cells("Polys", count));
    mesh->SetStrips(this->cells("Strips", count));
    this->addArrays("PointData", mesh->GetPointData(), count);
    this->addArrays("CellData", mesh->GetCellData(), mesh->GetNumberOfCells());
    this->addArrays("FieldData", mesh->GetFieldData(), -1);
    return mesh;
  }

  // One slice with its scalars, or its only array.
  vtkSmartPointer<vtkImageData> readImage()
  {
    const std::vector<double> extent = this->list(this->Xml.piece("Extent"), 6, "Extent");
    const std::vector<double> spacing = this->list(this->Xml.whole("Spacing"), 3, "Spacing");
    double count = 1.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double side = extent[2 * k + 1] - extent[2 * k] + 1.0;
      if (!(side >= 1.0 && side <= 16384.0) || !(spacing[k] > 0.0 && spacing[k] < 1e12))
      {
        this->Xml.refuse(
          "its Extent is of no samples or more than 16384 a side, or its Spacing is not positive");
      }
      count *= side;
    }
    if (extent[4] != extent[5])
    {
      this->Xml.refuse("holds several slices across z; give one");
    }
    if (!(count <= this->Most))
    {
      this->Xml.refuse("its Extent announces more samples than a file of its size can hold");
    }
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(
      static_cast<int>(extent[1] - extent[0] + 1.0), static_cast<int>(extent[3] - extent[2] + 1.0), 1);
    image->SetSpacing(spacing.data());
    const std::vector<double> origin = this->list(this->Xml.whole("Origin"), 3, "Origin");
    image->SetOrigin(origin[0] + extent[0] * spacing[0], origin[1] + extent[2] * spacing[1], 0.0);
    this->addArrays("PointData", image->GetPointData(), static_cast<vtkIdType>(count));
    vtkPointData* data = image->GetPointData();
    if (!data->GetScalars() && data->GetNumberOfArrays() == 1 && data->GetArray(0))
    {
      data->SetActiveScalars(data->GetArray(0)->GetName());
    }
    if (!data->GetScalars())
    {
      this->Xml.refuse("names none of its PointData as Scalars; save it with one array of heights");
    }
    return image;
  }

private:
  // So many numbers; where none are given, those that VTK takes.
  std::vector<double> list(const std::string& text, std::size_t size, const std::string& what)
  {
    std::vector<double> numbers;
    Words words(text);
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
    {
      numbers.push_back(numberOf(word).value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    if (numbers.empty() && what != "Extent")
    {
      numbers.assign(size, what == "Spacing" ? 1.0 : 0.0);
    }
    if (numbers.size() != size)
    {
      this->Xml.refuse("its " + what + " has not " + std::to_string(size) + " numbers; the file is damaged");
    }
    return numbers;
  }

  // A whole number; 0 where it is not given.
  vtkIdType wholeOf(const std::string& text, const std::string& what)
  {
    const double value = text.empty() ? 0.0 : numberOf(text).value_or(-1.0);
    if (!(value >= 0.0 && value <= this->Most))
    {
      this->Xml.refuse(what + " announces " + text.substr(0, 24) + ", more than a file of its size can hold");
    }
    return static_cast<vtkIdType>(value);
  }

  vtkIdType countOf(const std::string& name) { return this->wholeOf(this->Xml.piece(name), "its " + name); }

  vtkIdType componentsOf(const VtpDocument::Array& array, const std::string& where)
  {
    const vtkIdType given =
      this->wholeOf(array["NumberOfComponents"], "NumberOfComponents of its " + where + ' ' + array["Name"]);
    return std::clamp<vtkIdType>(given, 1, std::numeric_limits<int>::max());
  }

  // Takes so much of what the file may ask for.
  void spend(double bytes, const std::string& what)
  {
    if (!(bytes <= static_cast<double>(this->Room)))
    {
      this->Xml.refuse(what + " announces more than a file of its size can hold");
    }
    this->Room -= static_cast<std::size_t>(bytes);
  }

  std::uint64_t word(const std::string& bytes, std::size_t at) const
  {
    return wholeAt(bytes, at, this->HeaderSize, this->BigEndian);
  }

  // The text or the bytes that hold an array of a binary encoding.
  std::pair<std::string_view, bool> sourceOf(const VtpDocument::Array& array, const std::string& what)
  {
    if (array["format"] != "appended")
    {
      return { array.content, true };
    }
    const std::string_view all = this->Xml.appended();
    const std::optional<double> offset = numberOf(array["offset"]);
    if (!offset || !(*offset >= 0.0 && *offset <= static_cast<double>(all.size())))
    {
      this->Xml.refuse(what + " lies beyond the end of the file, which is truncated or damaged");
    }
    return { all.substr(static_cast<std::size_t>(*offset)), this->Xml.appendedIsText() };
  }

  // The first bytes of a source, which base64 may hide.
  static std::string taken(std::string_view source, bool isText, std::size_t size)
  {
    return isText ? bytesOfBase64(source, size) : std::string(source.substr(0, size));
  }

  // The bytes of an array as they stand there, uncompressed.
  std::string blob(const VtpDocument::Array& array, const std::string& what)
  {
    const auto [source, isText] = this->sourceOf(array, what);
    const auto broken = [&] { this->Xml.refuse(what + " breaks off; the file is truncated or damaged"); };
    if (!this->Compressor)
    {
      const std::string head = taken(source, isText, this->HeaderSize);
      const std::uint64_t size = head.size() == this->HeaderSize ? this->word(head, 0) : source.size() + 1;
      if (size > source.size())
      {
        broken();
      }
      const std::string decoded = isText ? bytesOfBase64(source, this->HeaderSize + size) : std::string();
      const std::string_view all = isText ? std::string_view(decoded) : source;
      if (size > all.size() - this->HeaderSize)
      {
        broken();
      }
      return std::string(all.substr(this->HeaderSize, size));
    }
    // Number of blocks, size of all but the last, of the last if it is shorter, then of each compressed.
    const std::string first = taken(source, isText, 3 * this->HeaderSize);
    if (first.size() < 3 * this->HeaderSize || this->word(first, 0) > source.size())
    {
      broken();
    }
    const std::uint64_t blocks = this->word(first, 0), full = this->word(first, this->HeaderSize),
                        last = this->word(first, 2 * this->HeaderSize);
    const std::size_t headSize = (3 + blocks) * this->HeaderSize;
    const std::string head = taken(source, isText, headSize);
    // Head and blocks are encoded each by themselves.
    const std::size_t encoded = isText ? (headSize + 2) / 3 * 4 : headSize;
    if (head.size() < headSize || encoded > source.size())
    {
      broken();
    }
    const double size =
      blocks == 0 ? 0.0
                  : (static_cast<double>(blocks) - (last > 0 ? 1.0 : 0.0)) * static_cast<double>(full) +
                      static_cast<double>(last);
    this->spend(size, what);
    std::string bytes(static_cast<std::size_t>(size), '\0');
    const std::string_view rest =
      isText ? trimmedFront(source).substr(std::min(encoded, trimmedFront(source).size()))
             : source.substr(encoded);
    const std::string packed = isText ? bytesOfBase64(rest, rest.size()) : std::string();
    const std::string_view data = isText ? std::string_view(packed) : rest;
    std::size_t from = 0, to = 0;
    for (std::uint64_t i = 0; i < blocks; ++i)
    {
      const std::uint64_t length = this->word(head, (3 + i) * this->HeaderSize);
      const std::uint64_t made = i + 1 == blocks && last > 0 ? last : full;
      if (length > data.size() - from ||
          this->Compressor->Uncompress(reinterpret_cast<const unsigned char*>(data.data()) + from,
            length,
            reinterpret_cast<unsigned char*>(bytes.data()) + to,
            made) != made)
      {
        broken();
      }
      from += length;
      to += made;
    }
    return bytes;
  }

  static std::string_view trimmedFront(std::string_view text)
  {
    return text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  }

  // An array of numbers of so many tuples.
  vtkSmartPointer<vtkDataArray> numbers(const VtpDocument::Array& array,
    const std::string& where,
    vtkIdType tuples)
  {
    const std::string what = "the array '" + array["Name"] + "' of its " + where;
    const int type = typeOf(array);
    const vtkIdType components = this->componentsOf(array, where);
    if (type < 0 || type == VTK_STRING)
    {
      this->Xml.refuse(what + " is of the type " + inQuotes(array["type"]) + ", which is not known there");
    }
    const auto values = static_cast<double>(tuples) * static_cast<double>(components);
    this->spend(values * (type == VTK_BIT ? 1.0 / 8.0 : vtkDataArray::GetDataTypeSize(type)), what);
    const bool isId = array["IdType"] == "1" && type == VTK_TYPE_INT64;
    auto made = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(isId ? VTK_ID_TYPE : type));
    made->SetNumberOfComponents(static_cast<int>(components));
    made->SetNumberOfTuples(tuples);
    if (made->GetNumberOfValues() == 0)
    {
      return made;
    }
    if (array["format"] == "ascii")
    {
      this->readText(array, what, made);
      return made;
    }
    std::string bytes = this->blob(array, what);
    const auto count = static_cast<std::size_t>(made->GetNumberOfValues());
    const auto size = static_cast<std::size_t>(made->GetDataTypeSize());
    if (bytes.size() != (type == VTK_BIT ? (count + 7) / 8 : count * size))
    {
      this->Xml.refuse(what + " has " + std::to_string(bytes.size()) + " bytes for " + std::to_string(count) +
                       " values; the file is damaged");
    }
    if (this->BigEndian && size > 1)
    {
      for (std::size_t i = 0; i < bytes.size(); i += size)
      {
        std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
          bytes.begin() + static_cast<std::ptrdiff_t>(i + size));
      }
    }
    std::memcpy(made->GetVoidPointer(0), bytes.data(), bytes.size());
    return made;
  }

  // A word that is known to be a number, whole as far as it goes.
  static vtkVariant longOf(std::string_view word)
  {
    if (word[0] == '-')
    {
      long long value = 0;
      std::from_chars(word.data(), word.data() + word.size(), value);
      return value;
    }
    unsigned long long value = 0;
    std::from_chars(word.data() + (word[0] == '+'), word.data() + word.size(), value);
    return value;
  }

  void readText(const VtpDocument::Array& array, const std::string& what, vtkDataArray* made)
  {
    Words words(array.content);
    const bool isFloating = made->GetDataType() == VTK_FLOAT || made->GetDataType() == VTK_DOUBLE;
    const bool isLong = !isFloating && made->GetDataTypeSize() == 8;
    const double least = made->GetDataTypeMin(), most = made->GetDataTypeMax();
    for (vtkIdType i = 0; i < made->GetNumberOfTuples(); ++i)
    {
      for (int k = 0; k < made->GetNumberOfComponents(); ++k)
      {
        const std::string_view word = words.next();
        const std::optional<double> value = numberOf(word);
        if (!value || (!isFloating && !(*value >= least && *value <= most)))
        {
          this->Xml.refuse(what + (word.empty() ? " breaks off" : " holds " + inQuotes(word)) + " at value " +
                           std::to_string(i * made->GetNumberOfComponents() + k) + "; the file is damaged");
        }
        if (isLong) // beyond what a double tells apart
        {
          made->SetVariantValue(i * made->GetNumberOfComponents() + k, longOf(word));
        }
        else
        {
          made->SetComponent(i, k, *value);
        }
      }
    }
    if (!words.next().empty())
    {
      this->Xml.refuse(what + " has more values than there should be; the file is damaged");
    }
  }

  // Texts, each ended by a zero.
  vtkSmartPointer<vtkStringArray> texts(const VtpDocument::Array& array, const std::string& where)
  {
    const std::string what = "the array '" + array["Name"] + "' of its " + where;
    std::string bytes;
    if (array["format"] == "ascii")
    {
      Words words(array.content);
      for (std::string_view word = words.next(); !word.empty(); word = words.next())
      {
        bytes += static_cast<char>(static_cast<int>(std::clamp(numberOf(word).value_or(0.0), 0.0, 255.0)));
      }
    }
    else
    {
      bytes = this->blob(array, what);
    }
    this->spend(static_cast<double>(bytes.size()) +
                  32.0 * static_cast<double>(std::count(bytes.begin(), bytes.end(), '\0')),
      what);
    auto made = vtkSmartPointer<vtkStringArray>::New();
    for (std::size_t at = 0; at < bytes.size();)
    {
      const std::size_t end = std::min(bytes.find('\0', at), bytes.size());
      made->InsertNextValue(bytes.substr(at, end - at));
      at = end + 1;
    }
    made->SetNumberOfComponents(
      static_cast<int>(std::min<vtkIdType>(this->componentsOf(array, where), 1024)));
    return made;
  }

  vtkSmartPointer<vtkCellArray> cells(const std::string& kind, vtkIdType points)
  {
    const vtkIdType count = this->countOf("NumberOf" + kind);
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    if (count == 0)
    {
      return cells;
    }
    const VtpDocument::Array *offsets = nullptr, *corners = nullptr;
    for (const VtpDocument::Array& array : this->Xml.section(kind).arrays)
    {
      offsets = array["Name"] == "offsets" ? &array : offsets;
      corners = array["Name"] == "connectivity" ? &array : corners;
    }
    if (!offsets || !corners)
    {
      this->Xml.refuse("its " + kind + " lack offsets or connectivity; the file is damaged");
    }
    const auto ends = this->numbers(*offsets, kind, count);
    vtkNew<vtkIdTypeArray> begins;
    begins->InsertNextValue(0);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double end = ends->GetComponent(i, 0);
      if (!(end >= static_cast<double>(begins->GetValue(i)) && end <= this->Most))
      {
        this->Xml.refuse(
          "offset " + std::to_string(i) + " of its " + kind + " does not fit; the file is damaged");
      }
      begins->InsertNextValue(static_cast<vtkIdType>(end));
    }
    const auto ids = this->numbers(*corners, kind, begins->GetValue(count));
    vtkNew<vtkIdTypeArray> names;
    names->SetNumberOfValues(ids->GetNumberOfTuples());
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      const double id = ids->GetComponent(i, 0);
      if (!(id >= 0.0 && id < static_cast<double>(points)))
      {
        const vtkIdType* const first = begins->GetPointer(0);
        const auto cell = std::upper_bound(first, first + count, i) - first - 1;
        this->Xml.refuse("cell " + std::to_string(cell) + " of its " + kind +
                         " names a point that does not exist; the file is damaged");
      }
      names->SetValue(i, static_cast<vtkIdType>(id));
    }
    cells->SetData(begins, names);
    return cells;
  }

  // With so many tuples each; where that is negative, as many as the array says.
  void addArrays(const std::string& kind, vtkFieldData* data, vtkIdType tuples)
  {
    const VtpDocument::Section& section = this->Xml.section(kind);
    for (const VtpDocument::Array& array : section.arrays)
    {
      vtkSmartPointer<vtkAbstractArray> made;
      if (typeOf(array) == VTK_STRING)
      {
        made = this->texts(array, kind);
      }
      else
      {
        const std::string given = array["NumberOfTuples"];
        made = this->numbers(array,
          kind,
          tuples >= 0 ? tuples : this->wholeOf(given, "NumberOfTuples of its " + kind + ' ' + array["Name"]));
      }
      made->SetName(array["Name"].empty() ? nullptr : array["Name"].c_str()); // plain already
      for (int k = 0; k < std::min(made->GetNumberOfComponents(), 1024); ++k)
      {
        const std::string name = array["ComponentName" + std::to_string(k)];
        if (!name.empty())
        {
          made->SetComponentName(k, plainName(name).c_str());
        }
      }
      data->AddArray(made);
    }
    static const char* const roles[] = {
      "Scalars", "Vectors", "Normals", "TCoords", "Tensors", "GlobalIds", "PedigreeIds"
    };
    auto* attributes = vtkDataSetAttributes::SafeDownCast(data);
    for (int role = 0; attributes && role < 7; ++role)
    {
      const auto named = section.attributes.find(roles[role]);
      if (named != section.attributes.end() && data->GetAbstractArray(plainName(named->second).c_str()))
      {
        attributes->SetActiveAttribute(plainName(named->second).c_str(), role);
      }
    }
  }

  VtpDocument Xml;
  std::size_t Room;
  double Most;
  bool BigEndian;
  std::size_t HeaderSize;
  vtkSmartPointer<vtkDataCompressor> Compressor;
};

} // namespace

vtkSmartPointer<vtkPolyData> readVtp(const std::string& path, const std::string& bytes)
{
  return Reader(path, bytes, "PolyData").read();
}

vtkSmartPointer<vtkImageData> readVti(const std::string& path, const std::string& bytes)
{
  return Reader(path, bytes, "ImageData").readImage();
}

} // namespace oversketch_files
