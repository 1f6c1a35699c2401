// 3MF, its core specification 1.3: what printers' programs read, in millimetres. Why not lib3mf: the
// interfaces of Debian 12's (1.8) and Debian 13's (2.x) are two, and LibArchive is linked anyway.
#include "mesh_file.h"
#include "zip_file.h"

#include "Mesh/weld.h"
#include "vtkOversketchFilterTools.h"

#include "vtkPoints.h"

#include <array>
#include <charconv>

namespace oversketch_files
{

namespace
{

const char* const contentTypes = R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
 <Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
 <Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
const char* const relationships = R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
 <Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";
const char* const modelHead = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
 <metadata name="Application">Oversketch</metadata>
 <resources>
)";

// The shortest that reads back as the same number.
template <typename Number>
void append(std::string& text, const char* name, Number number)
{
  std::array<char, 32> digits;
  char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text.append(" ").append(name).append("=\"").append(digits.data(), end).append("\"");
}

// Points with equal places are one: edges are told by the numbers of vertices.
void appendObject(std::string& text, vtkPolyData* mesh, int id)
{
  const oversketch::Mesh given = oversketch::MeshOf(mesh);
  const std::vector<int> vertices = oversketch::weldPoints(given.points);
  const oversketch::Mesh welded = vertices.empty() ? given : oversketch::weldedMesh(given, vertices);
  const bool isSingle = mesh->GetPoints()->GetDataType() == VTK_FLOAT;
  text += "  <object";
  append(text, "id", id);
  text += " type=\"model\">\n   <mesh>\n    <vertices>\n";
  constexpr std::array<const char*, 3> axes = { "x", "y", "z" }, corners = { "v1", "v2", "v3" };
  for (const oversketch::Vector3& p : welded.points)
  {
    text += "     <vertex";
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double x = p[static_cast<int>(k)];
      isSingle ? append(text, axes[k], static_cast<float>(x)) : append(text, axes[k], x);
    }
    text += "/>\n";
  }
  text += "    </vertices>\n    <triangles>\n";
  for (const oversketch::Triangle& t : welded.triangles)
  {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
      continue; // forbidden
    }
    text += "     <triangle";
    for (std::size_t k = 0; k < 3; ++k)
    {
      append(text, corners[k], t[k]);
    }
    text += "/>\n";
  }
  text += "    </triangles>\n   </mesh>\n  </object>\n";
}

} // namespace

void write3mf(vtkPolyData* mesh, const std::string& path)
{
  std::string model = modelHead, items;
  const std::vector<int> parts = partsOf(mesh);
  const int count = std::max<int>(1, static_cast<int>(parts.size()));
  for (int i = 0; i < count; ++i)
  {
    vtkSmartPointer<vtkPolyData> object = mesh;
    if (parts.size() > 1)
    {
      object = partAlone(mesh, parts[static_cast<std::size_t>(i)]);
    }
    appendObject(model, object, i + 1);
    items += "  <item";
    append(items, "objectid", i + 1);
    items += "/>\n";
  }
  model += " </resources>\n <build>\n" + items + " </build>\n</model>\n";
  fillZip(path,
    { { "[Content_Types].xml", std::make_shared<const std::string>(contentTypes) },
      { "_rels/.rels", std::make_shared<const std::string>(relationships) },
      { "3D/3dmodel.model", std::make_shared<const std::string>(std::move(model)) } },
    Packing::Deflated);
}

} // namespace oversketch_files
