#include "session_file.h"

#include "files.h"
#include "heights.h"
#include "mesh_file.h"
#include "models.h"
#include "node_json.h"
#include "texture.h"

#include "OpenCL/device.h"
#include "vtkOversketchSystem.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtksys/MD5.h"

#include "vtk_jsoncpp.h"

#include <fstream>
#include <limits>
#include <set>

namespace oversketch_session
{

using oversketch_files::Failed;

const char* const sessionEntry = "session.json";

namespace
{

constexpr const char* formatName = "oversketch-session";
constexpr int newestVersion = 2;
constexpr std::size_t mostSteps = 10000;                   // of a model
constexpr std::size_t longestText = std::size_t(64) << 20; // of session.json [bytes]

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

} // namespace

Origin originHere(int backendUsed)
{
  Origin origin;
  origin.version = OVERSKETCH_VERSION;
  origin.processor = processorName();
  origin.backend = backendWords()[static_cast<std::size_t>(backendUsed)];
  if (backendUsed == vtkOversketchSystem::OpenCL)
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
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    const vtkIdType size = ids->GetNumberOfIds();
    digest.add(&size, sizeof size);
    digest.add(ids->begin(), static_cast<std::size_t>(size) * sizeof size);
  }
  return digest.text();
}

Package Encoder::encode(const SessionFile& file)
{
  const Session& session = file.session;
  for (std::size_t place = 0; place < modelCount(session); ++place)
  {
    const std::size_t count = modelAt(session, place).nodes.size();
    if (count > mostSteps)
    {
      throw Failed("a session has at most " + std::to_string(mostSteps) + " steps; this one has " +
                   std::to_string(count));
    }
  }
  if (modelCount(session) > mostModels)
  {
    throw Failed("a session has at most " + std::to_string(mostModels) + " models; this one has " +
                 std::to_string(modelCount(session)));
  }
  Package package;
  Entries entries;
  const auto put = [&](const std::shared_ptr<const void>& identity, const auto& make)
  {
    const auto known = this->Last.find(identity);
    const Entry entry = known == this->Last.end() ? make() : known->second;
    package[entry.name] = entry.bytes;
    entries[identity] = entry;
    return entry.name;
  };
  const auto polydata = [](const std::string& folder, vtkPolyData* own)
  {
    Entry entry;
    entry.bytes = std::make_shared<std::string>(oversketch_files::bytesOf(own));
    entry.name = folder + "/" + digestOf(*entry.bytes) + ".vtp";
    return entry;
  };
  EntryWriter writer;
  writer.lines = [&](const Lines& lines)
  { return put(lines.identity(), [&] { return polydata("strokes", lines.own()); }); };
  writer.image = [&](const Image& image)
  {
    return put(image.bytes,
      [&]
      {
        const std::string picture = oversketch_files::pictureFormatOf(*image.bytes);
        const std::string format =
          picture.empty() ? oversketch_files::heightsFormatOf(*image.bytes) : picture;
        return Entry{ "images/" + digestOf(*image.bytes) + "." + format, image.bytes };
      });
  };
  const bool isFirst = isVersion1(session, systems());
  // Members that every model has.
  const auto jsonOfModel = [&](const Model& model, const Record& record)
  {
    Json::Value json;
    if (const SharedData& mesh = model.whole ? model.whole : model.mesh)
    {
      json["mesh"] = put(mesh.identity(),
        [&]
        {
          vtkNew<vtkPolyData> copy; // a writer keeps ranges in the arrays
          copy->DeepCopy(mesh);
          return polydata("mesh", copy);
        });
    }
    json["mesh_name"] = model.meshName;
    json["backend"] = backendWords()[static_cast<std::size_t>(model.backend)];
    const char* const list = isFirst ? "strokes" : "steps";
    json[list] = Json::arrayValue;
    for (const Node& node : model.nodes)
    {
      json[list].append(isFirst ? jsonOf1(node, this->Rows, writer) : jsonOf2(node, this->Rows, writer));
    }
    json["made_by"]["version"] = record.origin.version;
    json["made_by"]["backend"] = record.origin.backend;
    json["made_by"]["device"] = record.origin.device;
    json["made_by"]["processor"] = record.origin.processor;
    json["result_md5"] = record.digest;
    if (!model.shown)
    {
      json["shown"] = false;
    }
    if (model.locked)
    {
      json["locked"] = true;
    }
    for (const PartSource& part : model.hidden)
    {
      json["hidden_parts"].append(jsonOf(part));
    }
    return json;
  };
  Json::Value json = jsonOfModel(session, { file.origin, file.digest });
  json["format"] = formatName;
  json["format_version"] = isFirst ? 1 : 2;
  for (const auto& picture : session.pictures)
  {
    json["pictures"].append(jsonOf(*picture, writer));
  }
  const RestingModels& others = session.others;
  for (std::size_t i = 0; i < others.size(); ++i)
  {
    json["models"].append(jsonOfModel(others[i]->own, i < file.others.size() ? file.others[i] : Record()));
  }
  if (!others.empty())
  {
    json["place"] = static_cast<int>(session.place);
  }
  if (file.look)
  {
    json["look"] = jsonOf(*file.look);
  }
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "  ";
  package[sessionEntry] = std::make_shared<std::string>(Json::writeString(builder, json) + "\n");
  this->Last = std::move(entries);
  return package;
}

