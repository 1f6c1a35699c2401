#include "options.h"

#include "mesh_file.h"
#include "print_colours.h"
#include "upright_picture.h"

#include <algorithm>
#include <sstream>

namespace oversketch_command
{

using namespace oversketch_session;

namespace
{

constexpr std::size_t column = 23;   // where helps begin
constexpr std::size_t longest = 110; // of a line

// Lines of at most `longest`, all but the first indented; `at` characters of the first are there already.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t at)
{
  std::istringstream words(text);
  std::string lines;
  for (std::string word; words >> word;)
  {
    const bool isFirst = lines.empty();
    if (!isFirst && at + 1 + word.size() > longest)
    {
      lines += "\n" + std::string(indent, ' ');
      at = indent;
    }
    else if (!isFirst)
    {
      lines += ' ';
      ++at;
    }
    lines += word;
    at += word.size();
  }
  return lines;
}

std::string lineOf(const OptionText& option)
{
  const std::string name = "  " + option.names + (option.value.empty() ? "" : " " + option.value);
  const std::string gap =
    name.size() + 1 < column ? std::string(column - name.size(), ' ') : "\n" + std::string(column, ' ');
  return name + gap + wrapped(option.help, column, column) + "\n";
}

std::string examples(const std::vector<std::pair<std::string, std::string>>& lines)
{
  std::size_t most = 0;
  for (const auto& line : lines)
  {
    most = std::max(most, line.first.size());
  }
  std::string text;
  for (const auto& [usage, what] : lines)
  {
    text += "  " + usage + std::string(most - usage.size() + 3, ' ') + what + "\n";
  }
  return text;
}

} // namespace

std::string usageOf(const SystemRow& system)
{
  std::string usage = "oversketch " + system.verb;
  for (const OptionText& file : filesOf(system))
  {
    usage += " " + file.names;
  }
  for (const OptionText& option : neededOf(system))
  {
    usage += " " + option.names + " " + option.value;
  }
  return usage + " -o OUT [options]";
}

std::string helpText()
{
  std::vector<std::pair<std::string, std::string>> lines;
  for (const SystemRow& system : systems())
  {
    lines.emplace_back(usageOf(system), system.brief);
    lines.emplace_back("oversketch " + system.verb + " --help", "its options");
  }
  lines.emplace_back(
    "oversketch assemble PARTS.json -o OUT", "join drawings and meshes, placed, into one model");
  lines.emplace_back("oversketch check MESH [options]", "say whether a mesh can be printed, and if not, why");
  lines.emplace_back("oversketch replay SESSION.oversketch -o OUT", "make the mesh of a saved session again");
  lines.emplace_back("oversketch --version", "what this program is made of and runs on");
  lines.emplace_back("oversketch --help", "this text");
  return "Oversketch: a stroke and a mesh go in, a mesh comes out.\n\n" + examples(lines) +
         "\nExit code 0: done; 1: could not, a message says why, or check found a fault; 2: the command line "
         "makes no sense.\n";
}

std::string helpText(const SystemRow& system)
{
  std::string text = usageOf(system) + "\n\n" + wrapped(system.help, 0, 0) + "\n\n";
  for (const OptionText& file : filesOf(system))
  {
    text += lineOf(file);
  }
  for (const OptionText& option : optionsOf(system))
  {
    text += lineOf(option);
  }
  return text;
}

std::string replayHelpText()
{
  return "oversketch replay SESSION -o OUT [options]\n"
         "\n"
         "Takes the steps of a session again: bit for bit the mesh that was saved, where version, back end,\n"
         "device and processor are those that saved it. Says so where they are not, and where the mesh "
         "differs.\n"
         "\n"
         "  SESSION              .oversketch file, or a folder of the same content\n"
         "  -o, --output OUT     the mesh to write: " +
         std::string(oversketch_files::writtenExtensions) +
         "\n"
         "  --model N            only that model of a scene of several, counted from 1; without it all of "
         "them, as\n"
         "                       parts of one mesh\n";
}

std::string checkHelpText()
{
  return "oversketch check MESH [options]\n"
         "\n"
         "Says, a line a fact, whether a mesh can be printed: whether it is closed and its faces look "
         "outward, how\n"
         "many bodies and hollows it has, which faces pass through each other, how thin its walls are; and "
         "the\n"
         "remedy where it cannot. Exit code 0: ready to print; 1: not, or it could not be read; 2: the "
         "command\n"
         "line makes no sense.\n"
         "\n"
         "  MESH                 of triangles: " +
         std::string(oversketch_files::meshExtensions) +
         "\n"
         "  --wall X|X%          walls thinner than this are a fault: mm, or a share of the mesh's size (its "
         "box's\n"
         "                       diagonal); 0, none, where it is not given\n"
         "  --unit UNIT          what a length of 1 in the file is: mm, cm, m, in, or how many mm; mm where "
         "it is\n"
         "                       not given\n"
         "  -o, --output OUT     the mesh with walls by colour, red thin, blue thick, grey none, and faulty "
         "faces\n"
         "                       black: " +
         std::string(oversketch_files::faceColourExtensions) +
         "\n"
         "  --report JSON        all figures, lengths in mm, and the volume of each body\n";
}

std::string assembleHelpText()
{
  return "oversketch assemble PARTS.json -o OUT [options]\n"
         "\n"
         "Makes a model of each drawing that the file names, with its picture, puts it and meshes in their "
         "places\n"
         "and joins all into one mesh. Parts are not merged. Each wears its own picture: one material a part "
         "in\n"
         ".gltf, .glb and .obj; a .vtp file holds them as field arrays Part0.Texture, …, the cell array "
         "PartId says\n"
         "whose a face is. Parts are numbered from 0; one with a picture of its back counts twice, front and "
         "back.\n"
         "\n"
         "  PARTS.json           { \"parts\": [ … ] }, at most 1000; paths begin at its folder; members of a "
         "part:\n"
         "    strokes            a drawing (.vtp), as of oversketch inflate; or mesh\n"
         "    picture            the picture that it was drawn over; may be absent; one of\n"
         "                       " +
         std::string(oversketch_files::pictureExtensions) +
         "\n"
         "    back_picture       a picture of its back, as seen from behind; may be absent\n"
         "    parameters         { \"profile\": \"linear\", \"hole\": \"2\" }: as the options of oversketch "
         "inflate are\n"
         "                       called, a switch true or false; may be absent\n"
         "    mesh               in place of these: " +
         std::string(oversketch_files::meshExtensions) +
         "\n"
         "    box, depth         [left, bottom, right, top] that the drawing's canvas, or the mesh, comes to "
         "fill,\n"
         "                       and how far it is then moved along z; may be absent\n"
         "    placement          in place of these: an affine matrix, four rows of four numbers\n"
         "  -o, --output OUT     the mesh to write: " +
         std::string(oversketch_files::writtenExtensions) +
         "\n"
         "  --report JSON        times, and of each part what its strokes are, counts, place\n";
}

} // namespace oversketch_command
