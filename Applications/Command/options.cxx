#include "options.h"

#include "mesh_file.h"

#include <algorithm>
#include <map>

namespace oversketch_command
{

using namespace oversketch_files;

namespace
{

int choiceOf(const std::string& option, const std::string& value, const std::vector<std::string>& choices)
{
  const auto it = std::find(choices.begin(), choices.end(), value);
  if (it == choices.end())
  {
    std::string list;
    for (const std::string& choice : choices)
    {
      list += (list.empty() ? "" : ", ") + choice;
    }
    throw BadUse(option + " is one of " + list + ", not '" + value + "'");
  }
  return static_cast<int>(it - choices.begin());
}

void requireExtension(const std::string& option, const std::string& path, const std::string& extension)
{
  if (!path.empty() && extensionOf(path) != extension)
  {
    throw BadUse(option + " writes a " + extension + " file, not '" + path + "'");
  }
}

} // namespace

Options parseArguments(const std::vector<std::string>& arguments)
{
  Options options;
  if (arguments.empty())
  {
    throw BadUse("a command is needed: one-stroke or replay");
  }
  const std::string& first = arguments[0];
  if (first == "--help" || first == "-h" || first == "--version")
  {
    if (arguments.size() > 1)
    {
      throw BadUse("'" + arguments[1] + "' is one argument too many");
    }
    options.action = first == "--version" ? Action::Version : Action::Help;
    return options;
  }
  if (first != "one-stroke" && first != "replay")
  {
    throw BadUse("'" + first + "' is no command; there are one-stroke and replay");
  }
  const bool replay = first == "replay";
  options.action = replay ? Action::Replay : Action::OneStroke;
  std::map<std::string, std::string*> values = { { "-o", &options.output }, { "--output", &options.output } };
  if (!replay)
  {
    values.insert(
      { { "--picture", &options.picture }, { "--report", &options.report }, { "--inner", &options.inner } });
  }
  std::vector<std::string> files;
  bool onlyFiles = false;
  for (std::size_t i = 1; i < arguments.size(); ++i)
  {
    std::string option = arguments[i];
    if (onlyFiles || option.size() < 2 || option[0] != '-')
    {
      files.push_back(option);
      continue;
    }
    const std::size_t equals = option.rfind("--", 0) == 0 ? option.find('=') : std::string::npos;
    const auto value = [&]
    {
      if (equals != std::string::npos)
      {
        return arguments[i].substr(equals + 1);
      }
      if (++i == arguments.size())
      {
        throw BadUse(option + " needs a value");
      }
      return arguments[i];
    };
    option = option.substr(0, equals);
    const bool isSwitch =
      option == "--help" || (!replay && (option == "--adjust-normals" || option == "--as-published"));
    if (isSwitch && equals != std::string::npos)
    {
      throw BadUse(option + " takes no value");
    }
    if (option == "--")
    {
      onlyFiles = true;
    }
    else if (option == "--help" || option == "-h")
    {
      options.action = replay ? Action::ReplayHelp : Action::OneStrokeHelp;
      return options;
    }
    else if (values.count(option) > 0)
    {
      std::string& place = *values.at(option);
      if (!place.empty())
      {
        throw BadUse(option + " is given twice");
      }
      place = value();
      if (place.empty())
      {
        throw BadUse(option + " needs a value");
      }
    }
    else if (replay)
    {
      throw BadUse("'" + option + "' is no option of replay");
    }
    else if (option == "--backend")
    {
      options.backend = choiceOf(option, value(), { "auto", "opencl", "embree" });
    }
    else if (option == "--remesh")
    {
      options.remesh = choiceOf(option, value(), { "auto", "on", "off" });
    }
    else if (option == "--adjust-normals")
    {
      options.adjustNormals = true;
    }
    else if (option == "--as-published")
    {
      options.asPublished = true;
    }
    else
    {
      throw BadUse("'" + option + "' is no option of one-stroke");
    }
  }
  const std::size_t wanted = replay ? 1 : 2;
  if (files.size() > wanted)
  {
    throw BadUse("'" + files[wanted] + "' is one file too many");
  }
  if (files.size() < wanted)
  {
    throw BadUse(replay ? "replay needs a session" : "one-stroke needs a mesh and a stroke");
  }
  (replay ? options.session : options.mesh) = files[0];
  options.stroke = files.back();
  if (options.output.empty())
  {
    throw BadUse(first + " needs -o OUT, the mesh to write");
  }
  if (!isMeshExtension(extensionOf(options.output)))
  {
    throw BadUse("'" + options.output + "' is none of the mesh formats " + meshExtensions);
  }
  requireExtension("--picture", options.picture, ".png");
  requireExtension("--report", options.report, ".json");
  return options;
}

std::string helpText()
{
  return "Oversketch: a stroke and a mesh go in, a mesh comes out.\n"
         "\n"
         "  oversketch one-stroke MESH STROKE.vtp -o OUT [options]   deform a mesh by one stroke\n"
         "  oversketch one-stroke --help                             its options\n"
         "  oversketch replay SESSION.oversketch -o OUT              make the mesh of a saved session again\n"
         "  oversketch --version                                     what this program is made of and runs "
         "on\n"
         "  oversketch --help                                        this text\n"
         "\n"
         "Exit code 0: done; 1: could not, a message says why; 2: the command line makes no sense.\n";
}

std::string oneStrokeHelpText()
{
  return "oversketch one-stroke MESH STROKE.vtp -o OUT [options]\n"
         "\n"
         "Moves the part of the silhouette that the stroke was drawn beside onto the stroke, and the limb "
         "with it.\n"
         "\n"
         "  MESH                 triangle mesh: .obj .ply .stl .off .vtp .gltf .glb\n"
         "  STROKE.vtp           one polyline in pixels, with the view that it was drawn in\n"
         "  -o, --output OUT     the mesh to write, in any of these formats\n"
         "  --picture PNG        picture of the result from the stroke's view: stroke red, silhouette blue, "
         "region orange\n"
         "  --report JSON        times of the stages, counts, distances\n"
         "  --backend auto|opencl|embree\n"
         "                       where rays and mixtures are computed; auto takes OpenCL where there is a "
         "device\n"
         "  --remesh auto|on|off remesh the region before and after; auto does so where the deformation "
         "needs it\n"
         "  --adjust-normals     let details turn with the limb (slower)\n"
         "  --as-published       without the amendments to the published method\n"
         "  --inner DIR          write what every stage made as .vtp files into this folder\n";
}

std::string replayHelpText()
{
  return "oversketch replay SESSION -o OUT\n"
         "\n"
         "Opens the model of a session and draws its strokes again: bit for bit the mesh that was saved, "
         "where "
         "version, back end,\n"
         "device and processor are those that saved it. Says so where they are not, and where the mesh "
         "differs.\n"
         "\n"
         "  SESSION              .oversketch file, or a folder of the same content\n"
         "  -o, --output OUT     the mesh to write: .obj .ply .stl .off .vtp .gltf .glb\n";
}

} // namespace oversketch_command
