// Several models in one scene: one is worked on, the others rest beside it with what their steps made.
#ifndef oversketch_applications_session_scene_models_h
#define oversketch_applications_session_scene_models_h

#include "large_mesh.h"
#include "parts.h"
#include "session.h"

#include <string>
#include <vector>

namespace oversketch_session
{

// The things that the steps of a model made.
struct MadeModel
{
  SharedData mesh;     // null where they make none
  SharedData display;  // the same with point normals
  PartSources parts;   // of it
  std::string digest;  // digestOf(mesh); empty where there is none
  int backendUsed = 0; // vtkOversketchSystem::BackendType
};

struct RestingModel
{
  Model own;
  MadeModel made;
};
using RestingModels = std::vector<std::shared_ptr<const RestingModel>>;

constexpr std::size_t mostModels = 1000; // in a scene

std::size_t modelCount(const Session& session);
// A model by its place in the list of all.
const Model& modelAt(const Session& session, std::size_t place);
// The place of a model by its id; -1: it is not there.
int placeOfModel(const Session& session, int id);
// Null for the one that is worked on.
const RestingModel* restingAt(const Session& session, std::size_t place);

// Models of more triangles are worked on by proxies from here on, where their steps can be (isMoved). To be
// called before any is run.
void makeProxies(Session& session, vtkIdType most, const Progress& progress);
// Runs the steps of all others that have no mesh yet. Throws what a step throws that cannot be passed by.
void makeResting(Session& session);
// All models of a scene at rest, made.
RestingModels modelsOf(const Session& session);

// Another model is worked on; the one that was rests with what it made.
Session withChosen(const Session& session, std::size_t place, const MadeModel& made);
// With more models, at the end of the list.
Session withModels(const Session& session, const RestingModels& models);
// Without one that rests.
Session withoutModel(const Session& session, std::size_t place);
Session withModelSeen(const Session& session, std::size_t place, bool shown, bool locked);
// With a part of the one that is worked on seen or hidden.
Session withPartSeen(const Session& session, const PartSource& part, bool shown);

// The meshes of several models as one, each a part or several of it (vtkOversketchAssemble); of one alone
// that one. Null where there is none. Throws oversketch::Error.
vtkSmartPointer<vtkPolyData> joined(const std::vector<vtkPolyData*>& meshes);

// Whether both have the same points, cells and arrays, not only equal ones.
bool isShallowCopy(vtkPolyData* a, vtkPolyData* b);
// Copies a mesh, with polygons of its own: filters of VTK leave in them how far they are, and so do those of
// whoever shows the mesh meanwhile.
vtkSmartPointer<vtkPolyData> withOwnPolys(vtkPolyData* mesh);

} // namespace oversketch_session
#endif
