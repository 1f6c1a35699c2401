// The systems that a session's steps may name, each with its inputs and parameters: the one list that
// evaluator, session file, command, report and panel read. To add a system: a row in systems.cxx.
#ifndef oversketch_applications_session_scene_systems_h
#define oversketch_applications_session_scene_systems_h

#include "step.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkOversketchSystem;

namespace oversketch_session
{

// A value of a parameter that is one of a few.
struct Choice
{
  std::string word;  // "off": in files and on command lines
  std::string title; // "never": in a window
};

struct Parameter
{
  std::string property;           // as the class calls it: SetRemesh, GetRemesh
  std::string step;               // whose it is, by its name; empty: the system repeats it
  std::string word;               // "remesh": --remesh on a command line
  std::string title;              // "New triangles": in a window
  std::string help;               // a line; ends without a stop
  std::vector<Choice> choices;    // of an int that counts them from 0; empty for others
  std::vector<Choice> offers;     // of a text: what a form offers beside what is typed; empty: no field
  double least = 0.0, most = 0.0; // of a number, that a form offers; equal: any
  bool isLength = false;          // [model length]; a command line may give it as a share of the mesh's size
  bool isFile = false;            // of a text: a command line names a JSON file that says it
  bool isList = false;            // of a text: a command line may add to it, by the same option given again
  bool isLater = false;           // session files leave the default out, as those from before it do
  bool oneForAll = false;         // of numbers: a command line, or who types, may give one for all of them
  std::string actsWith;           // the input without which it has no effect; empty for none
  std::function<void(vtkOversketchSystem*, const Value&)> set;
  std::function<Value(vtkOversketchSystem*)> get;
  Value initial; // of a fresh instance; its alternative is that of all values of the parameter
};

// Two counts or lengths given at once: "--quads 64x48", the second where it is not the default.
struct Pair
{
  std::string word, first, second; // "quads", and the properties
  std::string help;                // a line; ends without a stop
};

// A text that a command line adds to, any number of times: "--move 0.5,n,3%" for "move 0.5 n 12.7".
struct Phrase
{
  std::string word, property; // "move", "Operations"
  // "T,AXIS,LENGTH": numbers, but AXIS, which is t, w or n; LENGTH may be a share of the mesh's size.
  std::string fields;
  std::string help; // a line; ends without a stop
};

struct SystemInput
{
  enum class Kind
  {
    Mesh,   // what the step before made, unless a step names another
    Stroke, // lines in pixels with the view that they were drawn in
    Curves, // lines on the mesh
    Picture,
    Heights // a grid of them, from a file that may be a picture
  };

  std::string name; // "Stroke"
  std::string word; // "stroke": STROKE.vtp on a command line, --stroke where it may be absent
  std::string help; // a line; ends without a stop
  Kind kind = Kind::Mesh;
  int port = 0;
  bool optional = false;
  bool byOption = false;   // it must be there, and a command line names it by an option, too
  bool orNumbers = false;  // of lines: a command line may give one as its places, "0 0, 0.4 0.3, 1 0"
  std::string madeBy = {}; // optional where this parameter, a text, is not empty; empty for none
};

// Whether values leave it to be given: it is not optional, or what would make it is not set.
bool isNeeded(const SystemInput& input, const Values& values);

// Whether it is given as the bytes of a file.
bool isImage(SystemInput::Kind kind);

// How a step acts on both sides of a mirror plane (SystemRunner::run).
enum class Mirroring
{
  None,     // it cannot
  Partners, // points follow their partners on the other side; where these have none, by two runs
  Strokes,  // it takes several strokes, each with a view of its own: each, and the same in the mirror
  TwoRuns
};

// Output port 0 of every system is the mesh that the next step gets.
struct SystemRow
{
  std::string name;  // "OneStroke", of vtkOversketchOneStroke
  std::string verb;  // "one-stroke": of the command
  std::string title; // "Stroke": a step of it, in a window
  std::string brief; // what it does, in a few words that follow on the verb
  std::string help;  // the same in sentences
  vtkSmartPointer<vtkOversketchSystem> (*make)() = nullptr;
  std::vector<SystemInput> inputs;
  std::vector<Parameter> parameters;
  std::vector<Pair> pairs;     // of parameters, which then have no options of their own
  std::vector<Phrase> phrases; // likewise
  Mirroring mirroring = Mirroring::None;
  Values keepingPoints; // with Mirroring::Partners: those by which its output's points keep their ids
  // The inputs whose pictures the mesh and its back wear, by its texture coordinates; empty for none. Where
  // the latter is given both are pictures of parts, 0 and 1.
  std::string textureInput, backTextureInput;
  // The switch by which the back wears, without a picture of its own, the skin of the first one, its inside
  // filled from the rim, mirrored; empty for none.
  std::string backFromRim;
  // Both are worn as skins: opaque, their colours led on past what the mesh covers of them (skin.h).
  bool skin = false;
  // Steps move parts of a mesh above all, so that a proxy will do for a large one (large_mesh.h).
  bool moves = false;
  // A step may add parts to the mesh that comes to it.
  bool addsParts = false;
  // A step makes one body of the parts of the mesh that comes to it.
  bool joinsParts = false;
  // A hand goes on changing its last step: what that computed is kept beside what the next one will need.
  bool previewsEdits = false;
  // Other properties that the class lets be set, each with the reason why no step holds it.
  std::map<std::string, std::string> leftOut;
};

// Those that are built.
const std::vector<SystemRow>& systems();
// By name or by verb; null where there is none.
const SystemRow* findSystem(const std::string& name, const std::vector<SystemRow>& rows = systems());
const SystemRow* findVerb(const std::string& verb);
const Parameter* findParameter(const SystemRow& row, const std::string& property);
const SystemInput* findInput(const SystemRow& row, const std::string& name);
// The first input of a kind, null where there is none.
const SystemInput* findInput(const SystemRow& row, SystemInput::Kind kind);

// The words of its choices.
std::vector<std::string> wordsOf(const Parameter& parameter);
// The value of a step's parameter: its own, or the default.
const Value& valueOf(const Step& step, const Parameter& parameter);

// Why no system of the list can run the step, whatever its inputs hold: the name of the system, of a
// parameter or of an input is unknown, or a value is none of the parameter's. Empty where one can.
std::string faultOf(const Step& step, const std::vector<SystemRow>& rows = systems());

// The words of vtkOversketchSystem::BackendType, in files and on command lines.
const std::vector<std::string>& backendWords();

// A step of the system by its name, or the system where that is empty.
vtkAlgorithm* ownerOf(vtkOversketchSystem* system, const std::string& step);

// The row with the defaults of a fresh instance.
SystemRow withDefaults(SystemRow row);

} // namespace oversketch_session
#endif
