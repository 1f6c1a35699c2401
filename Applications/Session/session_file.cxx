#include "session_file.h"

#include "files.h"
#include "mesh_file.h"

#include "OpenCL/device.h"
#include "vtkOversketchOneStroke.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtksys/MD5.h"

#include "vtk_jsoncpp.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

namespace oversketch_session
{

using oversketch_files::Failed;

const char* const sessionEntry = "session.json";

namespace
{

constexpr const char* formatName = "oversketch-session";
constexpr int formatVersion = 1;
const char* const backendNames[] = { "auto", "opencl", "embree" };
const char* const remeshNames[] = { "auto", "on", "off" };

// MD5, in hexadecimal.
class Digest
{
public:
  Digest()
    : State(vtksysMD5_New())
  {
    vtksysMD5_Initialize(this->State);
  }
  ~Digest() { vtksysMD5_Delete(this->State); }
  Digest(const Digest&) = delete;
  Digest& operator=(const Digest&) = delete;

  void add(const void* bytes, std::size_t size)
  {
    const auto* at = static_cast<const unsigned char*>(bytes);
    constexpr std::size_t most = std::size_t(1) << 30; // the call counts in int
    for (; size > most; at += most, size -= most)
    {
      vtksysMD5_Append(this->State, at, static_cast<int>(most));
    }
    vtksysMD5_Append(this->State, at, static_cast<int>(size));
  }
  std::string text()
  {
    char hex[32];
    vtksysMD5_FinalizeHex(this->State, hex);
    return { hex, 32 };
  }

private:
  vtksysMD5* State;
};

std::string digestOf(const std::string& bytes)
{
  Digest digest;
  digest.add(bytes.data(), bytes.size());
  return digest.text();
}

std::string processorName()
{
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
  {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos)
    {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

Json::Value pointOf(const Point& p)
{
  Json::Value value(Json::arrayValue);
  for (const double x : p)
  {
    value.append(x);
  }
  return value;
}

// Reads members of a JSON object, and says which is wrong.
class Reader
{
public:
  Reader(const Json::Value& object, std::string where)
    : Object(object)
    , Where(std::move(where))
  {
    if (!object.isObject())
    {
      throw Failed(this->Where + " is no object; the session is damaged");
    }
  }
  bool has(const char* name) const { return this->Object.isMember(name) && !this->Object[name].isNull(); }
  const Json::Value& get(const char* name) const
  {
    if (!this->has(name))
    {
      throw Failed(this->Where + " lacks '" + name + "'; the session is damaged");
    }
    return this->Object[name];
  }
  std::string text(const char* name) const
  {
    const Json::Value& value = this->get(name);
    this->require(value.isString(), name, "a string");
    return value.asString();
  }
  bool yes(const char* name) const
  {
    const Json::Value& value = this->get(name);
    this->require(value.isBool(), name, "true or false");
    return value.asBool();
  }
  double number(const char* name) const
  {
    const Json::Value& value = this->get(name);
    this->require(value.isNumeric() && std::isfinite(value.asDouble()), name, "a number");
    return value.asDouble();
  }
  int integer(const char* name, int most) const
  {
    const Json::Value& value = this->get(name);
    this->require(
      value.isInt() && value.asInt() >= 0 && value.asInt() <= most, name, "a number in its range");
    return value.asInt();
  }
  template <std::size_t N>
  int choice(const char* name, const char* const (&choices)[N]) const
  {
    const std::string chosen = this->text(name);
    for (std::size_t i = 0; i < N; ++i)
    {
      if (chosen == choices[i])
      {
        return static_cast<int>(i);
      }
    }
    throw Failed(this->Where + ": '" + name + "' is '" + chosen + "', which this version does not know");
  }
  Point point(const char* name) const
  {
    const Json::Value& value = this->get(name);
    this->require(value.isArray() && value.size() == 3, name, "three numbers");
    Point p{};
    for (Json::ArrayIndex i = 0; i < 3; ++i)
    {
      this->require(value[i].isNumeric() && std::isfinite(value[i].asDouble()), name, "three numbers");
      p[i] = value[i].asDouble();
    }
    return p;
  }
  const std::string& where() const { return this->Where; }

private:
  void require(bool good, const char* name, const char* what) const
  {
    if (!good)
    {
      throw Failed(this->Where + ": '" + name + "' is not " + what + "; the session is damaged");
    }
  }

  const Json::Value& Object;
  std::string Where;
};

// The bytes of an entry whose name tells its digest.
const std::string& entryOf(const Package& package, const std::string& name, const std::string& path)
{
  const auto it = package.find(name);
  if (it == package.end())
  {
    throw Failed(path + ": lacks its entry " + name + "; the session is damaged");
  }
  return *it->second;
}

Json::Value jsonOf(const Node& node, const std::string& entry)
{
  Json::Value json;
  const Parameters& parameters = node.action->parameters;
  json["name"] = node.name;
  json["on"] = node.on;
  json["stroke"] = entry;
  json["remesh"] = remeshNames[parameters.remesh];
  json["adjust_normals"] = parameters.adjustNormals;
  json["as_published"] = parameters.asPublished;
  if (node.action->mirror)
  {
    json["mirror"]["axis"] = node.action->mirror->axis;
    json["mirror"]["offset"] = node.action->mirror->offset;
  }
  if (node.committed)
  {
    json["section"]["middle"] = pointOf(node.committed->middle);
    json["section"]["length"] = node.committed->length;
  }
  return json;
}

Node nodeOf(const Reader& json, const Package& package, const std::string& path)
{
  auto action = std::make_shared<Action>();
  const std::string entry = json.text("stroke");
  action->stroke = oversketch_files::parseStroke(path + ": " + entry, entryOf(package, entry, path));
  action->parameters.remesh = json.choice("remesh", remeshNames);
  action->parameters.adjustNormals = json.yes("adjust_normals");
  action->parameters.asPublished = json.yes("as_published");
  if (json.has("mirror"))
  {
    const Reader mirror(json.get("mirror"), json.where() + ", mirror");
    action->mirror = MirrorPlane{ mirror.integer("axis", 2), mirror.number("offset") };
  }
  Node node;
  node.name = json.text("name");
  node.on = json.yes("on");
  if (json.has("section"))
  {
    const Reader section(json.get("section"), json.where() + ", section");
    node.committed = Section{ section.point("middle"), section.number("length") };
  }
  node.action = action;
  return node;
}

} // namespace

Origin originHere(int backendUsed)
{
  Origin origin;
  origin.version = OVERSKETCH_VERSION;
  origin.processor = processorName();
  origin.backend = backendNames[backendUsed];
  if (backendUsed == vtkOversketchOneStroke::OpenCL)
  {
    if (const auto device = oversketch::Device::instance())
    {
      origin.device = device->info().platform + ", " + device->info().device + ", " + device->info().version;
    }
  }
  return origin;
}

std::vector<std::string> differences(const Origin& recorded, const Origin& here)
{
  std::vector<std::string> lines;
  const auto compare = [&](const char* what, const std::string& was, const std::string& is)
  {
    if (was != is)
    {
      lines.push_back(std::string(what) + " was " + (was.empty() ? "none" : was) + ", here it is " +
                      (is.empty() ? "none" : is));
    }
  };
  compare("the version", recorded.version, here.version);
  compare("the back end", recorded.backend, here.backend);
  compare("the device", recorded.device, here.device);
  compare("the processor", recorded.processor, here.processor);
  return lines;
}

std::string digestOf(vtkPolyData* mesh)
{
  Digest digest;
  if (mesh->GetPoints())
  {
    vtkDataArray* points = mesh->GetPoints()->GetData();
    const int type = points->GetDataType();
    digest.add(&type, sizeof type);
    digest.add(points->GetVoidPointer(0),
      static_cast<std::size_t>(points->GetNumberOfValues() * points->GetDataTypeSize()));
  }
  std::vector<long long> polygons;
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    polygons.push_back(size);
    polygons.insert(polygons.end(), ids, ids + size);
  }
  digest.add(polygons.data(), polygons.size() * sizeof(long long));
  return digest.text();
}

Package Encoder::encode(const SessionFile& file)
{
  const Session& session = file.session;
  Package package;
  std::map<SharedData, Entry> entries;
  const auto put = [&](const std::string& folder, const SharedData& data)
  {
    const auto known = this->last_.find(data);
    Entry entry;
    if (known != this->last_.end())
    {
      entry = known->second;
    }
    else
    {
      vtkNew<vtkPolyData> copy; // a writer keeps ranges in the arrays
      copy->DeepCopy(data);
      entry.bytes = std::make_shared<std::string>(oversketch_files::bytesOf(copy));
      entry.name = folder + "/" + digestOf(*entry.bytes) + ".vtp";
    }
    package[entry.name] = entry.bytes;
    entries[data] = entry;
    return entry.name;
  };
  Json::Value json;
  json["format"] = formatName;
  json["format_version"] = formatVersion;
  json["mesh"] = put("mesh", session.mesh);
  json["mesh_name"] = session.meshName;
  json["backend"] = backendNames[session.backend];
  json["strokes"] = Json::arrayValue;
  for (const Node& node : session.nodes)
  {
    json["strokes"].append(jsonOf(node, put("strokes", node.action->stroke)));
  }
  json["made_by"]["version"] = file.origin.version;
  json["made_by"]["backend"] = file.origin.backend;
  json["made_by"]["device"] = file.origin.device;
  json["made_by"]["processor"] = file.origin.processor;
  json["result_md5"] = file.digest;
  Json::StreamWriterBuilder writer;
  writer["indentation"] = "  ";
  package[sessionEntry] = std::make_shared<std::string>(Json::writeString(writer, json) + "\n");
  this->last_ = std::move(entries);
  return package;
}

SessionFile decode(const Package& package, const std::string& path)
{
  if (package.count(sessionEntry) == 0)
  {
    throw Failed(path + ": holds no " + sessionEntry + "; it is no session");
  }
  Json::Value root;
  Json::CharReaderBuilder builder;
  Json::CharReaderBuilder::strictMode(&builder.settings_);
  std::string errors;
  std::istringstream stream(*package.at(sessionEntry));
  bool parsed = false;
  try
  {
    parsed = Json::parseFromStream(builder, stream, &root, &errors);
  }
  catch (const Json::Exception& error)
  {
    errors = error.what();
  }
  if (!parsed)
  {
    throw Failed(path + ": its " + sessionEntry + " is damaged: " + errors.substr(0, errors.find('\n')));
  }
  const Reader json(root, path + ": " + sessionEntry);
  if (json.text("format") != formatName)
  {
    throw Failed(path + ": is no session");
  }
  const int version = json.integer("format_version", std::numeric_limits<int>::max());
  if (version != formatVersion)
  {
    throw Failed(path + ": is a session of format version " + std::to_string(version) +
                 ", and this program reads version " + std::to_string(formatVersion) +
                 "; open it with the version of Oversketch that wrote it");
  }
  SessionFile file;
  Session& session = file.session;
  const std::string mesh = json.text("mesh");
  session.mesh = oversketch_files::parseMesh(path + ": " + mesh, entryOf(package, mesh, path));
  session.meshName = json.text("mesh_name");
  session.backend = json.choice("backend", backendNames);
  const Json::Value& strokes = json.get("strokes");
  if (!strokes.isArray())
  {
    throw Failed(json.where() + ": 'strokes' is not a list; the session is damaged");
  }
  for (Json::ArrayIndex i = 0; i < strokes.size(); ++i)
  {
    session.nodes.push_back(
      nodeOf(Reader(strokes[i], json.where() + ", stroke " + std::to_string(i + 1)), package, path));
  }
  const Reader origin(json.get("made_by"), json.where() + ", made_by");
  file.origin = {
    origin.text("version"), origin.text("backend"), origin.text("device"), origin.text("processor")
  };
  file.digest = json.text("result_md5");
  return file;
}

SessionFile readSession(const std::string& path)
{
  return decode(readPackage(path), path);
}

void writeSession(const std::string& path, const SessionFile& file)
{
  writeZip(path, Encoder().encode(file));
}

} // namespace oversketch_session
