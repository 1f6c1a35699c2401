// The XML part of a .vtp or .vti file as it stands there: sections, their arrays with attributes and text.
#ifndef oversketch_applications_files_vtp_document_h
#define oversketch_applications_files_vtp_document_h

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace oversketch_files
{

class VtpDocument
{
public:
  using Attributes = std::map<std::string, std::string>;
  struct Array
  {
    Attributes attributes;
    std::string content; // between the tags

    // "" for one that is not there.
    const std::string& operator[](const std::string& attribute) const;
  };
  struct Section
  {
    Attributes attributes;
    std::vector<Array> arrays;
    std::set<std::string> names; // of the arrays
  };

  // The type is "PolyData" or "ImageData". The bytes must outlive this. Throws Failed where they are not of
  // that, hold two arrays of a name in a section, or more than one piece with points.
  VtpDocument(const std::string& path, const std::string& bytes, const std::string& type);

  [[noreturn]] void refuse(const std::string& why) const;

  // Attributes of the file, of the data set and of its piece.
  const std::string& root(const std::string& name) { return this->Root[name]; }
  const std::string& whole(const std::string& name) { return this->Whole[name]; }
  const std::string& piece(const std::string& name) { return this->Piece[name]; }
  // PointData, CellData, FieldData, Points, Verts, Lines, Strips or Polys.
  const Section& section(const std::string& name) { return this->Sections[name]; }
  // What follows the '_' of the appended data, and whether it is base64.
  std::string_view appended() const { return this->Appended; }
  bool appendedIsText() const { return this->AppendedIsText; }

private:
  class Parser;

  std::string Path, Type;
  Attributes Root, Whole, Piece;
  std::map<std::string, Section> Sections;
  bool AppendedIsText = false;
  std::string_view Appended;
};

} // namespace oversketch_files
#endif
