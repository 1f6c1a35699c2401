#include "vtp_document.h"

#include "files.h"

#include <expat.h>

#include <algorithm>
#include <memory>

namespace oversketch_files
{

namespace
{

// Where the parser is, as an editor counts. Expat 2.8 has wider counters and warns of the old ones.
std::string placeOf(XML_Parser parser)
{
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 8
  const auto line = XML_GetCurrentLineNumber64(parser), column = XML_GetCurrentColumnNumber64(parser);
#else
  const auto line = XML_GetCurrentLineNumber(parser), column = XML_GetCurrentColumnNumber(parser);
#endif
  return "line " + std::to_string(line) + ", column " + std::to_string(column + 1);
}

} // namespace

class VtpDocument::Parser
{
public:
  explicit Parser(VtpDocument& document)
    : Document(document)
    , Expat(XML_ParserCreate(nullptr), &XML_ParserFree)
  {
    XML_SetUserData(this->Expat.get(), this);
    XML_SetElementHandler(
      this->Expat.get(),
      [](void* self, const XML_Char* name, const XML_Char** values)
      { static_cast<Parser*>(self)->open(name, values); },
      [](void* self, const XML_Char* name) { static_cast<Parser*>(self)->close(name); });
    XML_SetCharacterDataHandler(this->Expat.get(),
      [](void* self, const XML_Char* text, int size)
      { static_cast<Parser*>(self)->take(text, static_cast<std::size_t>(size)); });
    XML_SetStartDoctypeDeclHandler(this->Expat.get(),
      [](void* self, const XML_Char*, const XML_Char*, const XML_Char*, int)
      { static_cast<Parser*>(self)->stop("has a document type, which no such file has"); });
  }

  void parse(std::string_view text, bool isLast)
  {
    constexpr std::size_t block = std::size_t(1) << 20; // the call counts in int
    for (std::size_t at = 0; at < text.size(); at += block)
    {
      const std::size_t size = std::min(block, text.size() - at);
      const bool ends = isLast && at + size == text.size();
      if (this->Problem.empty() &&
          XML_Parse(this->Expat.get(), text.data() + at, static_cast<int>(size), ends) != XML_STATUS_OK &&
          this->Problem.empty())
      {
        this->Problem = this->HasRoot ? "is no XML from " + placeOf(this->Expat.get()) +
                                          " on; the file is truncated or damaged"
                                      : this->anotherType();
      }
    }
    if (this->Problem.empty() && !this->HasRoot)
    {
      this->Problem = this->anotherType();
    }
    if (!this->Problem.empty())
    {
      this->Document.refuse(this->Problem);
    }
  }

private:
  std::string anotherType() const
  {
    const std::string& type = this->Document.Type;
    return "is not an XML " + type + " file (" + (type == "PolyData" ? ".vtp" : ".vti") + ")";
  }

  void stop(const std::string& why)
  {
    this->Problem = this->Problem.empty() ? why : this->Problem;
    XML_StopParser(this->Expat.get(), XML_FALSE);
  }

  void open(const std::string& name, const XML_Char** values)
  {
    Attributes attributes;
    for (; *values; values += 2)
    {
      attributes[values[0]] = values[1];
    }
    if (this->InArray > 0) // what is known of the array, such as its range
    {
      ++this->InArray;
    }
    else if (!this->HasRoot)
    {
      this->HasRoot = true;
      this->Document.Root = attributes;
      if (name != "VTKFile" || attributes["type"] != this->Document.Type)
      {
        this->stop(this->anotherType());
      }
    }
    else if (name == this->Document.Type)
    {
      this->Document.Whole = attributes;
    }
    else if (name == "Piece")
    {
      this->openPiece(attributes);
    }
    else if (name == "FieldData" || (this->IsPiece && isOfPiece(name)))
    {
      this->Current = &this->Document.Sections[name];
      this->CurrentName = name;
      this->Current->attributes = attributes;
    }
    else if (this->Current && (name == "DataArray" || name == "Array"))
    {
      std::string& own = attributes["Name"];
      own = plainName(own);
      if (!own.empty() && !this->Current->names.insert(own).second)
      {
        this->stop("its " + this->CurrentName + " holds two arrays " + own + "; the file is damaged");
      }
      this->Current->arrays.push_back({ attributes, {} });
      this->InArray = 1;
    }
  }

  void openPiece(Attributes& attributes)
  {
    const char* const size = this->Document.Type == "PolyData" ? "NumberOfPoints" : "Extent";
    const auto isEmpty = [size](Attributes& piece) { return piece[size].empty() || piece[size] == "0"; };
    this->IsPiece = !isEmpty(attributes) || this->Document.Piece.empty();
    if (!isEmpty(attributes) && !isEmpty(this->Document.Piece))
    {
      this->stop("holds several pieces; save it as one");
    }
    if (this->IsPiece)
    {
      this->Document.Piece = attributes;
      auto& sections = this->Document.Sections;
      for (auto it = sections.begin(); it != sections.end();)
      {
        it = isOfPiece(it->first) ? sections.erase(it) : std::next(it);
      }
    }
  }

  void close(const std::string& name)
  {
    if (this->InArray > 0)
    {
      --this->InArray;
    }
    else if (name == this->CurrentName)
    {
      this->Current = nullptr;
    }
  }

  void take(const XML_Char* text, std::size_t size)
  {
    if (this->InArray == 1)
    {
      this->Current->arrays.back().content.append(text, size);
    }
  }

  static bool isOfPiece(const std::string& name)
  {
    static const std::set<std::string> all = {
      "PointData", "CellData", "Points", "Verts", "Lines", "Strips", "Polys"
    };
    return all.count(name) == 1;
  }

  VtpDocument& Document;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> Expat;
  std::string Problem, CurrentName;
  Section* Current = nullptr;
  int InArray = 0; // elements deep, from the array on
  bool HasRoot = false, IsPiece = false;
};

const std::string& VtpDocument::Array::operator[](const std::string& attribute) const
{
  static const std::string none;
  const auto it = this->attributes.find(attribute);
  return it == this->attributes.end() ? none : it->second;
}

VtpDocument::VtpDocument(const std::string& path, const std::string& bytes, const std::string& type)
  : Path(path)
  , Type(type)
{
  // Raw data is no XML, so what stands before it is closed by hand.
  const std::size_t cut = std::min(bytes.find("<AppendedData"), bytes.size());
  std::string_view tail;
  if (cut < bytes.size())
  {
    const std::size_t end = bytes.find('>', cut), begin = bytes.find('_', end);
    if (begin == std::string::npos)
    {
      this->refuse("its appended data is not there; the file is truncated");
    }
    this->AppendedIsText =
      std::string_view(bytes).substr(cut, end - cut).find("base64") != std::string_view::npos;
    this->Appended = std::string_view(bytes).substr(begin + 1);
    tail = "</VTKFile>";
  }
  Parser parser(*this);
  parser.parse(std::string_view(bytes).substr(0, cut), tail.empty());
  if (!tail.empty())
  {
    parser.parse(tail, true);
  }
}

void VtpDocument::refuse(const std::string& why) const
{
  throw Failed(this->Path + ": " + why);
}

} // namespace oversketch_files
