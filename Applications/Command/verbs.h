// Verbs of the command, and the pieces that they share.
#ifndef oversketch_applications_command_verbs_h
#define oversketch_applications_command_verbs_h

#include "evaluator.h"
#include "options.h"

#include <string>
#include <utility>
#include <vector>

namespace oversketch_command
{

// `oversketch one-stroke` and the verbs of all other systems: a session of one step. Reads, runs, writes;
// notes and warnings go to stderr, a progress line too where that is a terminal. Throws Failed. An interrupt
// (SIGINT) cancels: nothing is written.
void runSystem(const Options& options);

// `oversketch assemble`: several parts, drawings with their pictures or meshes, placed and joined into one
// mesh. Tells, stops and throws as runSystem.
void assemble(const Options& options);

// `oversketch check`: says on stdout what keeps a mesh from being printed, a line a fact. Returns whether
// nothing does. Stops and throws as runSystem.
bool check(const Options& options);

// `oversketch replay`: runs a saved session, of a scene all models or the one asked for; says on stderr where
// the machine or the mesh are not those that the session recorded. A stroke that failed when the session was
// saved is passed by as it was then, with its reason. As runSystem else.
void replay(const Options& options);

// A file's part in the run ("the mesh", "--report"), and its path.
using NamedFile = std::pair<std::string, std::string>;
// Throws BadUse where a file would be replaced that is read, or written as well: mesh, report, picture and
// those inside. OUT may be the mesh, which is then changed in its place. Throws Failed where one, but those
// inside, cannot be written.
void requireOutputs(const Options& options,
  std::vector<NamedFile> read,
  const std::vector<NamedFile>& inside = {});

// Runs a model, with a progress line: one of so many, after those that are done. Throws Failed after an
// interrupt.
std::vector<oversketch_session::Outcome> outcomesOf(oversketch_session::Evaluator& evaluator,
  const oversketch_session::Model& model,
  double done = 0.0,
  double all = 1.0);

// Puts a proxy in the place of a mesh of more triangles, and says so. Returns that mesh, or null: it stays.
oversketch_session::SharedData takeProxy(oversketch_session::Model& model, vtkIdType most);
// Moves the mesh as its proxy was. Both throw Failed after an interrupt, and Error.
vtkSmartPointer<vtkPolyData> movedAsProxy(vtkPolyData* mesh, vtkPolyData* proxyNow);

} // namespace oversketch_command
#endif
