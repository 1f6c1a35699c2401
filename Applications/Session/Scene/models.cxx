#include "models.h"

#include "evaluator.h"
#include "point_normals.h"
#include "session_file.h"

#include "vtkOversketchAssemble.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchStepRunner.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <utility>

namespace oversketch_session
{

namespace
{

std::shared_ptr<const RestingModel> resting(Model own, MadeModel made)
{
  auto model = std::make_shared<RestingModel>();
  model->own = std::move(own);
  model->made = std::move(made);
  return model;
}

MadeModel madeOf(const Model& model)
{
  Evaluator evaluator;
  Evaluator::Watch watch;
  watch.cancelled = [] { return false; };
  std::vector<Outcome> outcomes;
  evaluator.run(model, watch, outcomes);
  MadeModel made;
  made.backendUsed = backendUsedBy(outcomes);
  if (vtkPolyData* mesh = resultOf(model, outcomes))
  {
    made.mesh = deepCopyOf(mesh); // the evaluator's own goes with it
    made.display = oversketch_files::withPointNormals(made.mesh);
    made.parts = sourcesOf(model, outcomes);
    made.digest = digestOf(made.mesh);
  }
  return made;
}

int freshModel(const Session& session)
{
  int last = session.id;
  for (const auto& other : session.others)
  {
    last = std::max(last, other->own.id);
  }
  return last + 1;
}

// Among the others.
std::size_t otherOf(const Session& session, std::size_t place)
{
  return place < session.place ? place : place - 1;
}

} // namespace

std::size_t modelCount(const Session& session)
{
  return session.others.size() + 1;
}

const RestingModel* restingAt(const Session& session, std::size_t place)
{
  return place == session.place ? nullptr : session.others.at(otherOf(session, place)).get();
}

const Model& modelAt(const Session& session, std::size_t place)
{
  const RestingModel* other = restingAt(session, place);
  return other ? other->own : session;
}

int placeOfModel(const Session& session, int id)
{
  int place = static_cast<int>(modelCount(session)) - 1;
  while (place >= 0 && modelAt(session, static_cast<std::size_t>(place)).id != id)
  {
    --place;
  }
  return place;
}

void makeProxies(Session& session, vtkIdType most, const Progress& progress)
{
  constexpr vtkIdType coarser = 16; // times, so that 500,000 stand for 8 million
  const auto make = [&](Model& model)
  {
    if (isLarge(model.mesh, most) && isMoved(model))
    {
      model.whole = model.mesh;
      model.mesh = proxyOf(withOwnPolys(model.whole), progress, most / coarser);
    }
  };
  make(session);
  for (auto& other : session.others)
  {
    auto own = other->own;
    make(own);
    other = resting(std::move(own), other->made);
  }
}

void makeResting(Session& session)
{
  for (auto& other : session.others)
  {
    if (!other->made.mesh)
    {
      other = resting(other->own, madeOf(other->own));
    }
  }
}

RestingModels modelsOf(const Session& session)
{
  RestingModels models;
  for (std::size_t place = 0; place < modelCount(session); ++place)
  {
    const Model& own = modelAt(session, place);
    const RestingModel* other = restingAt(session, place);
    models.push_back(resting(own, other && other->made.mesh ? other->made : madeOf(own)));
  }
  return models;
}

Session withChosen(const Session& session, std::size_t place, const MadeModel& made)
{
  const RestingModel* chosen = restingAt(session, place);
  if (!chosen)
  {
    return session;
  }
  RestingModels all = session.others;
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(session.place), resting(session, made));
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(place));
  return { chosen->own, session.pictures, place, std::move(all) };
}

Session withModels(const Session& session, const RestingModels& models)
{
  Session next = session;
  for (const auto& model : models)
  {
    auto more = std::make_shared<RestingModel>(*model);
    more->own.id = freshModel(next);
    next.others.push_back(std::move(more));
  }
  return next;
}

Session withoutModel(const Session& session, std::size_t place)
{
  Session next = session;
  next.others.erase(next.others.begin() + static_cast<std::ptrdiff_t>(otherOf(session, place)));
  next.place -= place < session.place ? 1 : 0;
  return next;
}

Session withModelSeen(const Session& session, std::size_t place, bool shown, bool locked)
{
  Session next = session;
  if (const RestingModel* other = restingAt(session, place))
  {
    auto changed = std::make_shared<RestingModel>(*other);
    changed->own.shown = shown;
    changed->own.locked = locked;
    next.others[otherOf(session, place)] = std::move(changed);
  }
  else
  {
    next.shown = shown;
    next.locked = locked;
  }
  return next;
}

Session withPartSeen(const Session& session, const PartSource& part, bool shown)
{
  Session next = session;
  shown ? void(next.hidden.erase(part)) : void(next.hidden.insert(part));
  return next;
}

vtkSmartPointer<vtkPolyData> joined(const std::vector<vtkPolyData*>& meshes)
{
  if (meshes.size() < 2)
  {
    return meshes.empty() ? nullptr : meshes.front();
  }
  vtkNew<vtkOversketchAssemble> assemble;
  for (vtkPolyData* mesh : meshes)
  {
    assemble->AddInputData(placedBy(Eigen::Matrix4d::Identity(), mesh));
  }
  oversketch::StepRunner(assemble, {}).Run();
  return assemble->GetOutput();
}

vtkSmartPointer<vtkPolyData> withOwnPolys(vtkPolyData* mesh)
{
  auto own = shallowCopyOf(mesh);
  own->SetPolys(shallowCopyOf(mesh->GetPolys()));
  return own;
}

bool isShallowCopy(vtkPolyData* a, vtkPolyData* b)
{
  const auto haveSame = [a, b](const auto& of) { return of(a) == of(b); };
  const auto haveSameArrays = [a, b](const auto& of)
  {
    vtkFieldData *one = of(a), *other = of(b);
    bool same = one->GetNumberOfArrays() == other->GetNumberOfArrays();
    for (int i = 0; same && i < one->GetNumberOfArrays(); ++i)
    {
      same = one->GetAbstractArray(i) == other->GetAbstractArray(i);
    }
    return same;
  };
  using Data = vtkPolyData;
  return haveSame([](Data* of) { return of->GetPoints(); }) &&
         haveSame([](Data* of) { return of->GetVerts(); }) &&
         haveSame([](Data* of) { return of->GetLines(); }) &&
         haveSame([](Data* of) { return of->GetPolys(); }) &&
         haveSame([](Data* of) { return of->GetStrips(); }) &&
         haveSame([](Data* of) { return of->GetPointData()->GetNormals(); }) &&
         haveSame([](Data* of) { return of->GetPointData()->GetTCoords(); }) &&
         haveSameArrays([](Data* of) { return of->GetPointData(); }) &&
         haveSameArrays([](Data* of) { return of->GetCellData(); }) &&
         haveSameArrays([](Data* of) { return of->GetFieldData(); });
}

} // namespace oversketch_session
