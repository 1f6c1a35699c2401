#include "options.h"

#include "mesh_file.h"

#include <algorithm>
#include <map>

namespace oversketch_command
{

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
    throw BadUse("a command is needed: one-stroke");
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
  if (first != "one-stroke")
  {
    throw BadUse("'" + first + "' is no command; there is one-stroke");
  }
  options.action = Action::OneStroke;
  const std::map<std::string, std::string*> values = { { "-o", &options.output },
    { "--output", &options.output },
    { "--picture", &options.picture },
    { "--report", &options.report },
    { "--inner", &options.inner } };
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
    const bool isSwitch = option == "--adjust-normals" || option == "--as-published" || option == "--help";
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
      options.action = Action::OneStrokeHelp;
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
  if (files.size() != 2)
  {
    throw BadUse(
      files.size() < 2 ? "one-stroke needs a mesh and a stroke" : "'" + files[2] + "' is one file too many");
  }
  options.mesh = files[0];
  options.stroke = files[1];
  if (options.output.empty())
  {
    throw BadUse("one-stroke needs -o OUT, the mesh to write");
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

} // namespace oversketch_command