namespace
{

// The history of either version, with ids that differ.
std::vector<Node> nodesOf(const JsonReader& json,
  bool isFirst,
  const std::vector<SystemRow>& rows,
  EntryReader& entries)
{
  std::vector<Node> nodes;
  std::set<int> ids;
  const char* const list = isFirst ? "strokes" : "steps";
  const std::vector<JsonReader> listed = json.list(list, isFirst ? "stroke" : "step");
  if (listed.size() > mostSteps)
  {
    json.refuse(list,
      "has " + std::to_string(listed.size()) + " entries; a session has at most " +
        std::to_string(mostSteps));
  }
  for (const JsonReader& one : listed)
  {
    Node node = isFirst ? nodeOf1(one, rows, entries) : nodeOf2(one, rows, entries);
    if (isFirst)
    {
      node.id = static_cast<int>(nodes.size()) + 1;
    }
    if (!ids.insert(node.id).second)
    {
      one.refuse("id", "is that of another step; the session is damaged");
    }
    nodes.push_back(std::move(node));
  }
  return nodes;
}

Json::Value rootOf(const Package& package, const std::string& path)
{
  const auto entry = package.find(sessionEntry);
  if (entry == package.end())
  {
    throw Failed(path + ": holds no " + sessionEntry + "; it is no session");
  }
  if (entry->second->size() > longestText)
  {
    throw Failed(path + ": its " + sessionEntry + " has " + std::to_string(entry->second->size()) +
                 " bytes; that of a session has at most " + std::to_string(longestText));
  }
  return JsonReader::parse(*entry->second, path + ": its " + sessionEntry);
}

// All texts of a document, those of entries among them.
void addTexts(const Json::Value& value, std::set<std::string>& texts)
{
  if (value.isString())
  {
    texts.insert(value.asString());
  }
  else if (value.isArray() || value.isObject())
  {
    for (const Json::Value& one : value)
    {
      addTexts(one, texts);
    }
  }
}

// Such words may quote anything of a damaged text.
template <typename Work>
auto inPlainWords(const Work& work)
{
  try
  {
    return work();
  }
  catch (const Failed& failed)
  {
    throw Failed(oversketch_files::printable(failed.what()));
  }
}

SessionFile decodeAny(const Package& package, const std::string& path, const std::vector<SystemRow>& rows)
{
  const Json::Value root = rootOf(package, path);
  const JsonReader json(root, path + ": " + sessionEntry);
  if (json.text("format") != formatName)
  {
    throw Failed(path + ": is no session");
  }
  const int version = json.integer("format_version", 0, std::numeric_limits<int>::max());
  if (version < 1 || version > newestVersion)
  {
    throw Failed(path + ": is a session of format version " + std::to_string(version) +
                 ", and this program reads versions up to " + std::to_string(newestVersion) +
                 "; open it with the version of Oversketch that wrote it");
  }
  SessionFile file;
  Session& session = file.session;
  EntryReader entries(package, path);
  // Members that every model has.
  const auto modelOf = [&](const JsonReader& from, Model& model)
  {
    if (version == 1 || from.has("mesh"))
    {
      const std::string mesh = from.text("mesh");
      model.mesh = oversketch_files::parseMesh(path + ": " + mesh, *entries.bytes(mesh));
    }
    model.meshName = from.text("mesh_name");
    model.backend = from.choice("backend", backendWords());
    model.nodes = nodesOf(from, version == 1, rows, entries);
    model.shown = version == 1 || !from.has("shown") || from.yes("shown");
    model.locked = version > 1 && from.has("locked") && from.yes("locked");
    if (version > 1 && from.has("hidden_parts"))
    {
      for (const JsonReader& one : from.list("hidden_parts", "hidden part"))
      {
        model.hidden.insert(partSourceOf(one));
      }
    }
    const JsonReader origin = from.object("made_by");
    return Record{
      { origin.text("version"), origin.text("backend"), origin.text("device"), origin.text("processor") },
      from.text("result_md5")
    };
  };
  const Record record = modelOf(json, session);
  file.origin = record.origin;
  file.digest = record.digest;
  if (version > 1 && json.has("pictures"))
  {
    for (const JsonReader& one : json.list("pictures", "picture"))
    {
      session.pictures.push_back(std::make_shared<Picture>(pictureOf(one, entries)));
    }
  }
  if (version > 1 && json.has("models"))
  {
    const std::vector<JsonReader> models = json.list("models", "model");
    if (models.size() >= mostModels)
    {
      json.refuse("models",
        "has " + std::to_string(models.size()) + " entries; a session has at most " +
          std::to_string(mostModels) + " models");
    }
    for (const JsonReader& one : models)
    {
      auto other = std::make_shared<RestingModel>();
      file.others.push_back(modelOf(one, other->own));
      other->own.id = static_cast<int>(file.others.size()) + 1; // that of the first is 1
      session.others.push_back(std::move(other));
    }
    session.place = static_cast<std::size_t>(json.integer("place", 0, static_cast<int>(models.size())));
  }
  if (json.has("look"))
  {
    file.look = lookOf(json.object("look"));
  }
  return file;
}

} // namespace

SessionFile decode(const Package& package, const std::string& path, const std::vector<SystemRow>& rows)
{
  return inPlainWords([&] { return decodeAny(package, path, rows); });
}

SessionFile readSession(const std::string& path)
{
  return inPlainWords(
    [&]
    {
      std::set<std::string> named{ sessionEntry };
      const auto isNamed = [&named](const std::string& entry) { return named.count(entry) == 1; };
      addTexts(rootOf(readPackage(path, isNamed), path), named);
      return decodeAny(readPackage(path, isNamed), path, systems());
    });
}

void writeSession(const std::string& path, const SessionFile& file)
{
  writeZip(path, Encoder().encode(file));
}

} // namespace oversketch_session
